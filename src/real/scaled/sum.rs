//! Sums of numbers of wide range: exact, then rounded to nearest, halves upwards. 32 bits at a time, since the smallest
//! chips have no shifts by a variable of more.

use super::Scaled;

impl Scaled {
    #[inline]
    pub(super) fn plus(self, other: Self) -> Self {
        let (great, small) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let lower = great.exponent.wrapping_sub(small.exponent) as u32;
        // Half of the last place, or so little that it is lost. Greater still where exponents have wrapped.
        if lower > 32 {
            great
        } else if great.mantissa | small.mantissa < 0 || lower == 32 {
            great.plus_signed(small, lower)
        } else {
            great.plus_positive(small, lower)
        }
    }

    /// The sum of two that are not negative.
    #[inline]
    fn plus_positive(self, small: Self, lower: u32) -> Self {
        let small = small.mantissa as u32;
        let sum = (self.mantissa as u32).wrapping_add(small >> (lower & 31));
        let near = sum.wrapping_add((small << 1 >> (lower & 31)) & 1);
        if near >> 31 == 0 {
            Self { mantissa: near as i32, exponent: self.exponent }
        } else {
            // What has been cut off is less than half of this last place.
            Self { mantissa: (sum.wrapping_add(1) >> 1) as i32, exponent: self.exponent.wrapping_add(1) }
        }
    }

    /// The sum with one that is `2^lower` times smaller, by up to 32.
    fn plus_signed(self, small: Self, lower: u32) -> Self {
        let negative = self.mantissa < 0;
        let opposite = (self.mantissa ^ small.mantissa) < 0;
        if lower == 0 && opposite {
            return Self::from_i32(self.mantissa.wrapping_add(small.mantissa), self.exponent.wrapping_sub(31));
        }
        let (great, small) = (self.mantissa.unsigned_abs(), small.mantissa.unsigned_abs());
        let (whole, rest) = if lower == 0 {
            (small, 0)
        } else {
            (small >> 1 >> (lower.wrapping_sub(1) & 31), small << (32_u32.wrapping_sub(lower) & 31))
        };
        if opposite {
            Self::difference(great.wrapping_sub(whole), rest, negative, self.exponent)
        } else {
            Self::sum(great.wrapping_add(whole), rest, negative, self.exponent)
        }
    }

    /// A size of `2^30` to `2^32` and a `rest` of 32 bits below it.
    #[inline]
    fn sum(size: u32, rest: u32, negative: bool, exponent: i32) -> Self {
        if size >> 31 == 0 {
            Self::carried(size.wrapping_add(rounds_up(rest, negative).into()), negative, exponent)
        } else {
            let rest = (size << 31) | (rest >> 1) | (rest & 1);
            let size = (size >> 1).wrapping_add(rounds_up(rest, negative).into());
            Self::carried(size, negative, exponent.wrapping_add(1))
        }
    }

    /// A size less a `rest` of 32 bits below it, which is of one bit where they differ by `2^29` or less.
    #[inline]
    fn difference(size: u32, rest: u32, negative: bool, exponent: i32) -> Self {
        let size = size.wrapping_sub((rest != 0).into());
        let rest = rest.wrapping_neg();
        if size >> 30 != 0 {
            return Self::carried(size.wrapping_add(rounds_up(rest, negative).into()), negative, exponent);
        }
        let (size, rest) = ((size << 1) | (rest >> 31), rest << 1);
        if size >> 30 != 0 {
            let size = size.wrapping_add(rounds_up(rest, negative).into());
            return Self::carried(size, negative, exponent.wrapping_sub(1));
        }
        let size = if negative { (size as i32).wrapping_neg() } else { size as i32 };
        Self::from_i32(size, exponent.wrapping_sub(32))
    }
}

/// Whether what is below a last place is half of it or more, and for negative numbers more than half.
#[inline]
fn rounds_up(rest: u32, negative: bool) -> bool {
    rest >= (1_u32 << 31).wrapping_add(negative.into())
}
