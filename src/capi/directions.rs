//! Directions to shade with.

use super::{SphereQ14, SphereQ14Made, SphereQ30, SphereQ30Made, VectorQ14, VectorQ30};
use crate::raw;

/// The constants of a sphere whose radius over distance is `ratio` in Q30, for Q14 vectors.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_sphere_q14(ratio: i32) -> SphereQ14Made {
    SphereQ14Made::of(raw::sphere_q14(ratio))
}

/// The constants of a sphere whose radius over distance is `ratio` in Q30, for Q30 vectors.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_sphere_q30(ratio: i32) -> SphereQ30Made {
    SphereQ30Made::of(raw::sphere_q30(ratio))
}

/// The direction of the light's disc that is nearest to the mirror ray `r`, in Q14; `l` is the direction to its centre.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cap_q14(l: VectorQ14, r: VectorQ14, light: SphereQ14) -> VectorQ14 {
    raw::cap_q14(l.into(), r.into(), &light.into()).into()
}

/// The direction of the light's disc that is nearest to the mirror ray `r`, in Q30; `l` is the direction to its centre.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cap_q30(l: VectorQ30, r: VectorQ30, light: SphereQ30) -> VectorQ30 {
    raw::cap_q30(l.into(), r.into(), &light.into()).into()
}

/// The mirror ray of `v` about the normal `n`, in Q14.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_reflect_q14(n: VectorQ14, v: VectorQ14) -> VectorQ14 {
    raw::reflect_q14(n.into(), v.into()).into()
}

/// The mirror ray of `v` about the normal `n`, in Q30.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_reflect_q30(n: VectorQ30, v: VectorQ30) -> VectorQ30 {
    raw::reflect_q30(n.into(), v.into()).into()
}

/// The vector of length 1 in the direction of `v`, in Q14.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_normalize_q14(v: VectorQ14) -> VectorQ14 {
    raw::normalize_q14(v.into()).into()
}

/// The vector of length 1 in the direction of `v`, in Q30.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_normalize_q30(v: VectorQ30) -> VectorQ30 {
    raw::normalize_q30(v.into()).into()
}
