//! The energy factors of a widened highlight against 192 bits.

mod exact;

use std::f64::consts::FRAC_PI_2;

use ::fixed::types::{I2F14, I2F30, I16F16};
use exact::{Big, assert_tight, big, fixed, lsbs, pi, square, ulps, worst};
use half::f16;
use micromath::F32;
use oorandom::Rand64;
use sunglint::highlight::{exact_rp, exact_rp_q30, karis, karis_q30};
use sunglint::{Float, LightError, Scalar};

/// Pairs of a width and an angle up to `most`: the named angles with widths from 0.001 to 1, and random ones.
fn pairs(most: f64) -> Vec<[f64; 2]> {
    let mut source = Rand64::new(7);
    let mut logarithmic = |least: f64, most: f64| (least * (most / least).powf(source.rand_float())).min(most);
    let widths: Vec<f64> = (0..=60).map(|i| 0.001 * 1000_f64.powf(f64::from(i) / 60.0)).collect();
    let named = [0.0, 1e-4, 0.00465, 0.05, 0.3, 1.0, most];
    let mut pairs: Vec<[f64; 2]> = widths.iter().flat_map(|&alpha| named.map(|angle| [alpha, angle])).collect();
    pairs.extend((0..RANDOM).map(|_| [logarithmic(1e-3, 1.0), logarithmic(1e-5, most)]));
    pairs
}

const RANDOM: usize = 1500;

fn karis_truth(alpha: &Big, ratio: &Big) -> Big {
    let sum = alpha + ratio / big(2.0);
    let widened = if sum > big(1.0) { big(1.0) } else { sum };
    square(&(alpha / widened))
}

fn exact_rp_truth(alpha: &Big, theta: &Big) -> Big {
    let t = theta / (big(2.0) * alpha);
    big(1.0) / (big(1.0) + pi() / big(2.0) * &t + square(&t))
}

type Function<T> = fn(T, T) -> Result<T, LightError>;

/// Worst error in units of the last place over pairs that are rounded into the format first.
fn worst_of<T: Float>(function: Function<T>, truth: fn(&Big, &Big) -> Big, most: f64) -> f64 {
    worst(pairs(most).into_iter().map(|pair| {
        let [alpha, angle] = pair.map(T::nearest);
        ulps(function(alpha, angle).unwrap(), &truth(&big(alpha.exact()), &big(angle.exact())))
    }))
}

fn check<T: Float>() {
    let name = T::FORMAT;
    assert_tight(&format!("karis in {name}, ULP"), worst_of::<T>(karis, karis_truth, 1.0), 4.0);
    assert_tight(&format!("exact_rp in {name}, ULP"), worst_of::<T>(exact_rp, exact_rp_truth, FRAC_PI_2), 4.0);
}

#[test]
fn in_f64() {
    check::<f64>();
}

#[test]
fn in_f32() {
    check::<f32>();
}

#[test]
fn in_micromath() {
    check::<F32>();
}

#[test]
fn in_f16() {
    check::<f16>();
}

/// The same in integers, in units of the last place of Q30.
fn worst_q30(function: fn(I2F30, I2F30) -> Result<I2F30, LightError>, truth: fn(&Big, &Big) -> Big, most: f64) -> f64 {
    worst(pairs(most).into_iter().map(|pair| {
        // Cut, so that pi/2 stays within what is allowed.
        let [alpha, angle] = pair.map(|value| (value * f64::from(1 << 30)) as i32);
        let computed = function(I2F30::from_bits(alpha), I2F30::from_bits(angle)).unwrap();
        lsbs(computed.to_bits().into(), 30, &truth(&fixed(alpha.into(), 30), &fixed(angle.into(), 30)))
    }))
}

#[test]
fn in_integers() {
    assert_tight("karis_q30, LSB", worst_q30(karis_q30, karis_truth, 1.0), 0.5);
    assert_tight("exact_rp_q30, LSB", worst_q30(exact_rp_q30, exact_rp_truth, FRAC_PI_2), 0.52);
}

fn check_special<T: Float>() {
    let [zero, half, one] = [0.0, 0.5, 1.0].map(T::nearest);
    for function in [karis, exact_rp] as [Function<T>; 2] {
        // Neither a light nor a width: nothing is widened. A width without a light likewise.
        assert_eq!([function(zero, zero), function(half, zero)], [Ok(one); 2]);
        // A mirror under a disc.
        assert_eq!([function(zero, half), function(zero, one)], [Ok(zero); 2]);
        for alpha in [-0.5, 1.125, f64::INFINITY, f64::NAN].map(T::nearest) {
            assert!(matches!(function(alpha, half), Err(LightError::Alpha(_))));
        }
    }
    for angle in [-0.5, 1.75, f64::INFINITY, f64::NAN].map(T::nearest) {
        assert!(matches!(karis(half, angle), Err(LightError::Ratio(_))));
        assert!(matches!(exact_rp(half, angle), Err(LightError::SphereAngularRadius(_))));
    }
    // The widened highlight is cut at 1.
    assert_eq!(karis(one, one), Ok(one));
}

