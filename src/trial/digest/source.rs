//! Pseudo-random and hard inputs, made in integers.

use fixed::types::{I2F14, I2F30, I16F16};
use half::f16;
use micromath::F32;

use super::hash::Bits;
use crate::light::{DistantLight, SUN};
use crate::real::{Real, Scalar};
use crate::specular::normalize;
use crate::sphere::DistantSphere;

/// A format whose results are digested.
pub trait Digested: Real<Wide: Bits, Scalar: Bits, Level: Bits> + Bits {
    /// The lights of [`LIGHTS`], rounded while compiling.
    const LIGHTS: [DistantSphere<Self>; LIGHTS.len()];

    /// The number of some raw bits.
    fn raw(bits: u64) -> Self;

    /// A light by its ratio in Q30, rounded at run time.
    fn light(ratio: u32) -> DistantSphere<Self>;
}

const LIGHTS: [DistantLight; 8] =
    [SUN, sphere(0.0), sphere(1e-5), sphere(0.05), sphere(0.71), sphere(1.0), disc(270.0), disc(360.0)];

const fn sphere(ratio: f64) -> DistantLight {
    match DistantLight::from_ratio(ratio) {
        Ok(light) => light,
        Err(_) => panic!("a ratio is from 0 to 1"),
    }
}

const fn disc(angle: f64) -> DistantLight {
    match DistantLight::from_angle(angle) {
        Ok(light) => light,
        Err(_) => panic!("an angle is from 0 to 360 degrees"),
    }
}

// A macro, since no function of a trait can be called in a constant.
macro_rules! digested {
    ($format:ty, $bits:ident => $raw:expr, $ratio:ident => $light:expr) => {
        impl Digested for $format {
            const LIGHTS: [DistantSphere<Self>; LIGHTS.len()] = {
                let mut lights = [DistantSphere::<$format>::new(&SUN); LIGHTS.len()];
                let mut index = 0;
                while index < LIGHTS.len() {
                    lights[index] = DistantSphere::<$format>::new(&LIGHTS[index]);
                    index += 1;
                }
                lights
            };

            fn raw($bits: u64) -> Self {
                $raw
            }

            fn light($ratio: u32) -> DistantSphere<Self> {
                $light.unwrap_or(Self::LIGHTS[0])
            }
        }
    };
}

digested!(I2F14, bits => Self::from_bits(bits as i16), ratio => DistantSphere::<Self>::from_ratio_q30(q30(ratio)));
digested!(I2F30, bits => Self::from_bits(bits as i32), ratio => DistantSphere::<Self>::from_ratio_q30(q30(ratio)));
digested!(I16F16, bits => Self::from_bits(bits as i32), ratio => DistantSphere::<Self>::from_ratio_q30(q30(ratio)));
digested!(f64, bits => Self::from_bits(bits), ratio => DistantSphere::from_ratio(Self::from_q31(ratio << 1)));
digested!(f32, bits => Self::from_bits(bits as u32), ratio => DistantSphere::from_ratio(Self::from_q31(ratio << 1)));
digested!(F32, bits => Self(f32::from_bits(bits as u32)), ratio => DistantSphere::from_ratio(Self::from_q31(ratio << 1)));
digested!(f16, bits => Self::from_bits(bits as u16), ratio => DistantSphere::from_ratio(Self::from_q31(ratio << 1)));

fn q30(bits: u32) -> I2F30 {
    I2F30::from_bits(bits as i32)
}

/// A pseudo-random sequence (Steele, Lea and Flood's, 2014) and the inputs that are made of it.
pub(super) struct Source(pub(super) u64);

impl Source {
    pub(super) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let bits = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// A number of `0..end`.
    pub(super) fn below(&mut self, end: u32) -> u32 {
        ((u64::from(self.bits() as u32) * u64::from(end)) >> 32) as u32
    }

    /// From 0 to 1: anywhere, or tiny, or an end.
    pub(super) fn share(&mut self) -> u32 {
        let bits = (self.bits() >> 34) as u32;
        match self.below(8) {
            0 => 0,
            1 => 1 << 30,
            2..=4 => bits >> self.below(30),
            _ => bits,
        }
    }

    /// The same as a number.
    pub(super) fn part<S: Scalar>(&mut self) -> S {
        S::from_q31(self.share() << 1)
    }

    /// A positive or negative number of a size from `2^-12` to `2^12`, or zero.
    pub(super) fn quantity<S: Scalar>(&mut self) -> S {
        let number = self.lane_of::<S>(0);
        let two = S::ONE + S::ONE;
        (0..self.below(13)).fold(number, |number, _| number * two)
    }

    /// From -1 to 1, over `2^shrink`.
    fn lane_of<S: Scalar>(&mut self, shrink: u32) -> S {
        let bits = self.bits();
        let size = S::from_q31((bits as u32 >> 1).checked_shr(shrink).unwrap_or(0));
        if bits >> 63 == 0 { size } else { S::ZERO - size }
    }

    fn lanes<T: Real>(&mut self, shrink: u32) -> [T; 3] {
        [(); 3].map(|()| T::lane(self.lane_of(shrink)))
    }

    /// Any bits at all, an axis, or a unit vector of any direction.
    pub(super) fn direction<T: Digested>(&mut self) -> [T; 3] {
        match self.below(8) {
            0 => [(); 3].map(|()| T::raw(self.bits())),
            1 => {
                let one = T::lane(T::Scalar::ONE);
                let sign = if self.below(2) == 0 { one } else { T::sub(T::ZERO, one) };
                let mut axis = [T::ZERO; 3];
                axis[self.below(3) as usize] = sign;
                axis
            }
            _ => normalize(self.lanes(0)),
        }
    }

    /// Beside `l` or its opposite, by less and less; or anywhere.
    pub(super) fn beside<T: Digested>(&mut self, l: [T; 3]) -> [T; 3] {
        let kind = self.below(8);
        let shrink = self.below(32);
        let [x, y, z] = self.lanes(shrink);
        match kind {
            0 => l,
            1 => l.map(|lane| T::sub(T::ZERO, lane)),
            2..=4 => normalize([T::add(l[0], x), T::add(l[1], y), T::add(l[2], z)]),
            5 => normalize([T::sub(x, l[0]), T::sub(y, l[1]), T::sub(z, l[2])]),
            _ => self.direction(),
        }
    }

    pub(super) fn light<T: Digested>(&mut self) -> DistantSphere<T> {
        match self.below(16) as usize {
            index if index < LIGHTS.len() => T::LIGHTS[index],
            _ => T::light(self.share()),
        }
    }
}
