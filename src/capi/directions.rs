//! Directions to shade with.

use super::{SphereQ14, SphereQ14Made, SphereQ30, SphereQ30Made, VectorQ14, VectorQ30};
use crate::raw;

/// The constants of a sphere whose radius over distance is `ratio`, in Q30, for Q14 vectors: for a lamp that moves.
/// Once a light, not per pixel.
///
/// Within 0.51 units of Q28's last place. `SUNGLINT_RATIO` where `ratio` is out of 0 to 1 (2^30); the light is then a
/// point.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_sphere_q14(ratio: i32) -> SphereQ14Made {
    SphereQ14Made::of(raw::sphere_q14(ratio))
}

/// The constants of a sphere whose radius over distance is `ratio`, in Q30, for Q30 vectors: for a lamp that moves.
/// Once a light, not per pixel.
///
/// Within 0.75 units of Q60's last place. `SUNGLINT_RATIO` where `ratio` is out of 0 to 1 (2^30); the light is then a
/// point.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_sphere_q30(ratio: i32) -> SphereQ30Made {
    SphereQ30Made::of(raw::sphere_q30(ratio))
}

/// The direction to shade a highlight with, in Q14: `l`, the unit direction to the light's centre, turned towards the
/// unit mirror ray `r` (see `sunglint_reflect_q14`) by the angle between them, but by no more than the light's angular
/// radius. The default.
///
/// Error at the Sun at most 6.2e-5 rad, the step of Q14 being 6.1e-5; at most 1.7e-4 off length 1. Within a step of
/// `-l` it is some direction of the rim, and at `r = -l` it is `l`. A zero `r` gives zero, a zero `l` gives `x r`, `x`
/// being radius over distance. Vectors longer than 1.16 give some direction.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cap_q14(l: VectorQ14, r: VectorQ14, light: SphereQ14) -> VectorQ14 {
    raw::cap_q14(l.into(), r.into(), &light.into()).into()
}

/// The direction to shade a highlight with, in Q30: `l`, the unit direction to the light's centre, turned towards the
/// unit mirror ray `r` (see `sunglint_reflect_q30`) by the angle between them, but by no more than the light's angular
/// radius. The default.
///
/// Error at the Sun at most 1.5e-9 rad, the step of Q30 being 9.3e-10; at most 3.0e-9 off length 1. Within a step of
/// `-l` it is some direction of the rim, and at `r = -l` it is `l`. A zero `r` gives zero, a zero `l` gives `x r`, `x`
/// being radius over distance. Vectors longer than 1.16 give some direction.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cap_q30(l: VectorQ30, r: VectorQ30, light: SphereQ30) -> VectorQ30 {
    raw::cap_q30(l.into(), r.into(), &light.into()).into()
}

/// Epic's representative point with the distance divided out, in Q14: `normalize(l + D min(1, x / |D|))` with `D =
/// (l.r) r - l`, `x` being radius over distance. Beside the light as `sunglint_cap_q14`; its turn falls to about `x
/// cos(angle)`, half at 60 degrees, and is away from `r` beyond 90.
///
/// Error of this formula at the Sun at most 1.4e-4 rad. Zero where the sum is, for `x = 1` with `l` at a right angle
/// to `r`. Vectors longer than 1.16 give some direction.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_factored_q14(l: VectorQ14, r: VectorQ14, light: SphereQ14) -> VectorQ14 {
    raw::factored_q14(l.into(), r.into(), &light.into()).into()
}

/// Epic's representative point with the distance divided out, in Q30: `normalize(l + D min(1, x / |D|))` with `D =
/// (l.r) r - l`, `x` being radius over distance. Beside the light as `sunglint_cap_q30`; its turn falls to about `x
/// cos(angle)`, half at 60 degrees, and is away from `r` beyond 90.
///
/// Error of this formula at the Sun at most 2.3e-9 rad. Zero where the sum is, for `x = 1` with `l` at a right angle
/// to `r`. Vectors longer than 1.16 give some direction.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_factored_q30(l: VectorQ30, r: VectorQ30, light: SphereQ30) -> VectorQ30 {
    raw::factored_q30(l.into(), r.into(), &light.into()).into()
}

/// The mirror ray `2 (n.v) n - v` of the unit direction `v` from the surface to the camera, about the unit normal `n`,
/// in Q14. Each lane is within half a step. Shading languages' `reflect(i, n)` takes the direction to the surface,
/// `-v`.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_reflect_q14(n: VectorQ14, v: VectorQ14) -> VectorQ14 {
    raw::reflect_q14(n.into(), v.into()).into()
}

/// The mirror ray `2 (n.v) n - v` of the unit direction `v` from the surface to the camera, about the unit normal `n`,
/// in Q30. Each lane is within a step. Shading languages' `reflect(i, n)` takes the direction to the surface, `-v`.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_reflect_q30(n: VectorQ30, v: VectorQ30) -> VectorQ30 {
    raw::reflect_q30(n.into(), v.into()).into()
}

/// `v`, of any length, at length 1 in Q14: lanes may be of any other scale. Within 6.0e-5 rad, and 7.2e-5 of length 1.
/// A zero vector gives zero.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_normalize_q14(v: VectorQ14) -> VectorQ14 {
    raw::normalize_q14(v.into()).into()
}

/// `v`, of any length, at length 1 in Q30: lanes may be of any other scale. Within 9.0e-10 rad, and 1.2e-9 of length 1.
/// A zero vector gives zero.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_normalize_q30(v: VectorQ30) -> VectorQ30 {
    raw::normalize_q30(v.into()).into()
}

/// `1 / sqrt(x)` of a Q16 number, in Q16: within 0.5003 of the last place, over all inputs. Zero gives 2^32 - 1.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_reciprocal_root_q16(x: u32) -> u32 {
    raw::reciprocal_root_q16(x)
}
