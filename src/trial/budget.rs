//! Error budgets of the direction methods: the worst arithmetic error in radians, against the exact value of the
//! method's own formula at the rounded inputs.
//!
//! Each is 1.12 times the worst that searches have found, rounded up to two digits. A [search](super::search) judges
//! 515 000 to 940 000 inputs for each and climbs from random, hard and almost opposite directions to those that all
//! roundings work against; [`worst`](super::worst) has what was found, and `tests/search.rs` ties every budget here to
//! that. Seeds 1 and 2 each raised one record in twenty by 5 % or more, the most by 14 and 20 %, so 1.12 is
//! no proof. In f64 the oracle's own rounding counts as the method's; `tests/oracle.rs` holds
//! `cap` and `factored` there to their budgets against 192 bits too.
//!
//! Excluded are pairs for which the formula has no one answer: `r` within one step of the format of `-l`, where all
//! of the rim is as near (at the Sun `cap` holds there as well, in f16 from a tenth of a step), and representative
//! points less than 0.1 long.

use super::aim::{DISCS, HALVES, SPHERES};
use super::format::Format;
use super::method::Method;

/// Budgets for f64, f32, micromath, f16, I2F14, I2F30 and I16F16.
type Maxima = [f64; 7];

/// In place of a budget: all answers are NaN, or the disc is lost.
const FAILS: f64 = f64::NAN;

/// The budget of `method` in `format` under the light at `light` in [`BUDGETED`](super::lights::BUDGETED); none where
/// the method is known to fail.
pub fn maximum(method: Method, format: Format, light: usize) -> Option<f64> {
    let table = match method {
        Method::Epic => &EPIC,
        Method::Factored => &FACTORED,
        Method::Disc => &DISC,
        Method::Cap => &CAP,
    };
    table.get(light).map(|row| row[format as usize]).filter(|budget| !budget.is_nan())
}

/// Root mean square of the error of `cap` at the Sun over 300 000 random pairs from each of the seeds 1 to 3.
pub fn cap_rms_at_the_sun(format: Format) -> f64 {
    [4.6e-17, 1.4e-8, 1.8e-8, 1.1e-4, 2.3e-5, 4.5e-10, 5.7e-6][format as usize]
}

/// The representative point with its lengths. The Sun's distance in kilometres overflows f16 and fixed point; lights
/// that are given by their ratio alone have distance 1, which makes it the same arithmetic as [`FACTORED`].
const EPIC: [Maxima; 6] = [
    [4.3e-16, 1.5e-7, 1.6e-7, FAILS, FAILS, FAILS, FAILS],
    FACTORED[1],
    FACTORED[2],
    FACTORED[3],
    FACTORED[4],
    FACTORED[5],
];

/// The representative point with the distance divided out, where it is at least 0.1 long.
const FACTORED: [Maxima; 6] = [
    [4.0e-16, 1.3e-7, 1.6e-7, 8.7e-4, 1.4e-4, 2.3e-9, 3.5e-5],
    [4.2e-16, 1.1e-7, 1.3e-7, 5.0e-4, 1.3e-4, 2.3e-9, 3.0e-5],
    [4.1e-16, 1.6e-7, 3.7e-7, 1.1e-3, 1.5e-4, 2.5e-9, 3.6e-5],
    [6.9e-16, 2.5e-7, 3.8e-6, 2.0e-3, 2.2e-4, 3.4e-9, 5.5e-5],
    [2.6e-15, 1.6e-6, 2.5e-5, 1.2e-2, 1.1e-3, 2.0e-8, 2.7e-4],
    [1.4e-15, 6.2e-7, 6.5e-7, 5.1e-3, 6.0e-4, 9.2e-9, 1.5e-4],
];

