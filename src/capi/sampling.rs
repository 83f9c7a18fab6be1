//! The cone of a light: even samples of its disc, and soft shadows by the caller's visibility.

use core::ffi::c_void;

use super::{
    BasisQ14, BasisQ30, ConeQ14, ConeQ30, PointQ14, PointQ30, SeesQ14, SeesQ30, SoftShadow, SphereQ14, SphereQ30,
    VectorQ14, VectorQ30,
};
use crate::raw;

/// The directions of `light` about the unit direction `l` to its centre, for Q14 vectors. Once a light, not per pixel.
///
/// An `l` longer than 2 is taken for zero; samples are then meaningless.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cone_q14(l: VectorQ14, light: SphereQ14) -> ConeQ14 {
    raw::cone_q14(l.into(), &light.into())
}

/// The directions of `light` about the unit direction `l` to its centre, for Q30 vectors. Once a light, not per pixel.
///
/// An `l` longer than 2 is taken for zero; samples are then meaningless.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cone_q30(l: VectorQ30, light: SphereQ30) -> ConeQ30 {
    raw::cone_q30(l.into(), &light.into())
}

/// The direction of the light's disc at `point`, in Q14: even over the disc's solid angle if the points are over the
/// square, as those of `sunglint_point_q14` are. `z` 0 is the centre, 1 the rim; the turn begins at the first vector of
/// `sunglint_basis_q14` and goes towards the second.
///
/// Error at the Sun at most 1.2e-4 rad, of any disc 2.7e-4; `sunglint_cone_contains_q14` holds for every answer.
/// Numbers below 0 count as 0, above 1 as 1. Zero where `cone` is NULL.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cone_direction_q14(cone: Option<&ConeQ14>, point: PointQ14) -> VectorQ14 {
    cone.map_or([0; 3], |cone| raw::cone_direction_q14(cone, [point.z, point.turn])).into()
}

/// The direction of the light's disc at `point`, in Q30: even over the disc's solid angle if the points are over the
/// square, as those of `sunglint_point_q30` are. `z` 0 is the centre, 1 the rim; the turn begins at the first vector of
/// `sunglint_basis_q30` and goes towards the second.
///
/// Error at the Sun at most 1.9e-9 rad, of any disc 5.0e-9; `sunglint_cone_contains_q30` holds for every answer.
/// Numbers below 0 count as 0, above 1 as 1. Zero where `cone` is NULL.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cone_direction_q30(cone: Option<&ConeQ30>, point: PointQ30) -> VectorQ30 {
    cone.map_or([0; 3], |cone| raw::cone_direction_q30(cone, [point.z, point.turn])).into()
}

/// Whether the unit vector `direction`, in Q14, is within the light's disc: `|direction - l|^2 <= 2 w`, `w` being the
/// versine of the angular radius.
///
/// Directions that are told wrong are at most 2.9e-6 rad from the rim of a disc of 0.001 to 0.01 rad, as the Sun is,
/// and at most 8.9e-5 from any. False where `cone` is NULL.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cone_contains_q14(cone: Option<&ConeQ14>, direction: VectorQ14) -> bool {
    cone.is_some_and(|cone| raw::cone_contains_q14(cone, direction.into()))
}

/// Whether the unit vector `direction`, in Q30, is within the light's disc: `|direction - l|^2 <= 2 w`, `w` being the
/// versine of the angular radius.
///
/// Directions that are told wrong are at most 1.2e-11 rad from the rim of a disc of 0.001 to 0.01 rad, as the Sun is,
/// and at most 1.6e-9 from any. False where `cone` is NULL.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cone_contains_q30(cone: Option<&ConeQ30>, direction: VectorQ30) -> bool {
    cone.is_some_and(|cone| raw::cone_contains_q30(cone, direction.into()))
}

