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
    ///
    /// ```
    /// use sunglint::{Scalar, half::f16};
    ///
    /// assert_eq!(f16::nearest(0.1).to_bits(), 0x2e66);
    /// assert_eq!(f16::nearest(1e6), f16::INFINITY);
    /// ```
    fn nearest(value: f64) -> Self;

    /// The exact value; infinite for a [`Scaled`](super::Scaled) beyond f64's range.
    ///
    /// ```
    /// use sunglint::Scalar;
    ///
    /// // What f32 makes of a tenth.
    /// assert_eq!(0.1_f32.exact(), 0.100_000_001_490_116_12);
    /// ```
    fn exact(self) -> f64;

    /// A number that is known at compile time; brings no f64 arithmetic into integer-only code.
    ///
    /// ```
    /// use sunglint::real::{Constant, Scaled};
    /// use sunglint::{Scalar, half::f16};
    ///
    /// const PI: Constant = Constant::new(core::f64::consts::PI);
    /// assert_eq!(f32::constant(PI), core::f32::consts::PI);
    /// assert_eq!(f16::constant(PI), f16::PI);
    /// assert_eq!(Scaled::constant(PI).to_bits(16), 205_887);
    /// ```
    fn constant(constant: Constant) -> Self;

    /// The square root; zero for zero, NaN or zero for negatives. Correctly rounded in f64, f32 and f16; a micromath root
    /// is a bit trick and two Newton steps, off by up to 6e-6; [`Scaled`](super::Scaled) within 0.77 units of the last
    /// place (`tests/scaled.rs`).
    ///
    /// ```
    /// use sunglint::{Scalar, real::Scaled};
    ///
    /// assert_eq!(Scaled::new(0.25).root(), Scaled::new(0.5));
    /// assert_eq!(Scaled::new(-1.0).root(), Scaled::ZERO);
    /// assert!((-1.0_f32).root().is_nan());
    /// ```
    fn root(self) -> Self;

    /// `sqrt(a^2 + b^2)` of numbers that are not negative. Without their squares, which in a format of few exponents
    /// may leave its range; formats that have enough of them add the squares.
    ///
    /// ```
    /// use sunglint::{Scalar, half::f16};
    ///
    /// let [a, b, c] = [300.0, 400.0, 500.0].map(f16::from_f32);
    /// assert_eq!(f16::hypotenuse(a, b), c);
    /// assert_eq!(a * a, f16::INFINITY);
    /// ```
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

    /// `bits / 2^31`, to nearest (f16: of the nearest f32): how integers become fractions of 1, as no cast of a narrow
    /// format can.
    ///
    /// ```
    /// use sunglint::{Scalar, real::Scaled};
    ///
    /// assert_eq!(f32::from_q31(1 << 30), 0.5);
    /// assert_eq!(Scaled::from_q31(3 << 30), Scaled::new(1.5));
    /// ```
    fn from_q31(bits: u32) -> Self;

    /// `self * 2^31` for sums in integers: without its fraction of floats, to nearest of [`Scaled`](super::Scaled).
    /// Saturates at zero and below 2. NaN is zero.
    ///
    /// ```
    /// use sunglint::Scalar;
    ///
    /// assert_eq!(0.75_f32.to_q31(), 3 << 29);
    /// assert_eq!([-1.0, f32::NAN, 9.0].map(Scalar::to_q31), [0, 0, u32::MAX]);
    /// ```
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
    ///
    /// ```
    /// use sunglint::real::{Constant, Scalar};
    ///
    /// const THIRD: Constant = Constant::new(1.0 / 3.0);
    /// assert_eq!([f32::constant(THIRD), 1.0 / 3.0], [0.333_333_34; 2]);
    /// ```
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
    ///
    /// ```
    /// use sunglint::real::Constant;
    ///
    /// assert_eq!(Constant::new(0.1).value(), 0.1);
    /// ```
    pub const fn value(self) -> f64 {
        self.value
    }

    /// The same as an integer and a power of two.
    ///
    /// ```
    /// use sunglint::Scalar;
    /// use sunglint::real::Constant;
    ///
    /// // 31 bits of a tenth: within half of the last, which is 2^-34.
    /// assert!((Constant::new(0.1).scaled().exact() - 0.1).abs() <= 2_f64.powi(-35));
    /// ```
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
