//! The functions of [`crate::raw`] side by side for both of its formats.

use core::fmt::Debug;

use fixed::types::{I2F14, I2F30, U16F16, U32F32};

use crate::light::LightError;
use crate::material::{MaterialError, Surface};
use crate::raw;
use crate::real::{Real, Scaled};
use crate::sampling::Cone;
use crate::scene::{Channel, Lamp, Scene, SceneError};
use crate::sphere::DistantSphere;
use crate::trial::format::Format;

type Vector<T> = [<T as Raw>::Lane; 3];

type Levels<T> = [<T as Raw>::Light; 3];

type TwoVectors<T> = fn(Vector<T>, Vector<T>, &DistantSphere<T>) -> Vector<T>;

/// A format that [`crate::raw`] has on bits.
pub trait Raw: Real<Scalar = Scaled> + PartialEq {
    /// A lane's bits.
    type Lane: Copy + PartialEq + Debug;
    /// A level's bits.
    type Light: Copy + PartialOrd + Debug;

    const FORMAT: Format;
    const LAYER: Layer<Self>;

    fn bits(self) -> Self::Lane;
    fn of(bits: Self::Lane) -> Self;
    /// As many low bits as are needed.
    fn wide_of(bits: u64) -> Self::Wide;
    fn light_of(bits: u64) -> Self::Light;
    fn level_of(bits: Self::Light) -> Self::Level;
    fn light(level: Self::Level) -> Self::Light;
}

/// The functions, by their names without the format.
// Names for such types would only move them.
#[allow(clippy::type_complexity)]
pub struct Layer<T: Raw> {
    pub sphere: fn(i32) -> Result<DistantSphere<T>, LightError>,
    pub cap: TwoVectors<T>,
    pub factored: TwoVectors<T>,
    pub disc: TwoVectors<T>,
    pub reflect: fn(Vector<T>, Vector<T>) -> Vector<T>,
    pub normalize: fn(Vector<T>) -> Vector<T>,
    pub lambert: fn(T::Lane, T::Light, T::Wide) -> T::Light,
    pub lambert_disc: fn(T::Lane, T::Light, T::Wide, &DistantSphere<T>) -> T::Light,
    pub relative_illuminance: fn(T::Wide, &DistantSphere<T>) -> T::Wide,
    pub cone: fn(Vector<T>, &DistantSphere<T>) -> Cone<T>,
    pub direction: fn(&Cone<T>, [T::Lane; 2]) -> Vector<T>,
    pub contains: fn(&Cone<T>, Vector<T>) -> bool,
    pub basis: fn(Vector<T>) -> [Vector<T>; 2],
    pub last_point: fn(u32, u32) -> Option<[T::Lane; 2]>,
    pub soft_shadow: fn(&Cone<T>, Vector<T>, u32, u32, fn(Vector<T>) -> bool) -> [i32; 2],
    pub surface: fn([i32; 3], i32, [i32; 3]) -> Result<Surface<T>, MaterialError<Scaled>>,
    pub lamp: fn(Vector<T>, &DistantSphere<T>, Levels<T>) -> Result<Lamp<T>, SceneError<Scaled>>,
    pub shade: fn(&Scene<T, 2>, Vector<T>, Vector<T>) -> Levels<T>,
    pub shade_channel: fn(&Scene<T, 2>, Vector<T>, Vector<T>, Channel) -> T::Light,
}

impl Raw for I2F14 {
    type Lane = i16;
    type Light = u32;

    const FORMAT: Format = Format::I2F14;

    const LAYER: Layer<Self> = Layer {
        sphere: raw::sphere_q14,
        cap: raw::cap_q14,
        factored: raw::factored_q14,
        disc: raw::disc_q14,
        reflect: raw::reflect_q14,
        normalize: raw::normalize_q14,
        lambert: raw::lambert_q14,
        lambert_disc: raw::lambert_disc_q14,
        relative_illuminance: raw::relative_illuminance_q14,
        cone: raw::cone_q14,
        direction: raw::cone_direction_q14,
        contains: raw::cone_contains_q14,
        basis: raw::basis_q14,
        last_point: |first, count| raw::points_q14(first, count).last(),
        soft_shadow: raw::soft_shadow_q14,
        surface: raw::surface_q14,
        lamp: raw::lamp_q14,
        shade: raw::shade_q14,
        shade_channel: raw::shade_channel_q14,
    };

    fn bits(self) -> i16 {
        self.to_bits()
    }

    fn of(bits: i16) -> Self {
        Self::from_bits(bits)
    }

    fn wide_of(bits: u64) -> i32 {
        bits as i32
    }

    fn light_of(bits: u64) -> u32 {
        bits as u32
    }

    fn level_of(bits: u32) -> U16F16 {
        U16F16::from_bits(bits)
    }

    fn light(level: U16F16) -> u32 {
        level.to_bits()
    }
}

impl Raw for I2F30 {
    type Lane = i32;
    type Light = u64;

    const FORMAT: Format = Format::I2F30;

    const LAYER: Layer<Self> = Layer {
        sphere: raw::sphere_q30,
        cap: raw::cap_q30,
        factored: raw::factored_q30,
        disc: raw::disc_q30,
        reflect: raw::reflect_q30,
        normalize: raw::normalize_q30,
        lambert: raw::lambert_q30,
        lambert_disc: raw::lambert_disc_q30,
        relative_illuminance: raw::relative_illuminance_q30,
        cone: raw::cone_q30,
        direction: raw::cone_direction_q30,
        contains: raw::cone_contains_q30,
        basis: raw::basis_q30,
        last_point: |first, count| raw::points_q30(first, count).last(),
        soft_shadow: raw::soft_shadow_q30,
        surface: raw::surface_q30,
        lamp: raw::lamp_q30,
        shade: raw::shade_q30,
        shade_channel: raw::shade_channel_q30,
    };

    fn bits(self) -> i32 {
        self.to_bits()
    }

    fn of(bits: i32) -> Self {
        Self::from_bits(bits)
    }

    fn wide_of(bits: u64) -> i64 {
        bits as i64
    }

    fn light_of(bits: u64) -> u64 {
        bits
    }

    fn level_of(bits: u64) -> U32F32 {
        U32F32::from_bits(bits)
    }

    fn light(level: U32F32) -> u64 {
        level.to_bits()
    }
}