/// The disc by its cosine. What is far above `CAP` here is its test (small discs) or the tangent a few steps from `-l`,
/// which is more rounding than tangent there: the answer is on the rim, on any side.
const DISC: [Maxima; 6] = [
    [4.4e-3, 4.3e-3, 4.3e-3, 5.7e-2, 1.2e-2, 3.9e-3, 5.3e-3],
    [9.3e-5, 5.6e-4, 5.6e-4, 6.2e-2, 1.7e-2, 8.3e-5, 7.8e-3],
    [4.7e-2, 4.7e-2, 4.7e-2, 4.7e-2, 4.6e-2, 4.3e-2, 4.6e-2],
    [0.52, 0.52, 0.52, 0.52, 0.51, 0.48, 0.51],
    [1.9, 1.9, 1.9, 1.9, 1.9, 1.7, 1.9],
    [1.6, 1.6, 1.6, 1.6, 1.6, 1.5, 1.6],
];

/// The default.
const CAP: [Maxima; 6] = [
    [2.5e-16, 5.7e-8, 8.0e-8, 4.8e-4, 6.2e-5, 1.5e-9, 1.5e-5],
    [2.5e-16, 5.7e-8, 5.7e-8, 1.2e-4, 6.1e-5, 1.4e-9, 1.5e-5],
    [2.7e-16, 6.5e-8, 3.3e-7, 5.3e-4, 6.3e-5, 1.5e-9, 1.6e-5],
    [5.5e-16, 2.1e-7, 2.5e-6, 1.6e-3, 9.0e-5, 1.9e-9, 3.1e-5],
    [9.2e-16, 3.6e-7, 2.4e-6, 2.9e-3, 1.1e-4, 3.4e-9, 5.2e-5],
    [6.1e-16, 2.7e-7, 2.8e-7, 2.1e-3, 8.8e-5, 2.7e-9, 5.3e-5],
];

/// The budget of `method` in `format` under any light of an angular radius of `theta`; none for what has none.
pub fn of_any_light(method: Method, format: Format, theta: f64) -> Option<f64> {
    let span = DISCS.iter().position(|span| theta <= span.to)?;
    let table: &[Maxima] = match method {
        Method::Epic | Method::Factored => &ANY_FACTORED,
        Method::Disc => &ANY_DISC,
        Method::Cap => &ANY_CAP,
    };
    table.get(span).map(|row| row[format as usize])
}

/// How far from 1 the length of the answer of `cap` may be, under lights of an angular radius of `theta`.
pub fn cap_length(format: Format, theta: f64) -> f64 {
    CAP_LENGTH[usize::from(theta > HALVES[0].to)][format as usize]
}

/// How far beyond the rim the answer of `cap` may lie, in units of the disc's sine, where `r` is within a step of the
/// format of `-l`: there the tangent's lanes are subnormal in f16, and what of them is along `l` is rounded with them.
pub fn cap_beyond_the_rim(format: Format) -> f64 {
    if format == Format::F16 { 2.3e-2 } else { 0.0 }
}

/// `soft::cap` under each of [`BUDGETED`](super::lights::BUDGETED), beside what rounding to Q30 does next to `-l`.
/// Under wide discs what `l` lacks of unit length counts (`tests/soft.rs`).
pub const SOFT_CAP: [f64; 6] = [5.1e-8, 5.3e-8, 5.4e-8, 6.5e-8, 1.1e-7, 1.1e-7];

/// The direction of `soft::normalize`, in radians (`tests/soft.rs`).
pub const SOFT_NORMALIZE: f64 = 5.0e-8;

/// How far off the lanes of `reflect` may be; f64 has none.
pub fn reflect(format: Format) -> Option<f64> {
    Some(REFLECT[format as usize]).filter(|budget| !budget.is_nan())
}

/// How far off the direction of `normalize` may be, in radians, and how far from 1 its length, for
/// [`LENGTHS`](super::aim::LENGTHS).
pub fn normalize(format: Format) -> [f64; 2] {
    [NORMALIZE[0][format as usize], NORMALIZE[1][format as usize]]
}

