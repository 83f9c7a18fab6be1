//! Numbers of a 16-bit mantissa and a power of two, whose products fit 32 bits.

use super::table;
use crate::real::{Scalar, Scaled};

/// Whether the machine counts no leading zeros and multiplies to 32 bits alone: Cortex-M0 and M0+.
const NARROW: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// `mantissa * 2^(exponent - 16)`: the mantissa is 0, or from `2^15` to `2^16 - 1`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Short {
    pub(super) mantissa: u32,
    pub(super) exponent: i32,
}

/// `mantissa * 2^(exponent - 32)`, not rounded yet and not always normalised.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Long {
    pub(super) mantissa: u32,
    pub(super) exponent: i32,
}

impl Short {
    /// The number nearest to `value`, which is not negative; what is above `2^33` counts as that, and of what is below
    /// `2^-46` bits are lost. For constants.
    pub(super) fn of(value: Scaled) -> Self {
        let fraction = if value < Scaled::ONE { 62 } else { 31 };
        let bits = value.to_unsigned(fraction);
        let free = bits.leading_zeros();
        let rounded = (bits.wrapping_shl(free) >> 48) as u32 + (bits.wrapping_shl(free) >> 47 & 1) as u32;
        let exponent = 64_i32.wrapping_sub(free as i32).wrapping_sub(fraction as i32);
        // Rounded up past its end.
        let over = rounded >> 16;
        Self { mantissa: rounded >> over, exponent: exponent.wrapping_add(over as i32) }
    }

    /// The product, to nearest or half a last place below it.
    #[inline(always)]
    pub(super) fn times(self, other: Self) -> Self {
        let Long { mantissa, exponent } = self.product(other);
        // No product of mantissas is so great that this wraps.
        let product = mantissa.wrapping_add(1 << 14);
        let top = product >> 31;
        Self { mantissa: (product >> 15) >> top, exponent: exponent.wrapping_sub(1).wrapping_add(top as i32) }
    }

    /// The product, exactly.
    #[inline(always)]
    pub(super) fn product(self, other: Self) -> Long {
        Long {
            mantissa: self.mantissa.wrapping_mul(other.mantissa),
            exponent: self.exponent.wrapping_add(other.exponent),
        }
    }

    /// The sum with a number that is not greater than this one, or hardly.
    #[inline(always)]
    pub(super) fn plus(self, smaller: Self) -> Self {
        let lower = self.exponent.wrapping_sub(smaller.exponent).clamp(0, 31);
        let sum = self.mantissa.wrapping_add(smaller.mantissa >> lower);
        let over = sum >> 16;
        Self { mantissa: sum.wrapping_add(over) >> over, exponent: self.exponent.wrapping_add(over as i32) }
    }

    /// One over it, within 1.3e-5; 0 for 0.
    #[inline(always)]
    pub(super) fn reciprocal(self) -> Self {
        Self { mantissa: table::reciprocal(self.mantissa), exponent: 1_i32.wrapping_sub(self.exponent) }
    }
}

impl Long {
    /// Shifted to the left until its first bit is set; zero has an exponent 31 below.
    #[inline(always)]
    pub(super) fn normalised(self) -> Self {
        let (mantissa, free) = normalised(self.mantissa);
        Self { mantissa, exponent: self.exponent.wrapping_sub(free as i32) }
    }

    /// The nearest number of 16 bits, of one that is normalised.
    #[inline(always)]
    pub(super) fn short(self) -> Short {
        Short { mantissa: self.mantissa.saturating_add(1 << 15) >> 16, exponent: self.exponent }
    }

    /// The mantissa that it has with a greater exponent.
    #[inline(always)]
    pub(super) fn at(self, exponent: i32) -> u32 {
        self.mantissa >> (exponent.wrapping_sub(self.exponent).clamp(0, 31) as u32)
    }

    /// The sum, of at least the normalised greater one's exponent; less than `2^32`.
    #[inline(always)]
    pub(super) fn plus(self, other: Self) -> Self {
        let exponent = self.exponent.max(other.exponent).wrapping_add(1);
        Self { mantissa: self.at(exponent).wrapping_add(other.at(exponent)), exponent }
    }

    /// The square root of a number whose mantissa is at least `2^29`, or, where its exponent is even, `2^28`: within
    /// 3.1e-5.
    #[inline(always)]
    pub(super) fn root(self) -> Short {
        let odd = self.exponent & 1;
        let mut mantissa = self.mantissa >> odd;
        let mut exponent = self.exponent.wrapping_add(odd) >> 1;
        if mantissa < 1 << 30 {
            mantissa <<= 2;
            exponent = exponent.wrapping_sub(1);
        }
        Short { mantissa: table::root(mantissa), exponent }
    }
}

/// `bits * 2^zeros` with the first bit set, and the zeros before; 31 of them for 0.
#[inline(always)]
pub(super) fn normalised(bits: u32) -> (u32, u32) {
    if NARROW {
        return by_comparing(bits);
    }
    let zeros = (bits | 1).leading_zeros();
    (bits << zeros, zeros)
}

#[inline(always)]
fn by_comparing(mut bits: u32) -> (u32, u32) {
    let mut zeros = 0;
    if bits >> 16 == 0 {
        (bits, zeros) = (bits << 16, 16);
    }
    if bits >> 24 == 0 {
        (bits, zeros) = (bits << 8, zeros | 8);
    }
    if bits >> 28 == 0 {
        (bits, zeros) = (bits << 4, zeros | 4);
    }
    if bits >> 30 == 0 {
        (bits, zeros) = (bits << 2, zeros | 2);
    }
    if bits >> 31 == 0 {
        (bits, zeros) = (bits << 1, zeros | 1);
    }
    (bits, zeros)
}

/// `a b / 2^16`, cut, of a `b` below `2^16`.
#[inline(always)]
pub(super) fn share(a: u32, b: u32) -> u32 {
    if NARROW { share_of_halves(a, b) } else { ((u64::from(a) * u64::from(b)) >> 16) as u32 }
}

#[inline(always)]
fn share_of_halves(a: u32, b: u32) -> u32 {
    (a >> 16).wrapping_mul(b).wrapping_add((a & 0xffff).wrapping_mul(b) >> 16)
}
