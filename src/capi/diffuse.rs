//! Diffuse light.

use super::{SphereQ14, SphereQ30};
use crate::raw;

/// Lambert's law, the radiance `albedo / pi * illuminance * max(n.l, 0)` of a matt surface: `albedo` in Q14, from 0 to
/// 1; `illuminance`, that of a plane which faces the light, and the answer in unsigned Q16, in a unit of your choice;
/// `n_dot_l` in Q28, the plain sum of three products of the Q14 lanes of the normal and the direction to the light's
/// centre.
///
/// Within 0.57 units of Q16 for an illuminance up to 1000, 1.4 for any. `n_dot_l` below 0 counts as 0, above 1 as 1. A
/// negative albedo gives 0; what is too great is 2^32 - 1.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_lambert_q14(albedo: i16, illuminance: u32, n_dot_l: i32) -> u32 {
    raw::lambert_q14(albedo, illuminance, n_dot_l)
}

/// Lambert's law, the radiance `albedo / pi * illuminance * max(n.l, 0)` of a matt surface: `albedo` in Q30, from 0 to
/// 1; `illuminance`, that of a plane which faces the light, and the answer in unsigned Q32, in a unit of your choice;
/// `n_dot_l` in Q60, the plain sum of three products of the Q30 lanes of the normal and the direction to the light's
/// centre.
///
/// Within 2.5 units of Q32, or of 31 bits where they are coarser, for an illuminance up to 1000, 2.9 for any. `n_dot_l`
/// below 0 counts as 0, above 1 as 1. A negative albedo gives 0; what is too great is 2^64 - 1.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_lambert_q30(albedo: i32, illuminance: u64, n_dot_l: i64) -> u64 {
    raw::lambert_q30(albedo, illuminance, n_dot_l)
}

/// Lambert's law with the light's true size, so that it fades out as it sets: `albedo / pi * illuminance` times
/// `sunglint_relative_illuminance_q14`.
///
/// Formats and special cases are those of `sunglint_lambert_q14` and of that one; the error is the one's more than the
/// other's.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_lambert_disc_q14(albedo: i16, illuminance: u32, n_dot_l: i32, light: SphereQ14) -> u32 {
    raw::lambert_disc_q14(albedo, illuminance, n_dot_l, &light.into())
}

/// Lambert's law with the light's true size, so that it fades out as it sets: `albedo / pi * illuminance` times
/// `sunglint_relative_illuminance_q30`.
///
/// Formats and special cases are those of `sunglint_lambert_q30` and of that one; the error is the one's more than the
/// other's.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_lambert_disc_q30(albedo: i32, illuminance: u64, n_dot_l: i64, light: SphereQ30) -> u64 {
    raw::lambert_disc_q30(albedo, illuminance, n_dot_l, &light.into())
}

/// Illuminance of a plane under a disc, over that of a plane which faces it: `n_dot_l` in Q28, see
/// `sunglint_lambert_q14`; the answer in Q28, from 0 to 2^28.
///
/// `n.l` itself where the disc is wholly above the plane, zero where it is wholly below, `2 x / (3 pi)` when its centre
/// sets, `x` being radius over distance. Relative error 2.9e-7 at every elevation down to the last sliver, before the
/// rounding to Q28; 1.4e-7 absolute for discs beyond half the sky.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_relative_illuminance_q14(n_dot_l: i32, light: SphereQ14) -> i32 {
    raw::relative_illuminance_q14(n_dot_l, &light.into())
}

/// Illuminance of a plane under a disc, over that of a plane which faces it: `n_dot_l` in Q60, see
/// `sunglint_lambert_q30`; the answer in Q60, from 0 to 2^60, of which 31 bits are significant.
///
/// `n.l` itself where the disc is wholly above the plane, zero where it is wholly below, `2 x / (3 pi)` when its centre
/// sets, `x` being radius over distance. Relative error 2.9e-7 at every elevation down to the last sliver; 1.4e-7
/// absolute for discs beyond half the sky.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_relative_illuminance_q30(n_dot_l: i64, light: SphereQ30) -> i64 {
    raw::relative_illuminance_q30(n_dot_l, &light.into())
}
