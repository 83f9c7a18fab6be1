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
//! whose two terms cancel towards the last sliver, up to the power 5/2 of what is left of the disc. Written over `M(cos
//! t) = (t - sin t cos t) / sin^3 t`, which is smooth from 0 to a right angle and beyond, it is `E = x^3 sin^3 b (M(A) -
//! h M(h A))`, `A = cos a = c / C`; and the difference is `1 - h` times the *mean* of `V(u) = d(u M(u))/du` over `u` from
//! `h A` to `A`, so that
//!
//! `E = x^3 sin^3(b) (1 - h) mean(V)`,
//!
//! where everything is positive and nothing cancels. `V` is a polynomial in `1 - u`, [`MEAN`]: a mean of it is as
//! exact as the polynomial itself, 2.5e-7, for every disc. Above the plane, `E(h) - E(-h) = pi x^3 h` does the rest.

use crate::real::{Constant, Real, Scalar};
use crate::sphere::DistantSphere;

/// 1/pi.
const INVERSE_PI: Constant = Constant::new(core::f64::consts::FRAC_1_PI);

/// Pi.
const PI: Constant = Constant::new(core::f64::consts::PI);

/// Keeps differences of small sines from being subnormal in f16.
const SCALE: Constant = Constant::new(64.0);

/// The integral of `V` from `1 - u = 0`, by powers of `1 - u` from the highest, 11, to the first. The minimax fit of
/// degree 10 to `V`, relative error 2.5e-7 (`tests/diffuse.rs`); `V` itself has the coefficients `(k + 1)(k + 2) g(k) /
/// (2 k + 5)` with `g(k) = g(k - 1) (k + 2) / (2 k + 3)`, `g(0) = 2/3`.
const MEAN: [Constant; 11] = [
    Constant::new(0.036_408_695_407_695_62),
    Constant::new(-0.142_743_589_672_120_25),
    Constant::new(0.265_851_655_044_808_23),
    Constant::new(-0.270_570_747_920_365_51),
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
/// direction to the light's **centre**, in fixed point the plain sum of products: Q28 for I2F14, Q60 for I2F30, Q32 for
/// I16F16. `albedo`, from 0 to 1, is a lane (Q14, Q30, Q16). Levels are U16F16, or U32F32 for I2F30; illuminance and
/// radiance are in units of your choice, and U16F16 steps are `1.5e-5`.
///
/// `n_dot_l` above 1 counts as 1; below 0, and NaN, as 0. Negative albedos, and NaN, give 0; an answer that is too
/// great for the level gives the greatest level.
///
/// Error in units of the last place, in fixed point of the level or of 31 bits, whichever is coarser: LAMBERT_ERRORS.
#[inline]
pub fn lambert<T: Real>(albedo: T, illuminance: T::Level, n_dot_l: T::Wide) -> T::Level {
    matt::<T>(albedo, illuminance, up_to_one(T::scalar(n_dot_l)))
}

/// [`lambert`] with the light's true size: `albedo / pi * illuminance *` [`relative_illuminance`], so that the light
/// fades out as it sets.
#[inline]
pub fn lambert_disc<T: Real>(
    albedo: T,
    illuminance: T::Level,
    n_dot_l: T::Wide,
    light: &DistantSphere<T>,
) -> T::Level {
    matt::<T>(albedo, illuminance, relative_illuminance(n_dot_l, light))
}

/// Illuminance of a plane under a disc, over that of a plane which faces it: `E / (pi x^2)`, from 0 to 1.
///
/// Where the disc is wholly above the plane, `n.l >= x`, it is `n.l` itself; where it is wholly below, `n.l <= -x`, zero;
/// between the two what is left of the disc gives (2/(3 pi)) x or so when its centre sets. For a light that is normalised to give an
/// illuminance (see [`radiance`](crate::normalization::radiance)), times that is the illuminance of the plane. Beyond
/// half the sky, where the plane that faces the light gets pi, it is `1 - x^2 e(-n.l)`, `e` being that of the disc that
/// is missing.
///
/// `n_dot_l` above 1 counts as 1. NaN gives 0, or 1 beyond half the sky.
#[inline]
pub fn relative_illuminance<T: Real>(n_dot_l: T::Wide, light: &DistantSphere<T>) -> T::Scalar {
    let [sine, x, c] = [n_dot_l, light.sin, light.cos].map(T::scalar);
    let zero = T::Scalar::ZERO;
    if light.cos >= T::WIDE_ZERO {
        of_cap(sine, x, c)
    } else {
        T::Scalar::ONE - x * x * of_cap(zero - sine, x, zero - c)
    }
}

/// Illuminance of a plane under a disc of the given radiance: `radiance * pi x^2 *` [`relative_illuminance`] (beyond half the
/// sky without `x^2`).
///
/// In f16 the answer for the Sun needs a radiance of 1000 or more to be a normal number at every elevation.
#[inline]
pub fn illuminance<T: Real>(radiance: T::Scalar, n_dot_l: T::Wide, light: &DistantSphere<T>) -> T::Scalar {
    let relative = relative_illuminance(n_dot_l, light);
    let pi = T::Scalar::constant(PI);
    let x = T::scalar(light.sin);
    // In this order nothing overflows or underflows that the answer does not.
    if light.cos >= T::WIDE_ZERO { radiance * x * relative * (pi * x) } else { radiance * relative * pi }
}

#[inline]
fn matt<T: Real>(albedo: T, illuminance: T::Level, share: T::Scalar) -> T::Level {
    let white = T::of_level(illuminance) * T::Scalar::constant(INVERSE_PI);
    T::level(white * share * T::of_lane(albedo))
}

#[inline]
fn up_to_one<S: Scalar>(value: S) -> S {
    let positive = if value > S::ZERO { value } else { S::ZERO };
    if positive < S::ONE { positive } else { S::ONE }
}

/// [`relative_illuminance`] of a disc of up to half the sky.
#[inline]
fn of_cap<S: Scalar>(sine: S, x: S, c: S) -> S {
    if sine >= x {
        return up_to_one(sine);
    }
    let below = sine < S::ZERO;
    let depth = if below { S::ZERO - sine } else { sine };
    // Not for NaN.
    let astride = depth < x;
    match (astride, below) {
        (true, true) => segment(depth, x, c),
        (true, false) => sine + segment(depth, x, c),
        (false, _) => S::ZERO,
    }
}

/// The same of a disc whose centre is `depth` below the plane, but not all of it.
#[inline]
fn segment<S: Scalar>(depth: S, x: S, c: S) -> S {
    let scale = S::constant(SCALE);
    let (depth, radius) = (depth * scale, x * scale);
    let (h, left) = (depth / radius, (radius - depth) / radius);
    let q = (left * (S::ONE + h)).root();
    let side = (c * c + (x * q) * (x * q)).root();
    let (cos_a, sin_b) = (c / side, q / side);
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
