//! The reciprocal of a 31-bit mantissa, in integers: a small table and one cubic step, no division.

use crate::constant;

/// Cells of the table, one for each of the five bits that follow a mantissa's first.
const CELLS: usize = 32;

/// The line that lies closest to `1 / y` over each cell: value at the cell's start and fall over the cell, in Q15.
const LINES: [(u16, u16); CELLS] = lines();

/// What `1 / y` is above 1, of `y = m / 2^31` for `m` in `[2^30, 2^31)`, in Q32: the reciprocal's 33 bits without the
/// first.
///
/// Within 0.54 of the last place. `m = 2^30` gives `2^32 - 1`, which stands for `2^32`.
#[inline]
pub(crate) fn fraction_of_reciprocal(m: u32) -> u32 {
    let (start, fall) = LINES.get((m >> 25) as usize & (CELLS - 1)).copied().unwrap_or_default();
    // Q15 in 16 bits.
    let seed = u32::from(start).wrapping_sub((u32::from(fall) * ((m >> 9) & 0xffff)) >> 16);
    // Products of 16 bits alone, since the smallest chips have no wider ones. The residual 1 - y seed is under 2^-12,
    // so the low 32 bits of Q43 hold it.
    let product = (m >> 16).wrapping_mul(seed << 13).wrapping_add((m & 0xffff).wrapping_mul(seed) >> 3);
    let residual = 0_u32.wrapping_sub(product) as i32;
    let coarse = residual >> 16;
    let correction = residual.wrapping_add(coarse.wrapping_mul(coarse) >> 11);
    let seed = seed as i32;
    let (high, low) = (correction >> 16, correction & 0xffff);
    // Q42: a seed in Q15 times a correction in Q43, less 16 bits.
    let fine = high.wrapping_mul(seed).wrapping_add(((low as u32).wrapping_mul(seed as u32) >> 16) as i32);
    let fraction =
        (i64::from(seed) << 17).wrapping_add(i64::from(fine.wrapping_add(1 << 9) >> 10)).wrapping_sub(1 << 32);
    // That of 1/2 is 2, which does not fit.
    u32::try_from(fraction).unwrap_or(u32::MAX)
}

const fn lines() -> [(u16, u16); CELLS] {
    let mut lines = [(0, 0); CELLS];
    let mut cell = 0;
    while cell < CELLS {
        lines[cell] = line((cell + CELLS) as f64 / 64.0, (cell + CELLS + 1) as f64 / 64.0);
        cell += 1;
    }
    lines
}

/// The chord from `from` to `to`, lowered by half of its greatest distance from the curve.
const fn line(from: f64, to: f64) -> (u16, u16) {
    let start = 1.0 / from;
    let fall = start - 1.0 / to;
    let slope = fall / (to - from);
    // Where the tangent has the chord's slope: 1 / y^2.
    let root = constant::sqrt(1.0 / slope);
    let gap = start - slope * (root - from) - 1.0 / root;
    const Q15: f64 = 32768.0;
    (((start - gap / 2.0) * Q15 + 0.5) as u16, (fall * Q15 + 0.5) as u16)
}

#[cfg(test)]
mod tests {
    use super::fraction_of_reciprocal;

    /// In the last place.
    fn error(m: u32) -> f64 {
        let exact = 9_223_372_036_854_775_808.0 / f64::from(m) - 4_294_967_296.0;
        // 2^32 - 1 stands for 2^32.
        (f64::from(fraction_of_reciprocal(m)) - exact.min(4_294_967_295.0)).abs()
    }

    /// `tests/exhaustive.rs` has all mantissas.
    #[test]
    fn is_within_its_bound_and_the_bound_is_tight() {
        let mantissas = (1_u32 << 30..1 << 31).step_by(997).chain([1 << 30, (1 << 31) - 1]);
        let worst = mantissas.map(error).fold(0.0, f64::max);
        assert!(worst < 0.54 && worst > 0.5, "{worst}");
    }
}
