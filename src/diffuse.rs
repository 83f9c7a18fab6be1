//! Diffuse light: what a matt surface sends back, and what a disc gives to a plane that it sets behind.
//!
//! Both take the direction to the light's *centre*, never the shifted direction of [`specular`](crate::specular): that
//! one turns with the camera, and at grazing incidence it is wrong by more than the answer (`tests/furnace.rs`).
//!
//! # The horizon
//!
//! A disc of sine `x` and cosine `c` whose centre is `h x` below the plane shows a segment of itself. Cut at the
//! azimuth `a` from the plane's side and at the azimuth `b` from the disc's, `sin a = x sin b = x q / C`, with `q^2 =
//! 1 - h^2` and `C^2 = c^2 + x^2 q^2`, its illuminance is
//!
//! `E = (a - sin a cos a) - h x^3 (b - sin b cos b)`,
//!
//! whose two terms cancel towards the last sliver, up to the power 5/2 of what is left of the disc. Written over
//! `M(cos t) = (t - sin t cos t) / sin^3 t`, which is smooth from 0 to a right angle and beyond, it is `E = x^3 sin^3
//! b (M(A) - h M(h A))`, `A = cos a = c / C`; and the difference is `1 - h` times the *mean* of `V(u) = d(u M(u))/du`
//! over `u` from `h A` to `A`, so that
//!
//! `E = x^3 sin^3(b) (1 - h) mean(V)`,
//!
//! where everything is positive and nothing cancels. `V` is fitted by a polynomial in `1 - u`, so that its mean is as
//! exact as the polynomial itself, 2.5e-7, for every disc. With the centre `h x` above the plane it is `pi x^3 h`
//! more: by as much do the two sides of the plane differ.
//!
//! The closed form that is found elsewhere (Lagarde and de Rousiers, 2014) is 17 times off in f32 at the Sun with three
//! hundredths of its radius up, and negative below that (`tests/furnace.rs`).
//!
//! # What the vectors allow
//!
//! Near the horizon the answer is as good as `n.l`, and that is as good as the vectors. With `n` and `l` rounded into
//! the format, at the Sun, the relative illuminance is off by at most these parts of what it is when the centre sets
//! (`trial::diffuse::VECTORS`): f32 1.4e-4, I2F30 1.6e-6, I16F16 0.024, I2F14 0.11, f16 0.88. So f16 knows that the
//! Sun sets, but not when; from a ratio of 0.05 on it is within 0.1.

use crate::real::{Constant, INVERSE_PI, Real, Scalar, within_one};
use crate::sphere::DistantSphere;

/// Pi.
const PI: Constant = Constant::new(core::f64::consts::PI);

/// Keeps differences of small sines, and the light of small segments, from being subnormal in f16.
const SCALE: Constant = Constant::new(64.0);

/// Takes that off again.
const UNSCALE: Constant = Constant::new(1.0 / 64.0);

/// The integral of `V` from `1 - u = 0`, by powers of `1 - u` from the highest, 11, to the first. The minimax fit of
/// degree 10 to `V`, relative error 2.5e-7 (`tests/diffuse.rs`); `V` itself has the coefficients `(k + 1)(k + 2) g(k) /
/// (2 k + 5)` with `g(k) = g(k - 1) (k + 2) / (2 k + 3)`, `g(0) = 2/3`.
const MEAN: [Constant; 11] = [
    Constant::new(0.036_408_695_407_695_62),
    Constant::new(-0.142_743_589_672_120_25),
    Constant::new(0.265_851_655_044_808_23),
    Constant::new(-0.270_570_747_920_365_5),
    Constant::new(0.188_419_984_157_893_81),
    Constant::new(-0.056_430_230_961_800_06),
    Constant::new(0.051_024_512_617_983_92),
    Constant::new(0.054_790_463_105_942_67),
    Constant::new(0.101_829_232_630_900_81),
    Constant::new(0.171_419_960_959_719_79),
    Constant::new(0.266_666_732_941_254_26),
];

/// Lambert's law: the radiance `albedo / pi * illuminance * max(n.l, 0)` of a matt surface, the same in all directions.
///
/// `illuminance` is that of a plane which faces the light; `n_dot_l` the dot product of the unit normal with the unit
/// direction to the light's **centre**, in fixed point the plain sum of products: Q28 for I2F14, Q60 for I2F30, Q32
/// for I16F16. `albedo`, from 0 to 1, is a lane (Q14, Q30, Q16). Illuminance and radiance are levels, in units of your
/// choice: U16F16, or U32F32 for I2F30.
///
/// `n_dot_l` above 1 counts as 1; below 0, and NaN, as 0. Negative albedos, and NaN, give 0; an answer that is too
/// great for the level gives the greatest level.
///
/// Worst error in units of the last place (`tests/diffuse.rs`): f64 4.5, f32 and micromath 3.2, f16 3.0; in fixed point
/// of the level, or of 31 bits where those are coarser: I2F14 and I16F16 0.57, I2F30 2.5. That is for levels up to
/// 1000; for any level f32 3.3, f16 3.2, I2F14 and I16F16 1.4, I2F30 2.9 (`tests/figures.rs`).
///
/// ```
/// use sunglint::lambert;
///
/// // Grass at noon: a quarter of 100 000 lx comes back, in candela per square metre.
/// let luminance = lambert(0.25_f32, 100_000.0, 1.0);
/// assert!((luminance - 7957.75).abs() < 0.01);
/// ```
#[inline]
pub fn lambert<T: Real>(albedo: T, illuminance: T::Level, n_dot_l: T::Wide) -> T::Level {
    matt::<T>(albedo, illuminance, within_one(T::scalar(n_dot_l)))
}

