//! Integers and f64 become numbers of wide range, and the way back.

use super::{MAX, Scaled, ZERO};
use crate::multiply::NARROW;

impl Scaled {
    /// `bits * 2^exponent`, to nearest.
    ///
    /// ```
    /// use sunglint::real::{Scalar, Scaled};
    ///
    /// assert_eq!(Scaled::from_bits(-3, -1), Scaled::new(-1.5));
    /// // A cosine in Q60 keeps 31 bits.
    /// assert_eq!(Scaled::from_bits((1 << 60) - 1, -60), Scaled::ONE);
    /// ```
    #[inline]
    pub const fn from_bits(bits: i64, exponent: i32) -> Self {
        if bits as i32 as i64 == bits {
            Self::from_i32(bits as i32, exponent)
        } else {
            Self::of_size(bits.unsigned_abs(), bits < 0, exponent)
        }
    }

    /// `bits * 2^exponent`, to nearest but that the last bit of numbers with 64 does not break ties.
    ///
    /// ```
    /// use sunglint::real::{Scalar, Scaled};
    ///
    /// // A light level in Q16, and the greatest number of 64 bits, which is rounded.
    /// assert_eq!(Scaled::from_unsigned(205_887, -16).to_bits(16), 205_887);
    /// assert_eq!(Scaled::from_unsigned(u64::MAX, -64), Scaled::ONE);
    /// ```
    #[inline]
    pub const fn from_unsigned(bits: u64, exponent: i32) -> Self {
        Self::of_size(bits, false, exponent)
    }

    /// `bits * 2^exponent`, exactly.
    #[inline]
    pub(crate) const fn from_i32(bits: i32, exponent: i32) -> Self {
        if bits == 0 {
            return ZERO;
        }
        let (top, free) = aligned(bits.unsigned_abs());
        // The lowest number alone has no bit to spare, and that one's last is zero.
        let mantissa = (top >> 1) as i32;
        let exponent = exponent.wrapping_add(32).wrapping_sub(free as i32);
        Self { mantissa: if bits < 0 { mantissa.wrapping_neg() } else { mantissa }, exponent }
    }

    /// `size * 2^exponent` or its negative, to nearest, halves upwards, which for a negative number is towards zero.
    #[inline]
    const fn of_size(size: u64, negative: bool, exponent: i32) -> Self {
        let [high, low] = [(size >> 32) as u32, size as u32];
        let (high, low, exponent) = if high == 0 { (low, 0, exponent.wrapping_sub(32)) } else { (high, low, exponent) };
        if high == 0 {
            return ZERO;
        }
        let (top, free) = aligned(high);
        let top = top | (low >> 1 >> (31_u32.wrapping_sub(free) & 31));
        let up = top & 1 != 0 && !(negative && low << (free & 31) == 0);
        let mantissa = (top >> 1).wrapping_add(up as u32);
        let exponent = exponent.wrapping_add(64).wrapping_sub(free as i32);
        Self::carried(mantissa, negative, exponent)
    }

    /// A size that may have been rounded up to `2^31`, which is past its end.
    #[inline]
    pub(super) const fn carried(size: u32, negative: bool, exponent: i32) -> Self {
        let over = size >> 31;
        let mantissa = (size >> over) as i32;
        let exponent = exponent.wrapping_add(over as i32);
        Self { mantissa: if negative { mantissa.wrapping_neg() } else { mantissa }, exponent }
    }

    /// The number nearest to `value`; zero for NaN, [`Scalar::MAX`](super::Scalar::MAX) or its negative for infinities.
    /// For constants.
    ///
    /// ```
    /// use sunglint::real::{Scalar, Scaled};
    ///
    /// const HALF: Scaled = Scaled::new(0.5);
    /// assert_eq!((HALF * HALF).exact(), 0.25);
    /// assert_eq!([f64::NAN, f64::INFINITY].map(Scaled::new), [Scaled::ZERO, Scaled::MAX]);
    /// ```
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
    ///
    /// ```
    /// use sunglint::real::{Scalar, Scaled};
    ///
    /// assert_eq!(Scaled::new(1.5).to_bits(14), 24_576); // Q14
    /// assert_eq!([-1.5, -0.5, 0.5].map(|half| Scaled::new(half).to_bits(0)), [-1, 0, 1]);
    /// assert_eq!(Scaled::MAX.to_bits(0), i64::MAX);
    /// ```
    #[inline]
    pub const fn to_bits(self, fraction: u32) -> i64 {
        match self.places_below(fraction) {
            shift @ 1.. => self.cut(shift) as i64,
            shift @ -32..=0 => (self.mantissa as i64) << (shift.wrapping_neg() & 63),
            _ if self.mantissa == 0 => 0,
            _ if self.mantissa < 0 => i64::MIN,
            _ => i64::MAX,
        }
    }

