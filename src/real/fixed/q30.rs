//! I2F30 by hand: without products of 64 bits where the chip has none.

use fixed::types::I2F30;

use super::Lanes;
use crate::specular::nearest;
use crate::sphere::DistantSphere;

/// [`Real::normalize`](crate::real::Real::normalize) on bits.
#[inline]
pub(super) fn normalize(v: Lanes) -> Lanes {
    super::normalize::<30>(v)
}

/// [`cap`](crate::specular::cap).
#[inline]
pub(super) fn cap(l: [I2F30; 3], r: [I2F30; 3], light: &DistantSphere<I2F30>) -> [I2F30; 3] {
    nearest(l, r, light)
}
