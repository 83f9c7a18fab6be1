//! Directions of the disc, and the light of a matt surface.

use sunglint::sampling::Cone;
use sunglint::trial::chip::{Case, pairs};
use sunglint::{DistantSphere, Real, SUN, Scalar};

use crate::calls::sampling::{self, Facing, Matt, Sample};
use crate::counter::Counter;
use crate::inputs::{all, of_numbers, rounded};
use crate::row::Row;

pub fn count<T: Real>(counter: &Counter) {
    let row = |function| Row { function, format: T::NAME, by: "sunglint", case: "any" };
    let sphere = DistantSphere::<T>::of(&SUN);
    let lights = all(pairs(Case::Outside).map(|pair| rounded::<T>(pair.l)));
    row("basis").count(counter, sampling::basis, &lights);
    row("sin_cos").count(counter, sampling::sin_cos, &of_numbers(|[turn, ..]| T::Scalar::nearest(turn)));
    let mut cones = lights.into_iter().map(|l| Cone::new(l, &sphere));
    let sample = |[z, turn, _]: [f64; 3]| Sample { cone: cones.next().unwrap(), point: [z, turn].map(T::from_f64) };
    row("Cone::direction").count(counter, sampling::cone_direction, &of_numbers(sample));
    row("relative_illuminance").count(counter, sampling::relative_illuminance, &of_numbers(|n| facing(n, sphere)));
    row("lambert").count(counter, sampling::lambert, &of_numbers(matt::<T>));
}

/// Half of the suns are setting.
fn facing<T: Real>([cos, setting, _]: [f64; 3], sphere: DistantSphere<T>) -> Facing<T> {
    let n_dot_l = if setting < 0.5 { SUN.sin() * (2.0 * cos - 1.0) } else { cos };
    Facing { n_dot_l: T::wide(n_dot_l), sphere }
}

fn matt<T: Real>([albedo, level, n_dot_l]: [f64; 3]) -> Matt<T> {
    let illuminance = T::level(T::Scalar::nearest(100.0 * level));
    Matt { albedo: T::from_f64(albedo), illuminance, n_dot_l: T::wide(n_dot_l) }
}
