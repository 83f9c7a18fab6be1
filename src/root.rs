//! The reciprocal square root of a 32-bit mantissa, in integers: a small table and one cubic step, no division.
//!
//! Products of 64 bits are put together from 16-bit halves for chips that have no others: the same bits, in fewer steps
//! than general products would take.

pub(crate) mod single;

use crate::constant;
use crate::multiply::{NARROW, wide};

/// Cells of the table, one for each value of a mantissa's top six bits. The first 16 are of no use, but with them no
/// index is out of bounds, and the check would take as many bytes.
const CELLS: usize = 64;

/// The line that lies closest to `1/sqrt(y)` over each cell, as one word: its fall per unit, in Q14, in the high half,
/// its value at `y = 0`, in Q15 without the bits above 16, in the low half.
const LINES: [u32; CELLS] = lines();

/// `2^31 / sqrt(m / 2^32)` for `m` in `[2^30, 2^32)`: Q31 in `[2^31, 2^32)`.
///
/// Within 0.573 of the last place of the exact value for the middle of the interval that `m` stands for, so that
/// a caller may cut a longer mantissa to its top 32 bits. `m = 2^30` gives `2^32 - 1`.
#[inline]
pub(crate) fn reciprocal_root(m: u32) -> u32 {
    of_middle::<NARROW>(m)
}

/// [`reciprocal_root`], by halves on any machine if so wanted.
#[inline(always)]
pub(crate) fn of_middle<const HALVES: bool>(m: u32) -> u32 {
    let seed = seed(m);
    // What half a unit of m adds to the residual.
    let half = seed.wrapping_mul(seed) >> 21;
    finish::<31, HALVES>(seed, residual::<HALVES>(m, seed).wrapping_add(half))
}

/// `1/sqrt(m / 2^32)` for `m` in `[2^30, 2^32)`, in Q30, of a mantissa that has not been cut: within 0.54 of the last
/// place.
#[inline]
pub(crate) fn whole_reciprocal_root(m: u32) -> u32 {
    of_whole::<30, NARROW>(m)
}

/// What `1/sqrt(m / 2^32)` is above 1, of `m` in `[2^30, 2^32)`, in Q32: the root's 33 bits without the first, of a
/// mantissa that has not been cut.
///
/// Within 0.65 of the last place. `m = 2^30` gives `2^32 - 1`, which stands for `2^32`.
#[inline]
pub(crate) fn fraction_of_reciprocal_root(m: u32) -> u32 {
    // The root of 1/4 is 2, which does not fit.
    if m == 1 << 30 { u32::MAX } else { of_whole::<32, NARROW>(m) }
}

/// The low 32 of the root's bits, `FRACTION` being after the point.
#[inline(always)]
pub(crate) fn of_whole<const FRACTION: u32, const HALVES: bool>(m: u32) -> u32 {
    let seed = seed(m);
    finish::<FRACTION, HALVES>(seed, residual::<HALVES>(m, seed))
}

/// `1 / sqrt(m / 2^32)` to 12 bits, in Q15: 16 bits, so that the square is exact in 32.
#[inline(always)]
fn seed(m: u32) -> u32 {
    // The index has six bits.
    let line = LINES.get((m >> 26) as usize).copied().unwrap_or_default();
    line.wrapping_sub((line >> 16).wrapping_mul(m >> 16) >> 15) & 0xffff
}

/// `factor seed / 2^16`, cut, for a seed of 16 bits.
#[inline(always)]
const fn times_seed<const HALVES: bool>(factor: u32, seed: u32) -> u32 {
    if HALVES {
        let low = seed.wrapping_mul(factor & 0xffff) >> 16;
        seed.wrapping_mul(factor >> 16).wrapping_add(low)
    } else {
        (wide(factor, seed << 16) >> 32) as u32
    }
}

