//! The sampling of a light's disc against the definition: what is measured, and the budgets.
//!
//! Budgets are for f64, f32, micromath, f16, I2F14, I2F30 and I16F16: 1.12 times the worst of the seeds 1 to 3 with 100
//! 000 inputs each, rounded up to two digits; an ignored test of `tests/sampling.rs` prints them again.

use oorandom::Rand64;

use super::found::{Found, worse, worst};
use super::input;
use crate::light::DistantLight;
use crate::oracle;
use crate::real::{Real, Scalar};
use crate::sampling::{Cone, basis, sin_cos};
use crate::sphere::DistantSphere;

/// Worst error of a sampled direction in radians under each light of [`BUDGETED`](super::lights::BUDGETED), then of
/// [`WIDE`].
pub const DIRECTION: [[f64; 7]; 9] = [
    [2.8e-16, 1.1e-7, 1.1e-7, 8.2e-4, 1.2e-4, 1.8e-9, 3.0e-5],
    [3.0e-16, 1.1e-7, 1.0e-7, 1.2e-4, 1.2e-4, 1.9e-9, 3.0e-5],
    [3.2e-16, 1.1e-7, 5.3e-7, 8.7e-4, 1.2e-4, 1.8e-9, 3.0e-5],
    [4.3e-16, 1.3e-7, 4.4e-6, 1.3e-3, 1.2e-4, 2.0e-9, 2.9e-5],
    [7.1e-16, 3.4e-7, 5.3e-6, 2.4e-3, 1.3e-4, 2.5e-9, 3.5e-5],
    [9.1e-16, 2.4e-7, 5.0e-6, 2.5e-3, 1.5e-4, 2.6e-9, 3.9e-5],
    [8.7e-16, 3.1e-7, 1.5e-5, 4.2e-3, 1.5e-4, 2.7e-9, 3.6e-5],
    [8.6e-16, 2.6e-7, 5.2e-6, 2.2e-3, 1.6e-4, 2.7e-9, 3.9e-5],
    [7.9e-16, 2.3e-7, 5.1e-6, 2.0e-3, 1.6e-4, 2.4e-9, 3.6e-5],
];

/// Worst error of [`basis`].
pub const BASIS: [f64; 7] = [5.0e-16, 1.3e-7, 1.3e-7, 1.1e-3, 1.5e-4, 2.1e-9, 3.5e-5];

/// Worst error of [`sin_cos`].
pub const TURN: [f64; 7] = [2.5e-16, 8.3e-8, 8.3e-8, 6.2e-4, 4.1e-10, 4.9e-10, 4.2e-10];

/// Discs beyond half the sky, as UsdLux angles in degrees.
pub const WIDE: [f64; 3] = [200.0, 300.0, 360.0];

/// Directions to lights: the six axes, then random ones, one in eight of them beside an axis.
pub fn lights(seed: u64, count: usize) -> impl Iterator<Item = [f64; 3]> {
    let axes =
        [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    axes.into_iter().chain(input::random(seed, count, 0.1).map(|pair| pair.l))
}

/// Points of the square: random ones, and in turns the ends of either side.
pub fn points<T: Real>(seed: u64) -> impl Iterator<Item = [T; 2]> {
    let mut source = Rand64::new(u128::from(seed) + 1000);
    let last = T::from_f64(below_one::<T>());
    (0_u32..).map(move |index| {
        let mut random = || T::from_f64(source.rand_float() * below_one::<T>());
        let (z, turn) = (random(), random());
        match index % 8 {
            0 => [T::ZERO, turn],
            1 => [last, turn],
            2 => [z, T::from_f64(f64::from((index / 8) % 8) / 8.0)],
            _ => [z, turn],
        }
    })
}

/// The greatest number below 1 of the format.
pub fn below_one<T: Real>() -> f64 {
    // From the coarsest to the finest, the last step that is still seen.
    let below = |digits: i32| 1.0 - libm::scalbn(1.0, -digits);
    (1..=53).map(below).take_while(|&value| T::from_f64(value).to_f64() == value).last().unwrap_or(0.0)
}

/// Error in radians of the sampled direction.
pub fn direction_error<T: Real>(light: &DistantLight, seed: u64, count: usize) -> Found {
    let sphere = DistantSphere::<T>::of(light);
    let mut found = Found::new();
    for (l, point) in lights(seed, count).zip(points::<T>(seed)) {
        let l = l.map(T::from_f64);
        let answer = Cone::new(l, &sphere).direction(point).map(T::to_f64);
        let (l, point) = (l.map(T::to_f64), point.map(T::to_f64));
        let truth = oracle::cone::direction(l, light.angular_radius(), point);
        found.add(oracle::angle_between(answer, truth), [l[0], l[1], l[2], point[0], point[1], 0.0]);
    }
    found
}

/// The greatest of the two vectors' cosines to each other and to `l` and of the differences of their lengths from 1.
pub fn basis_error<T: Real>(seed: u64, count: usize) -> Found {
    let mut found = Found::new();
    for l in lights(seed, count) {
        let l = l.map(T::from_f64);
        let [t, b] = basis(l).map(|v| v.map(T::to_f64));
        let l = l.map(T::to_f64);
        let right = |a, b| (oracle::angle_between(a, b) - core::f64::consts::FRAC_PI_2).abs();
        let long = |v: [f64; 3]| (libm::hypot(libm::hypot(v[0], v[1]), v[2]) - 1.0).abs();
        let error = worst([right(t, l), right(b, l), right(t, b), long(t), long(b)].into_iter());
        found.add(error, [l[0], l[1], l[2], 0.0, 0.0, 0.0]);
    }
    found
}

/// Error of sine and cosine, whichever is greater, of `turns`.
pub fn turn_error<T: Real>(turns: impl Iterator<Item = T>) -> Found {
    let mut found = Found::new();
    for turn in turns {
        let [sin, cos] = sin_cos(T::of_lane(turn)).map(Scalar::exact);
        let turn = turn.to_f64();
        let [sine, cosine] = oracle::cone::turned(turn);
        found.add(worse((sin - sine).abs(), (cos - cosine).abs()), [turn, 0.0, 0.0, 0.0, 0.0, 0.0]);
    }
    found
}
