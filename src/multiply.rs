//! Products of two 32-bit numbers, on chips whose multiplier keeps no more than 32 bits put together from 16-bit ones.
//! Both ways give the same bits.

/// Whether the machine has no product of 64 bits: Cortex-M0 and M0+, and Thumb of ARM7, which are also those without
/// compare-and-swap.
pub(crate) const NARROW: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// The product of two numbers of 32 bits.
#[inline(always)]
pub(crate) const fn wide(a: u32, b: u32) -> u64 {
    if NARROW { put_together(a, b) } else { (a as u64).wrapping_mul(b as u64) }
}

/// From four products of 16-bit halves.
#[inline(always)]
const fn put_together(a: u32, b: u32) -> u64 {
    const HALF: u32 = 0xffff;
    let [a_high, a_low, b_high, b_low] = [a >> 16, a & HALF, b >> 16, b & HALF];
    let low = a_low.wrapping_mul(b_low);
    // A product of halves leaves room for another half.
    let middle = a_high.wrapping_mul(b_low).wrapping_add(low >> 16);
    let other = a_low.wrapping_mul(b_high).wrapping_add(middle & HALF);
    let high = a_high.wrapping_mul(b_high).wrapping_add(middle >> 16).wrapping_add(other >> 16);
    ((high as u64) << 32) | ((other << 16) | (low & HALF)) as u64
}

/// The product of two signed numbers of 32 bits.
#[inline(always)]
pub(crate) const fn signed(a: i32, b: i32) -> i64 {
    if NARROW { put_together_signed(a, b) } else { (a as i64).wrapping_mul(b as i64) }
}

/// The square of a signed number of 32 bits.
#[inline(always)]
pub(crate) const fn square(a: i32) -> u64 {
    if NARROW { put_together_square(a) } else { (a as i64).wrapping_mul(a as i64) as u64 }
}

/// `a b / 2^32` to nearest, halves upwards, for `b` of `2^31` and more where that is less than `2^31`.
#[inline(always)]
pub(crate) const fn rounded_high(a: i32, b: u32) -> i32 {
    if NARROW {
        put_together_high(a, b)
    } else {
        // As a signed number `b` is 2^32 less.
        let lacking = ((a as i64) << 32) | (1 << 31);
        (lacking.wrapping_add((a as i64).wrapping_mul(b as i32 as i64)) >> 32) as i32
    }
}

#[inline(always)]
const fn put_together_signed(a: i32, b: i32) -> i64 {
    const HALF: i32 = 0xffff;
    let [a_high, a_low, b_high, b_low] = [a >> 16, a & HALF, b >> 16, b & HALF];
    let low = (a_low as u32).wrapping_mul(b_low as u32);
    // A signed half times an unsigned one leaves room for another half.
    let middle = a_high.wrapping_mul(b_low).wrapping_add((low >> 16) as i32);
    let other = a_low.wrapping_mul(b_high).wrapping_add(middle & HALF);
    let high = a_high.wrapping_mul(b_high).wrapping_add(middle >> 16).wrapping_add(other >> 16);
    ((high as i64) << 32) | (((other as u32) << 16) | (low & 0xffff)) as i64
}

/// From three products, of which the middle one counts twice.
#[inline(always)]
const fn put_together_square(a: i32) -> u64 {
    let (high, low) = (a >> 16, a & 0xffff);
    let middle = high.wrapping_mul(low);
    let ends = ((high.wrapping_mul(high) as u64) << 32) | (low as u32).wrapping_mul(low as u32) as u64;
    let twice = (((middle >> 15) as u32 as u64) << 32) | ((middle as u32) << 17) as u64;
    ends.wrapping_add(twice)
}

#[inline(always)]
const fn put_together_high(a: i32, b: u32) -> i32 {
    const HALF: u32 = 0xffff;
    let (a_high, a_low) = (a >> 16, a as u32 & HALF);
    let (b_high, b_low) = (b >> 16, b & HALF);
    // There is room for half of the last place too.
    let other = a_low.wrapping_mul(b_high).wrapping_add(a_low.wrapping_mul(b_low) >> 16).wrapping_add(1 << 15);
    let middle = a_high.wrapping_mul(b_low as i32).wrapping_add((other & HALF) as i32);
    a_high.wrapping_mul(b_high as i32).wrapping_add(middle >> 16).wrapping_add((other >> 16) as i32)
}

#[cfg(test)]
mod tests {
    use super::{
        put_together, put_together_high, put_together_signed, put_together_square, rounded_high, signed, square,
    };

    fn numbers() -> Vec<u32> {
        let ends =
            [0, 1, 2, 0x7fff, 0x8000, 0xffff, 0x1_0000, 0x1_0001, 0x7fff_ffff, 0x8000_0000, 0xffff_0000, u32::MAX];
        let spread = (0..2000_u32).map(|step| step.wrapping_mul(2_654_435_761));
        ends.into_iter().chain(spread).collect()
    }

    #[test]
    fn halves_make_the_same_product() {
        for a in numbers() {
            for b in numbers() {
                assert_eq!(put_together(a, b), u64::from(a) * u64::from(b), "{a:#x} {b:#x}");
            }
        }
    }

    #[test]
    fn halves_make_the_same_signed_product() {
        for a in numbers().into_iter().map(|a| a as i32) {
            assert_eq!(put_together_square(a), i64::from(a).pow(2) as u64, "{a:#x}");
            assert_eq!(square(a), put_together_square(a), "{a:#x}");
            for b in numbers().into_iter().map(|b| b as i32) {
                assert_eq!(put_together_signed(a, b), i64::from(a) * i64::from(b), "{a:#x} {b:#x}");
                assert_eq!(signed(a, b), put_together_signed(a, b), "{a:#x} {b:#x}");
            }
        }
    }

    #[test]
    fn halves_make_the_same_upper_half() {
        for a in numbers().into_iter().map(|a| a as i32) {
            for b in numbers().into_iter().map(|b| b | 1 << 31) {
                let exact = i64::from(a) * i64::from(b);
                let rounded = ((exact + (1 << 31)) >> 32) as i32;
                assert_eq!([put_together_high(a, b), rounded_high(a, b)], [rounded; 2], "{a:#x} {b:#x}");
            }
        }
    }
}