/// `m seed^2 - 1` in Q42. It is under 2^-11, so that 32 bits of the product hold it.
#[inline(always)]
const fn residual<const HALVES: bool>(m: u32, seed: u32) -> u32 {
    if HALVES {
        let low = seed.wrapping_mul(m & 0xffff);
        // The upper 32 of the 48 bits of m seed.
        let root = seed.wrapping_mul(m >> 16).wrapping_add(low >> 16);
        let rest = seed.wrapping_mul(root & 0xffff).wrapping_add(seed.wrapping_mul(low & 0xffff) >> 16);
        (seed.wrapping_mul(root >> 16) << 12).wrapping_add(rest >> 4)
    } else {
        (wide(m, seed.wrapping_mul(seed)) >> 20) as u32
    }
}

/// `seed (1 - residual/2 + 3/8 residual^2)`, to nearest: the low 32 of its bits, `FRACTION` being after the point.
#[inline(always)]
const fn finish<const FRACTION: u32, const HALVES: bool>(seed: u32, residual: u32) -> u32 {
    let residual = residual as i32;
    let coarse = residual >> 16;
    let square = coarse.wrapping_mul(coarse) as u32;
    // In Q43, since half of it is meant.
    let correction = ((square.wrapping_mul(3) >> 12) as i32).wrapping_sub(residual);
    if HALVES {
        let (high, low) = (correction >> 16, correction as u32 & 0xffff);
        // Q42.
        let fine = (seed as i32).wrapping_mul(high).wrapping_add((seed.wrapping_mul(low) >> 16) as i32);
        let rounded = (fine >> (41 - FRACTION)).wrapping_add(1) >> 1;
        (seed << (FRACTION - 15)).wrapping_add(rounded as u32)
    } else {
        let fine = (correction as i64).wrapping_mul((seed << (FRACTION - 26)) as i64);
        // The last bit that is cut off is set, for rounding.
        let root = ((seed as u64) << (FRACTION + 17)) | (1 << 31);
        (root.wrapping_add(fine as u64) >> 32) as u32
    }
}

const fn lines() -> [u32; CELLS] {
    let mut lines = [0; CELLS];
    let mut cell = CELLS / 4;
    while cell < CELLS {
        lines[cell] = line(cell as f64 / CELLS as f64, (cell + 1) as f64 / CELLS as f64);
        cell += 1;
    }
    lines
}

/// By how much lines fall less than chords, in Q14: what the cubic step leaves of an error grows with the root, and is
/// greatest at the start of the first cell, where 1/sqrt is steepest. Found by trying.
const FLATTER: f64 = 10.0;

/// The chord from `from` to `to`, lowered by half of its greatest distance from the curve, and a little flatter.
const fn line(from: f64, to: f64) -> u32 {
    let start = 1.0 / constant::sqrt(from);
    let slope = (start - 1.0 / constant::sqrt(to)) / (to - from);
    // Where the tangent has the chord's slope: y^(-3/2) / 2.
    let root = cube_root(1.0 / (2.0 * slope));
    let gap = start - slope * (root * root - from) - 1.0 / root;
    let fall = (slope * 16384.0 - FLATTER + 0.5) as u32;
    let half = (to - from) / 2.0;
    let middle = start - slope * half - gap / 2.0;
    // A quarter of the slope is what cutting y to 16 bits adds in the middle, and half a unit the cut of the product;
    // the other half rounds.
    let origin = (middle + fall as f64 / 16384.0 * (from + half)) * 32768.0 - slope / 4.0;
    (fall << 16) | (origin as u32 & 0xffff)
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
    use super::{fraction_of_reciprocal_root, of_middle, of_whole, reciprocal_root, seed, times_seed};

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
        assert!(root < 0.573 && root > 0.5, "{root}");
        assert!(fraction < 0.65 && fraction > 0.5, "{fraction}");
    }

    #[test]
    fn halves_give_the_same_bits() {
        for m in (1_u32 << 30..=u32::MAX).step_by(997).chain([0, 1 << 30, u32::MAX]) {
            assert_eq!(of_middle::<false>(m), of_middle::<true>(m), "{m:#x}");
            assert_eq!(of_whole::<30, false>(m), of_whole::<30, true>(m), "{m:#x}");
            assert_eq!(of_whole::<32, false>(m), of_whole::<32, true>(m), "{m:#x}");
            assert_eq!(times_seed::<false>(m, seed(m)), times_seed::<true>(m, seed(m)), "{m:#x}");
        }
    }
}