#[test]
fn special_values_and_errors() {
    check_special::<f64>();
    check_special::<f32>();
    check_special::<F32>();
    check_special::<f16>();
    assert_eq!(karis(f64::NAN, 0.5).unwrap_err().to_string(), "alpha is NaN, allowed is 0 to 1");
}

#[test]
fn special_values_and_errors_in_integers() {
    let [zero, half, one] = [0.0, 0.5, 1.0].map(I2F30::from_num);
    for function in [karis_q30, exact_rp_q30] {
        assert_eq!([function(zero, zero), function(half, zero)], [Ok(one); 2]);
        assert_eq!([function(zero, half), function(zero, one)], [Ok(zero); 2]);
        for bits in [-1, i32::MIN, (1 << 30) + 1, i32::MAX] {
            assert_eq!(function(I2F30::from_bits(bits), half), Err(LightError::AlphaQ30(bits)));
        }
    }
    let right = (FRAC_PI_2 * f64::from(1 << 30)) as i32;
    assert!(exact_rp_q30(half, I2F30::from_bits(right)).is_ok());
    for bits in [-1, right + 1, i32::MAX] {
        assert_eq!(exact_rp_q30(half, I2F30::from_bits(bits)), Err(LightError::AngularRadiusQ30(bits)));
    }
    assert_eq!(karis_q30(half, I2F30::from_bits(-1)), Err(LightError::RatioQ30(-1)));
    assert_eq!(karis_q30(half, I2F30::from_bits((1 << 30) + 1)), Err(LightError::RatioQ30((1 << 30) + 1)));
}

/// Where alpha is a thousandth, `t^2` is above f16's greatest number for discs wider than half a radian.
#[test]
fn wide_discs_do_not_overflow_in_f16() {
    let [alpha, theta] = [1e-3, FRAC_PI_2].map(f16::nearest);
    let t = theta / (alpha + alpha);
    assert!((t * t).is_infinite());
    let truth = exact_rp_truth(&big(alpha.exact()), &big(theta.exact()));
    println!("{} in place of {}", exact_rp(alpha, theta).unwrap(), truth.to_f64().value());
    assert!(ulps(exact_rp(alpha, theta).unwrap(), &truth) <= 1.0);
}

/// What hardware that flushes subnormals makes of an f16.
fn flushed(value: f16) -> f16 {
    if value.is_normal() { value } else { f16::ZERO }
}

/// A roughness of 3 % under the Sun, and under discs of 0.05 and 1.
const SIZES: [f64; 4] = [0.0, 0.00465, 0.05, 1.0];

#[test]
fn quotient_of_squares_is_lost_where_f16_flushes() {
    let alpha = f16::nearest(1e-3);
    let answers = SIZES.map(|ratio| {
        let widened = alpha + f16::nearest(ratio / 2.0);
        [flushed(alpha * alpha) / flushed(widened * widened), karis(alpha, f16::nearest(ratio)).unwrap()]
    });
    println!("squares divided, quotient squared: {answers:?}");
    let [point, sun, disc, half_sky] = answers;
    // Zero over zero, twice, and zero.
    assert!(point[0].is_nan() && sun[0].is_nan());
    assert_eq!([disc[0], half_sky[0]], [f16::ZERO; 2]);
    assert_eq!(point[1], f16::ONE);
    assert!(sun[1].is_normal() && disc[1].is_normal());
    // 4e-6: there, flushing leaves nothing to either.
    assert!(half_sky[1] > f16::ZERO && !half_sky[1].is_normal());
}

#[test]
fn quotient_of_squares_is_lost_in_i2f14() {
    let alpha = I2F14::from_num(1e-3);
    let old = SIZES.map(|ratio| {
        let widened = alpha + I2F14::from_num(ratio / 2.0);
        (alpha * alpha).checked_div(widened * widened)
    });
    let [point, sun, disc, half_sky] =
        SIZES.map(|ratio| karis_q30(I2F30::from_num(1e-3), I2F30::from_num(ratio)).unwrap());
    assert_eq!(old, [None, None, Some(I2F14::ZERO), Some(I2F14::ZERO)]);
    assert_eq!(point, I2F30::ONE);
    assert!(sun > disc && disc > half_sky && half_sky > 0);
}

/// `alpha / alpha'` of 0.002 fits I16F16, its square of 4e-6 does not: a quarter of its last place.
#[test]
fn square_of_the_quotient_is_lost_in_i16f16() {
    let [alpha, ratio] = [1e-3, 0.998].map(I16F16::from_num);
    let quotient = alpha / (alpha + ratio / 2);
    assert!(quotient > 0);
    assert_eq!(quotient * quotient, I16F16::ZERO);
    let factor: f64 = karis_q30(I2F30::from_num(1e-3), I2F30::from_num(0.998)).unwrap().to_num();
    assert!((factor / 4e-6 - 1.0).abs() < 1e-3, "{factor:e}");
}
