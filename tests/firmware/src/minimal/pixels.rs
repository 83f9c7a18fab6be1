//! What the images that light a pixel have to answer.

use std::f32;
use std::f64;

use sunglint::fixed::types::{I2F14, I2F30, I16F16, U16F16, U32F32};
use sunglint::half::f16;
use sunglint::highlight::DiscGgx;
use sunglint::material::{Material, Surface};
use sunglint::micromath::F32;
use sunglint::raw::{PixelQ14, SUN_Q14};
use sunglint::scene::{Lamp, Scene};
use sunglint::trial::Format;
use sunglint::{DistantSphere, Real, SUN};

use crate::inputs::{SUN_AT, seen};

/// The images' sea.
fn sea() -> Material {
    Material::new([0.01, 0.03, 0.05], 0.02, [0.02; 3]).expect("the images have the same")
}

/// A level as it lies in memory.
type InMemory<L> = fn(L) -> Vec<u8>;

/// All answers, as they lie in memory, under a light of illuminance pi.
pub fn answers(format: Format) -> Vec<u8> {
    match format {
        Format::F64 => of::<f64>(f64::consts::PI, |level| level.to_le_bytes().to_vec()),
        Format::F32 => of::<f32>(f32::consts::PI, |level| level.to_le_bytes().to_vec()),
        Format::Micromath => of::<F32>(F32(f32::consts::PI), |level| level.0.to_le_bytes().to_vec()),
        Format::F16 => of::<f16>(f16::PI, |level| level.to_le_bytes().to_vec()),
        Format::I2F14 => of::<I2F14>(U16F16::PI, |level| level.to_le_bytes().to_vec()),
        Format::I2F30 => of::<I2F30>(U32F32::PI, |level| level.to_le_bytes().to_vec()),
        Format::I16F16 => of::<I16F16>(U16F16::PI, |level| level.to_le_bytes().to_vec()),
    }
}

fn of<T: Real>(illuminance: T::Level, in_memory: InMemory<T::Level>) -> Vec<u8> {
    let mut scene = Scene::<T, 1, DiscGgx<T>>::with_highlight(&Surface::of(&sea()), DiscGgx::new);
    let lamp = Lamp::new(SUN_AT.map(T::from_f64), DistantSphere::of(&SUN), [illuminance; 3]);
    assert!(lamp.is_ok_and(|lamp| scene.push(&lamp).is_ok()), "the images' lamp is one");
    let colours = seen().map(|[n, v, _]| scene.shade(n.map(T::from_f64), v.map(T::from_f64)));
    colours.flatten().flat_map(in_memory).collect()
}

/// Those of `PixelQ14`.
pub fn by_pixel_q14() -> Vec<u8> {
    let lanes = |v: [f64; 3]| v.map(|lane| <I2F14 as Real>::from_f64(lane).to_bits());
    let pixel = PixelQ14::new([9830, 0, 13107], &SUN_Q14, &Surface::of(&sea()), [205_887; 3]);
    let pixel = pixel.expect("the images have the same");
    let colours = seen().map(|[n, v, _]| pixel.shade(lanes(n), lanes(v)));
    colours.flatten().flat_map(u32::to_le_bytes).collect()
}
