//! An integer times a power of two: what fixed point computes with where no Q format is wide enough.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Sub};

use super::{Constant, Scalar};
use crate::reciprocal::fraction_of_reciprocal;
use crate::root::fraction_of_reciprocal_root;

/// A 31-bit mantissa and a sign, Q31 in [1/2, 1), times a power of two. Integer arithmetic alone.
///
/// Sums and products are rounded to nearest: within 0.5 units of the last place, which is `2^-30` of the value or less.
/// Quotients and roots are within 0.77, by and of a power of two exact (`tests/scaled.rs`, `tests/exhaustive.rs`).
/// There is no NaN and no infinity: what is divided by zero is [`Scalar::MAX`] or its negative (zero for zero), and the
/// root of a negative number is zero.
///
/// Exponents have 32 bits. `MAX` is `2^(2^20)`, a thousand times the exponent of f64's greatest number; it takes
/// eleven squarings of it in a row to leave the range, upon which exponents wrap. Numbers below `2^-(2^24)` may
/// count as zero in sums and comparisons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scaled {
    /// Zero, or of a size from `2^30` to `2^31 - 1`.
    mantissa: i32,
    exponent: i32,
}

/// So small that nothing is lost by adding it.
const ZERO: Scaled = Scaled { mantissa: 0, exponent: -(1 << 24) };

const MAX: Scaled = Scaled { mantissa: i32::MAX, exponent: 1 << 20 };

impl Scaled {
    /// `bits * 2^exponent`, to nearest.
    #[inline]
    pub const fn from_bits(bits: i64, exponent: i32) -> Self {
        let free = bits.unsigned_abs().leading_zeros();
        // The lowest number of all has no room for its sign; one less is as near as the mantissa can tell.
        if free == 0 {
            return Self::from_bits(bits.wrapping_add(1), exponent);
        }
        if bits == 0 {
            return ZERO;
        }
        let aligned = bits << (free - 1);
        let mantissa = (aligned >> 32) + ((aligned >> 31) & 1);
        let exponent = exponent.wrapping_add(64 - free as i32);
        // Rounded up past its end.
        let over = mantissa == 1 << 31 || mantissa == -(1 << 31);
        if over {
            Self { mantissa: (mantissa / 2) as i32, exponent: exponent.wrapping_add(1) }
        } else {
            Self { mantissa: mantissa as i32, exponent }
        }
    }

    /// `bits * 2^exponent`, to nearest but that the last bit of numbers with 64 does not break ties.
    #[inline]
    pub const fn from_unsigned(bits: u64, exponent: i32) -> Self {
        // The bit that is lost of numbers with 64 is far below the mantissa's last.
        if bits >> 63 == 0 {
            Self::from_bits(bits as i64, exponent)
        } else {
            Self::from_bits((bits >> 1) as i64, exponent.wrapping_add(1))
        }
    }

    /// The number nearest to `value`; zero for NaN, [`Scalar::MAX`] or its negative for infinities. For constants.
    pub const fn new(value: f64) -> Self {
        let bits = value.to_bits();
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let magnitude = match (bits >> 52) & 0x7ff {
            0x7ff if fraction != 0 => return ZERO,
            0x7ff => MAX,
            0 => Self::from_bits(fraction, -1074),
            exponent => Self::from_bits(fraction | (1 << 52), exponent as i32 - 1075),
        };
        if value < 0.0 { magnitude.negative() } else { magnitude }
    }

    /// The value times `2^fraction` as an integer, to nearest, halves upwards; saturates.
    #[inline]
    pub const fn to_bits(self, fraction: u32) -> i64 {
        let mantissa = self.mantissa as i64;
        match self.places_below(fraction) {
            shift @ 1..=32 => (mantissa >> shift) + ((mantissa >> (shift - 1)) & 1),
            shift @ -32..=0 => mantissa << -shift,
            shift if shift > 0 || mantissa == 0 => 0,
            _ if mantissa < 0 => i64::MIN,
            _ => i64::MAX,
        }
    }

