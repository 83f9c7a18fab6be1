//! Roots and reciprocals of short mantissas: a value at the start of each cell, and a line from one to the next.

use crate::constant;

/// Cells of each table.
const CELLS: usize = 128;

/// `sqrt(y)` less a half in Q17, from `y = 0` on in steps of 1/128; the first quarter is not looked up.
static ROOTS: [u16; CELLS + 1] = roots();

/// `1 / y` less 1 in Q16, from `y = 1/2` on in steps of 1/256.
static RECIPROCALS: [u16; CELLS + 1] = reciprocals();

/// `sqrt(y)` in Q16 of a `y` in Q32 from 1/4: from `2^15` to `2^16 - 1`.
#[inline(always)]
pub(super) fn root(y: u32) -> u32 {
    let cell = (y >> 25) as usize;
    let [from, to] = [cell, cell + 1].map(|cell| u32::from(ROOTS[cell]));
    // Truncated, hence the tables are of values a half greater.
    let rise = to.wrapping_sub(from).wrapping_mul(y >> 9 & 0xffff) >> 16;
    (1 << 16 | from).wrapping_add(rise) >> 1
}

/// `2^31 / y` for `y` from `2^15` to `2^16 - 1`, likewise.
#[inline(always)]
pub(super) fn reciprocal(y: u32) -> u32 {
    let cell = (y >> 8 & 127) as usize;
    let [from, to] = [cell, cell + 1].map(|cell| u32::from(RECIPROCALS[cell]));
    let fall = from.wrapping_sub(to).wrapping_mul(y & 0xff) >> 8;
    (1 << 16 | from).wrapping_sub(fall) >> 1
}

const fn roots() -> [u16; CELLS + 1] {
    let mut knots = [0; CELLS + 1];
    // A quarter's root is a half, of which the table has what is above.
    let mut knot = CELLS / 4;
    while knot <= CELLS {
        let y = knot as f64 / CELLS as f64;
        let root = constant::sqrt(y);
        // Half of what a chord lacks, f'' h^2 / 8.
        let gap = 1.0 / (y * root * (4 * 16 * CELLS * CELLS) as f64);
        knots[knot] = bits((root + gap - 0.5) * 131_072.0 + 1.25);
        knot += 1;
    }
    knots
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
        for top in 1 << 14..1 << 16_u32 {
            for y in [0, 1, 0x8000, 0xffff].map(|low| top << 16 | low) {
                let short = root(y);
                assert!((1 << 15..1 << 16).contains(&short), "{y:#x}");
                let error = f64::from(short) / f64::from(y).sqrt() - 1.0;
                (worst, bias, count) = (worst.max(error.abs()), bias + error, count + 1.0);
            }
        }
        println!("root {worst:e} {:e}", bias / count);
        assert!(worst < 3.1e-5 && worst > 1e-5, "{worst}");
        assert!((bias / count).abs() < 1e-6, "{}", bias / count);
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
        assert!((bias / count).abs() < 1e-6, "{}", bias / count);
    }
}
