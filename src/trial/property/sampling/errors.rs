//! The errors of sampling, and their budgets for discs of every size.

use core::f64::consts::{FRAC_PI_2, PI};

use super::Sample;
use crate::light::DistantLight;
use crate::oracle;
use crate::real::{Real, Scalar};
use crate::sampling::{basis, sin_cos};
use crate::trial::format::{Format, Visitor};
use crate::trial::found::{worse, worst};
use crate::trial::property::figures::{Figures, NONE, Row};

/// Angular radii up to which a bin of discs goes; the last is the full sphere, of which the narrow formats can't tell what
/// is less than 0.001 short of it.
const BINS: [f64; 9] = [1e-3, 1e-2, 0.1, 0.5, 1.2, FRAC_PI_2, 2.4, PI - 1e-3, 4.0];

/// The rows: directions by bin, the band about the rim by bin, then one each.
const RIM: usize = BINS.len();
const LENGTH: usize = 2 * RIM;
const BASIS: usize = LENGTH + 1;
const TURN: usize = BASIS + 1;
const SOLID_ANGLE: usize = TURN + 1;
const DENSITY: usize = SOLID_ANGLE + 1;

/// Budgets of directions in radians and of the rim's band in radians for discs of every size, then of what is measured
/// once for all discs.
pub const BUDGETS: [Row; DENSITY + 1] = [
    ("direction, below 0.001 rad", [3.2e-16, 1.2e-7, 1.2e-7, 9.8e-4, 1.7e-4, 1.9e-9, 3.1e-5]),
    ("direction, below 0.01 rad", [3.4e-16, 1.1e-7, 1.5e-7, 9.3e-4, 1.2e-4, 1.9e-9, 3e-5]),
    ("direction, below 0.1 rad", [3.3e-16, 1.2e-7, 1.1e-6, 8.7e-4, 1.3e-4, 1.9e-9, 3.1e-5]),
    ("direction, below 0.5 rad", [6.2e-16, 2.6e-7, 4.3e-6, 2e-3, 1.4e-4, 2.8e-9, 3.7e-5]),
    ("direction, below 1.2 rad", [1.2e-15, 4.8e-7, 5.3e-6, 4.3e-3, 2.1e-4, 3.6e-9, 5e-5]),
    ("direction, up to half the sky", [1.6e-15, 6e-7, 5.3e-6, 5.3e-3, 2.7e-4, 3.9e-9, 7.3e-5]),
    ("direction, below 2.4 rad", [1.8e-15, 6.7e-7, 2.1e-5, 5.7e-3, 2.7e-4, 5e-9, 6.5e-5]),
    ("direction, below 3.1406 rad", [1.5e-15, 4.4e-7, 8.3e-6, 3.5e-3, 1.8e-4, 3.5e-9, 4.3e-5]),
    ("direction, up to the full sphere", [1.2e-15, 3.5e-7, 5.1e-6, 2.4e-3, 1.7e-4, 3.2e-9, 4.3e-5]),
    ("rim, below 0.001 rad", [3.7e-19, 3.1e-9, 3.1e-9, 4.7e-4, 6.8e-5, 8.6e-13, 1.7e-5]),
    ("rim, below 0.01 rad", [5.9e-18, 1.6e-9, 1.6e-9, 2.1e-4, 3.2e-6, 1.4e-11, 1.2e-7]),
    ("rim, below 0.1 rad", [4.7e-17, 1.8e-8, 1.9e-8, 1.4e-4, 4e-6, 1.4e-10, 9.9e-7]),
    ("rim, below 0.5 rad", [2.5e-16, 8e-8, 8.2e-8, 6.5e-4, 2.6e-5, 6e-10, 5.8e-6]),
    ("rim, below 1.2 rad", [3.8e-16, 3e-7, 3e-7, 2.3e-3, 5.7e-5, 1.3e-9, 1.5e-5]),
    ("rim, up to half the sky", [7.5e-16, 3.6e-7, 3.6e-7, 2.6e-3, 8.9e-5, 1.4e-9, 2.6e-5]),
    ("rim, below 2.4 rad", [1e-15, 3.5e-7, 3.5e-7, 3e-3, 8.4e-5, 1.6e-9, 2.3e-5]),
    ("rim, below 3.1406 rad", [5e-16, 2e-7, 2e-7, 1.6e-3, 3.6e-5, 1.1e-9, 8.3e-6]),
    ("rim, up to the full sphere", [5e-16, 3.3e-8, 3.3e-8, 4.8e-4, 6.8e-5, 1.1e-9, 1.8e-5]),
    ("length of a direction", [8.8e-16, 4.8e-7, 1.1e-5, 3.6e-3, 1.3e-4, 3.5e-9, 3.1e-5]),
    ("basis", [5e-16, 1.4e-7, 1.4e-7, 1.2e-3, 1.5e-4, 2.3e-9, 3.7e-5]),
    ("sine and cosine of a turn", [2.5e-16, 8.5e-8, 8.5e-8, 6.2e-4, 4.1e-10, 5e-10, 4.2e-10]),
    ("solid angle, relative", [1.3e-15, 3.6e-7, 3.6e-7, 2.8e-3, 4.2e-6, 2.7e-9, 2.7e-7]),
    ("density times solid angle", [1.3e-16, 6.7e-8, 6.7e-8, 5.5e-4, 6.6e-10, 6.6e-10, 6.6e-10]),
];

