//! Errors of narrow floats in units of the last place, against f64, whose own rounding is 1e-8 of such a unit.

use std::f64::consts::PI;

use half::f16;
use micromath::F32;
use sunglint::blackbody::{relative_to_peak, relative_to_peak_frequency};
use sunglint::highlight::{exact_rp, karis};
use sunglint::normalization::{radiance, sun_radius_at};
use sunglint::oracle::planck::Law;
use sunglint::sampling::sin_cos;
use sunglint::trial::quantity::Quantity;
use sunglint::{DistantSphere, Float, LightError, Real, soft};

/// A float that is tried bit by bit.
pub trait Bits: Float {
    /// Digits, and exponent of the least normal number.
    const SHAPE: [i64; 2];

    /// The least number whose root is right.
    const LEAST_ROOTED: f64 = 0.0;

    fn of(bits: u64) -> Self;
}

impl Bits for f32 {
    const SHAPE: [i64; 2] = [24, -126];

    fn of(bits: u64) -> Self {
        Self::from_bits(bits as u32)
    }
}

impl Bits for F32 {
    const SHAPE: [i64; 2] = [24, -126];

    // Its bit trick makes nothing of subnormals.
    const LEAST_ROOTED: f64 = f32::MIN_POSITIVE as f64;

    fn of(bits: u64) -> Self {
        Self(f32::from_bits(bits as u32))
    }
}

impl Bits for f16 {
    const SHAPE: [i64; 2] = [11, -14];

    fn of(bits: u64) -> Self {
        Self::from_bits(bits as u16)
    }
}

/// Distance from a truth that is zero or a normal f64, in units of the last place there.
fn ulps<T: Bits>(answer: T, truth: f64) -> f64 {
    let [digits, least] = T::SHAPE;
    let exponent = ((truth.to_bits() >> 52 & 0x7ff) as i64 - 1023).max(least);
    (answer.exact() - truth) / f64::from_bits(((exponent + 1 - digits + 1023) as u64) << 52)
}

/// Nothing to measure where the claim holds; the worst of all where not.
fn only(claim: bool) -> f64 {
    if claim { 0.0 } else { f64::NAN }
}

fn in_unit(value: f64) -> bool {
    (0.0..=1.0).contains(&value)
}

/// `1 / (pi x^2)` and the like, straight from the definitions.
fn truth_of(quantity: Quantity, ratio: f64) -> f64 {
    let square = ratio * ratio;
    let versine = square / (1.0 + (1.0 - square).sqrt());
    match quantity {
        Quantity::Versine => versine,
        Quantity::SolidAngle => 2.0 * PI * versine,
        Quantity::SizeFactor | Quantity::InverseSizeFactor if ratio == 0.0 => 1.0,
        Quantity::SizeFactor => PI * square,
        Quantity::InverseSizeFactor => 1.0 / (PI * square),
        Quantity::WhiteRadiance => 1.0 / square,
    }
}

fn judged<T: Bits>(answer: Result<T, LightError>, truth: f64) -> f64 {
    match answer {
        Ok(answer) => ulps(answer, truth),
        // From the middle between the greatest number and the one that would follow it.
        Err(LightError::Overflow(format)) => only(format == T::FORMAT && ulps(T::MAX, truth) <= -0.5),
        Err(_) => f64::NAN,
    }
}

pub fn quantity<T: Bits>(quantity: Quantity, bits: u64) -> f64 {
    let ratio = T::of(bits);
    let (exact, answer) = (ratio.exact(), quantity.in_float(ratio));
    if in_unit(exact) {
        judged(answer, truth_of(quantity, exact))
    } else {
        only(matches!(answer, Err(LightError::Ratio(_))))
    }
}

/// The greatest error of the four constants of a light.
pub fn sphere<T: Bits>(bits: u64) -> f64 {
    let ratio = T::of(bits);
    let exact = ratio.exact();
    match DistantSphere::<T>::from_ratio(ratio) {
        Ok(sphere) if in_unit(exact) => {
            let scaled = exact * T::SCALE.exact();
            let errors = [
                ulps(sphere.sin(), exact),
                ulps(sphere.sin_square(), scaled * scaled),
                ulps(sphere.cos(), (1.0 - exact * exact).sqrt()),
                ulps(sphere.versine(), truth_of(Quantity::Versine, exact)),
            ];
            errors.into_iter().map(f64::abs).fold(0.0, f64::max)
        }
        Err(LightError::Ratio(_)) => only(!in_unit(exact)),
        _ => f64::NAN,
    }
}

pub fn sun_radius<T: Bits>(bits: u64) -> f64 {
    let distance = T::of(bits);
    let exact = distance.exact();
    match sun_radius_at(distance) {
        Ok(radius) => ulps(radius, exact * (6_957_000.0 / 1_495_978_707.0)),
        Err(LightError::Distance(_)) => only(!(exact > 0.0 && exact.is_finite())),
        Err(_) => f64::NAN,
    }
}

/// Roots of what is not negative; of negative numbers NaN or zero.
pub fn root<T: Bits>(bits: u64) -> f64 {
    let value = T::of(bits);
    let (exact, root) = (value.exact(), value.root());
    let normal = exact == 0.0 || exact >= T::LEAST_ROOTED;
    if exact >= 0.0 && exact.is_finite() {
        if normal { ulps(root, exact.sqrt()) } else { only((0.0..=1e-18).contains(&root.exact())) }
    } else if exact == f64::INFINITY {
        only(!root.exact().is_finite())
    } else {
        only(root.exact().is_nan() || root.exact() == 0.0)
    }
}

