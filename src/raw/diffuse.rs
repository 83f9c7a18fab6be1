//! Diffuse light on raw bits.

use fixed::types::{I2F14, I2F30, U16F16, U32F32};

use super::{SphereQ14, SphereQ30};
use crate::diffuse;
use crate::real::Real;

/// [`lambert`](diffuse::lambert): albedo in Q14, `n_dot_l` in Q28 (the plain sum of three products of Q14), illuminance
/// and radiance in unsigned Q16. Within 0.57 units of Q16.
pub fn lambert_q14(albedo: i16, illuminance: u32, n_dot_l: i32) -> u32 {
    diffuse::lambert(I2F14::from_bits(albedo), U16F16::from_bits(illuminance), n_dot_l).to_bits()
}

/// [`lambert`](diffuse::lambert): albedo in Q30, `n_dot_l` in Q60 (the plain sum of three products of Q30), illuminance
/// and radiance in unsigned Q32. Within 2.5 units of Q32, or of 31 bits where they are coarser.
pub fn lambert_q30(albedo: i32, illuminance: u64, n_dot_l: i64) -> u64 {
    diffuse::lambert(I2F30::from_bits(albedo), U32F32::from_bits(illuminance), n_dot_l).to_bits()
}

/// [`lambert_disc`](diffuse::lambert_disc), in the Q formats of [`lambert_q14`].
pub fn lambert_disc_q14(albedo: i16, illuminance: u32, n_dot_l: i32, light: &SphereQ14) -> u32 {
    diffuse::lambert_disc(I2F14::from_bits(albedo), U16F16::from_bits(illuminance), n_dot_l, light).to_bits()
}

/// [`lambert_disc`](diffuse::lambert_disc), in the Q formats of [`lambert_q30`].
pub fn lambert_disc_q30(albedo: i32, illuminance: u64, n_dot_l: i64, light: &SphereQ30) -> u64 {
    diffuse::lambert_disc(I2F30::from_bits(albedo), U32F32::from_bits(illuminance), n_dot_l, light).to_bits()
}

/// [`relative_illuminance`](diffuse::relative_illuminance): `n_dot_l` in Q28, the answer in Q28 from 0 to `2^28`.
pub fn relative_illuminance_q14(n_dot_l: i32, light: &SphereQ14) -> i32 {
    I2F14::narrow(diffuse::relative_illuminance(n_dot_l, light))
}

/// [`relative_illuminance`](diffuse::relative_illuminance): `n_dot_l` in Q60, the answer in Q60 from 0 to `2^60`, of
/// which 31 bits are significant.
pub fn relative_illuminance_q30(n_dot_l: i64, light: &SphereQ30) -> i64 {
    I2F30::narrow(diffuse::relative_illuminance(n_dot_l, light))
}
