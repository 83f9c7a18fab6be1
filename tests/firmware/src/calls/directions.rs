//! Which point of the disc the mirror ray sees.

use sunglint::trial::formula;
use sunglint::{DistantSphere, Real, UnfactoredSphere, specular};

/// To the light and along the mirror ray.
pub struct Ray<T: Real> {
    pub l: [T; 3],
    pub r: [T; 3],
    pub sphere: DistantSphere<T>,
    pub unfactored: UnfactoredSphere<T>,
}

pub fn cap<T: Real>(ray: &Ray<T>) -> [T; 3] {
    specular::cap(ray.l, ray.r, &ray.sphere)
}

pub fn cap_by_formula<T: Real>(ray: &Ray<T>) -> [T; 3] {
    formula::cap(ray.l, ray.r, &ray.sphere)
}

pub fn factored<T: Real>(ray: &Ray<T>) -> [T; 3] {
    specular::factored(ray.l, ray.r, &ray.sphere)
}

pub fn disc<T: Real>(ray: &Ray<T>) -> [T; 3] {
    specular::disc(ray.l, ray.r, &ray.sphere)
}

pub fn epic<T: Real>(ray: &Ray<T>) -> [T; 3] {
    specular::epic(ray.l, ray.r, &ray.unfactored)
}