    /// The same in 32 bits.
    #[inline]
    pub(crate) const fn to_i32(self, fraction: u32) -> i32 {
        match self.places_below(fraction) {
            shift @ 1.. => self.cut(shift),
            0 => self.mantissa,
            _ if self.mantissa == 0 => 0,
            _ if self.mantissa < 0 => i32::MIN,
            _ => i32::MAX,
        }
    }

    /// The value times `2^fraction` as an unsigned integer, to nearest; zero for negative values, saturates.
    ///
    /// ```
    /// use sunglint::real::{Scalar, Scaled};
    ///
    /// assert_eq!(Scaled::new(2.5).to_unsigned(16), 163_840); // Q16
    /// assert_eq!([Scaled::new(-2.0), Scaled::MAX].map(|end| end.to_unsigned(16)), [0, u64::MAX]);
    /// ```
    #[inline]
    pub const fn to_unsigned(self, fraction: u32) -> u64 {
        match self.places_below(fraction) {
            _ if self.mantissa <= 0 => 0,
            shift @ 1.. => self.cut(shift) as u64,
            shift @ -33..=0 => (self.mantissa as u64) << (shift.wrapping_neg() & 63),
            _ => u64::MAX,
        }
    }

    /// The same in 32 bits.
    #[inline]
    pub(crate) const fn to_u32(self, fraction: u32) -> u32 {
        match self.places_below(fraction) {
            _ if self.mantissa <= 0 => 0,
            shift @ 1.. => self.cut(shift) as u32,
            shift @ -1..=0 => (self.mantissa as u32) << (shift.wrapping_neg() & 31),
            _ => u32::MAX,
        }
    }

    /// The mantissa without `shift` bits, which are one or more, to nearest, halves upwards.
    #[inline]
    const fn cut(self, shift: i32) -> i32 {
        // Half of the last place at most, and minus that is rounded upwards too.
        if shift > 31 {
            0
        } else {
            (self.mantissa >> (shift & 31)).wrapping_add((self.mantissa >> (shift.wrapping_sub(1) & 31)) & 1)
        }
    }

    /// How many of the mantissa's bits lie below `2^-fraction`.
    #[inline]
    const fn places_below(self, fraction: u32) -> i32 {
        31_i32.wrapping_sub(fraction as i32).wrapping_sub(self.exponent)
    }
}

/// Bits other than zero shifted to the top, and by how much.
#[inline]
const fn aligned(bits: u32) -> (u32, u32) {
    if NARROW {
        by_halves(bits)
    } else {
        let free = bits.leading_zeros();
        (bits << (free & 31), free)
    }
}

/// The same where the machine counts no zeros, and its library takes twice as long as this.
#[inline]
const fn by_halves(bits: u32) -> (u32, u32) {
    let (top, free) = shifted_if_zero::<16>(bits, 0);
    let (top, free) = shifted_if_zero::<8>(top, free);
    let (top, free) = shifted_if_zero::<4>(top, free);
    let (top, free) = shifted_if_zero::<2>(top, free);
    shifted_if_zero::<1>(top, free)
}

/// Without the first `STEP` bits where they are zero, and how many have gone.
#[inline]
const fn shifted_if_zero<const STEP: u32>(bits: u32, gone: u32) -> (u32, u32) {
    if bits >> (32 - STEP) == 0 { (bits << STEP, gone.wrapping_add(STEP)) } else { (bits, gone) }
}

#[cfg(test)]
mod tests {
    use super::by_halves;

    #[test]
    fn halves_find_the_first_bit() {
        for free in 0..32 {
            for pattern in [0x8000_0000, u32::MAX, 0xa5a5_a5a5, 0x8000_0001] {
                let bits = pattern >> free;
                assert_eq!(by_halves(bits), (bits << free, free));
            }
        }
    }
}
