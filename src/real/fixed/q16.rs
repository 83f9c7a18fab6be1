//! I16F16 by the formulas that all formats share.

use fixed::types::I16F16;

use super::Lanes;
use crate::specular::nearest;
use crate::sphere::DistantSphere;

/// [`Real::normalize`](crate::real::Real::normalize) on bits.
#[inline]
pub(super) fn normalize(v: Lanes) -> Lanes {
    super::normalize::<16>(v)
}

/// [`cap`](crate::specular::cap).
#[inline]
pub(super) fn cap(l: [I16F16; 3], r: [I16F16; 3], light: &DistantSphere<I16F16>) -> [I16F16; 3] {
    nearest(l, r, light)
}
