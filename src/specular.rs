//! Specular direction: which point of the disc does the mirror ray see?
//!
//! Every method takes the unit direction `l` from the surface to the light's centre, the unit mirror direction `r` (see
//! [`reflect`]) and the light's constants, and gives the direction to shade with. The answer that all of them aim at is
//! `l` turned towards `r` by the angle between them, but by no more than the angular radius `theta`.
//!
//! Lengths may be off by what rounding to the format does to them; the answer of [`cap`] is as long as `l` and `r`
//! are. NaN and infinite lanes, and zero vectors, give the documented answers below. In fixed point, vectors longer
//! than 1.16 give a meaningless direction; they never panic.

use crate::real::Real;
use crate::sphere::{DistantSphere, UnfactoredSphere};
use crate::vec3::zip;

/// The representative point with its lengths, as published: `C = (L.r) r - L`, `P = L + C sat(R / |C|)`, for `L` of
/// the light's distance (Karis, 2013).
///
/// For studies. A distance in kilometres overflows f16, whose answer is then NaN, and every fixed-point format, whose
/// answer is then finite and meaningless. See [`factored`] for what it computes where it works.
///
/// ```
/// use sunglint::{SUN, UnfactoredSphere, epic};
///
/// let sun = UnfactoredSphere::<f32>::of(&SUN);
/// let [x, _, _] = epic([0.0, 0.0, 1.0], [0.6, 0.0, 0.8], &sun);
/// // 37 degrees beside the light it turns by 0.8 of what it should, whatever the format.
/// assert!((x / (0.8 * 4.65e-3) - 1.0).abs() < 0.01);
/// ```
#[inline]
pub fn epic<T: Real>(l: [T; 3], r: [T; 3], light: &UnfactoredSphere<T>) -> [T; 3] {
    let to_light = T::diff(light.distance, l, T::WIDE_ZERO, l);
    let c = T::diff(T::dot(to_light, r), r, T::WIDE_ONE, to_light);
    let square = T::square(c);
    let p = if T::within(square, 0, light.radius_square) {
        zip(to_light, c, T::add)
    } else {
        T::rim(to_light, T::WIDE_ZERO, c, square, light.radius)
    };
    // Left as it is, a NaN shows that the method failed.
    if p.into_iter().all(|lane| lane.partial_cmp(&lane).is_some()) { T::normalize(p) } else { p }
}

/// Epic's point with the distance divided out: `D = (l.r) r - l`, `P = l + D sat(x / |D|)`, normalised.
///
/// Error in radians against exact arithmetic on the same inputs, where `P` is at least 0.1 long: 12 % above the worst
/// that a search has found (`tests/search.rs`). NaN gives zero.
///
/// | | f64 | f32 | micromath | f16 | I2F14 | I2F30 | I16F16 |
/// |---|---|---|---|---|---|---|---|
/// | the Sun | 4.0e-16 | 1.3e-7 | 1.6e-7 | 8.7e-4 | 1.4e-4 | 2.3e-9 | 3.5e-5 |
/// | up to half the sky | 3.9e-15 | 2.5e-6 | 5.1e-5 | 1.8e-2 | 1.3e-3 | 2.6e-8 | 3.2e-4 |
///
/// `x` is radius over distance. `D` is perpendicular to the *line* of `r`, so that the turn is about `theta cos(angle)`
/// in place of `theta`: exact inside the disc, for the Sun 0.34 % short at 5 degrees, half at 60, and *away* from `r`
/// beyond 90 degrees. It is even in `r` (in I2F30 and I16F16 but for the last bit): the sign of `reflect` does not
/// matter. Where `P` is zero (`x = 1`, `l` perpendicular to `r`) the answer is zero. Meant for lights that subtend up
/// to 180 degrees, as spheres do.
///
/// ```
/// use sunglint::{DistantSphere, SUN, factored};
///
/// const SUN_F64: DistantSphere<f64> = DistantSphere::<f64>::new(&SUN);
/// let x = |r| factored([0.0, 0.0, 1.0], r, &SUN_F64)[0];
///
/// assert!((x([0.003, 0.0, 0.999_995_5]) - 0.003).abs() < 1e-7); // inside the disc: the ray itself
/// assert!((x([0.6, 0.0, 0.8]) / (0.8 * SUN.sin()) - 1.0).abs() < 0.01); // 0.8 of what it should be
/// assert!(x([0.6, 0.0, -0.8]) < 0.0); // behind the light: away from the ray
/// ```
#[inline]
pub fn factored<T: Real>(l: [T; 3], r: [T; 3], light: &DistantSphere<T>) -> [T; 3] {
    let d = T::diff(T::dot(l, r), r, T::WIDE_ONE, l);
    let square = T::square(d);
    let saturated = T::within(square, 0, light.sin_square);
    let p = if saturated { zip(l, d, T::add) } else { T::rim(l, T::WIDE_ZERO, d, square, light.sin) };
    T::normalize(p)
}

