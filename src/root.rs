//! The reciprocal square root of a 32-bit mantissa, in integers: a small table and one cubic step, no division.

use crate::constant;
use crate::multiply::wide;

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
    u32::try_from(root::<31>(m, 1)).unwrap_or(u32::MAX)
}

/// What `1/sqrt(m / 2^32)` is above 1, of `m` in `[2^30, 2^32)`, in Q32: the root's 33 bits without the first, of a
/// mantissa that has not been cut.
///
/// Within 0.65 of the last place. `m = 2^30` gives `2^32 - 1`, which stands for `2^32`.
#[inline]
pub(crate) fn fraction_of_reciprocal_root(m: u32) -> u32 {
    // The first bit is carried out, but by the root of 1/4, which is 2.
    u32::try_from(root::<32>(m, 0).wrapping_sub(1 << 32)).unwrap_or(u32::MAX)
}

/// `1 / sqrt((m + half / 2) / 2^32)` in `FRACTION` bits, of which 31 to 40 make sense.
#[inline]
fn root<const FRACTION: u32>(m: u32, half: u64) -> i64 {
    // Below 2^30, which no caller gives, any line will do.
    let (start, fall) = LINES.get((m >> 26).wrapping_sub(16) as usize).copied().unwrap_or_default();
    // 16 bits, so that the square is exact in 32.
    let seed = u32::from(start).wrapping_sub((u32::from(fall) * ((m >> 10) & 0xffff)) >> 16) & 0xffff;
    let square = seed * seed;
    // y seed^2 in Q62.
    let product = wide(m, square) + half * u64::from(square) / 2;
    // The residual is under 2^-11, hence in Q42 a number of 31 bits.
    let residual = ((1_i64 << 62).wrapping_sub(product as i64)) >> 20;
    let residual_square = residual.wrapping_mul(residual) >> 42;
    let correction = (residual / 2).wrapping_add(residual_square.wrapping_mul(3) >> 3);
    // Of Q57.
    let shift = const { 57 - FRACTION };
    let fine = i64::from(seed).wrapping_mul(correction).wrapping_add(1 << (shift - 1)) >> shift;
    (i64::from(seed) << (FRACTION - 15)).wrapping_add(fine)
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
    // The greatest start, of 1/4, is 65 525.
    (((start - gap / 2.0) * Q15 + 0.5) as u16, (fall * Q15 + 0.5) as u16)
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
    use super::{fraction_of_reciprocal_root, reciprocal_root};

    /// In the last place, against the middle of the interval that `m` stands for.
    fn error(m: u32) -> f64 {
        let exact = 2_147_483_648.0 / ((f64::from(m) + 0.5) / 4_294_967_296.0).sqrt();
        (f64::from(reciprocal_root(m)) - exact).abs()
    }

    /// In the last place, against `m` itself.
    fn error_of_fraction(m: u32) -> f64 {
        let exact = 4_294_967_296.0 / (f64::from(m) / 4_294_967_296.0).sqrt() - 4_294_967_296.0;
        // 2^32 - 1 stands for 2^32.
        (f64::from(fraction_of_reciprocal_root(m)) - exact.min(4_294_967_295.0)).abs()
    }

    /// `tests/exhaustive.rs` has all mantissas. A stride that is coprime to the cells reaches every cell at ever
    /// different places.
    fn worst(error: fn(u32) -> f64) -> f64 {
        (1_u32 << 30..=u32::MAX).step_by(997).chain([1 << 30, u32::MAX]).map(error).fold(0.0, f64::max)
    }

    #[test]
    fn is_within_its_bounds_and_they_are_tight() {
        let (root, fraction) = (worst(error), worst(error_of_fraction));
        assert!(root < 0.58 && root > 0.5, "{root}");
        assert!(fraction < 0.65 && fraction > 0.5, "{fraction}");
    }
}
