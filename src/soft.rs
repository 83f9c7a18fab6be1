//! f32 in integers, for chips without an FPU: no float arithmetic, hence no float library, is linked.
//!
//! Roots are correctly rounded. Directions become I2F30, go through [`specular`] there, and are rounded to f32 once, so
//! that the error is that of storing the answer and little more, at a fraction of the cost of float arithmetic by
//! software. Lights are those of [`raw`](crate::raw).
//!
//! ```
//! use sunglint::raw::SUN_Q30;
//! use sunglint::soft;
//!
//! let (n, v, l) = ([0.0, 0.0, 1.0], [0.6, 0.0, 0.8], soft::normalize([-3.0, 0.0, 4.2]));
//! let specular_l = soft::cap(l, soft::reflect(n, v), &SUN_Q30);
//! // The mirror ray is 0.98 degrees from the Sun's centre: the nearest point of the disc is 0.27 degrees from it.
//! let cos = l[0] * specular_l[0] + l[1] * specular_l[1] + l[2] * specular_l[2];
//! assert!((cos.acos().to_degrees() - 0.2664).abs() < 0.001);
//! assert_eq!(soft::reciprocal_root(4.0), 0.5);
//! ```

mod lane;

use fixed::types::I2F30;

use crate::raw::SphereQ30;
use crate::root::single;
use crate::specular;
use crate::vec3::each;

use lane::{Q30, float, lanes};

/// `1 / sqrt(x)`, correctly rounded: over all inputs (`tests/exhaustive.rs`).
///
/// As IEEE 754 has it: of zero infinity with the zero's sign, of infinity zero, of what is negative NaN. Subnormals are
/// numbers like others.
///
/// ```
/// use sunglint::soft;
///
/// assert_eq!(soft::reciprocal_root(0.25), 2.0);
/// assert_eq!(soft::reciprocal_root(0.0), f32::INFINITY);
/// assert!(soft::reciprocal_root(-1.0).is_nan());
/// ```
pub fn reciprocal_root(x: f32) -> f32 {
    f32::from_bits(single::reciprocal_root(x.to_bits()))
}

/// `sqrt(x)`, correctly rounded: bit by bit what libm and root instructions give, over all inputs
/// (`tests/exhaustive.rs`).
///
/// As IEEE 754 has it: of either zero that zero, of what is negative NaN. Subnormals are numbers like others.
///
/// ```
/// use sunglint::soft;
///
/// // To the last bit, of subnormals too.
/// assert_eq!([2.0, 1e-40].map(soft::root), [2.0_f32.sqrt(), 1e-40_f32.sqrt()]);
/// ```
pub fn root(x: f32) -> f32 {
    f32::from_bits(single::root(x.to_bits()))
}

/// [`cap`](specular::cap) of unit vectors in f32.
///
/// Special cases are those of I2F30: where a lane of `l` is NaN or 2 and more the answer is zero, where one of `r` is,
/// the answer is `l`; a zero `r` gives zero. Lanes below `2^-7` are rounded to multiples of `2^-30` on the way in and
/// out, also where the answer is `r` itself.
///
/// Error, as that of [`cap`](specular::cap), in radians: `5.4e-8 + 1.15e-9 x / gap` for `x` up to 0.05, 1.1e-7 in place
/// of 5.4e-8 up to 1, `gap` being the angle between `r` and `-l`, beside which the side of the rim hangs on the
/// rounding to Q30; 4.8e-8 of it is what storing the answer in f32 may cost (`tests/soft.rs`).
///
/// ```
/// use sunglint::{SUN, raw::SUN_Q30, soft};
///
/// // Towards a ray 37 degrees off, by the Sun's radius.
/// let [x, y, z] = soft::cap([0.0, 0.0, 1.0], [0.6, 0.0, 0.8], &SUN_Q30);
/// assert!((x - SUN.sin() as f32).abs() < 1e-9 && y == 0.0 && z == SUN.cos() as f32);
/// ```
pub fn cap(l: [f32; 3], r: [f32; 3], light: &SphereQ30) -> [f32; 3] {
    let Some(from) = lanes(l) else { return [0.0; 3] };
    let Some(to) = lanes(r) else { return l };
    each(specular::cap(from, to, light), near_one)
}

/// [`reflect`](specular::reflect) of unit vectors in f32: zero where a lane is NaN or 2 and more.
///
/// Each lane is within 6.1e-8 (`tests/soft.rs`).
///
/// ```
/// use sunglint::soft;
///
/// assert_eq!(soft::reflect([0.0, 0.0, 1.0], [0.6, 0.0, 0.8]), [-0.6, 0.0, 0.8]);
/// assert_eq!(soft::reflect([0.0, 0.0, f32::NAN], [0.6, 0.0, 0.8]), [0.0; 3]);
/// ```
pub fn reflect(n: [f32; 3], v: [f32; 3]) -> [f32; 3] {
    match (lanes(n), lanes(v)) {
        (Some(n), Some(v)) => each(specular::reflect(n, v), near_one),
        _ => [0.0; 3],
    }
}

/// `v` at unit length: of any length, subnormal lanes included. A zero vector, and one with a NaN or an infinity, gives
/// zero.
///
/// The direction is within 5.0e-8 rad (`tests/soft.rs`).
///
/// ```
/// use sunglint::soft;
///
/// assert_eq!(soft::normalize([3.0, 0.0, 4.0]), [0.6, 0.0, 0.8]);
/// assert_eq!(soft::normalize([0.0, 1e-40, 0.0]), [0.0, 1.0, 0.0]);
/// assert_eq!(soft::normalize([f32::INFINITY, 0.0, 0.0]), [0.0; 3]);
/// ```
pub fn normalize(v: [f32; 3]) -> [f32; 3] {
    match lane::scaled(each(v, f32::to_bits)) {
        Some(v) => each(specular::normalize(v), near_one),
        None => [0.0; 3],
    }
}

fn near_one(lane: I2F30) -> f32 {
    f32::from_bits(float(lane.to_bits(), Q30))
}
