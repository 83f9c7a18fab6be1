//! Structured cases out of plain bytes: a fuzzer's, a corpus file's, or random ones.

use core::f64::consts::{FRAC_PI_2, PI};

use super::format::Format;
use super::input::{turned, unit};
use crate::light::{DistantLight, SUN};

/// Reads a case off bytes, one number after the other; beyond their end all are zero.
///
/// A case is the same on every machine and in every version of this file, or the corpus would lose its meaning: add
/// kinds at the end of a list that is chosen from, and only while that stays within a power of two.
#[derive(Clone, Debug)]
pub struct Draw<'a> {
    bytes: &'a [u8],
}

impl<'a> Draw<'a> {
    /// A case from its first byte on.
    pub const fn new(bytes: &'a [u8]) -> Self {
        Self { bytes }
    }

    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        self.bytes.split_off_first().copied().unwrap_or(0)
    }

    /// The next eight bytes.
    pub fn bits(&mut self) -> u64 {
        u64::from_le_bytes([(); 8].map(|()| self.byte()))
    }

    /// One of some choices, by one byte.
    pub fn one_of<T: Copy, const N: usize>(&mut self, choices: [T; N]) -> T {
        choices[usize::from(self.byte()) % N]
    }

    /// Evenly from 0 to 1, the latter left out.
    pub fn fraction(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Evenly between two ends.
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.fraction()
    }

    /// The logarithm evenly between those of two positive ends.
    pub fn logarithmic(&mut self, from: f64, to: f64) -> f64 {
        from * libm::pow(to / from, self.fraction())
    }

    /// One of the seven formats.
    pub fn format(&mut self) -> Format {
        self.one_of(Format::ALL)
    }

    /// Any number of a format by its raw bits, NaN and infinities included: random ones, and those where formats end.
    pub fn any(&mut self, format: Format) -> f64 {
        let bits = self.bits();
        let special = [0.0, -0.0, 1.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 2.0, -2.0, 0.5];
        let end = 1 << (format.width() - 1);
        match bits & 7 {
            0 => special[(bits >> 3) as usize % special.len()],
            1 => format.value([end - 1, end, end + 1, 1][(bits >> 3) as usize % 4]),
            _ => format.value(bits >> 3),
        }
    }

    /// A unit vector: anywhere, on an axis, beside one, or with one tiny lane.
    pub fn direction(&mut self) -> [f64; 3] {
        let kind = self.byte() % 8;
        let z = self.between(-1.0, 1.0);
        let turn = self.between(0.0, 2.0 * PI);
        let ring = libm::sqrt((1.0 - z) * (1.0 + z));
        let anywhere = [ring * libm::cos(turn), ring * libm::sin(turn), z];
        let lane = usize::from(kind) % 3;
        let mut axis = [0.0; 3];
        axis[lane] = if z < 0.0 { -1.0 } else { 1.0 };
        match kind {
            0 => axis,
            1 => {
                let distance = self.logarithmic(1e-6, 1.0);
                unit([0, 1, 2].map(|i| axis[i] + distance * anywhere[i]))
            }
            2 => {
                let shrink = self.logarithmic(1e-7, 1.0);
                let mut thin = anywhere;
                thin[lane] *= shrink;
                if thin == [0.0; 3] { axis } else { unit(thin) }
            }
            _ => anywhere,
        }
    }

    /// `l` turned by an angle towards any side.
    pub fn turned(&mut self, l: [f64; 3], angle: f64) -> [f64; 3] {
        let aside = self.direction();
        turned(l, aside, angle)
    }

    /// A direction beside `l` where a disc of angular radius `theta` is hard: inside, about and beside the rim, at a
    /// right angle, beside `-l`, the same and the opposite direction, and anywhere.
    pub fn beside(&mut self, l: [f64; 3], theta: f64) -> [f64; 3] {
        let angle = match self.byte() % 8 {
            0 => self.between(0.0, PI),
            1 => self.logarithmic(1e-8, PI),
            2 => PI - self.logarithmic(1e-8, PI),
            3 => theta * self.logarithmic(0.5, 2.0),
            4 => theta * (1.0 - self.logarithmic(1e-8, 1e-2)),
            5 => theta * (1.0 + self.logarithmic(1e-8, 1e-2)),
            6 => FRAC_PI_2 + self.one_of([-1.0, 1.0]) * self.logarithmic(1e-8, 1e-1),
            _ => self.one_of([0.0, PI, theta, FRAC_PI_2]),
        };
        self.turned(l, angle.min(PI))
    }

    /// A light of up to half the sky by its ratio: the Sun, a point, tiny ones, any, and those of almost half the sky.
    pub fn sphere(&mut self) -> DistantLight {
        let ratio = match self.byte() % 8 {
            0 => SUN.sin(),
            1 => self.one_of([0.0, 1.0, 0.7, 0.5]),
            2 => self.logarithmic(1e-6, 1e-3),
            3 => 1.0 - self.logarithmic(1e-9, 1e-1),
            4 => self.between(0.69, 0.73),
            _ => self.logarithmic(1e-3, 1.0),
        };
        DistantLight::from_ratio(ratio).unwrap_or(SUN)
    }

    /// A light of any size up to the full sphere: as [`Draw::sphere`], or by its UsdLux angle in degrees, also where next
    /// to nothing is left of the full sphere.
    pub fn light(&mut self) -> DistantLight {
        let angle = match self.byte() % 8 {
            0 => self.between(180.0, 360.0),
            4 => 360.0 - self.logarithmic(1e-5, 10.0),
            1 | 5 => self.one_of([180.0, 360.0, 0.0, 0.53, 270.0, 359.99, 180.0_f64.next_up(), 180.0_f64.next_down()]),
            _ => return self.sphere(),
        };
        DistantLight::from_angle(angle).unwrap_or(SUN)
    }
}
