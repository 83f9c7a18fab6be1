//! Numbers of a 16-bit mantissa and a power of two, whose products fit 32 bits.

use super::table;
use crate::real::{Scalar, Scaled};

/// Whether the machine counts no leading zeros and multiplies to 32 bits alone: Cortex-M0 and M0+.
const NARROW: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// `mantissa * 2^(exponent - 16)`: the mantissa is below `2^16`, and a constant's 0 or at least `2^15`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
    /// The number nearest to `value`, which is not negative and below `2^64`; what is below `2^-46` loses bits. For
    /// constants.
    pub(super) fn of(value: Scaled) -> Self {
        let fraction = match value {
            small if small < Scaled::ONE => 62,
            middle if middle < Scaled::from_bits(1, 32) => 31,
            _ => 0,
        };
        let bits = value.to_unsigned(fraction);
        let free = bits.leading_zeros();
        let rounded = (bits.wrapping_shl(free) >> 48) as u32 + (bits.wrapping_shl(free) >> 47 & 1) as u32;
        let exponent = 64_i32.wrapping_sub(free as i32).wrapping_sub(fraction as i32);
        // Rounded up past its end.
        let over = rounded >> 16;
        Self { mantissa: rounded >> over, exponent: exponent.wrapping_add(over as i32) }
    }

    /// The product, cut to 16 bits; of them the first is lost at each product of a chain.
    #[inline(always)]
    pub(super) fn times(self, other: Self) -> Self {
        self.product(other).short()
    }

    /// The product, exactly.
    #[inline(always)]
    pub(super) fn product(self, other: Self) -> Long {
        Long {
            mantissa: self.mantissa.wrapping_mul(other.mantissa),
            exponent: self.exponent.wrapping_add(other.exponent),
        }
    }

    /// Half the sum with a number that is not greater than this one.
    #[inline(always)]
    pub(super) fn mean(self, smaller: Self) -> Self {
        let lower = distance(self.exponent, smaller.exponent);
        Self { mantissa: self.mantissa.wrapping_add(smaller.mantissa >> lower) >> 1, exponent: self.exponent }
    }

    /// One over a number whose mantissa has its first bit set, within 3.1e-5.
    #[inline(always)]
    pub(super) fn reciprocal(self) -> Self {
        Self { mantissa: table::reciprocal(self.mantissa), exponent: 1_i32.wrapping_sub(self.exponent) }
    }
}

impl Long {
    /// Shifted to the left until the first bit is set, or `MOST` times, which is 31, 15, 7 or 3.
    #[inline(always)]
    pub(super) fn normalised<const MOST: u32>(self) -> Self {
        let (mantissa, free) = normalised::<MOST>(self.mantissa);
        Self { mantissa, exponent: self.exponent.wrapping_sub(free as i32) }
    }

    /// Cut to 16 bits.
    #[inline(always)]
    pub(super) fn short(self) -> Short {
        Short { mantissa: self.mantissa >> 16, exponent: self.exponent }
    }

    /// The mantissa that it has with an exponent that is not less.
    #[inline(always)]
    pub(super) fn at(self, exponent: i32) -> u32 {
        self.mantissa >> distance(exponent, self.exponent)
    }

    /// The sum, whose exponent is one above the greater of the two.
    #[inline(always)]
    pub(super) fn plus(self, other: Self) -> Self {
        let exponent = self.exponent.max(other.exponent).wrapping_add(1);
        Self { mantissa: self.at(exponent).wrapping_add(other.at(exponent)), exponent }
    }

    /// The square root of a number that is normalised, within 3.1e-5.
    #[inline(always)]
    pub(super) fn root(self) -> Short {
        let odd = self.exponent as u32 & 1;
        let exponent = self.exponent.wrapping_add(1) >> 1;
        Short { mantissa: table::root(self.mantissa, odd), exponent }
    }
}

