//! I2F14 by hand: 16-bit lanes in 32-bit registers.

use fixed::types::I2F14;

use super::Lanes;
use crate::specular::nearest;
use crate::sphere::DistantSphere;

/// [`Real::normalize`](crate::real::Real::normalize) on bits.
#[inline]
pub(super) fn normalize(v: Lanes) -> Lanes {
    super::normalize::<14>(v)
}

/// [`cap`](crate::specular::cap).
#[inline]
pub(super) fn cap(l: [I2F14; 3], r: [I2F14; 3], light: &DistantSphere<I2F14>) -> [I2F14; 3] {
    nearest(l, r, light)
}
