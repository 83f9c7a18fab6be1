//! Number formats that no type has, emulated: fixed point of any number of fraction bits, floats of any precision and
//! range, with and without flushing of subnormals.

mod fixed_point;
mod narrow;

use core::fmt;

pub use fixed_point::FixedPoint;
pub use narrow::{FlushingF16, Narrow, UnscaledF16};

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

// A macro, since what makes a type has to be written out: the list and the match are of the same words.
macro_rules! words {
    ($([$fraction:literal])* $(($digits:literal, $exponent:literal, $flushing:literal))*) => {
        impl Word {
            /// All words that are tried: of a family, which is fixed point or floats of one range, the shorter first.
            pub const ALL: &[Self] = &[
                $(Self::Fixed { fraction: $fraction },)*
                $(Self::Float { digits: $digits, exponent: $exponent, flushing: $flushing },)*
            ];

            /// Calls `visitor` with a type that computes in the word by the formulas that all formats share; nothing
            /// where the word is none of [`Word::ALL`].
            pub fn visit<V: Visitor>(self, visitor: V) -> Option<V::Output> {
                match self {
                    $(Self::Fixed { fraction: $fraction } => Some(visitor.visit::<FixedPoint<$fraction>>()),)*
                    $(Self::Float { digits: $digits, exponent: $exponent, flushing: $flushing } => {
                        Some(visitor.visit::<Narrow<$digits, $exponent, $flushing>>())
                    })*
                    _ => None,
                }
            }
        }
    };
}

words! {
    [8] [10] [12] [13] [14] [15] [16] [18] [20] [22] [24] [26] [28] [30]
    (8, 5, false) (9, 5, false) (10, 5, false) (11, 5, false) (12, 5, false) (13, 5, false) (14, 5, false)
    (8, 8, false) (9, 8, false) (10, 8, false) (11, 8, false) (12, 8, false) (13, 8, false) (14, 8, false)
    (16, 8, false) (18, 8, false) (20, 8, false) (22, 8, false) (24, 8, false)
    (8, 5, true) (9, 5, true) (10, 5, true) (11, 5, true) (12, 5, true) (13, 5, true) (14, 5, true)
    (8, 8, true) (11, 8, true) (16, 8, true) (24, 8, true)
}

impl Word {
    /// The format that is this word, if one is; I2F14 and I2F30 compute some of it by hand, not by the formulas.
    pub const fn format(self) -> Option<Format> {
        match self {
            Self::Fixed { fraction: 14 } => Some(Format::I2F14),
            Self::Fixed { fraction: 30 } => Some(Format::I2F30),
            Self::Float { digits: 24, exponent: 8, flushing: false } => Some(Format::F32),
            Self::Float { digits: 11, exponent: 5, flushing: false } => Some(Format::F16),
            _ => None,
        }
    }

    /// Fraction bits, or digits of the significand.
    pub const fn digits(self) -> u32 {
        match self {
            Self::Fixed { fraction } => fraction,
            Self::Float { digits, .. } => digits,
        }
    }

    /// How many bits a number has in all.
    pub const fn width(self) -> u32 {
        match self {
            Self::Fixed { fraction } => fraction + 2,
            // The sign takes the place of the hidden digit.
            Self::Float { digits, exponent, .. } => digits + exponent,
        }
    }

    /// The step between numbers just below 1.
    pub fn step(self) -> f64 {
        libm::scalbn(1.0, -(self.digits() as i32))
    }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fixed { fraction } => write!(f, "Q{fraction} in {} bits", self.width()),
            Self::Float { digits, exponent, flushing } => {
                let flushing = if *flushing { ", flushing" } else { "" };
                write!(f, "p {digits}, e {exponent}{flushing}")
            }
        }
    }
}