/// How many bits to shift by from an exponent to a greater one; 31 where all are lost.
#[inline(always)]
pub(super) fn distance(greater: i32, exponent: i32) -> u32 {
    greater.wrapping_sub(exponent).clamp(0, 31) as u32
}

/// `bits * 2^zeros` with the first bit set, and the zeros before; but at most `MOST` zeros, which is 31, 15, 7 or 3.
#[inline(always)]
pub(super) fn normalised<const MOST: u32>(bits: u32) -> (u32, u32) {
    if NARROW {
        return by_table::<MOST>(bits);
    }
    let zeros = (bits | const { 1 << (31 - MOST) }).leading_zeros();
    (bits << zeros, zeros)
}

/// The same where there is no instruction that counts zeros: sets all bits below the first, which leaves 32 numbers to
/// tell apart.
#[inline(always)]
fn by_table<const MOST: u32>(bits: u32) -> (u32, u32) {
    let below = const { 31 - MOST };
    let mut filled = bits >> below;
    filled |= filled >> 1;
    filled |= filled >> 2;
    if MOST > 3 {
        filled |= filled >> 4;
    }
    if MOST > 7 {
        filled |= filled >> 8;
    }
    if MOST > 15 {
        filled |= filled >> 16;
    }
    // One of `below` to 31, hence no difference below zero and none above 31.
    let zeros = u32::from(ZEROS[(filled.wrapping_mul(TELLS_APART) >> 27) as usize]).wrapping_sub(below) & 31;
    (bits << zeros, zeros)
}

/// Times this, the 32 numbers `2^k - 1` from `k = 1` on differ in their top five bits, and the first has none of them,
/// as zero.
const TELLS_APART: u32 = 0x07cd_d22b;

/// Zeros before a number, by those five bits.
static ZEROS: [u8; 32] = zeros();

const fn zeros() -> [u8; 32] {
    let mut table = [0; 32];
    let mut zeros = 0;
    while zeros < 32 {
        table[((u32::MAX >> zeros).wrapping_mul(TELLS_APART) >> 27) as usize] = zeros as u8;
        zeros += 1;
    }
    table
}

/// `a b / 2^16`, cut, of a `b` below `2^16`.
#[inline(always)]
pub(super) fn share(a: u32, b: u32) -> u32 {
    if NARROW { share_of_halves(a, b) } else { ((u64::from(a) * u64::from(b << 16)) >> 32) as u32 }
}

#[inline(always)]
fn share_of_halves(a: u32, b: u32) -> u32 {
    (a >> 16).wrapping_mul(b).wrapping_add((a & 0xffff).wrapping_mul(b) >> 16)
}

#[cfg(test)]
mod tests {
    use super::{by_table, normalised, share, share_of_halves};

    /// Numbers of all lengths.
    fn numbers() -> impl Iterator<Item = u32> {
        let spread = (0..100_000_u32).map(|step| step.wrapping_mul(2_654_435_761) >> (step % 32));
        (0..32).flat_map(|bit| [1_u32 << bit, (1 << bit) - 1, u32::MAX << bit]).chain(spread)
    }

    #[test]
    fn every_machine_normalises_alike() {
        for bits in numbers() {
            assert_eq!(normalised::<31>(bits), by_table::<31>(bits), "{bits:#x}");
            assert_eq!(normalised::<15>(bits), by_table::<15>(bits), "{bits:#x}");
            assert_eq!(normalised::<7>(bits), by_table::<7>(bits), "{bits:#x}");
            assert_eq!(normalised::<3>(bits), by_table::<3>(bits), "{bits:#x}");
        }
    }

    #[test]
    fn every_machine_shares_alike() {
        for a in numbers() {
            for b in [0, 1, 0x7fff, 0x8000, 0xffff, a >> 16, a & 0xffff] {
                assert_eq!([share(a, b), share_of_halves(a, b)], [((u64::from(a) * u64::from(b)) >> 16) as u32; 2]);
            }
        }
    }
}
