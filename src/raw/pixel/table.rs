//! Roots and reciprocals of short mantissas: a value at the start of each cell, and a line from one to the next.

use crate::constant;

/// Cells of the reciprocal's table.
const CELLS: usize = 128;

/// Cells of an octave of roots.
const OCTAVE: usize = 32;

/// `sqrt(y)` for `y` from 1/2 to 1, then from 1/4 to 1/2: Q17 at a cell's start, and in the lowest 15 bits the rise
/// over the cell in the same unit.
static ROOTS: [u32; 2 * OCTAVE] = roots();

/// `1 / y` less 1 in Q16, from `y = 1/2` on in steps of 1/256.
static RECIPROCALS: [u16; CELLS + 1] = reciprocals();

/// `sqrt(y)` in Q16 of a `y` in Q32 from 1/2, or where it is `odd` of the half of that: from `2^15` to `2^16 - 1`.
#[inline(always)]
pub(super) fn root(y: u32, odd: u32) -> u32 {
    let line = ROOTS[((odd & 1) << 5 | y >> 26 & 31) as usize];
    // Cut, hence the table's values are half of a last place greater.
    line.wrapping_add((line & 0x7fff).wrapping_mul(y >> 11 & 0x7fff)) >> 16
}

/// `2^31 / y` for `y` from `2^15` to `2^16 - 1`, likewise.
#[inline(always)]
pub(super) fn reciprocal(y: u32) -> u32 {
    let cell = (y >> 8 & 127) as usize;
    let (from, to) = (u32::from(RECIPROCALS[cell]), u32::from(RECIPROCALS[cell + 1]));
    let fall = from.wrapping_sub(to).wrapping_mul(y & 0xff) >> 8;
    (1 << 16 | from).wrapping_sub(fall) >> 1
}

const fn roots() -> [u32; 2 * OCTAVE] {
    let mut lines = [0; 2 * OCTAVE];
    let mut cell = 0;
    while cell < OCTAVE {
        let from = (cell + OCTAVE) as f64 / (2 * OCTAVE) as f64;
        let to = (cell + 1 + OCTAVE) as f64 / (2 * OCTAVE) as f64;
        lines[cell] = line(from, to);
        lines[cell + OCTAVE] = line(from / 2.0, to / 2.0);
        cell += 1;
    }
    lines
}

/// The chord of the root, raised by half of what it lacks at most, `f'' h^2 / 8`.
const fn line(from: f64, to: f64) -> u32 {
    let (start, end) = (constant::sqrt(from), constant::sqrt(to));
    let gap = (to - from) * (to - from) / (from * start * 64.0);
    // The next cell's line starts from its own gap.
    let start = ((start + gap) * 131_072.0 + 1.5) as u32;
    let end = ((end + gap) * 131_072.0 + 1.5) as u32;
    // No root is 1.
    let end = if end > 131_071 { 131_071 } else { end };
    start << 15 | (end - start)
}

const fn reciprocals() -> [u16; CELLS + 1] {
    let mut knots = [0; CELLS + 1];
    let mut knot = 0;
    while knot <= CELLS {
        let y = (knot + CELLS) as f64 / (2 * CELLS) as f64;
        let gap = 2.0 / (y * y * y * (16 * 4 * CELLS * CELLS) as f64);
        knots[knot] = bits((1.0 / y - gap - 1.0) * 65_536.0 + 0.5);
        knot += 1;
    }
    knots
}

/// The nearest number of 16 bits.
const fn bits(value: f64) -> u16 {
    let nearest = (value + 0.5) as u32;
    if nearest > u16::MAX as u32 { u16::MAX } else { nearest as u16 }
}

#[cfg(test)]
mod tests {
    use super::{reciprocal, root};

    /// Every mantissa that can be told apart, and those that lie next to them.
    #[test]
    fn roots_are_within_their_bound_and_it_is_tight() {
        let (mut worst, mut bias, mut count) = (0.0_f64, 0.0, 0.0);
        for top in 1 << 15..1 << 16_u32 {
            for y in [0, 1, 0x8000, 0xffff].map(|low| top << 16 | low) {
                for odd in [0, 1] {
                    let short = root(y, odd);
                    assert!((1 << 15..1 << 16).contains(&short), "{y:#x}");
                    let error = f64::from(short) / (f64::from(y) / f64::from(1 + odd)).sqrt() - 1.0;
                    (worst, bias, count) = (worst.max(error.abs()), bias + error, count + 1.0);
                }
            }
        }
        println!("root {worst:e} {:e}", bias / count);
        assert!(worst < 3.3e-5 && worst > 1e-5, "{worst}");
        assert!((bias / count).abs() < 3.5e-6, "{}", bias / count);
    }

    #[test]
    fn reciprocals_are_within_their_bound_and_it_is_tight() {
        let (mut worst, mut bias, mut count) = (0.0_f64, 0.0, 0.0);
        for y in 1 << 15..1 << 16_u32 {
            let short = reciprocal(y);
            assert!((1 << 15..1 << 16).contains(&short), "{y:#x}");
            let error = f64::from(short) * f64::from(y) / 2_147_483_648.0 - 1.0;
            (worst, bias, count) = (worst.max(error.abs()), bias + error, count + 1.0);
        }
        println!("reciprocal {worst:e} {:e}", bias / count);
        assert!(worst < 3.1e-5 && worst > 1e-5, "{worst}");
        assert!((bias / count).abs() < 8e-6, "{}", bias / count);
    }
}