const ANY_FACTORED: [Maxima; SPHERES] = [
    [4.2e-16, 1.2e-7, 1.6e-7, 9.5e-4, 1.3e-4, 2.3e-9, 3.5e-5],
    [4.2e-16, 1.5e-7, 2.1e-7, 1.1e-3, 1.5e-4, 2.4e-9, 3.7e-5],
    [4.1e-16, 1.6e-7, 6.4e-7, 1.2e-3, 1.5e-4, 2.5e-9, 3.8e-5],
    [6.3e-16, 2.2e-7, 2.6e-6, 1.8e-3, 1.8e-4, 2.9e-9, 4.2e-5],
    [9.9e-16, 5.5e-7, 8.1e-6, 4.6e-3, 3.8e-4, 6.5e-9, 9.2e-5],
    [3.4e-15, 2.1e-6, 3.7e-5, 1.6e-2, 1.2e-3, 2.3e-8, 2.9e-4],
    [3.9e-15, 2.5e-6, 5.1e-5, 1.8e-2, 1.3e-3, 2.6e-8, 3.2e-4],
];
const ANY_DISC: [Maxima; DISCS.len()] = [
    [9.3e-4, 9.3e-4, 9.3e-4, 6.2e-2, 1.7e-2, 8.3e-4, 8.0e-3],
    [1.9e-2, 1.9e-2, 1.9e-2, 6.1e-2, 1.9e-2, 1.7e-2, 1.9e-2],
    [9.4e-2, 9.4e-2, 9.4e-2, 9.4e-2, 9.3e-2, 8.6e-2, 9.2e-2],
    [0.39, 0.39, 0.39, 0.39, 0.39, 0.37, 0.39],
    [0.95, 1.1, 1.1, 1.1, 0.99, 0.81, 1.0],
    [1.9, 1.9, 1.9, 1.9, 1.9, 1.7, 1.9],
    [1.9, 1.9, 1.9, 1.9, 1.8, 1.7, 1.8],
    [1.9, 1.9, 1.9, 1.9, 1.9, 1.8, 1.9],
    [0.73, 0.74, 0.74, 0.74, 0.75, 0.68, 0.72],
];
const ANY_CAP: [Maxima; DISCS.len()] = [
    [2.5e-16, 5.7e-8, 6.1e-8, 4.6e-4, 6.3e-5, 1.6e-9, 1.8e-5],
    [2.6e-16, 6.0e-8, 1.7e-7, 4.9e-4, 6.4e-5, 1.5e-9, 1.6e-5],
    [3.7e-16, 7.4e-8, 6.0e-7, 6.0e-4, 6.5e-5, 1.6e-9, 1.7e-5],
    [5.5e-16, 1.6e-7, 2.1e-6, 1.4e-3, 1.1e-4, 2.2e-9, 2.6e-5],
    [8.0e-16, 3.0e-7, 2.9e-6, 2.3e-3, 1.2e-4, 3.1e-9, 4.2e-5],
    [9.7e-16, 4.5e-7, 2.9e-6, 3.2e-3, 1.3e-4, 3.7e-9, 5.3e-5],
    [1.1e-15, 4.3e-7, 2.2e-6, 3.7e-3, 1.2e-4, 3.8e-9, 5.5e-5],
    [1.4e-15, 3.3e-7, 3.0e-6, 2.8e-3, 1.3e-4, 2.8e-9, 5.3e-5],
    [1.0e-15, 3.4e-7, 3.0e-6, 2.8e-3, 1.2e-4, 2.6e-9, 4.0e-5],
];
const CAP_LENGTH: [Maxima; 2] = [
    [6.3e-16, 3.2e-7, 5.6e-6, 7.5e-3, 1.7e-4, 3.0e-9, 4.0e-5],
    [7.5e-16, 3.7e-7, 5.6e-6, 7.9e-3, 1.7e-4, 2.3e-9, 3.2e-5],
];
const REFLECT: Maxima = [FAILS, 3.0e-7, 3.0e-7, 2.7e-3, 3.5e-5, 7.9e-10, 8.6e-6];
const NORMALIZE: [Maxima; 2] = [
    [1.5e-16, 7.8e-8, 7.8e-8, 6.4e-4, 6.0e-5, 9.0e-10, 1.5e-5],
    [3.8e-16, 2.0e-7, 5.4e-6, 1.8e-3, 7.2e-5, 1.2e-9, 1.5e-5],
];
