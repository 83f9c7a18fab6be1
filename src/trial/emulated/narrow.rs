//! Floats of any precision up to f32's, in f16's and in f32's range.

use core::ops::{Add, Div, Mul, Sub};

use crate::real::float::{INVERSE_PI, PI, TWICE_PI};
use crate::real::{Constant, Float, STEEP_COSINE, Scalar};

/// A float of `DIGITS` digits of the significand (2 to 24, the hidden one included) and `EXPONENT` bits of the exponent
/// (5 or 8); where `FLUSHING`, numbers below the least normal one are zero. Where not `SCALED`, lengths are squared as
/// they are, without [`Float::SCALE`] and [`Float::TINY`].
///
/// Every operation is done in f64 and rounded to nearest, ties to even, once more. That gives what one rounding would:
/// a sum, product, quotient or root of numbers of `p` digits either is a tie or is farther from every tie than f64,
/// whose 53 digits are at least `2 p + 2`, can round it (S. Figueroa, "When is double rounding innocuous?", 1995).
/// Where the answer is subnormal, ties have fewer digits and lie farther apart: sums and products are exact in f64
/// there, and quotients keep their distance; no root is subnormal. `tests/emulated.rs` tries it against f16 and f32.
///
/// Flushed is what has been rounded; since constants and conversions flush as well, no argument is ever subnormal.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Narrow<const DIGITS: u32, const EXPONENT: u32, const FLUSHING: bool, const SCALED: bool = true>(f64);

/// f16 on hardware that flushes subnormals to zero, as many phones' GPUs do.
pub type FlushingF16 = Narrow<11, 5, true>;

/// The same without the scale that keeps squares normal.
pub type UnscaledF16 = Narrow<11, 5, true, false>;

