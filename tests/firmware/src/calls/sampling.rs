//! Directions of the disc, and the light of a matt surface.

use sunglint::sampling::{self, Cone};
use sunglint::{DistantSphere, Real, Scalar, diffuse};

/// A cone and where in it.
pub struct Sample<T: Real> {
    pub cone: Cone<T>,
    pub point: [T; 2],
}

/// A cosine at a light.
pub struct Facing<T: Real> {
    pub n_dot_l: T::Wide,
    pub sphere: DistantSphere<T>,
}

/// A matt surface.
pub struct Matt<T: Real> {
    pub albedo: T,
    pub illuminance: T::Level,
    pub n_dot_l: T::Wide,
}

pub fn sin_cos<S: Scalar>(turn: &S) -> [S; 2] {
    sampling::sin_cos(*turn)
}

pub fn basis<T: Real>(l: &[T; 3]) -> [[T; 3]; 2] {
    sampling::basis(*l)
}

pub fn cone_direction<T: Real>(sample: &Sample<T>) -> [T; 3] {
    sample.cone.direction(sample.point)
}

pub fn relative_illuminance<T: Real>(facing: &Facing<T>) -> T::Scalar {
    diffuse::relative_illuminance(facing.n_dot_l, &facing.sphere)
}

pub fn lambert<T: Real>(matt: &Matt<T>) -> T::Level {
    diffuse::lambert(matt.albedo, matt.illuminance, matt.n_dot_l)
}