/// The nearest direction of the disc by its cosine (Lagarde and de Rousiers, 2014): `r` where `l.r >= cos`, else
/// `normalize(cos l + sin normalize(r - (l.r) l))`.
///
/// For studies: the same answer as [`cap`] in exact arithmetic, but the cosine of a small disc is so close to 1 that
/// f16 takes half of the directions at 5 radii of the Sun to be inside, and some at 10, and f32 has only 181 steps from
/// the Sun's cosine to 1. At `r = -l` and a few steps of the format from it the answer is some direction of the rim, on
/// the wrong side even in f64: what rounding leaves of the tangent is normalised. NaN gives a zero vector, or `l` where
/// `r` alone is NaN; an infinite `r` may be returned.
///
/// Worst error at the Sun in radians (`tests/search.rs`): f64 4.4e-3, f32 and micromath 4.3e-3, f16 5.7e-2, I2F14 1.2e-2,
/// I2F30 3.9e-3, I16F16 5.3e-3.
///
/// ```
/// use sunglint::half::f16;
/// use sunglint::{DistantSphere, SUN, cap, disc};
///
/// const SUN_F16: DistantSphere<f16> = DistantSphere::<f16>::new(&SUN);
/// let [l, r] = [[0.0, 0.0, 1.0], [0.0186, 0.0, 0.999_83]].map(|v| v.map(f16::from_f64));
/// // A ray four radii beside the Sun is taken to meet it, since f16 rounds both cosines to 1; `cap` knows.
/// assert_eq!(disc(l, r, &SUN_F16), r);
/// assert_eq!(cap(l, r, &SUN_F16)[0], SUN_F16.sin());
/// ```
#[inline]
pub fn disc<T: Real>(l: [T; 3], r: [T; 3], light: &DistantSphere<T>) -> [T; 3] {
    let l_dot_r = T::dot(l, r);
    if l_dot_r >= light.cos {
        return r;
    }
    let outward = T::normalize(T::diff(l_dot_r, l, T::WIDE_ONE, r));
    T::normalize(T::diff(light.cos, l, light.sin, outward))
}

/// The nearest direction of the disc, without cancellation. **The default.**
///
/// With `e = r - l` (or `r + l` where `l.r < 0`), which is exact where it matters, `s = e - (e.l) l` is the sine of
/// the angle times the tangent, to full relative precision near `l` and near `-l` alike. Inside the disc, `s.s <=
/// x^2`, the answer is `r` itself and costs no root; outside it is `l + (x / |s|) s - w l`, `w` being the versine.
/// The rim of discs between 44 and 136 degrees is told by its cosine.
///
/// I2F14 and I2F30 have code of their own for the same point, which takes lengths to be 1: from 0.84 to 1.16 an answer
/// is off by at most 1.6 times what the length of `l` and `r` is off, and nothing overflows (`trial::property::raw`).
///
/// At `r = -l` every direction on the rim is as near: the answer is `l`; for the full sphere it is `r`. Within a step
/// of the format of `-l` it is some direction of the rim, in f16 up to `2.3e-2 x` beyond it; within half a step of
/// I2F14 it is `l`. For `x = 0` the answer is `l`, but `r` where the two are parallel to within a step of the format. A
/// zero `r` gives zero, a zero `l` gives `x r`. Where `r` is not finite the answer is `l`; where `l` is not finite, or
/// longer than 2, it is zero.
///
/// Error at the Sun in radians, all angles but those within a step of the format of `-l`, against exact arithmetic on
/// the same inputs: 12 % above the worst that a search has found (`tests/search.rs`; other discs: `trial::budget`; that
/// of f64 is held against 192 bits too, in `tests/oracle.rs`). The length is 1 to within 3.2e-7 in f32, 7.5e-3 in f16,
/// 1.7e-4 in I2F14 and 3.0e-9 in I2F30, under discs up to a ratio of 1:
///
/// | | f64 | f32 | micromath | f16 | I2F14 | I2F30 | I16F16 |
/// |---|---|---|---|---|---|---|---|
/// | worst | 2.5e-16 | 5.7e-8 | 8.0e-8 | 4.8e-4 | 6.2e-5 | 1.5e-9 | 1.5e-5 |
/// | root mean square | 4.6e-17 | 1.4e-8 | 1.8e-8 | 1.1e-4 | 2.3e-5 | 4.5e-10 | 5.7e-6 |
///
/// Cost: three dot products (four where `l.r < 0`), and outside the disc one root.
///
/// ```
/// use sunglint::{DistantSphere, SUN, cap};
///
/// const SUN_F32: DistantSphere<f32> = DistantSphere::<f32>::new(&SUN);
/// let l = [0.0, 0.0, 1.0];
/// // Inside the disc the ray itself, outside the rim on its side, opposite the light the light.
/// assert_eq!(cap(l, [0.004, 0.0, 0.999_992], &SUN_F32), [0.004, 0.0, 0.999_992]);
/// assert_eq!(cap(l, [0.6, 0.0, 0.8], &SUN_F32), [SUN_F32.sin(), 0.0, SUN_F32.cos()]);
/// assert_eq!(cap(l, [0.0, 0.0, -1.0], &SUN_F32), l);
/// ```
#[inline]
pub fn cap<T: Real>(l: [T; 3], r: [T; 3], light: &DistantSphere<T>) -> [T; 3] {
    T::cap(l, r, light)
}

