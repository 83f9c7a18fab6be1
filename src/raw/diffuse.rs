//! Diffuse light on raw bits.

use fixed::types::{I2F14, I2F30, U16F16, U32F32};

use super::{SphereQ14, SphereQ30};
use crate::diffuse;
use crate::real::Real;

/// [`lambert`](diffuse::lambert): albedo in Q14, `n_dot_l` in Q28 (the plain sum of three products of Q14), illuminance
/// and radiance in unsigned Q16. Within 0.57 units of Q16 for levels up to 1000, 1.4 for any (`tests/figures.rs`).
///
/// ```
/// use sunglint::raw::lambert_q14;
///
/// // Illuminance pi makes a white surface that faces the light white; a grey one 60 degrees off it a quarter of that.
/// assert_eq!(lambert_q14(16_384, 205_887, 1 << 28), 65_536);
/// assert_eq!(lambert_q14(8192, 205_887, 1 << 27), 16_384);
/// ```
pub fn lambert_q14(albedo: i16, illuminance: u32, n_dot_l: i32) -> u32 {
    diffuse::lambert(I2F14::from_bits(albedo), U16F16::from_bits(illuminance), n_dot_l).to_bits()
}

/// [`lambert`](diffuse::lambert): albedo in Q30, `n_dot_l` in Q60 (the plain sum of three products of Q30), illuminance
/// and radiance in unsigned Q32. Within 2.5 units of Q32, or of 31 bits where they are coarser, for levels up to 1000, 2.9
/// for any (`tests/figures.rs`).
///
/// ```
/// use sunglint::raw::lambert_q30;
///
/// // 100 000 lx on a white wall, 60 degrees off: 15 915 cd/m^2.
/// assert_eq!(lambert_q30(1 << 30, 100_000 << 32, 1 << 59) >> 32, 15_915);
/// assert_eq!(lambert_q30(1 << 30, 100_000 << 32, -1), 0);
/// ```
pub fn lambert_q30(albedo: i32, illuminance: u64, n_dot_l: i64) -> u64 {
    diffuse::lambert(I2F30::from_bits(albedo), U32F32::from_bits(illuminance), n_dot_l).to_bits()
}

/// [`lambert_disc`](diffuse::lambert_disc), in the Q formats of [`lambert_q14`]. The error is that of it and
/// of [`relative_illuminance_q14`].
///
/// ```
/// use sunglint::raw::{SUN_Q14, lambert_disc_q14, lambert_q14};
///
/// // The Sun half set, on a white plane: a thousandth of white, where its centre alone gives nothing.
/// assert_eq!(lambert_disc_q14(16_384, 205_887, 0, &SUN_Q14), 65);
/// assert_eq!(lambert_q14(16_384, 205_887, 0), 0);
/// ```
pub fn lambert_disc_q14(albedo: i16, illuminance: u32, n_dot_l: i32, light: &SphereQ14) -> u32 {
    diffuse::lambert_disc(I2F14::from_bits(albedo), U16F16::from_bits(illuminance), n_dot_l, light).to_bits()
}

/// [`lambert_disc`](diffuse::lambert_disc), in the Q formats of [`lambert_q30`]. The error is that of it and
/// of [`relative_illuminance_q30`].
///
/// ```
/// use sunglint::raw::{SUN_Q30, lambert_disc_q30, lambert_q30};
///
/// // Wholly above the plane the disc is as good as its centre.
/// let (white, illuminance, cos) = (1 << 30, 5 << 32, 1 << 58);
/// assert_eq!(lambert_disc_q30(white, illuminance, cos, &SUN_Q30), lambert_q30(white, illuminance, cos));
/// assert_eq!(lambert_disc_q30(white, illuminance, -cos, &SUN_Q30), 0);
/// ```
pub fn lambert_disc_q30(albedo: i32, illuminance: u64, n_dot_l: i64, light: &SphereQ30) -> u64 {
    diffuse::lambert_disc(I2F30::from_bits(albedo), U32F32::from_bits(illuminance), n_dot_l, light).to_bits()
}

/// [`relative_illuminance`](diffuse::relative_illuminance): `n_dot_l` in Q28, the answer in Q28 from 0 to `2^28`.
/// Within 2.9e-7 of it, beyond half the sky within 1.4e-7, and half a unit (`tests/figures.rs`).
///
/// ```
/// use sunglint::raw::{SUN_Q14, relative_illuminance_q14};
///
/// assert_eq!(relative_illuminance_q14(1 << 27, &SUN_Q14), 1 << 27);
/// // Half set: 2 x / (3 pi) of its light, 9.87e-4.
/// assert_eq!(relative_illuminance_q14(0, &SUN_Q14), 264_910);
/// assert_eq!(relative_illuminance_q14(-SUN_Q14.sin(), &SUN_Q14), 0);
/// ```
pub fn relative_illuminance_q14(n_dot_l: i32, light: &SphereQ14) -> i32 {
    I2F14::narrow(diffuse::relative_illuminance(n_dot_l, light))
}

/// [`relative_illuminance`](diffuse::relative_illuminance): `n_dot_l` in Q60, the answer in Q60 from 0 to `2^60`, of
/// which 31 bits are significant. Within 2.9e-7 of it, beyond half the sky within 1.4e-7 (`tests/figures.rs`).
///
/// ```
/// use sunglint::raw::{SUN_Q30, relative_illuminance_q30};
///
/// // By as much do the two sides of a plane differ: the centre's cosine.
/// let height = SUN_Q30.sin() / 2;
/// let [above, below] = [height, -height].map(|cos| relative_illuminance_q30(cos, &SUN_Q30));
/// assert!((above - below).abs_diff(height) < height as u64 >> 20);
/// ```
pub fn relative_illuminance_q30(n_dot_l: i64, light: &SphereQ30) -> i64 {
    I2F30::narrow(diffuse::relative_illuminance(n_dot_l, light))
}