/// `2^exponent`, of a normal f64.
const fn power(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

/// `2^exponent` in f16's range, `wide` in f32's.
const fn of_range<const EXPONENT: u32>(narrow: i32, wide: i32) -> f64 {
    power(if EXPONENT == 5 { narrow } else { wide })
}

impl<const DIGITS: u32, const EXPONENT: u32, const FLUSHING: bool, const SCALED: bool>
    Narrow<DIGITS, EXPONENT, FLUSHING, SCALED>
{
    /// The greatest power of two that is finite.
    const GREATEST_POWER: i32 = (1 << (EXPONENT - 1)) - 1;

    /// The least normal number.
    const LEAST: f64 = power(1 - Self::GREATEST_POWER);

    /// The greatest finite number.
    const GREATEST: f64 = power(Self::GREATEST_POWER) * (2.0 - power(1 - DIGITS as i32));

    /// Added and subtracted again, this leaves the step of subnormals as the last place.
    const SUBNORMAL: f64 = 1.5 * power(1 - Self::GREATEST_POWER - DIGITS as i32 + 53);

    /// The nearest number, ties to even.
    #[inline]
    const fn rounded(value: f64) -> Self {
        const { assert!(DIGITS >= 2 && DIGITS <= 24 && (EXPONENT == 5 || EXPONENT == 8)) }
        let size = value.abs();
        if size < Self::LEAST {
            return Self::below_normal(value, size);
        }
        let dropped = const { 53 - DIGITS };
        let bits = size.to_bits();
        // A significand that rounds up past its end carries into the exponent, as it should; infinity stays what it is.
        let up = (1 << (dropped - 1)) - 1 + ((bits >> dropped) & 1);
        let near = f64::from_bits((bits + up) & !((1 << dropped) - 1));
        if near <= Self::GREATEST {
            Self(near.copysign(value))
        } else if value.is_nan() {
            Self(f64::NAN)
        } else {
            Self(f64::INFINITY.copysign(value))
        }
    }

    /// The same of what is below the least normal number before it is rounded.
    #[inline]
    const fn below_normal(value: f64, size: f64) -> Self {
        let near = (size + Self::SUBNORMAL) - Self::SUBNORMAL;
        let flushed = if FLUSHING && near < Self::LEAST { 0.0 } else { near };
        Self(flushed.copysign(value))
    }

    /// A constant as its nearest number and what that lacks.
    const fn pair([value, low]: [f64; 2]) -> [Self; 2] {
        let high = Self::rounded(value);
        [high, Self::rounded((value - high.0) + low)]
    }
}

// A macro, since an operator is a trait each.
macro_rules! operator {
    ($operator:ident, $function:ident, $sign:tt) => {
        impl<const DIGITS: u32, const EXPONENT: u32, const FLUSHING: bool, const SCALED: bool> $operator
            for Narrow<DIGITS, EXPONENT, FLUSHING, SCALED>
        {
            type Output = Self;

            #[inline]
            fn $function(self, other: Self) -> Self {
                Self::rounded(self.0 $sign other.0)
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl<const DIGITS: u32, const EXPONENT: u32, const FLUSHING: bool, const SCALED: bool> Scalar
    for Narrow<DIGITS, EXPONENT, FLUSHING, SCALED>
{
    const ZERO: Self = Self(0.0);

    const ONE: Self = Self(1.0);

    const MAX: Self = Self(Self::GREATEST);

    // Of the range alone, as in f16 and f32.
    const NEAR_ONE: Option<[Constant; 2]> = Some(Constant::either_way(of_range::<EXPONENT>(12, 64)));

    #[inline]
    fn nearest(value: f64) -> Self {
        Self::rounded(value)
    }

    #[inline]
    fn exact(self) -> f64 {
        self.0
    }

    #[inline]
    fn constant(constant: Constant) -> Self {
        Self::rounded(constant.value())
    }

    #[inline]
    fn root(self) -> Self {
        Self::rounded(libm::sqrt(self.0))
    }

    // As f16 and f32 do: in a narrow range the squares might leave it.
    #[inline]
    fn hypotenuse(a: Self, b: Self) -> Self {
        if EXPONENT > 5 {
            return (a * a + b * b).root();
        }
        let (great, small) = if a > b { (a, b) } else { (b, a) };
        if great > Self::ZERO {
            let ratio = small / great;
            great * (Self::ONE + ratio * ratio).root()
        } else {
            Self::ZERO
        }
    }

    // By f32, as f16 does.
    #[inline]
    fn from_q31(bits: u32) -> Self {
        Self::rounded(f32::from_q31(bits).into())
    }

    #[inline]
    fn to_q31(self) -> u32 {
        self.0.to_q31()
    }
}

/// The constants follow from digits and range by the rules by which f16's and f32's are made, so that 11 digits and 5
/// bits, and 24 and 8, have the very same.
impl<const DIGITS: u32, const EXPONENT: u32, const FLUSHING: bool, const SCALED: bool> Float
    for Narrow<DIGITS, EXPONENT, FLUSHING, SCALED>
{
    const FORMAT: &'static str = "emulated float";

    const STEEP: [Self; 2] = [Self::rounded(-STEEP_COSINE), Self::rounded(STEEP_COSINE)];

    const SCALE: Self = if SCALED { Self::rounded(of_range::<EXPONENT>(6, 0)) } else { Self::ONE };

    const TINY: Self = if SCALED { Self::rounded(of_range::<EXPONENT>(-3, -30)) } else { Self::ONE };

    const SAFE_SQUARE: [Self; 2] =
        if EXPONENT == 5 { [Self(0.0625), Self(1024.0)] } else { [Self::rounded(1e-30), Self::rounded(1e30)] };

    const SPLITTER: Self = Self::rounded(power(DIGITS.div_ceil(2) as i32) + 1.0);

    const PI: [Self; 2] = Self::pair(PI);

    const TWICE_PI: [Self; 2] = Self::pair(TWICE_PI);

    const INVERSE_PI: [Self; 2] = Self::pair(INVERSE_PI);

    #[inline]
    fn over_root(length: Self, square: Self) -> Self {
        length / square.root()
    }
}