/// [`lambert`] with the light's true size: `albedo / pi * illuminance *` [`relative_illuminance`], so that the light
/// fades out as it sets.
///
/// Arguments and special cases are those of the two; the error is that of the one more than that of the other.
///
/// ```
/// use sunglint::fixed::types::{I2F14, U16F16};
/// use sunglint::{DistantSphere, SUN, lambert, lambert_disc};
///
/// const SUN_Q14: DistantSphere<I2F14> = DistantSphere::<I2F14>::new(&SUN);
///
/// // Snow under 2000 units of light; n.l in Q28. High up both laws are one; half set, the disc alone still lights.
/// let (snow, light) = (I2F14::from_num(0.9), U16F16::from_num(2000));
/// assert_eq!(lambert_disc(snow, light, 1 << 27, &SUN_Q14), lambert(snow, light, 1 << 27));
/// assert_eq!(lambert(snow, light, 0), U16F16::ZERO);
/// assert!((lambert_disc(snow, light, 0, &SUN_Q14).to_num::<f64>() - 0.5655).abs() < 1e-3);
/// ```
#[inline]
pub fn lambert_disc<T: Real>(albedo: T, illuminance: T::Level, n_dot_l: T::Wide, light: &DistantSphere<T>) -> T::Level {
    matt::<T>(albedo, illuminance, relative_illuminance(n_dot_l, light))
}

/// Illuminance of a plane under a disc, over that of a plane which faces it: `E / (pi x^2)`, from 0 to 1.
///
/// Where the disc is wholly above the plane, `n.l >= x`, it is `n.l` itself; where it is wholly below, `n.l <= -x`,
/// zero; when its centre sets, about `2 x / (3 pi)`. For a light that is normalised to give an illuminance (see
/// [`radiance`](crate::normalization::radiance)), times that it is the illuminance of the plane. Beyond half the sky,
/// where the plane that faces the light gets pi, it is `1 - x^2 e(-n.l)`, `e` being that of the disc that is missing.
///
/// Continuous, and rising with `n.l` but for rounding. `n_dot_l` above 1 counts as 1. NaN gives 0, or 1 beyond half the
/// sky. The answer is never negative.
///
/// Worst relative error at every elevation down to the last sliver, for the sine and the cosine as they are in the
/// format, of discs of a ratio up to the one given (searched for, `tests/figures.rs`); of I2F30's and I16F16's cosines
/// 31 bits count. Most of it is the polynomial, 2.5e-7. f16 counts answers below its least normal number, 6.1e-5, as
/// that one; where it flushes them they are zero.
///
/// | ratio | f64 | f32 | micromath | f16 | I2F14 | I2F30 | I16F16 |
/// |---|---|---|---|---|---|---|---|
/// | 0.01, as the Sun's | 2.8e-7 | 9.4e-7 | 1.3e-5 | 6.8e-3 | 2.9e-7 | 2.9e-7 | 2.9e-7 |
/// | 0.5 | 2.8e-7 | 9.7e-7 | 1.7e-5 | 7.2e-3 | 2.9e-7 | 2.9e-7 | 2.9e-7 |
/// | 1 | 2.8e-7 | 1.1e-6 | 1.7e-5 | 7.2e-3 | 2.9e-7 | 2.9e-7 | 2.9e-7 |
///
/// Beyond half the sky the error is absolute: f64 and fixed point 1.4e-7, f32 1.2e-6, micromath 8.3e-6, f16 7.7e-3 (it
/// rounds the sine of 181 degrees to 1; `tests/diffuse.rs`).
///
/// Cost: two comparisons; where the plane cuts the disc, two roots, three divisions and a polynomial of degree 10.
///
/// ```
/// use sunglint::{DistantSphere, SUN, relative_illuminance};
///
/// const SUN_F32: DistantSphere<f32> = DistantSphere::<f32>::new(&SUN);
///
/// assert_eq!(relative_illuminance(0.5, &SUN_F32), 0.5);
/// // The Sun half set gives as much as a point 0.0565 degrees high.
/// assert!((relative_illuminance(0.0, &SUN_F32) - 9.87e-4).abs() < 1e-6);
/// assert_eq!(relative_illuminance(-0.005, &SUN_F32), 0.0);
/// ```
#[inline]
pub fn relative_illuminance<T: Real>(n_dot_l: T::Wide, light: &DistantSphere<T>) -> T::Scalar {
    let (sine, x) = (T::scalar(n_dot_l), T::scalar(light.sin));
    if light.cos >= T::WIDE_ZERO { of_cap(sine, x) } else { T::Scalar::ONE - x * x * of_cap(T::Scalar::ZERO - sine, x) }
}

