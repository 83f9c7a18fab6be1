//! The number formats as a list.

use crate::real::Real;

/// One of the seven number formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// `f64` over libm.
    F64,
    /// `f32` over libm.
    F32,
    /// `micromath::F32`.
    Micromath,
    /// `half::f16`.
    F16,
    /// `fixed::types::I2F14`, Q28 accumulators.
    I2F14,
    /// `fixed::types::I2F30`, Q60 accumulators.
    I2F30,
    /// `fixed::types::I16F16`, Q32 accumulators.
    I16F16,
}

/// What is to be done in a format, once that is a type.
pub trait Visitor {
    /// What comes of it.
    type Output;
    /// Does it in the format `T`.
    fn visit<T: Real>(self) -> Self::Output;
}

impl Format {
    /// All formats, in the order of tables.
    pub const ALL: [Self; 7] =
        [Self::F64, Self::F32, Self::Micromath, Self::F16, Self::I2F14, Self::I2F30, Self::I16F16];

    /// Calls `visitor` with the format's type.
    pub fn visit<V: Visitor>(self, visitor: V) -> V::Output {
        match self {
            Self::F64 => visitor.visit::<f64>(),
            Self::F32 => visitor.visit::<f32>(),
            Self::Micromath => visitor.visit::<micromath::F32>(),
            Self::F16 => visitor.visit::<half::f16>(),
            Self::I2F14 => visitor.visit::<fixed::types::I2F14>(),
            Self::I2F30 => visitor.visit::<fixed::types::I2F30>(),
            Self::I16F16 => visitor.visit::<fixed::types::I16F16>(),
        }
    }

    /// The format of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// Name of the format.
    pub const fn name(self) -> &'static str {
        match self {
            Self::F64 => <f64 as Real>::NAME,
            Self::F32 => <f32 as Real>::NAME,
            Self::Micromath => <micromath::F32 as Real>::NAME,
            Self::F16 => <half::f16 as Real>::NAME,
            Self::I2F14 => <fixed::types::I2F14 as Real>::NAME,
            Self::I2F30 => <fixed::types::I2F30 as Real>::NAME,
            Self::I16F16 => <fixed::types::I16F16 as Real>::NAME,
        }
    }

    /// The raw bits of `value`, which the format must hold exactly, in as many low bits as it has.
    pub fn bits(self, value: f64) -> u64 {
        match self {
            Self::F64 => value.to_bits(),
            Self::F32 | Self::Micromath => (value as f32).to_bits().into(),
            Self::F16 => half::f16::from_f64(value).to_bits().into(),
            Self::I2F14 => (<fixed::types::I2F14 as Real>::from_f64(value).to_bits() as u16).into(),
            Self::I2F30 => (<fixed::types::I2F30 as Real>::from_f64(value).to_bits() as u32).into(),
            Self::I16F16 => (<fixed::types::I16F16 as Real>::from_f64(value).to_bits() as u32).into(),
        }
    }

    /// The number that some raw bits are, in as many low bits as the format has.
    pub fn value(self, bits: u64) -> f64 {
        match self {
            Self::F64 => f64::from_bits(bits),
            Self::F32 | Self::Micromath => f32::from_bits(bits as u32).into(),
            Self::F16 => half::f16::from_bits(bits as u16).to_f64(),
            Self::I2F14 => fixed::types::I2F14::from_bits(bits as i16).to_f64(),
            Self::I2F30 => fixed::types::I2F30::from_bits(bits as i32).to_f64(),
            Self::I16F16 => fixed::types::I16F16::from_bits(bits as i32).to_f64(),
        }
    }

    /// How many bits a number of the format has.
    pub const fn width(self) -> usize {
        match self {
            Self::F64 => 64,
            Self::F32 | Self::Micromath | Self::I2F30 | Self::I16F16 => 32,
            Self::F16 | Self::I2F14 => 16,
        }
    }

    /// The unit in the last place of numbers of the size of `value`; below a float format's least normal number the
    /// step of its subnormals, in fixed point the last bit.
    pub fn ulp(self, value: f64) -> f64 {
        let (precision, least_exponent) = match self {
            Self::F64 => (53, -1022),
            Self::F16 => (11, -14),
            Self::F32 | Self::Micromath => (24, -126),
            Self::I2F14 | Self::I2F30 | Self::I16F16 => return self.step(),
        };
        let exponent = libm::ilogb(value).max(least_exponent);
        libm::scalbn(1.0, exponent - precision + 1)
    }

    /// The step between numbers just below 1.
    pub const fn step(self) -> f64 {
        match self {
            Self::F64 => f64::EPSILON / 2.0,
            Self::F32 | Self::Micromath => (f32::EPSILON / 2.0) as f64,
            Self::F16 => 1.0 / 2048.0,
            Self::I2F14 => 1.0 / 16384.0,
            Self::I2F30 => 1.0 / 1_073_741_824.0,
            Self::I16F16 => 1.0 / 65536.0,
        }
    }
}
