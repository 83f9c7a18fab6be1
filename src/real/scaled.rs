//! An integer times a power of two: what fixed point computes with where no Q format is wide enough.

mod integers;
mod sum;

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Sub};

use super::{Constant, Scalar};
use crate::multiply::{signed, wide};
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
/// eleven squarings of it in a row to leave the range, upon which exponents wrap. Numbers below `2^-(2^24)`, which no
/// formula reaches, may count as zero in sums, and sums of them with zero need not be the number itself.
#[repr(C)]
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
    /// The mantissa in Q31 and the exponent, for digests.
    #[cfg(feature = "oracle")]
    pub(crate) const fn parts(self) -> (i32, i32) {
        (self.mantissa, self.exponent)
    }

    #[inline]
    const fn negative(self) -> Self {
        Self { mantissa: self.mantissa.wrapping_neg(), ..self }
    }

    /// `bits * 2^exponent` of a size from `2^(29 + PLACES)` to that of a mantissa times `2^PLACES`, rounded to nearest,
    /// halves upwards.
    #[inline]
    fn near<const PLACES: u32>(bits: i64, exponent: i32) -> Self {
        let high = (bits >> 32) as i32;
        // Whether the first bit differs from the sign.
        if (high ^ (high << (33 - PLACES))) < 0 {
            let mantissa = bits.wrapping_add(1 << (PLACES - 1)) >> PLACES;
            return Self { mantissa: mantissa as i32, exponent: exponent.wrapping_add(31 + PLACES as i32) };
        }
        let mantissa = (bits.wrapping_add(1 << (PLACES - 2)) >> (PLACES - 1)) as i32;
        let exponent = exponent.wrapping_add(30 + PLACES as i32);
        // Rounded up past its end.
        if mantissa == i32::MIN {
            Self { mantissa: if high < 0 { -(1 << 30) } else { 1 << 30 }, exponent: exponent.wrapping_add(1) }
        } else {
            Self { mantissa, exponent }
        }
    }

    /// The mantissa times 1 and a `fraction` in Q32, which together are 33 bits: Q62, and more than its last bit is not
    /// lost.
    #[inline]
    fn times_one_and(self, fraction: u32) -> i64 {
        // What reading the mantissa as unsigned adds.
        let excess = i64::from(fraction & (self.mantissa >> 31) as u32) << 32;
        let product = (wide(self.mantissa as u32, fraction) as i64).wrapping_sub(excess);
        (i64::from(self.mantissa) << 31).wrapping_add(product >> 1)
    }

    /// Negated where `other` is negative.
    #[inline]
    fn signed_by(self, other: Self) -> Self {
        if other.mantissa < 0 { self.negative() } else { self }
    }
}

/// `mantissa * 2^exponent`, both integers: whole, and without a conversion that a chip without an FPU would compute.
#[cfg(feature = "defmt")]
impl defmt::Format for Scaled {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=i32} * 2^{=i32}", self.mantissa, self.exponent.wrapping_sub(31));
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
        let product = signed(self.mantissa, other.mantissa);
        if product == 0 {
            return ZERO;
        }
        Self::near::<31>(product, self.exponent.wrapping_add(other.exponent).wrapping_sub(62))
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
                Self::near::<32>(quotient, exponent).signed_by(other)
            }
        }
    }
}

impl PartialOrd for Scaled {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let (a, b) = (self, other);
        Some(if a.mantissa > 0 && b.mantissa > 0 {
            (a.exponent, a.mantissa).cmp(&(b.exponent, b.mantissa))
        } else if a.mantissa < 0 && b.mantissa < 0 {
            (b.exponent, a.mantissa).cmp(&(a.exponent, b.mantissa))
        } else {
            a.mantissa.cmp(&b.mantissa)
        })
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
        Self::near::<32>(self.times_one_and(fraction), self.exponent.wrapping_sub(half).wrapping_sub(62))
    }

    #[inline]
    fn from_q31(bits: u32) -> Self {
        Self::from_unsigned(bits.into(), -31)
    }

    #[inline]
    fn to_q31(self) -> u32 {
        self.to_u32(31)
    }

    #[inline]
    fn hypotenuse(a: Self, b: Self) -> Self {
        (a * a + b * b).root()
    }
}
