//! Raw bits in, raw bits out: for consoles and firmware whose fixed-point type is their own.
//!
//! Vectors are `[i16; 3]` in Q14 (16384 is 1) or `[i32; 3]` in Q30 (1073741824 is 1), of length 1 give or take a
//! rounding; up to 1.16 nothing overflows. Each function is the one of the same name in [`specular`], in integers to
//! the end, with that function's formula, special cases and error; `tests/raw.rs` holds the two to the same bits. The
//! scene's need the feature `heapless`.
//!
//! Dot products, and a light's constants, are `i32` in Q28 beside Q14 vectors and `i64` in Q60 beside Q30 vectors: the
//! plain sum of three products. Light levels of a surface or a scene are `u32` in Q16 (65536 is 1) and `u64` in Q32,
//! quantities of radiometry and of black bodies `u32` in Q16; shares of a light and of a spectrum's greatest are `i32`
//! in Q30, but for [`relative_illuminance_q14`] and [`relative_illuminance_q30`], which are in the scale of a dot product.

mod blackbody;
mod diffuse;
#[cfg(feature = "heapless")]
mod pixel;
mod radiometry;
mod sampling;
#[cfg(feature = "heapless")]
mod scene;

pub use blackbody::*;
pub use diffuse::*;
#[cfg(feature = "heapless")]
pub use pixel::PixelQ14;
pub use radiometry::*;
pub use sampling::*;
#[cfg(feature = "heapless")]
pub use scene::{
    LampQ14, LampQ30, SceneQ14, SceneQ30, SurfaceQ14, SurfaceQ30, lamp_q14, lamp_q30, shade_channel_q14,
    shade_channel_q30, shade_q14, shade_q30, surface_q14, surface_q30,
};

use fixed::types::{I2F14, I2F30};

use crate::light::{LightError, SUN};
use crate::root::whole_reciprocal_root;
use crate::specular;
use crate::sphere::DistantSphere;
use crate::vec3::each;

/// A light's constants for Q14 vectors: four Q28 numbers, 16 bytes.
pub type SphereQ14 = DistantSphere<I2F14>;

/// A light's constants for Q30 vectors: four Q60 numbers, 32 bytes.
pub type SphereQ30 = DistantSphere<I2F30>;

/// [`SUN`] for Q14 vectors.
pub const SUN_Q14: SphereQ14 = SphereQ14::new(&SUN);

/// [`SUN`] for Q30 vectors.
pub const SUN_Q30: SphereQ30 = SphereQ30::new(&SUN);

/// The constants of a sphere whose radius over distance is `ratio` in Q30, for Q14 vectors: for a lamp that moves, in
/// integers. Each is within 0.51 units of Q28 (`tests/sphere.rs`).
///
/// ```
/// use sunglint::LightError;
/// use sunglint::raw::{SUN_Q14, sphere_q14};
///
/// // The Sun's 0.004 650 467 times 2^30.
/// assert_eq!(sphere_q14(4_993_401), Ok(SUN_Q14));
/// assert_eq!(sphere_q14(-1), Err(LightError::RatioQ30(-1)));
/// ```
///
/// # Errors
/// [`LightError::RatioQ30`] where `ratio` is out of 0 to `2^30`.
pub fn sphere_q14(ratio: i32) -> Result<SphereQ14, LightError> {
    SphereQ14::from_ratio_q30(I2F30::from_bits(ratio))
}

/// The constants of a sphere whose radius over distance is `ratio` in Q30, for Q30 vectors: for a lamp that moves, in
/// integers. Each is within 0.75 units of Q60 (`tests/sphere.rs`).
///
/// ```
/// use sunglint::raw::{cap_q30, sphere_q30};
///
/// // A lamp of 5 cm radius at 1.25 m: 5 / 125 in Q30, by one division of integers.
/// let lamp = sphere_q30(((5_i64 << 30) / 125) as i32).unwrap();
/// // What it turns a ray by is the ratio itself.
/// assert_eq!(cap_q30([0, 0, 1 << 30], [1 << 30, 0, 0], &lamp)[0], 42_949_672);
/// ```
///
/// # Errors
/// [`LightError::RatioQ30`] where `ratio` is out of 0 to `2^30`.
pub fn sphere_q30(ratio: i32) -> Result<SphereQ30, LightError> {
    SphereQ30::from_ratio_q30(I2F30::from_bits(ratio))
}