    /// The value times `2^fraction` as an unsigned integer, to nearest; zero for negative values, saturates.
    #[inline]
    pub const fn to_unsigned(self, fraction: u32) -> u64 {
        let mantissa = if self.mantissa > 0 { self.mantissa as u64 } else { 0 };
        match self.places_below(fraction) {
            shift @ 1..=32 => (mantissa >> shift) + ((mantissa >> (shift - 1)) & 1),
            shift @ -33..=0 => mantissa << -shift,
            shift if shift > 0 || mantissa == 0 => 0,
            _ => u64::MAX,
        }
    }

    /// The mantissa in Q31 and the exponent, for digests.
    #[cfg(feature = "oracle")]
    pub(crate) const fn parts(self) -> (i32, i32) {
        (self.mantissa, self.exponent)
    }

    /// How many of the mantissa's bits lie below `2^-fraction`.
    #[inline]
    const fn places_below(self, fraction: u32) -> i32 {
        31_i32.wrapping_sub(fraction as i32).wrapping_sub(self.exponent)
    }

    #[inline]
    const fn negative(self) -> Self {
        Self { mantissa: self.mantissa.wrapping_neg(), ..self }
    }

    /// The mantissa times 1 and a `fraction` in Q32, which together are 33 bits: Q62, and more than its last bit is not
    /// lost.
    #[inline]
    fn times_one_and(self, fraction: u32) -> i64 {
        let mantissa = i64::from(self.mantissa);
        (mantissa << 31).wrapping_add(mantissa.wrapping_mul(fraction.into()) >> 1)
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        let (great, small) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let lower = great.exponent.wrapping_sub(small.exponent);
        // Negative only where exponents have wrapped.
        if !(0..=33).contains(&lower) {
            return great;
        }
        let sum = (i64::from(great.mantissa) << 31) + (i64::from(small.mantissa) << 31).wrapping_shr(lower as u32);
        Self::from_bits(sum, great.exponent.wrapping_sub(62))
    }

    /// Negated where `other` is negative.
    #[inline]
    fn signed_by(self, other: Self) -> Self {
        if other.mantissa < 0 { self.negative() } else { self }
    }
}

impl Add for Scaled {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        self.plus(other)
    }
}

impl Sub for Scaled {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self.plus(other.negative())
    }
}

impl Mul for Scaled {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let product = i64::from(self.mantissa) * i64::from(other.mantissa);
        Self::from_bits(product, self.exponent.wrapping_add(other.exponent).wrapping_sub(62))
    }
}

impl Div for Scaled {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        match (self.mantissa, other.mantissa) {
            (0, _) => ZERO,
            (_, 0) => MAX.signed_by(self),
            _ => {
                let quotient = self.times_one_and(fraction_of_reciprocal(other.mantissa.unsigned_abs()));
                let exponent = self.exponent.wrapping_sub(other.exponent).wrapping_sub(62);
                Self::from_bits(quotient, exponent).signed_by(other)
            }
        }
    }
}

impl PartialOrd for Scaled {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        (*self - *other).mantissa.partial_cmp(&0)
    }
}

impl Scalar for Scaled {
    const ZERO: Self = ZERO;

    const ONE: Self = Self::new(1.0);

    const MAX: Self = MAX;

    const NEAR_ONE: Option<[Constant; 2]> = None;

    fn nearest(value: f64) -> Self {
        Self::new(value)
    }

    fn exact(self) -> f64 {
        libm::scalbn(f64::from(self.mantissa), self.exponent.saturating_sub(31))
    }

    #[inline]
    fn constant(constant: Constant) -> Self {
        constant.scaled()
    }

    #[inline]
    fn root(self) -> Self {
        if self.mantissa <= 0 {
            return ZERO;
        }
        // An even exponent leaves the mantissa in [1/4, 1) of 32 bits.
        let odd = self.exponent & 1;
        let fraction = fraction_of_reciprocal_root(self.mantissa.unsigned_abs() << (1 - odd));
        let half = self.exponent.wrapping_add(odd) / 2;
        Self::from_bits(self.times_one_and(fraction), self.exponent.wrapping_sub(half).wrapping_sub(62))
    }

    #[inline]
    fn from_q31(bits: u32) -> Self {
        Self::from_bits(bits.into(), -31)
    }

    #[inline]
    fn to_q31(self) -> u32 {
        u32::try_from(self.to_unsigned(31)).unwrap_or(u32::MAX)
    }

    #[inline]
    fn hypotenuse(a: Self, b: Self) -> Self {
        (a * a + b * b).root()
    }
}
