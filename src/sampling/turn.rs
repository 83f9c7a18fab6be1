//! Sine and cosine of a part of a full turn, by one polynomial each, since most formats have neither.

use crate::real::{Constant, Scalar, within_one};

/// Terms of the series for the format with most digits, f64: the first one left out is below 7e-17.
const TERMS: usize = 8;

/// Terms for formats of up to 31 digits: the first one left out is below 7e-12 of the sine, 2e-10 of the cosine.
const SHORT_TERMS: usize = 5;

/// `(2 pi - sin(2 pi t) / t) / t^2` in powers of `-t^2`.
const SINE: [Constant; TERMS] = series(3);

/// `(1 - cos(2 pi t)) / t^2` in powers of `-t^2`.
const COSINE: [Constant; TERMS] = series(2);

/// `[sin(2 pi t), cos(2 pi t)]` of `t` turns in `[0, 1]`.
///
/// Error of either, over all turns that the 16-bit formats have and those of the others that are found by search, as
/// `tests/turn.rs` and `tests/figures.rs` assert:
///
/// | | f64 | f32 | micromath | f16 | I2F14 | I2F30 | I16F16 |
/// |---|---|---|---|---|---|---|---|
/// | worst | 2.5e-16 | 8.5e-8 | 8.5e-8 | 6.2e-4 | 4.1e-10 | 5.0e-10 | 4.2e-10 |
///
/// Turns below 0, and NaN, are taken for 0 and turns above 1 for 1.
///
/// Source: Taylor's series about 0, after folding the turn into its first eighth, which is exact.
///
/// ```
/// use sunglint::sampling::sin_cos;
///
/// // Quarters are exact; a twelfth is 30 degrees.
/// assert_eq!([0.0_f32, 0.25, 0.5, 0.75].map(sin_cos), [[0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [-1.0, 0.0]]);
/// let [sin, cos] = sin_cos(1.0_f32 / 12.0);
/// assert!((sin - 0.5).abs() < 8.5e-8 && (cos - 0.866_025_4).abs() < 8.5e-8);
/// ```
#[inline]
pub fn sin_cos<S: Scalar>(turn: S) -> [S; 2] {
    const HALF: Constant = Constant::new(0.5);
    const QUARTER: Constant = Constant::new(0.25);
    const EIGHTH: Constant = Constant::new(0.125);
    const EIGHT: Constant = Constant::new(8.0);
    const EIGHT_LESS_TURN: Constant = Constant::new(8.0 - core::f64::consts::TAU);
    let (half, quarter) = (S::constant(HALF), S::constant(QUARTER));
    let turn = within_one(turn);
    let (turn, opposite) = if turn >= half { (turn - half, true) } else { (turn, false) };
    let (turn, crossed) = if turn >= quarter { (turn - quarter, true) } else { (turn, false) };
    let (turn, mirrored) = if turn > S::constant(EIGHTH) { (quarter - turn, true) } else { (turn, false) };
    let square = turn * turn;
    // The greater part, 8 t and 1, is exact.
    let lacking = turn * (S::constant(EIGHT_LESS_TURN) + square * sum(&SINE, square));
    let (sin, cos) = (S::constant(EIGHT) * turn - lacking, S::ONE - square * sum(&COSINE, square));
    let (sin, cos) = if mirrored { (cos, sin) } else { (sin, cos) };
    let (sin, cos) = if crossed { (cos, S::ZERO - sin) } else { (sin, cos) };
    if opposite { [S::ZERO - sin, S::ZERO - cos] } else { [sin, cos] }
}

#[inline]
fn sum<S: Scalar>(series: &[Constant; TERMS], square: S) -> S {
    const BELOW_31_DIGITS: Constant = Constant::new(1.0 / (1_u64 << 40) as f64);
    let short = S::ONE + S::constant(BELOW_31_DIGITS) <= S::ONE;
    let terms = if short { SHORT_TERMS } else { TERMS };
    series.iter().take(terms).rev().fold(S::ZERO, |sum, &term| S::constant(term) - square * sum)
}

/// `(2 pi)^k / k!` for every other `k` from `power` on, which is 2 or 3.
const fn series(power: usize) -> [Constant; TERMS] {
    const TAU: f64 = core::f64::consts::TAU;
    let mut terms = [Constant::new(0.0); TERMS];
    let mut value = TAU * TAU / 2.0 * if power == 3 { TAU / 3.0 } else { 1.0 };
    let (mut term, mut k) = (0, power);
    while term < TERMS {
        terms[term] = Constant::new(value);
        value *= TAU * TAU / ((k + 1) * (k + 2)) as f64;
        (term, k) = (term + 1, k + 2);
    }
    terms
}
