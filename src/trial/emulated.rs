//! Number formats that no type has, emulated: fixed point of any number of fraction bits, floats of any precision and
//! range, with and without flushing of subnormals.

mod fixed_point;
mod narrow;

use core::fmt;

pub use fixed_point::FixedPoint;
pub use narrow::Narrow;

use super::format::{Format, Visitor};

/// A word length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// Fixed point of 2 integer bits with this many fraction bits, 6 to 30, in as many bits as that takes.
    Fixed {
        /// Fraction bits.
        fraction: u32,
    },
    /// A float.
    Float {
        /// Digits of the significand, the hidden one included: 8 to 24.
        digits: u32,
        /// Bits of the exponent: 5 or 8.
        exponent: u32,
        /// Whether subnormal arguments and results of every operation are zero.
        flushing: bool,
    },
}

impl Word {
    /// Calls `visitor` with the word's type; nothing where there is none.
    pub fn visit<V: Visitor>(self, visitor: V) -> Option<V::Output> {
        self.format().map(|format| format.visit(visitor))
    }

    /// The format that is this word, if one is.
    pub fn format(self) -> Option<Format> {
        match self {
            Self::Fixed { fraction: 14 } => Some(Format::I2F14),
            Self::Fixed { fraction: 30 } => Some(Format::I2F30),
            Self::Float { digits: 24, exponent: 8, flushing: false } => Some(Format::F32),
            Self::Float { digits: 11, exponent: 5, flushing: false } => Some(Format::F16),
            _ => None,
        }
    }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fixed { fraction } => write!(f, "Q{fraction}"),
            Self::Float { digits, exponent, flushing } => {
                let flushing = if *flushing { " flushing" } else { "" };
                write!(f, "p{digits} e{exponent}{flushing}")
            }
        }
    }
}