fn bin(light: &DistantLight) -> usize {
    let theta = light.angular_radius();
    BINS.into_iter().position(|end| theta <= end).unwrap_or(RIM - 1)
}

/// The budget of a direction under a light.
pub fn direction_budget(format: Format, light: &DistantLight) -> f64 {
    BUDGETS[bin(light)].1[format as usize]
}

pub struct Errors(pub Sample);

impl Visitor for Errors {
    type Output = Figures;

    fn visit<T: Real>(self) -> Figures {
        let Self(sample) = self;
        if sample.raw {
            return NONE;
        }
        let theta = sample.light.angular_radius();
        let cone = sample.cone::<T>();
        let point = sample.point.map(T::from_f64);
        let l = sample.l.map(T::from_f64).map(T::to_f64);
        let answer = cone.direction(point).map(T::to_f64);
        let truth = oracle::cone::direction(l, theta, point.map(T::to_f64));
        let beside = sample.direction.map(T::from_f64);
        let angle = oracle::angle_between(l, beside.map(T::to_f64));
        let wrong = cone.contains(beside) != (angle <= theta);
        let bin = bin(&sample.light);
        let [solid_angle, density] = densities::<T>(&sample);
        [
            Some((bin, oracle::angle_between(answer, truth))),
            Some((RIM + bin, if wrong { (angle - theta).abs() } else { 0.0 })),
            Some((LENGTH, (size(answer) - 1.0).abs())),
            Some((BASIS, basis_error(sample.l.map(T::from_f64)))),
            Some((TURN, turn_error(point[1]))),
            solid_angle.map(|error| (SOLID_ANGLE, error)),
            density.map(|error| (DENSITY, error)),
            None,
        ]
    }
}

/// Relative error of the solid angle, and the error of its product with the density, where the format's lights have all
/// their digits: from a ratio of 1e-5 on, in I2F14 and I16F16 of 0.001 and in f16 of 0.0045.
fn densities<T: Real>(sample: &Sample) -> [Option<f64>; 2] {
    let least = match sample.format {
        Format::F16 => 0.0045,
        Format::I2F14 | Format::I16F16 => 0.001,
        _ => 1e-5,
    };
    let theta = sample.light.angular_radius();
    if theta < least || theta > PI {
        return [None; 2];
    }
    let cone = sample.cone::<T>();
    let truth = oracle::cone::solid_angle(theta);
    let solid_angle = cone.solid_angle().exact();
    let product = cone.pdf().map_or(f64::INFINITY, Scalar::exact) * solid_angle;
    [Some((solid_angle - truth).abs() / truth), Some((product - 1.0).abs())]
}

/// The greatest of the two vectors' cosines to each other and to `l` and of the differences of their lengths from 1.
fn basis_error<T: Real>(l: [T; 3]) -> f64 {
    let [t, b] = basis(l).map(|v| v.map(T::to_f64));
    let l = l.map(T::to_f64);
    let right = |a, b| (oracle::angle_between(a, b) - FRAC_PI_2).abs();
    worst([right(t, l), right(b, l), right(t, b), (size(t) - 1.0).abs(), (size(b) - 1.0).abs()].into_iter())
}

/// The greater error of sine and cosine.
fn turn_error<T: Real>(turn: T) -> f64 {
    let [sin, cos] = sin_cos(T::of_lane(turn)).map(Scalar::exact);
    let [sine, cosine] = oracle::cone::turned(turn.to_f64());
    worse((sin - sine).abs(), (cos - cosine).abs())
}

fn size(v: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(v[0], v[1]), v[2])
}