/// Illuminance of a plane under a disc of the given radiance: `radiance * pi x^2 *` [`relative_illuminance`] (beyond
/// half the sky without `x^2`). `pi` for the sky of radiance 1.
///
/// Worst relative error as that of [`relative_illuminance`], and a unit of the last place or two; beyond half the sky
/// the error is a part of the radiance, at most 4.4e-7 in f64 and fixed point, 1.5e-6 in f32, 2.5e-5 in micromath and
/// 7.3e-3 in f16 (searched for, `tests/figures.rs`). A share of less than
/// the least normal number of a float has lost digits before a great radiance multiplies it. In f16 the Sun of radiance
/// 1 gives 6.8e-5, next to that number: there, scale the radiance, or use [`lambert_disc`] with the illuminance. What
/// is too great for a float is infinite.
///
/// ```
/// use core::f64::consts::PI;
/// use sunglint::{DistantLight, DistantSphere, SUN, illuminance};
///
/// // The sky of radiance 1, and the Sun that gives 1361 W/m^2 overhead, at 30 degrees of elevation.
/// let sky = DistantSphere::<f64>::of(&DistantLight::from_angle(180.0)?);
/// assert!((illuminance(1.0, 1.0, &sky) - PI).abs() < 1e-15);
/// let radiance = 1361.0 / (PI * SUN.sin() * SUN.sin());
/// assert!((illuminance(radiance, 0.5, &DistantSphere::<f64>::new(&SUN)) - 680.5).abs() < 1e-9);
/// # Ok::<(), sunglint::LightError>(())
/// ```
#[inline]
pub fn illuminance<T: Real>(radiance: T::Scalar, n_dot_l: T::Wide, light: &DistantSphere<T>) -> T::Scalar {
    let relative = relative_illuminance(n_dot_l, light);
    let pi = T::Scalar::constant(PI);
    let x = T::scalar(light.sin);
    // In this order nothing overflows or underflows that the answer does not, but for the share itself.
    if light.cos >= T::WIDE_ZERO { radiance * x * relative * (pi * x) } else { radiance * relative * pi }
}

#[inline]
fn matt<T: Real>(albedo: T, illuminance: T::Level, share: T::Scalar) -> T::Level {
    let white = T::of_level(illuminance) * T::Scalar::constant(INVERSE_PI);
    T::level(white * share * T::of_lane(albedo))
}

/// [`relative_illuminance`] of a disc of up to half the sky.
#[inline]
fn of_cap<S: Scalar>(sine: S, x: S) -> S {
    if sine >= x { within_one(sine) } else { astride_or_below(sine, x) }
}

#[inline(never)]
fn astride_or_below<S: Scalar>(sine: S, x: S) -> S {
    let below = sine < S::ZERO;
    let [depth, x] = [if below { S::ZERO - sine } else { sine }, x].map(|sine| sine * S::constant(SCALE));
    // Not for NaN.
    let astride = depth < x;
    let scaled = match (astride, below) {
        (true, true) => segment(depth, x),
        (true, false) => depth + segment(depth, x),
        (false, _) => S::ZERO,
    };
    scaled * S::constant(UNSCALE)
}

/// The same of a disc whose centre is `depth` below the plane, but not all of it; `depth`, `x` and the answer are
/// scaled.
#[inline]
fn segment<S: Scalar>(depth: S, x: S) -> S {
    let (h, left) = (depth / x, (x - depth) / x);
    let across = left * (S::ONE + h);
    let sine = x * S::constant(UNSCALE);
    // The cosine that belongs to the sine as it was rounded, which for discs of almost half the sky is another.
    let cosine_square = (S::ONE - sine) * (S::ONE + sine);
    let inverse = S::ONE / (cosine_square + sine * sine * across);
    let (cos_a, sin_b) = ((cosine_square * inverse).root(), (across * inverse).root());
    let mean = mean(S::ONE - h * cos_a, S::ONE - cos_a);
    sin_b * sin_b * sin_b * left * mean * S::constant(INVERSE_PI) * x
}

/// The mean of `V` from one argument to the other: the slope of its integral's chord, by Horner's scheme for both of
/// the chord's ends at once.
#[inline]
fn mean<S: Scalar>(from: S, to: S) -> S {
    let step = |(value, slope): (S, S), coefficient: Constant| {
        let value = value * from + S::constant(coefficient);
        (value, slope * to + value)
    };
    MEAN.into_iter().fold((S::ZERO, S::ZERO), step).1
}
