//! Formulas as all formats share them, where a format has code of its own beside them.

use crate::real::Real;
use crate::specular::nearest;
use crate::sphere::DistantSphere;

/// [`cap`](crate::specular::cap) by its formula.
#[inline]
pub fn cap<T: Real>(l: [T; 3], r: [T; 3], light: &DistantSphere<T>) -> [T; 3] {
    nearest(l, r, light)
}
