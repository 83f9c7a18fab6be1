//! Why a lamp could not be made.

use core::fmt;

use crate::real::Scalar;

/// Why a lamp, or a quantity of it, could not be made; holds the value in its own format, so that integer-only code
/// stays so, and displays the range allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RadiometryError<S> {
    /// The power is negative, NaN or infinite.
    Power(S),
    /// The area is not positive and finite.
    Area(S),
    /// The solid angle is not positive and finite.
    SolidAngle(S),
    /// A radius or a distance is not positive and finite, or a position leaves no distance.
    Length(S),
    /// The radius is greater than the distance: what is lit would be inside.
    Inside {
        /// The radius given.
        radius: S,
        /// The distance given, which is the greatest radius allowed.
        distance: S,
    },
    /// A colour is negative, NaN or infinite.
    Colour(S),
    /// The answer is greater than the format's greatest number.
    Overflow,
}

impl<S: Scalar> fmt::Display for RadiometryError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Power(value) => write!(f, "power is {}, allowed is any finite number from 0", value.exact()),
            Self::Area(value) => write!(f, "area is {}, allowed is any positive finite number", value.exact()),
            Self::SolidAngle(value) => {
                write!(f, "solid angle is {}, allowed is any positive finite number", value.exact())
            }
            Self::Length(value) => {
                write!(f, "radius or distance is {}, allowed is any positive finite number", value.exact())
            }
            Self::Inside { radius, distance } => {
                write!(f, "radius is {}, allowed is up to the distance {}", radius.exact(), distance.exact())
            }
            Self::Colour(value) => write!(f, "colour is {}, allowed is any finite number from 0", value.exact()),
            Self::Overflow => write!(f, "the answer is greater than the format's greatest number"),
        }
    }
}

impl<S: Scalar> core::error::Error for RadiometryError<S> {}
