//! f32 in integers.

use super::{SphereQ30, VectorF32};
use crate::soft;

/// `1 / sqrt(x)` in integers, correctly rounded, over all inputs. Of zero infinity with its sign, of infinity zero, of
/// what is negative NaN.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_soft_reciprocal_root(x: f32) -> f32 {
    soft::reciprocal_root(x)
}

/// `sqrt(x)` in integers, correctly rounded, over all inputs. Of either zero that zero, of what is negative NaN.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_soft_root(x: f32) -> f32 {
    soft::root(x)
}

/// `sunglint_cap_q30` of unit vectors of floats: through Q30, in integers.
///
/// Error in radians `5.4e-8 + 1.15e-9 x / gap` for a radius over distance `x` up to 0.05, 1.1e-7 in place of 5.4e-8 up
/// to 1, `gap` being the angle between `r` and `-l`. Lanes below 2^-7 are rounded to multiples of 2^-30. Where a lane
/// of `l` is NaN or 2 and more the answer is zero, where one of `r` is, it is `l`; a zero `r` gives zero.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_soft_cap(l: VectorF32, r: VectorF32, light: SphereQ30) -> VectorF32 {
    soft::cap(l.into(), r.into(), &light.into()).into()
}

/// `sunglint_reflect_q30` of unit vectors of floats: through Q30, in integers. Each lane is within 6.1e-8. Zero where a
/// lane is NaN or 2 and more.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_soft_reflect(n: VectorF32, v: VectorF32) -> VectorF32 {
    soft::reflect(n.into(), v.into()).into()
}

/// `v`, of any length, at length 1, in integers: within 5.0e-8 rad. A zero vector, and one with a NaN or an infinity,
/// gives zero.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_soft_normalize(v: VectorF32) -> VectorF32 {
    soft::normalize(v.into()).into()
}
