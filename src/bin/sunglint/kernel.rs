//! Building blocks as a list: functions that are part of a lit pixel.
//!
//! To add one: a variant of [`Kernel`], its name and unit, its errors and its call. Table, chart and clock then have it.

use oorandom::Rand64;
use sunglint::oracle::angle_between;
use sunglint::trial::{Found, input};
use sunglint::{Real, normalize, reflect};

use crate::clock::{Batch, batch};

/// A function to be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// A vector of any length to unit length.
    Normalize,
    /// The mirror direction.
    Reflect,
}

impl Kernel {
    /// All of them, in the order of tables.
    pub const ALL: [Self; 2] = [Self::Normalize, Self::Reflect];

    /// Name, as tables and charts print it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Normalize => "normalize",
            Self::Reflect => "reflect",
        }
    }

    /// What its errors are in.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Normalize | Self::Reflect => "rad",
        }
    }

    /// Its errors against f64 at `count` random inputs, as rounded into the format.
    pub fn errors<T: Real>(self, seed: u64, count: usize) -> Measured {
        match self {
            Self::Normalize => Measured::of(&normalize_errors::<T>(seed, count)),
            Self::Reflect => Measured::of(&reflect_errors::<T>(seed, count)),
        }
    }

    /// Its calls, for the clock.
    pub fn calls<T: Real>(self) -> Batch {
        let pairs = pairs::<T>();
        match self {
            Self::Normalize => batch(pairs, |&[_, b]| normalize(b)),
            Self::Reflect => batch(pairs, |&[a, b]| reflect(a, b)),
        }
    }
}

/// What came of judging a kernel, however many inputs it has.
pub struct Measured {
    /// The worst error.
    pub max: f64,
    /// Root mean square of the error.
    pub rms: f64,
    /// Inputs that were tried.
    pub samples: u64,
    /// Input of the worst error.
    pub worst: Vec<f64>,
}

impl Measured {
    fn of<const INPUTS: usize>(found: &Found<INPUTS>) -> Self {
        Self { max: found.max, rms: found.rms(), samples: found.samples, worst: found.worst.to_vec() }
    }
}

/// Angle between `normalize(v)` and `v`, for lengths from a half to 1.15, the most that fits every format.
fn normalize_errors<T: Real>(seed: u64, count: usize) -> Found<3> {
    let mut source = Rand64::new(u128::from(seed));
    let mut found = Found::new();
    for pair in input::random(seed, count, 0.0) {
        let length = 0.5 + 0.65 * source.rand_float();
        let v = pair.r.map(|lane| T::from_f64(length * lane));
        let exact = v.map(T::to_f64);
        found.add(angle(normalize(v), exact), exact);
    }
    found
}

/// Angle between `reflect(n, v)` and `2 (n.v) n - v` in f64, which is rounded less often here than there.
fn reflect_errors<T: Real>(seed: u64, count: usize) -> Found<6> {
    let mut found = Found::new();
    for pair in input::random(seed, count, 0.0) {
        let [n, v] = [pair.l, pair.r].map(|vector| vector.map(T::from_f64));
        let [[a, b, c], [d, e, f]] = [n, v].map(|vector| vector.map(T::to_f64));
        let twice = 2.0 * a.mul_add(d, b.mul_add(e, c * f));
        let truth = [twice.mul_add(a, -d), twice.mul_add(b, -e), twice.mul_add(c, -f)];
        found.add(angle(reflect(n, v), truth), [a, b, c, d, e, f]);
    }
    found
}

/// The angle between an answer and the truth; NaN where the answer is no direction.
fn angle<T: Real>(answer: [T; 3], truth: [f64; 3]) -> f64 {
    let answer = answer.map(T::to_f64);
    if answer == [0.0; 3] { f64::NAN } else { angle_between(answer, truth) }
}

/// Pixels across the ball whose pixels make a batch.
const SIDE: u32 = 64;

/// Directions to the light and along the mirror ray of the pixels of a ball.
pub fn pairs<T: Real>() -> Vec<[[T; 3]; 2]> {
    input::ball(SIDE).map(|pair| [pair.l.map(T::from_f64), pair.r.map(T::from_f64)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_that_is_no_direction_is_as_wrong_as_can_be() {
        let mut found = Found::<3>::new();
        found.add(angle([0.0_f32; 3], [0.0, 0.0, 1.0]), [0.0; 3]);
        assert_eq!(found.max, f64::INFINITY);
        assert!(angle([f32::NAN; 3], [0.0, 0.0, 1.0]).is_nan());
    }

    #[test]
    fn errors_are_about_a_step_of_the_format() {
        for kernel in Kernel::ALL {
            let error = kernel.errors::<f32>(1, 1000);
            assert!(error.max > 1e-9 && error.max < 1e-6, "{} {}", kernel.name(), error.max);
            assert!(error.rms < error.max && error.samples == 1000);
        }
    }
}
