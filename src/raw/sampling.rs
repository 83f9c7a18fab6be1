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
pub fn cone_q14(l: [i16; 3], light: &SphereQ14) -> ConeQ14 {
    Cone::new(q14(l), light)
}

/// [`Cone::direction`] in Q14; the point too, from 0 to 16383. Worst error at the Sun 1.2e-4 rad.
pub fn cone_direction_q14(cone: &ConeQ14, [z, turn]: [i16; 2]) -> [i16; 3] {
    each(cone.direction([I2F14::from_bits(z), I2F14::from_bits(turn)]), I2F14::to_bits)
}

/// [`Cone::contains`] in Q14.
pub fn cone_contains_q14(cone: &ConeQ14, direction: [i16; 3]) -> bool {
    cone.contains(q14(direction))
}

/// The basis of [`sampling::basis`] in Q14.
pub fn basis_q14(l: [i16; 3]) -> [[i16; 3]; 2] {
    let [t, b] = sampling::basis(q14(l));
    [each(t, I2F14::to_bits), each(b, I2F14::to_bits)]
}

/// [`sampling::points`] in Q14.
pub fn points_q14(first: u32, count: u32) -> impl Iterator<Item = [i16; 2]> {
    sampling::points::<I2F14>(first, count).map(|[z, turn]| [z.to_bits(), turn.to_bits()])
}

/// [`shadow::soft_shadow`] in Q14: the visible share and the mean cosine, both in Q30.
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
pub fn cone_q30(l: [i32; 3], light: &SphereQ30) -> ConeQ30 {
    Cone::new(q30(l), light)
}

/// [`Cone::direction`] in Q30; the point too, from 0 to `2^30 - 1`. Worst error at the Sun 1.8e-9 rad.
pub fn cone_direction_q30(cone: &ConeQ30, [z, turn]: [i32; 2]) -> [i32; 3] {
    each(cone.direction([I2F30::from_bits(z), I2F30::from_bits(turn)]), I2F30::to_bits)
}

/// [`Cone::contains`] in Q30.
pub fn cone_contains_q30(cone: &ConeQ30, direction: [i32; 3]) -> bool {
    cone.contains(q30(direction))
}

/// The basis of [`sampling::basis`] in Q30.
pub fn basis_q30(l: [i32; 3]) -> [[i32; 3]; 2] {
    let [t, b] = sampling::basis(q30(l));
    [each(t, I2F30::to_bits), each(b, I2F30::to_bits)]
}

/// [`sampling::points`] in Q30.
pub fn points_q30(first: u32, count: u32) -> impl Iterator<Item = [i32; 2]> {
    sampling::points::<I2F30>(first, count).map(|[z, turn]| [z.to_bits(), turn.to_bits()])
}

/// [`shadow::soft_shadow`] in Q30: the visible share and the mean cosine, both in Q30.
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