/// [`cap`] by its formula, in every format alike.
#[inline(always)]
pub(crate) fn nearest<T: Real>(l: [T; 3], r: [T; 3], light: &DistantSphere<T>) -> [T; 3] {
    let l_dot_r = T::dot(l, r);
    let toward = l_dot_r >= T::WIDE_ZERO;
    let (s, exponent) = if toward {
        tangent(zip(r, l, T::sub), l)
    } else {
        // Beside -l the tangent is so short that what the first step leaves along l counts.
        let (s, first) = tangent(zip(r, l, T::add), l);
        let (s, second) = tangent(s, l);
        (s, first.wrapping_add(second))
    };
    let square = T::square(s);
    let [behind, ahead] = T::STEEP;
    // The full sphere's cosine is given as -2.
    let full = light.cos < T::twice(behind);
    // False for NaN and infinity, one of which the square is wherever an input was not finite.
    let usable = square > T::WIDE_ZERO && square <= T::WIDE_MAX;
    if !usable {
        return if square == T::WIDE_ZERO && (toward || full) { r } else { finite(l) };
    }
    let inside = if light.cos >= ahead {
        toward && T::within(square, exponent, light.sin_square)
    } else if light.cos >= behind {
        l_dot_r >= light.cos
    } else {
        toward || full || !T::within(square, exponent, light.sin_square)
    };
    if inside { r } else { T::rim(l, light.versine, s, square, light.sin) }
}

/// The mirror direction `r = 2 (n.v) n - v` of the unit direction `v` from the surface to the camera, about the unit
/// normal `n`.
///
/// Shading languages' `reflect(i, n)` takes the direction *to* the surface: `reflect(-v, n)` there is this;
/// `reflect(v, n)` there is its negative.
///
/// Each lane is within half a step of I2F14 and I16F16 and one step of I2F30, 3.0e-7 in f32 and micromath, 2.7e-3 in f16
/// (`tests/specular.rs`, `tests/search.rs`). NaN gives NaN.
///
/// ```
/// use sunglint::reflect;
///
/// // Floor, and a camera to the right: what it sees comes from the left.
/// assert_eq!(reflect([0.0, 0.0, 1.0], [0.6, 0.0, 0.8_f32]), [-0.6, 0.0, 0.8]);
/// ```
#[inline]
pub fn reflect<T: Real>(n: [T; 3], v: [T; 3]) -> [T; 3] {
    T::diff(T::twice(T::dot(n, v)), n, T::WIDE_ONE, v)
}

/// `v` at unit length. A zero vector, and one with a NaN or an infinity, gives zero.
///
/// Worst error of direction and of length over lengths (`tests/search.rs`):
///
/// | | f64 | f32 | micromath | f16 | I2F14 | I2F30 | I16F16 |
/// |---|---|---|---|---|---|---|---|
/// | lengths from | 1e-150 | 1e-30 | 1e-30 | 0.01 | 0.1 | 0.01 | 1 |
/// | to | 1e150 | 1e30 | 1e30 | 3e4 | 1.9 | 1.9 | 3e4 |
/// | direction, rad | 1.5e-16 | 7.8e-8 | 7.8e-8 | 6.4e-4 | 6.0e-5 | 9.0e-10 | 1.5e-5 |
/// | length | 3.8e-16 | 2.0e-7 | 5.4e-6 | 1.8e-3 | 7.2e-5 | 1.2e-9 | 1.5e-5 |
///
/// ```
/// use sunglint::normalize;
///
/// assert_eq!(normalize([3.0, 0.0, 4.0_f32]), [0.6, 0.0, 0.8]);
/// // Lengths whose squares overflow or underflow are rescaled.
/// assert_eq!([2e30_f32, 1e-40].map(|x| normalize([x, 0.0, 0.0])), [[1.0, 0.0, 0.0]; 2]);
/// assert_eq!(normalize([f32::INFINITY, 0.0, 0.0]), [0.0; 3]);
/// ```
#[inline]
pub fn normalize<T: Real>(v: [T; 3]) -> [T; 3] {
    T::normalize(v)
}

/// `e` less its part along `l`, magnified by two to the power given beside it.
#[inline]
fn tangent<T: Real>(e: [T; 3], l: [T; 3]) -> ([T; 3], u32) {
    let (e, exponent) = T::magnify(e);
    (T::diff(T::WIDE_ONE, e, T::dot(e, l), l), exponent)
}

/// `l`, or zero where it is not finite or longer than 2.
#[cold]
pub(crate) fn finite<T: Real>(l: [T; 3]) -> [T; 3] {
    let square = T::dot(l, l);
    let short = square >= T::WIDE_ZERO && square <= T::twice(T::twice(T::WIDE_ONE));
    if short { l } else { [T::ZERO; 3] }
}
