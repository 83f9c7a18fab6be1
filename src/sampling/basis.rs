//! Two directions across a given one.

use crate::real::{Real, Scalar};
use crate::specular::finite;
use crate::vec3::each;

/// Two unit vectors `[t, b]` perpendicular to the unit vector `l` and to each other, with `t x b = l`.
///
/// `t` is the x axis, and `b` the y axis (its negative where `l.z < 0`), carried along by the least rotation that takes
/// the z axis (its negative) to `l`: with `s` the sign of `l.z` (1 for zero) and `h = 1 / (1 + |l.z|)`,
///
/// ```text
/// t = (1 - h x^2,  -h x y,  -s x)        b = (-s h x y,  s (1 - h y^2),  -y)
/// ```
///
/// so that it is continuous over either half of the sphere, poles included, and no lane is beyond 1. Source: the
/// branchless basis of Duff and others (2017), here with the part along an `l` that is not of length 1 taken off.
///
/// Error, as `tests/figures.rs` asserts: how far the three are from right angles in radians, and the two from length 1,
/// whichever is greatest:
///
/// | | f64 | f32 | micromath | f16 | I2F14 | I2F30 | I16F16 |
/// |---|---|---|---|---|---|---|---|
/// | worst | 5.0e-16 | 1.4e-7 | 1.4e-7 | 1.2e-3 | 1.5e-4 | 2.3e-9 | 3.7e-5 |
///
/// For an `l` that is zero, not finite or longer than 2 the answer is that of the z axis.
///
/// ```
/// use sunglint::fixed::types::I2F14;
/// use sunglint::sampling::basis;
///
/// assert_eq!(basis([0.0_f32, 0.0, 1.0]), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
/// // In Q14, across (0, 0.6, 0.8): east, and up the slope.
/// let [t, b] = basis([0, 9830, 13107].map(I2F14::from_bits)).map(|v| v.map(I2F14::to_bits));
/// assert_eq!([t, b], [[16384, 0, 0], [0, 13107, -9830]]);
/// ```
#[inline]
pub fn basis<T: Real>(l: [T; 3]) -> [[T; 3]; 2] {
    let l = finite(l);
    let [x, y, z] = [T::of_lane(l[0]), T::of_lane(l[1]), T::of_lane(l[2])];
    let (zero, one) = (T::Scalar::ZERO, T::Scalar::ONE);
    let behind = z < zero;
    let turned = |value: T::Scalar| if behind { zero - value } else { value };
    let share = one / (one + turned(z));
    let cross = zero - x * (y * share);
    let t = [one - x * (x * share), cross, turned(zero - x)];
    let b = [turned(cross), turned(one - y * (y * share)), zero - y];
    [across(t, l), across(b, l)]
}

/// `v` less its part along `l`.
#[inline]
fn across<T: Real>(v: [T::Scalar; 3], l: [T; 3]) -> [T; 3] {
    let v = each(v, T::lane);
    T::diff(T::WIDE_ONE, v, T::dot(v, l), l)
}