/// [`cap`](specular::cap) in Q14. Worst error at the Sun 6.2e-5 rad, the step of Q14 being 6.1e-5.
///
/// ```
/// use sunglint::raw::{SUN_Q14, cap_q14};
///
/// // The Sun straight above, the mirror ray 37 degrees beside it: the answer is on the rim, 0.00465 * 16384 = 76.2 to the
/// // side of the ray.
/// assert_eq!(cap_q14([0, 0, 16_384], [9830, 0, 13_107], &SUN_Q14), [76, 0, 16_384]);
/// // A ray that meets the Sun is the answer itself.
/// assert_eq!(cap_q14([0, 0, 16_384], [-60, 20, 16_384], &SUN_Q14), [-60, 20, 16_384]);
/// ```
pub fn cap_q14(l: [i16; 3], r: [i16; 3], light: &SphereQ14) -> [i16; 3] {
    each(specular::cap(q14(l), q14(r), light), I2F14::to_bits)
}

/// [`factored`](specular::factored) in Q14. Worst error at the Sun 1.4e-4 rad.
///
/// ```
/// use sunglint::raw::{SUN_Q14, cap_q14, factored_q14};
///
/// let (l, r) = ([0, 0, 16_384], [9830, 0, 13_107]);
/// // 37 degrees beside the light it turns by 0.8 of the Sun's radius, which is the model's error.
/// assert_eq!([factored_q14(l, r, &SUN_Q14)[0], cap_q14(l, r, &SUN_Q14)[0]], [61, 76]);
/// ```
pub fn factored_q14(l: [i16; 3], r: [i16; 3], light: &SphereQ14) -> [i16; 3] {
    each(specular::factored(q14(l), q14(r), light), I2F14::to_bits)
}

/// [`disc`](specular::disc) in Q14, for studies. Worst error at the Sun 1.2e-2 rad, which is 2.6 of its radii.
///
/// ```
/// use sunglint::raw::{SUN_Q14, cap_q14, disc_q14};
///
/// // 1.7 radii beside the Sun, and still a cosine that Q14 rounds to 1: taken for the Sun.
/// let (l, r) = ([0, 0, 16_384], [127, 0, 16_384]);
/// assert_eq!([disc_q14(l, r, &SUN_Q14), cap_q14(l, r, &SUN_Q14)], [r, [76, 0, 16_384]]);
/// ```
pub fn disc_q14(l: [i16; 3], r: [i16; 3], light: &SphereQ14) -> [i16; 3] {
    each(specular::disc(q14(l), q14(r), light), I2F14::to_bits)
}

/// [`reflect`](specular::reflect) in Q14. Each lane is within half a step.
///
/// ```
/// use sunglint::raw::reflect_q14;
///
/// // Floor, and a camera to the right: what it sees comes from the left.
/// assert_eq!(reflect_q14([0, 0, 16_384], [9830, 0, 13_107]), [-9830, 0, 13_107]);
/// ```
pub fn reflect_q14(n: [i16; 3], v: [i16; 3]) -> [i16; 3] {
    each(specular::reflect(q14(n), q14(v)), I2F14::to_bits)
}

/// [`normalize`](specular::normalize) in Q14. Within 6.0e-5 rad, the length within 7.2e-5, for lengths from 0.1 on.
///
/// ```
/// use sunglint::raw::normalize_q14;
///
/// // Any length will do, a normal of a height map's steps for instance.
/// assert_eq!(normalize_q14([3, 0, 4]), [9830, 0, 13_107]); // 0.6, 0, 0.8
/// assert_eq!(normalize_q14([0; 3]), [0; 3]);
/// ```
pub fn normalize_q14(v: [i16; 3]) -> [i16; 3] {
    each(specular::normalize(q14(v)), I2F14::to_bits)
}

/// [`cap`](specular::cap) in Q30. Worst error at the Sun 1.5e-9 rad, the step of Q30 being 9.3e-10.
///
/// ```
/// use sunglint::raw::{SUN_Q30, cap_q30};
///
/// let r = [644_245_094, 0, 858_993_459]; // 0.6, 0, 0.8
/// // The Sun's sine and cosine: 0.004 650 467 and 0.999 989 187.
/// assert_eq!(cap_q30([0, 0, 1 << 30], r, &SUN_Q30), [4_993_401, 0, 1_073_730_213]);
/// ```
pub fn cap_q30(l: [i32; 3], r: [i32; 3], light: &SphereQ30) -> [i32; 3] {
    each(specular::cap(q30(l), q30(r), light), I2F30::to_bits)
}

