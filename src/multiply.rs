//! Products of two 32-bit numbers, on chips whose multiplier keeps no more than 32 bits put together from 16-bit ones.

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

#[cfg(test)]
mod tests {
    use super::put_together;

    #[test]
    fn halves_make_the_same_product() {
        let ends =
            [0, 1, 2, 0x7fff, 0x8000, 0xffff, 0x1_0000, 0x1_0001, 0x7fff_ffff, 0x8000_0000, 0xffff_0000, u32::MAX];
        let spread = (0..2000_u32).map(|step| step.wrapping_mul(2_654_435_761));
        let numbers: Vec<u32> = ends.into_iter().chain(spread).collect();
        for &a in &numbers {
            for &b in &numbers {
                assert_eq!(put_together(a, b), u64::from(a) * u64::from(b), "{a:#x} {b:#x}");
            }
        }
    }
}
