//! The cone of a light on raw bits.

use fixed::types::{I2F14, I2F30};

use super::{SphereQ14, SphereQ30, q14, q30};
use crate::real::{Real, Scalar};
use crate::sampling::{self, Cone};
use crate::shadow;
use crate::vec3::each;

/// The directions to a light for Q14 vectors.
pub type ConeQ14 = Cone<I2F14>;

/// The directions to a light for Q30 vectors.
pub type ConeQ30 = Cone<I2F30>;

/// [`Cone::new`] in Q14.
///
/// ```
/// use sunglint::raw::{SUN_Q14, cone_q14};
///
/// let cone = cone_q14([0, 0, 16_384], &SUN_Q14);
/// // One over the Sun's solid angle, per steradian, in Q16.
/// assert_eq!(cone.pdf().unwrap().to_bits(16) >> 16, 14_718);
/// ```
pub fn cone_q14(l: [i16; 3], light: &SphereQ14) -> ConeQ14 {
    Cone::new(q14(l), light)
}

/// [`Cone::direction`] in Q14; the point too, from 0 to 16383. Worst error at discs like the Sun's 1.2e-4 rad
/// (`tests/figures.rs`).
///
/// ```
/// use sunglint::raw::{SUN_Q14, cone_direction_q14, cone_q14};
///
/// let cone = cone_q14([0, 0, 16_384], &SUN_Q14);
/// // The centre, and the rim a quarter of a turn round.
/// assert_eq!(cone_direction_q14(&cone, [0, 0]), [0, 0, 16_384]);
/// assert_eq!(cone_direction_q14(&cone, [16_383, 4096]), [0, 76, 16_384]);
/// ```
pub fn cone_direction_q14(cone: &ConeQ14, [z, turn]: [i16; 2]) -> [i16; 3] {
    each(cone.direction([I2F14::from_bits(z), I2F14::from_bits(turn)]), I2F14::to_bits)
}

/// [`Cone::contains`] in Q14. At discs like the Sun's the rim is told to within 2.9e-6 rad (`tests/figures.rs`).
///
/// ```
/// use sunglint::raw::{SUN_Q14, cone_contains_q14, cone_q14};
///
/// let cone = cone_q14([0, 0, 16_384], &SUN_Q14);
/// // The Sun's radius is 76.2 steps of Q14.
/// assert!(cone_contains_q14(&cone, [76, 0, 16_384]) && !cone_contains_q14(&cone, [77, 0, 16_384]));
/// ```
pub fn cone_contains_q14(cone: &ConeQ14, direction: [i16; 3]) -> bool {
    cone.contains(q14(direction))
}

/// The basis of [`sampling::basis`] in Q14. Within 1.5e-4 of right angles and of length 1.
///
/// ```
/// use sunglint::raw::basis_q14;
///
/// assert_eq!(basis_q14([9830, 0, 13_107]), [[13_107, 0, -9830], [0, 16_384, 0]]);
/// ```
pub fn basis_q14(l: [i16; 3]) -> [[i16; 3]; 2] {
    let [t, b] = sampling::basis(q14(l));
    [each(t, I2F14::to_bits), each(b, I2F14::to_bits)]
}

/// [`sampling::points`] in Q14, from 0 to 16383.
///
/// ```
/// use sunglint::raw::points_q14;
///
/// // From the middle of the square on, each far from those before.
/// assert!(points_q14(0, 3).eq([[8192, 8192], [4176, 1144], [160, 10_481]]));
/// ```
pub fn points_q14(first: u32, count: u32) -> impl Iterator<Item = [i16; 2]> {
    sampling::points::<I2F14>(first, count).map(|[z, turn]| [z.to_bits(), turn.to_bits()])
}

/// [`shadow::soft_shadow`] in Q14: the visible share and the mean cosine, both in Q30. Besides the sampling's
/// error, `2 count^-0.75`, Q14 itself costs up to 0.0021 at the Sun (`tests/shadow.rs`).
///
/// ```
/// use sunglint::raw::{SUN_Q14, cone_q14, soft_shadow_q14};
///
/// let up = [0, 0, 16_384];
/// // A wall hides the half of the Sun that lies towards -x.
/// let [visible, _] = soft_shadow_q14(&cone_q14(up, &SUN_Q14), up, 0, 256, |direction| direction[0] > 0);
/// assert!(visible.abs_diff(1 << 29) < 1 << 25); // half, within 1/32
/// ```
pub fn soft_shadow_q14(
    cone: &ConeQ14,
    n: [i16; 3],
    first: u32,
    count: u32,
    mut sees: impl FnMut([i16; 3]) -> bool,
) -> [i32; 2] {
    means(shadow::soft_shadow(cone, q14(n), first, count, |direction| sees(each(direction, I2F14::to_bits))))
}