/// [`factored`](specular::factored) in Q30. Worst error at the Sun 2.3e-9 rad.
///
/// ```
/// use sunglint::raw::{SUN_Q30, factored_q30};
///
/// let (l, r) = ([0, 0, 1 << 30], [644_245_094, 0, 858_993_459]);
/// // The sign of `r` does not matter, so `l` moves away from rays behind it.
/// assert_eq!(factored_q30(l, r, &SUN_Q30)[0], 4_005_871);
/// assert_eq!(factored_q30(l, [644_245_094, 0, -858_993_459], &SUN_Q30)[0], -4_005_871);
/// ```
pub fn factored_q30(l: [i32; 3], r: [i32; 3], light: &SphereQ30) -> [i32; 3] {
    each(specular::factored(q30(l), q30(r), light), I2F30::to_bits)
}

/// [`disc`](specular::disc) in Q30, for studies. Worst error at the Sun 3.9e-3 rad, a few steps from `-l`.
///
/// ```
/// use sunglint::raw::{SUN_Q30, cap_q30, disc_q30};
///
/// let (l, r) = ([0, 0, 1 << 30], [644_245_094, 0, 858_993_459]);
/// // Away from `-l` the cosine has enough digits in Q60.
/// assert_eq!(disc_q30(l, r, &SUN_Q30), cap_q30(l, r, &SUN_Q30));
/// ```
pub fn disc_q30(l: [i32; 3], r: [i32; 3], light: &SphereQ30) -> [i32; 3] {
    each(specular::disc(q30(l), q30(r), light), I2F30::to_bits)
}

/// [`reflect`](specular::reflect) in Q30. Each lane is within a step.
///
/// ```
/// use sunglint::raw::reflect_q30;
///
/// // A ray that comes along the normal goes back along it; the last bit may be off.
/// let n = [644_245_094, 0, 858_993_459];
/// let r = reflect_q30(n, n);
/// assert!(r.into_iter().zip(n).all(|(r, n)| r.abs_diff(n) <= 2));
/// ```
pub fn reflect_q30(n: [i32; 3], v: [i32; 3]) -> [i32; 3] {
    each(specular::reflect(q30(n), q30(v)), I2F30::to_bits)
}

/// [`normalize`](specular::normalize) in Q30. Within 9.0e-10 rad, the length within 1.2e-9, for lengths from 0.01 on.
///
/// ```
/// use sunglint::raw::normalize_q30;
///
/// let [x, y, z] = normalize_q30([1 << 20, 1 << 20, 0]);
/// // Half the root of 2, in Q30, within a bit.
/// assert!(x.abs_diff(759_250_125) <= 1 && x == y && z == 0);
/// ```
pub fn normalize_q30(v: [i32; 3]) -> [i32; 3] {
    each(specular::normalize(q30(v)), I2F30::to_bits)
}

/// `1 / sqrt(x)` of a Q16 number, in Q16: within 0.5003 of the last place, over all inputs (`tests/exhaustive.rs`).
///
/// Zero gives the greatest number.
///
/// ```
/// use sunglint::raw::reciprocal_root_q16;
///
/// assert_eq!(reciprocal_root_q16(4 * 65_536), 32_768); // 1/2
/// assert_eq!([0, 1, u32::MAX].map(reciprocal_root_q16), [u32::MAX, 1 << 24, 256]);
/// ```
#[inline]
pub fn reciprocal_root_q16(x: u32) -> u32 {
    if x == 0 {
        return u32::MAX;
    }
    let even = x.leading_zeros() & 30;
    // 2^24 / sqrt(x), of which the mantissa's root is in Q30.
    let root = whole_reciprocal_root(x << even) >> (21 - even / 2);
    root.wrapping_add(1) >> 1
}

fn q14(v: [i16; 3]) -> [I2F14; 3] {
    each(v, I2F14::from_bits)
}

fn q30(v: [i32; 3]) -> [I2F30; 3] {
    each(v, I2F30::from_bits)
}
