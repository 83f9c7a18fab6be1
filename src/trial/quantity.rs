//! The light quantities of one argument as a list, with their truth.

use fixed::types::{I2F30, U16F48, U52F12};

use crate::light::LightError;
use crate::normalization;
use crate::oracle;
use crate::real::Float;

/// A quantity that depends on radius over distance alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// `1 - cos(theta)`.
    Versine,
    /// `2 pi (1 - cos(theta))`.
    SolidAngle,
    /// `pi sin^2(theta)`, 1 for 0.
    SizeFactor,
    /// One over that.
    InverseSizeFactor,
    /// `(d/R)^2`.
    WhiteRadiance,
}

/// A fixed-point answer: its value, and the value of its last bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedPoint {
    /// The value.
    pub value: f64,
    /// What the last bit is worth.
    pub lsb: f64,
    /// Name of the format.
    pub format: &'static str,
}

impl Quantity {
    /// All quantities, in the order of tables.
    pub const ALL: [Self; 5] =
        [Self::Versine, Self::SolidAngle, Self::SizeFactor, Self::InverseSizeFactor, Self::WhiteRadiance];

    /// Name of the function.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Versine => "versine",
            Self::SolidAngle => "solid_angle",
            Self::SizeFactor => "size_factor",
            Self::InverseSizeFactor => "inverse_size_factor",
            Self::WhiteRadiance => "white_radiance",
        }
    }

    /// The exact value, to a few of f64's last places.
    pub fn truth(self, ratio: f64) -> f64 {
        match self {
            Self::Versine => oracle::closed::versine(ratio),
            Self::SolidAngle => oracle::closed::solid_angle(ratio),
            Self::SizeFactor => oracle::closed::size_factor(ratio),
            Self::InverseSizeFactor => 1.0 / oracle::closed::size_factor(ratio),
            Self::WhiteRadiance => 1.0 / (ratio * ratio),
        }
    }

    /// The answer in a float format.
    ///
    /// # Errors
    /// Those of the function.
    pub fn in_float<T: Float>(self, ratio: T) -> Result<T, LightError> {
        match self {
            Self::Versine => normalization::versine(ratio),
            Self::SolidAngle => normalization::solid_angle(ratio),
            Self::SizeFactor => normalization::size_factor(ratio),
            Self::InverseSizeFactor => normalization::inverse_size_factor(ratio),
            Self::WhiteRadiance => normalization::white_radiance(ratio),
        }
    }

    /// The answer in fixed point.
    ///
    /// # Errors
    /// Those of the function.
    pub fn in_fixed(self, ratio: I2F30) -> Result<FixedPoint, LightError> {
        match self {
            Self::Versine => normalization::versine_q30(ratio).map(q48),
            Self::SolidAngle => normalization::solid_angle_q30(ratio).map(q48),
            Self::SizeFactor => normalization::size_factor_q30(ratio).map(q48),
            Self::InverseSizeFactor => normalization::inverse_size_factor_q30(ratio).map(q12),
            Self::WhiteRadiance => normalization::white_radiance_q30(ratio).map(q12),
        }
    }
}

fn q48(value: U16F48) -> FixedPoint {
    let lsb = 1.0 / (1_u64 << 48) as f64;
    FixedPoint { value: value.to_bits() as f64 * lsb, lsb, format: "U16F48" }
}

fn q12(value: U52F12) -> FixedPoint {
    let lsb = 1.0 / 4096.0;
    FixedPoint { value: value.to_bits() as f64 * lsb, lsb, format: "U52F12" }
}