/// [`Cone::new`] in Q30.
///
/// ```
/// use sunglint::raw::{SUN_Q30, cone_q30};
/// use sunglint::{SUN, Scalar};
///
/// let cone = cone_q30([0, 0, 1 << 30], &SUN_Q30);
/// assert!((cone.solid_angle().exact() / SUN.solid_angle() - 1.0).abs() < 2.6e-9);
/// ```
pub fn cone_q30(l: [i32; 3], light: &SphereQ30) -> ConeQ30 {
    Cone::new(q30(l), light)
}

/// [`Cone::direction`] in Q30; the point too, from 0 to `2^30 - 1`. Worst error at discs like the Sun's 1.9e-9
/// rad (`tests/figures.rs`).
///
/// ```
/// use sunglint::raw::{SUN_Q30, cone_contains_q30, cone_direction_q30, cone_q30, points_q30};
///
/// let cone = cone_q30([0, 0, 1 << 30], &SUN_Q30);
/// // Half of the disc's light comes from within 0.707 of its radius.
/// assert_eq!(cone_direction_q30(&cone, [1 << 29, 0]), [3_530_872, 0, 1_073_736_019]);
/// assert!(points_q30(0, 64).all(|point| cone_contains_q30(&cone, cone_direction_q30(&cone, point))));
/// ```
pub fn cone_direction_q30(cone: &ConeQ30, [z, turn]: [i32; 2]) -> [i32; 3] {
    each(cone.direction([I2F30::from_bits(z), I2F30::from_bits(turn)]), I2F30::to_bits)
}

/// [`Cone::contains`] in Q30. At discs like the Sun's the rim is told to within 1.2e-11 rad (`tests/figures.rs`).
///
/// ```
/// use sunglint::raw::{SUN_Q30, cone_contains_q30, cone_q30};
///
/// let cone = cone_q30([0, 0, 1 << 30], &SUN_Q30);
/// // The rim, and what is a fiftieth of the radius outside of it.
/// assert!(cone_contains_q30(&cone, [4_993_401, 0, 1_073_730_213]));
/// assert!(!cone_contains_q30(&cone, [5_093_269, 0, 1_073_729_744]));
/// ```
pub fn cone_contains_q30(cone: &ConeQ30, direction: [i32; 3]) -> bool {
    cone.contains(q30(direction))
}

/// The basis of [`sampling::basis`] in Q30. Within 2.3e-9 of right angles and of length 1.
///
/// ```
/// use sunglint::raw::basis_q30;
///
/// let [t, b] = basis_q30([0, 1 << 30, 0]);
/// assert_eq!([t, b], [[1 << 30, 0, 0], [0, 0, -(1 << 30)]]); // t x b = l
/// ```
pub fn basis_q30(l: [i32; 3]) -> [[i32; 3]; 2] {
    let [t, b] = sampling::basis(q30(l));
    [each(t, I2F30::to_bits), each(b, I2F30::to_bits)]
}

/// [`sampling::points`] in Q30, from 0 to `2^30 - 1`.
///
/// ```
/// use sunglint::raw::points_q30;
///
/// // The second pixel of a picture with 16 points each goes on where the first has ended.
/// assert!(points_q30(16, 16).eq(points_q30(0, 32).skip(16)));
/// ```
pub fn points_q30(first: u32, count: u32) -> impl Iterator<Item = [i32; 2]> {
    sampling::points::<I2F30>(first, count).map(|[z, turn]| [z.to_bits(), turn.to_bits()])
}

/// [`shadow::soft_shadow`] in Q30: the visible share and the mean cosine, both in Q30. Within `2 count^-0.75`
/// (`tests/shadow.rs`).
///
/// ```
/// use sunglint::raw::{SUN_Q30, cone_q30, soft_shadow_q30};
///
/// let cone = cone_q30([0, 0, 1 << 30], &SUN_Q30);
/// // Nothing in the way, but the surface itself is upright: half of the Sun is behind it.
/// let [visible, cosine] = soft_shadow_q30(&cone, [1 << 30, 0, 0], 0, 256, |_| true);
/// assert!(visible.abs_diff(1 << 29) < 1 << 25); // half, within 1/32
/// // And what it gets is the 9.87e-4 of a Sun half set.
/// assert!((f64::from(cosine) / 2_f64.powi(30) / 9.87e-4 - 1.0).abs() < 0.03);
/// ```
pub fn soft_shadow_q30(
    cone: &ConeQ30,
    n: [i32; 3],
    first: u32,
    count: u32,
    mut sees: impl FnMut([i32; 3]) -> bool,
) -> [i32; 2] {
    means(shadow::soft_shadow(cone, q30(n), first, count, |direction| sees(each(direction, I2F30::to_bits))))
}

fn means<T: Real>(seen: shadow::SoftShadow<T>) -> [i32; 2] {
    // From Q31, to nearest.
    [seen.visible, seen.cosine]
        .map(|mean| i32::try_from((mean.to_q31() >> 1) + (mean.to_q31() & 1)).unwrap_or(i32::MAX))
}
