//! The reciprocal square root of a 32-bit mantissa, in integers: a small table and one cubic step, no division.

use crate::constant;

/// Cells of the table, one for each of the top six bits that a mantissa in [1/4, 1) can have.
const CELLS: usize = 48;

/// The line that lies closest to `1/sqrt(y)` over each cell: value at the cell's start and fall over the cell, in Q15.
const LINES: [(u16, u16); CELLS] = lines();

/// `2^31 / sqrt(m / 2^32)` for `m` in `[2^30, 2^32)`: Q31 in `[2^31, 2^32)`.
///
/// Within 0.58 of the last place of the exact value for the middle of the interval that `m` stands for, so that
/// a caller may cut a longer mantissa to its top 32 bits. `m = 2^30` gives `2^32 - 1`.
#[inline]
pub(crate) fn reciprocal_root(m: u32) -> u32 {
    root(m, 1)
}

/// [`reciprocal_root`] of `m` itself, for a mantissa that has not been cut. Within 0.58 of the last place as well.
#[inline]
pub(crate) fn reciprocal_root_of_whole(m: u32) -> u32 {
    root(m, 0)
}

/// `2^31 / sqrt((m + half / 2) / 2^32)`.
#[inline]
fn root(m: u32, half: u64) -> u32 {
    // Below 2^30, which no caller gives, any line will do.
    let (start, fall) = LINES.get((m >> 26).wrapping_sub(16) as usize).copied().unwrap_or_default();
    // 16 bits, so that the square is exact in 32.
    let seed = u32::from(start).wrapping_sub((u32::from(fall) * ((m >> 10) & 0xffff)) >> 16) & 0xffff;
    let square = u64::from(seed * seed);
    // y seed^2 in Q62.
    let product = u64::from(m) * square + half * square / 2;
    // The residual is under 2^-11, hence in Q42 a number of 31 bits.
    let residual = ((1_i64 << 62).wrapping_sub(product as i64)) >> 20;
    let residual_square = residual.wrapping_mul(residual) >> 42;
    let correction = (residual / 2).wrapping_add(residual_square.wrapping_mul(3) >> 3);
    let fine = i64::from(seed).wrapping_mul(correction).wrapping_add(1 << 25) >> 26;
    let root = (i64::from(seed) << 16).wrapping_add(fine);
    u32::try_from(root).unwrap_or(u32::MAX)
}

const fn lines() -> [(u16, u16); CELLS] {
    let mut lines = [(0, 0); CELLS];
    let mut cell = 0;
    while cell < CELLS {
        lines[cell] = line((cell + 16) as f64 / 64.0, (cell + 17) as f64 / 64.0);
        cell += 1;
    }
    lines
}

/// The chord from `from` to `to`, lowered by half of its greatest distance from the curve.
const fn line(from: f64, to: f64) -> (u16, u16) {
    let start = 1.0 / constant::sqrt(from);
    let fall = start - 1.0 / constant::sqrt(to);
    // Where the tangent has the chord's slope: y^(-3/2) / 2 = fall / (to - from).
    let slope = fall / (to - from);
    let root = cube_root(1.0 / (2.0 * slope));
    let gap = start - slope * (root * root - from) - 1.0 / root;
    const Q15: f64 = 32768.0;
    let start = (start - gap / 2.0) * Q15 + 0.5;
    let start = if start > 65535.0 { 65535.0 } else { start };
    (start as u16, (fall * Q15 + 0.5) as u16)
}

/// Newton's cube root, for arguments around 1.
const fn cube_root(value: f64) -> f64 {
    let mut root = 1.0;
    let mut step = 0;
    while step < 8 {
        root -= (root - value / (root * root)) / 3.0;
        step += 1;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::{reciprocal_root, reciprocal_root_of_whole};

    /// The greater error in the last place: against the middle of the interval that `m` stands for, and against `m`
    /// itself.
    fn error(m: u32) -> f64 {
        let exact = |m: f64| 2_147_483_648.0 / (m / 4_294_967_296.0).sqrt();
        let middle = f64::from(reciprocal_root(m)) - exact(f64::from(m) + 0.5);
        // The greatest number that there is stands for 2^32.
        let whole = f64::from(reciprocal_root_of_whole(m)) - exact(f64::from(m)).min(4_294_967_295.0);
        middle.abs().max(whole.abs())
    }

    fn worst(mantissas: impl Iterator<Item = u32>) -> f64 {
        mantissas.map(error).fold(0.0, f64::max)
    }

    /// Measured over all mantissas by the test below.
    const BOUND: f64 = 0.58;

    #[test]
    fn is_within_its_bound_and_the_bound_is_tight() {
        // A stride that is coprime to the cells reaches every cell at ever different places.
        let worst = worst((1_u32 << 30..=u32::MAX).step_by(997).chain([1 << 30, u32::MAX]));
        assert!(worst < BOUND, "{worst}");
        assert!(worst > 0.5, "{worst}");
    }

    #[test]
    #[ignore = "3.2 thousand million roots: cargo test --release -- --ignored"]
    fn is_within_its_bound_for_every_mantissa() {
        let worst = worst(1 << 30..=u32::MAX);
        println!("reciprocal_root, all 3 221 225 472 mantissas: worst {worst} ULP");
        assert!(worst < BOUND && worst > 0.5, "{worst}");
    }
}