/// Roots in integers, which are the same bits as libm's; of what is not a number any NaN will do.
pub fn soft_root(bits: u64) -> f64 {
    let value = f32::of(bits);
    let (answer, libm) = (soft::root(value), libm::sqrtf(value));
    let same = answer.to_bits() == libm.to_bits() || (answer.is_nan() && libm.is_nan());
    if !same {
        return f64::NAN;
    }
    if value > 0.0 && value.is_finite() { ulps(answer, f64::from(value).sqrt()) } else { 0.0 }
}

/// Reciprocal roots in integers, and IEEE 754's special cases of them.
pub fn soft_reciprocal_root(bits: u64) -> f64 {
    let value = f32::of(bits);
    let answer = soft::reciprocal_root(value);
    if value > 0.0 && value.is_finite() {
        ulps(answer, 1.0 / f64::from(value).sqrt())
    } else if value == 0.0 {
        only(answer.is_infinite() && answer.is_sign_negative() == value.is_sign_negative())
    } else if value == f32::INFINITY {
        only(answer.to_bits() == 0)
    } else {
        only(answer.is_nan())
    }
}

/// The greater error of sine and cosine in steps of the numbers just below 1, for turns from 0 to 1 in the lanes of a
/// format.
pub fn turn<T: Real>(turn: T, step: f64) -> f64 {
    let [sin, cos] = sin_cos(T::of_lane(turn)).map(|value| T::lane(value).to_f64());
    let [sine, cosine] = <[f64; 2]>::from((2.0 * PI * turn.to_f64()).sin_cos());
    (sin - sine).abs().max((cos - cosine).abs()) / step
}

/// Planck's law over its peak at a positive ratio.
pub fn planck(law: Law, ratio: f64) -> f64 {
    match law {
        Law::Wavelength => {
            let peak = 4.965_114_231_744_276_f64;
            peak.exp_m1() / (peak / ratio).exp_m1() / (ratio * ratio) / (ratio * ratio) / ratio
        }
        Law::Frequency => {
            let peak = 2.821_439_372_122_079_f64;
            peak.exp_m1() / (peak * ratio).exp_m1() * (ratio * ratio) * ratio
        }
    }
}

/// In steps of the numbers just below 1.
pub fn relative<T: Bits>(law: Law, bits: u64) -> f64 {
    let ratio = T::of(bits);
    let exact = ratio.exact();
    let answer = match law {
        Law::Wavelength => relative_to_peak(ratio),
        Law::Frequency => relative_to_peak_frequency(ratio),
    };
    if exact > 0.0 && exact.is_finite() {
        (answer.exact() - planck(law, exact)) * f64::from_bits(((T::SHAPE[0] + 1023) as u64) << 52)
    } else {
        only(answer.exact() == 0.0)
    }
}

fn pair(bits: u64) -> [f16; 2] {
    [f16::of(bits >> 16), f16::of(bits & 0xffff)]
}

/// Karis's factor of `alpha` and `ratio`.
pub fn karis_of(bits: u64) -> f64 {
    let [alpha, ratio] = pair(bits);
    let [a, x] = [alpha, ratio].map(f16::to_f64);
    let answer = karis(alpha, ratio);
    if in_unit(a) && in_unit(x) {
        let quotient = a / (a + x / 2.0).min(1.0);
        judged(answer, if quotient.is_nan() { 1.0 } else { quotient * quotient })
    } else {
        only(matches!(answer, Err(LightError::Alpha(_) | LightError::Ratio(_))))
    }
}

/// The energy factor of `alpha` and the angular radius.
pub fn exact_rp_of(bits: u64) -> f64 {
    let [alpha, theta] = pair(bits);
    let [a, angle] = [alpha, theta].map(f16::to_f64);
    let answer = exact_rp(alpha, theta);
    // f16's pi/2 is the nearest.
    if in_unit(a) && (0.0..=f16::from_f64(PI / 2.0).to_f64()).contains(&angle) {
        let t = angle / (2.0 * a.abs());
        judged(answer, if angle == 0.0 { 1.0 } else { 1.0 / (1.0 + PI / 2.0 * t + t * t) })
    } else {
        only(matches!(answer, Err(LightError::Alpha(_) | LightError::SphereAngularRadius(_))))
    }
}

/// Radiance of an intensity from 0.001 on and a ratio from 1/2048 on; below, a number or an overflow.
pub fn radiance_of(bits: u64) -> f64 {
    let [intensity, ratio] = pair(bits);
    let [i, x] = [intensity, ratio].map(f16::to_f64);
    let allowed = i >= 0.0 && i.is_finite();
    let answer = radiance(intensity, ratio);
    if allowed && in_unit(x) && x > 0.0 && (i < 0.001 || x < 1.0 / 2048.0) {
        let overflow = answer == Err(LightError::Overflow("f16"));
        return only(overflow || answer.is_ok_and(f16::is_finite));
    }
    match answer {
        Err(LightError::Ratio(_)) => only(!in_unit(x)),
        Err(LightError::Intensity(_)) => only(in_unit(x) && !allowed),
        Ok(answer) if x == 0.0 => only(answer == intensity),
        Err(LightError::Overflow(_)) => only(allowed && in_unit(x) && i / (PI * x * x) > 65_000.0),
        answer if allowed && in_unit(x) => judged(answer, i / (PI * x * x)),
        _ => f64::NAN,
    }
}