/// Two unit vectors perpendicular to the unit vector `l` and to each other, in Q14, with `t x b = l`: the x and y axes
/// carried along by the least rotation that takes the z axis to `l` (where `l.z` is negative its negative, and that of
/// y).
///
/// Angles and lengths are within 1.5e-4. For a zero `l`, and one longer than 2, those of the z axis.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_basis_q14(l: VectorQ14) -> BasisQ14 {
    let [t, b] = raw::basis_q14(l.into());
    BasisQ14 { t: t.into(), b: b.into() }
}

/// Two unit vectors perpendicular to the unit vector `l` and to each other, in Q30, with `t x b = l`: the x and y axes
/// carried along by the least rotation that takes the z axis to `l` (where `l.z` is negative its negative, and that of
/// y).
///
/// Angles and lengths are within 2.3e-9. For a zero `l`, and one longer than 2, those of the z axis.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_basis_q30(l: VectorQ30) -> BasisQ30 {
    let [t, b] = raw::basis_q30(l.into());
    BasisQ30 { t: t.into(), b: b.into() }
}

/// The point `index` of the sequence R2, in Q14: any run of its points fills the square of 0 to 1 evenly. `(1/2 + index
/// / g, 1/2 + index / g^2)` modulo 1, `g` being 1.3247, the plastic number; comes round after 2^32.
///
/// To give every pixel points of its own, let pixel `k` begin at `k` times the count, wrapping.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_point_q14(index: u32) -> PointQ14 {
    let [z, turn] = raw::points_q14(index, 1).next().unwrap_or_default();
    PointQ14 { z, turn }
}

/// The point `index` of the sequence R2, in Q30: any run of its points fills the square of 0 to 1 evenly. `(1/2 + index
/// / g, 1/2 + index / g^2)` modulo 1, `g` being 1.3247, the plastic number; comes round after 2^32.
///
/// To give every pixel points of its own, let pixel `k` begin at `k` times the count, wrapping.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_point_q30(index: u32) -> PointQ30 {
    let [z, turn] = raw::points_q30(index, 1).next().unwrap_or_default();
    PointQ30 { z, turn }
}

/// What a surface with the unit normal `n` sees of a light: asks `sees` for `count` directions to it, those of the
/// points from `first` on, whether they are free, passing `user` on as it is. Directions under the surface count as
/// hidden and are not asked for.
///
/// The visible share is within `2 count^-0.75` of the area that is seen, and the mean cosine as a share of its
/// greatest, of discs that a plane, a sphere or the surface's own horizon cuts; at the Sun, which is few steps of Q14
/// wide, 0.0021 are added. Zeros where `cone` or `sees` is NULL, and for a `count` of 0.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_soft_shadow_q14(
    cone: Option<&ConeQ14>,
    n: VectorQ14,
    first: u32,
    count: u32,
    sees: SeesQ14,
    user: *mut c_void,
) -> SoftShadow {
    let (Some(cone), Some(sees)) = (cone, sees) else { return SoftShadow::default() };
    raw::soft_shadow_q14(cone, n.into(), first, count, |direction| sees(direction.into(), user)).into()
}

/// What a surface with the unit normal `n` sees of a light: asks `sees` for `count` directions to it, those of the
/// points from `first` on, whether they are free, passing `user` on as it is. Directions under the surface count as
/// hidden and are not asked for.
///
/// The visible share is within `2 count^-0.75` of the area that is seen, and the mean cosine as a share of its
/// greatest, of discs that a plane, a sphere or the surface's own horizon cuts. Zeros where `cone` or `sees` is NULL,
/// and for a `count` of 0.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_soft_shadow_q30(
    cone: Option<&ConeQ30>,
    n: VectorQ30,
    first: u32,
    count: u32,
    sees: SeesQ30,
    user: *mut c_void,
) -> SoftShadow {
    let (Some(cone), Some(sees)) = (cone, sees) else { return SoftShadow::default() };
    raw::soft_shadow_q30(cone, n.into(), first, count, |direction| sees(direction.into(), user)).into()
}
