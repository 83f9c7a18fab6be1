//! The numbers that shading computes with once directions have become cosines.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Sub};

#[cfg(feature = "fixed")]
use super::Scaled;

/// A number of wide range: the float format itself, or [`Scaled`](super::Scaled) integers beside fixed-point lanes.
///
/// A highlight of width `alpha` spans `alpha^4` to `1 / alpha^2`, more than any Q format of 32 or 64 bits holds to one
/// per cent, so fixed point carries its exponent along.
pub trait Scalar:
    'static + Copy + PartialOrd + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// 0.
    const ZERO: Self;

    /// 1.
    const ONE: Self;

    /// The greatest finite number.
    const MAX: Self;

    /// A power of two and one over it: neither numbers between them nor their reciprocals, times a number about 1,
    /// leave the format's range, subnormal numbers included. None where no number of a formula can leave it.
    const NEAR_ONE: Option<[Constant; 2]>;

    /// The nearest value of the format.
    fn nearest(value: f64) -> Self;

    /// The exact value.
    fn exact(self) -> f64;

    /// A number that is known at compile time; brings no f64 arithmetic into integer-only code.
    fn constant(constant: Constant) -> Self;

    /// The square root; zero for zero, NaN or zero for negatives.
    fn root(self) -> Self;

    /// `sqrt(a^2 + b^2)` of numbers that are not negative. Without their squares, which in a format of few exponents
    /// may leave its range; formats that have enough of them add the squares.
    #[inline]
    fn hypotenuse(a: Self, b: Self) -> Self {
        let (great, small) = if a > b { (a, b) } else { (b, a) };
        if great > Self::ZERO {
            let ratio = small / great;
            great * (Self::ONE + ratio * ratio).root()
        } else {
            Self::ZERO
        }
    }

    /// `bits / 2^31`, to nearest: how integers become fractions of 1, as no cast of a narrow format can.
    fn from_q31(bits: u32) -> Self;

    /// `self * 2^31` without its fraction, for sums in integers; saturates at zero and below 2. NaN is zero.
    fn to_q31(self) -> u32;
}

/// A number known at compile time, in every format that it may be needed in.
///
/// ```
/// use sunglint::real::{Constant, Scalar};
///
/// fn half<S: Scalar>(value: S) -> S {
///     const HALF: Constant = Constant::new(0.5);
///     value * S::constant(HALF)
/// }
/// assert_eq!(half(3.0_f32), 1.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant {
    value: f64,
    #[cfg(feature = "fixed")]
    scaled: Scaled,
}

impl Constant {
    /// The constant nearest to `value`.
    pub const fn new(value: f64) -> Self {
        Self {
            value,
            #[cfg(feature = "fixed")]
            scaled: Scaled::new(value),
        }
    }

    /// A power of two and one over it.
    pub(crate) const fn either_way(power: f64) -> [Self; 2] {
        [Self::new(power), Self::new(1.0 / power)]
    }

    /// The value that it was made of.
    pub const fn value(self) -> f64 {
        self.value
    }

    /// The same as an integer and a power of two.
    #[cfg(feature = "fixed")]
    pub const fn scaled(self) -> Scaled {
        self.scaled
    }
}

/// The value alone.
#[cfg(feature = "defmt")]
impl defmt::Format for Constant {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=f64}", self.value);
    }
}

/// The value alone.
#[cfg(feature = "serde")]
impl serde::Serialize for Constant {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(self.value)
    }
}

/// The constant nearest to the number read.
#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Constant {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        f64::deserialize(deserializer).map(Self::new)
    }
}

/// 1/2.
pub(crate) const HALF: Constant = Constant::new(0.5);

/// 1/pi.
pub(crate) const INVERSE_PI: Constant = Constant::new(core::f64::consts::FRAC_1_PI);

/// Whether a number is above zero; false for NaN.
#[inline]
pub(crate) fn positive<S: Scalar>(value: S) -> bool {
    value > S::ZERO
}

/// The lesser of two numbers; `limit` where `value` is NaN.
#[inline]
pub(crate) fn at_most<S: Scalar>(value: S, limit: S) -> S {
    if value < limit { value } else { limit }
}

/// The nearest number of 0 to 1; 0 for NaN.
#[inline]
pub(crate) fn within_one<S: Scalar>(value: S) -> S {
    if value > S::ONE {
        S::ONE
    } else if value > S::ZERO {
        value
    } else {
        S::ZERO
    }
}
