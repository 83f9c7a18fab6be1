//! The reciprocal square root to 16 bits, in products of 32: a table of 96 bytes and one step of Newton's.

use crate::constant;

/// One for each of the top five bits that a mantissa in [1/4, 1) can have.
const CELLS: usize = 24;

/// What the table starts with: on [`NO_COUNT`] the compiler sees that nothing below 8 is looked up, and elsewhere 8 lines
/// of zero spare a comparison.
const FIRST: usize = if NO_COUNT { 8 } else { 0 };

/// The line beside `1/sqrt(y)` over each cell: its value at the cell's start in Q23, and in the low eight bits its fall
/// over the cell in Q11. What the fall adds to the value is far below the seed's last bit.
const LINES: [u32; CELLS + 8 - FIRST] = lines();

/// Whether the machine has no instruction that counts leading zeros: Cortex-M0 and M0+.
pub(super) const NO_COUNT: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// `half` and `2^(31 - half) / sqrt(square) 2^half`, which lies from `2^15` to `2^16`, of a `square` above 0:
/// `half` is how often it is to be doubled twice to be at least `2^30`.
///
/// Within 1 of the exact value, and within 0.61 where it is below `1.2 * 2^15`. That of zero is that of 1.
// Where there is little flash, one copy has to do, at the price of a call.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
pub(super) fn reciprocal_root(square: u32) -> (u32, u32) {
    let (half, mantissa) = if NO_COUNT { compared(square) } else { counted(square) };
    (half, root(mantissa))
}

#[inline(always)]
const fn counted(square: u32) -> (u32, u32) {
    let half = square.leading_zeros() >> 1;
    (half, square.wrapping_shl(half.wrapping_mul(2)))
}

/// The same by comparing: most vectors are about as long as 1.
#[inline(always)]
const fn compared(mut square: u32) -> (u32, u32) {
    let mut half = 0;
    while square < 1 << 22 {
        square <<= 8;
        half = u32::wrapping_add(half, 4);
    }
    while square < 1 << 30 {
        square <<= 2;
        half = u32::wrapping_add(half, 1);
    }
    (half, square)
}

/// `2^31 / sqrt(m)` of `m` in `[2^30, 2^32)`.
#[inline(always)]
fn root(m: u32) -> u32 {
    let line = LINES.get((m >> 27).wrapping_sub(FIRST as u32) as usize).copied().unwrap_or_default();
    // In Q11, so that the square is exact in 24 bits.
    let seed = line.wrapping_sub((line & 0xff).wrapping_mul((m << 5) >> 12)) >> 20;
    // How much y seed^2 is above 1. It is under 2^-9, hence in Q40 a number of 32 bits, of which 16 will do.
    let above = (m >> 14).wrapping_mul(seed.wrapping_mul(seed)) as i32 >> 16;
    let fall = above.wrapping_mul(seed as i32) >> 20;
    (seed << 5).wrapping_sub(fall as u32) >> 1
}

const fn lines() -> [u32; CELLS + 8 - FIRST] {
    let mut lines = [0; CELLS + 8 - FIRST];
    let mut cell = 8;
    while cell < CELLS + 8 {
        lines[cell - FIRST] = line(cell as f64 / 32.0, (cell + 1) as f64 / 32.0);
        cell += 1;
    }
    lines
}

/// The chord from `from` to `to`, lowered by half of its greatest distance from the curve.
const fn line(from: f64, to: f64) -> u32 {
    const STEPS: u32 = 64;
    const Q11: f64 = 2048.0;
    let start = 1.0 / constant::sqrt(from);
    let fall = ((start - 1.0 / constant::sqrt(to)) * Q11 + 0.5) as u32;
    let (mut most, mut least) = (0.0, 0.0);
    let mut step = 0;
    while step <= STEPS {
        let part = step as f64 / STEPS as f64;
        let gap = start - fall as f64 / Q11 * part - 1.0 / constant::sqrt(from + (to - from) * part);
        most = if gap > most { gap } else { most };
        least = if gap < least { gap } else { least };
        step += 1;
    }
    // The seed is cut to Q11.
    let value = (start - (most + least) / 2.0) * Q11 + 0.5;
    (((value * 4096.0) as u32) << 8) | fall
}

#[cfg(test)]
mod tests {
    use super::{compared, counted, reciprocal_root};

    #[test]
    fn leading_zeros_by_comparing_are_the_same() {
        for bit in 0..32 {
            for square in [1_u32 << bit, (1 << bit) | ((1_u64 << bit) - 1) as u32] {
                assert_eq!(compared(square), counted(square), "{square:#x}");
            }
        }
    }

    /// Worst error over a spread of mantissas below `end`.
    fn worst(start: u32, end: u32) -> f64 {
        let error = |m: u32| {
            let (half, root) = reciprocal_root(m);
            assert_eq!(half, 0);
            assert!(root <= 1 << 16, "{m:#x}");
            (f64::from(root) - 2_147_483_648.0 / f64::from(m).sqrt()).abs()
        };
        (start..=end).step_by(997).chain([start, end]).map(error).fold(0.0, f64::max)
    }

    #[test]
    fn is_within_its_bounds_and_they_are_tight() {
        let all = worst(1 << 30, u32::MAX);
        assert!(all < 1.0 && all > 0.9, "{all}");
        // sqrt(m) = 2^16 / 1.2.
        let small = worst(2_982_616_178, u32::MAX);
        assert!(small < 0.61 && small > 0.5, "{small}");
    }

    #[test]
    fn halves_count() {
        for half in 0..16 {
            assert_eq!(reciprocal_root(u32::MAX >> (2 * half)).0, half);
            assert_eq!(reciprocal_root(1 << (30 - 2 * half)), (half, reciprocal_root(1 << 30).1));
        }
    }
}
