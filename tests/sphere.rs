//! A light's constants in every format against 192 bits: correctly rounded, and the same by every way to them.

mod exact;

use ::fixed::types::{I2F14, I2F30, I16F16};
use exact::lights::{Truth, lights, ratios};
use exact::{Big, assert_tight, big, distance, fixed, last_place, square, ulps, worst};
use half::f16;
use micromath::F32;
use sunglint::{DistantLight, DistantSphere, Float, LightError, Real, SUN, Scalar};

#[test]
fn ratio_in_a_format_is_0_to_1() {
    for ratio in [-1.0_f32, 1.0_f32.next_up(), f32::INFINITY, f32::NAN] {
        let expected = format!("radius over distance is {ratio}, allowed is 0 to 1");
        let rounded = DistantSphere::<f32>::from_ratio(ratio).unwrap_err().to_string();
        // The neighbour of 1 has more digits in f64.
        assert_eq!(rounded, expected.replace(&ratio.to_string(), &f64::from(ratio).to_string()));
        assert!(matches!(DistantSphere::<F32>::from_ratio(F32(ratio)), Err(LightError::Ratio(_))));
        assert!(matches!(DistantSphere::<f64>::from_ratio(ratio.into()), Err(LightError::Ratio(_))));
    }
    for ratio in [f16::NEG_ONE, f16::from_f32(1.001), f16::INFINITY, f16::NAN] {
        assert!(matches!(DistantSphere::<f16>::from_ratio(ratio), Err(LightError::Ratio(_))));
    }
}

#[test]
fn ratio_in_q30_is_0_to_1() {
    for bits in [-1, i32::MIN, (1 << 30) + 1, i32::MAX] {
        let ratio = I2F30::from_bits(bits);
        let error = DistantSphere::<I2F30>::from_ratio_q30(ratio).unwrap_err();
        assert_eq!(error, LightError::RatioQ30(bits));
        assert_eq!(DistantSphere::<I2F14>::from_ratio_q30(ratio).unwrap_err(), error);
        assert_eq!(DistantSphere::<I16F16>::from_ratio_q30(ratio).unwrap_err(), error);
        assert_eq!(error.to_string(), format!("radius over distance is {bits} in Q30, allowed is 0 to 1073741824"));
    }
}

/// By what the squared sine's root is scaled.
fn scale<T: Real>() -> Big {
    big(if T::NAME == "f16" { 64.0 } else { 1.0 })
}

/// The truth of the four constants: sine, its square in the format's scale, least cosine, versine.
fn constants_of<T: Real>(truth: &Truth, light: &DistantLight) -> [Big; 4] {
    // All directions are inside the whole sky, also those whose dot product is a rounding below -1.
    let full = light.cos() < 0.0 && light.sin() <= f64::EPSILON;
    let cos = if full { big(-2.0) } else { truth.cos.clone() };
    [truth.sin.clone(), square(&(&truth.sin * scale::<T>())), cos, truth.versine.clone()]
}

fn wide<T: Real>(sphere: &DistantSphere<T>) -> [T::Wide; 4] {
    [sphere.sin(), sphere.sin_square(), sphere.cos(), sphere.versine()]
}

/// Worst error over all lights of the constants in a float format, in units of its last place.
fn worst_float<T: Float + Real<Wide = T>>(new: impl Fn(&DistantLight) -> DistantSphere<T>) -> f64 {
    worst(lights().flat_map(|(light, truth)| {
        let truths = constants_of::<T>(&truth, &light);
        let computed = wide(&new(&light));
        [0, 1, 2, 3].map(|i| ulps(computed[i], &truths[i]))
    }))
}

/// The same in fixed point, where `slack` units in the last place of f64, which the light is held in, do not count.
fn worst_fixed<T: Real>(new: impl Fn(&DistantLight) -> DistantSphere<T>, fraction: u32, slack: f64) -> f64
where
    i128: From<T::Wide>,
{
    worst(lights().flat_map(|(light, truth)| {
        let truths = constants_of::<T>(&truth, &light);
        let computed = wide(&new(&light)).map(i128::from);
        [0, 1, 2, 3].map(|i| {
            let error = distance(&fixed(computed[i], fraction), &truths[i], -(fraction as i32));
            let place = last_place::<f64>(&truths[i]) + fraction as i32;
            error - slack * 2.0_f64.powi(place)
        })
    }))
}

#[test]
fn constants_in_f64() {
    assert_tight("f64, ULP", worst_float(DistantSphere::<f64>::new), 4.0);
}

#[test]
fn constants_in_f32_are_correctly_rounded() {
    assert_tight("f32, ULP", worst_float(DistantSphere::<f32>::new), 0.5);
}

#[test]
fn constants_in_micromath_are_correctly_rounded() {
    assert_tight("micromath, ULP", worst_float(DistantSphere::<F32>::new), 0.5);
}

#[test]
fn constants_in_f16_are_correctly_rounded() {
    assert_tight("f16, ULP", worst_float(DistantSphere::<f16>::new), 0.5);
}

#[test]
fn constants_in_i2f14_are_correctly_rounded() {
    assert_tight("I2F14, LSB", worst_fixed(DistantSphere::<I2F14>::new, 28, 0.0), 0.5);
}

#[test]
fn constants_in_i16f16_are_correctly_rounded() {
    assert_tight("I16F16, LSB", worst_fixed(DistantSphere::<I16F16>::new, 32, 0.0), 0.5);
}

#[test]
fn constants_in_i2f30_have_all_that_f64_has() {
    let worst = worst_fixed(DistantSphere::<I2F30>::new, 60, 4.0);
    assert_tight("I2F30, LSB beyond 4 ULP of f64", worst, 0.5);
}

/// The same light by the trait and by the function that works in constants.
fn assert_same<T: Real + PartialEq>(new: impl Fn(&DistantLight) -> DistantSphere<T>)
where
    T::Wide: PartialEq,
{
    for (light, _) in lights() {
        assert_eq!(new(&light), DistantSphere::of(&light), "{light:?}");
    }
}

#[test]
fn constants_are_the_same_in_generic_code() {
    assert_same(DistantSphere::<f64>::new);
    assert_same(DistantSphere::<f32>::new);
    assert_same(DistantSphere::<F32>::new);
    assert_same(DistantSphere::<f16>::new);
    assert_same(DistantSphere::<I2F14>::new);
    assert_same(DistantSphere::<I2F30>::new);
    assert_same(DistantSphere::<I16F16>::new);
}

const IN_F64: DistantSphere<f64> = DistantSphere::<f64>::new(&SUN);
const IN_F32: DistantSphere<f32> = DistantSphere::<f32>::new(&SUN);
const IN_MICROMATH: DistantSphere<F32> = DistantSphere::<F32>::new(&SUN);
const IN_F16: DistantSphere<f16> = DistantSphere::<f16>::new(&SUN);
const IN_I2F14: DistantSphere<I2F14> = DistantSphere::<I2F14>::new(&SUN);
const IN_I2F30: DistantSphere<I2F30> = DistantSphere::<I2F30>::new(&SUN);
const IN_I16F16: DistantSphere<I16F16> = DistantSphere::<I16F16>::new(&SUN);

#[test]
fn constants_are_the_same_at_compile_time() {
    assert_eq!(IN_F64, DistantSphere::of(&SUN));
    assert_eq!(IN_F32, DistantSphere::of(&SUN));
    assert_eq!(IN_MICROMATH, DistantSphere::of(&SUN));
    assert_eq!(IN_F16, DistantSphere::of(&SUN));
    assert_eq!(IN_I2F14, DistantSphere::of(&SUN));
    assert_eq!(IN_I2F30, DistantSphere::of(&SUN));
    assert_eq!(IN_I16F16, DistantSphere::of(&SUN));
}

/// Worst error of the constants that are computed in the format itself, from the ratio as the format has it.
fn worst_in_format<T: Float + Real<Wide = T>>(ratios: impl Iterator<Item = T>) -> f64 {
    worst(ratios.flat_map(|ratio| {
        let truth = Truth::of_ratio(big(ratio.exact()));
        let truths = [truth.sin.clone(), square(&(&truth.sin * scale::<T>())), truth.cos, truth.versine];
        let computed = wide(&DistantSphere::<T>::from_ratio(ratio).unwrap());
        [0, 1, 2, 3].map(|i| ulps(computed[i], &truths[i]))
    }))
}

#[test]
fn constants_computed_in_f64() {
    assert_tight("from_ratio in f64, ULP", worst_in_format(ratios()), 0.51);
}

#[test]
fn constants_computed_in_f32() {
    assert_tight("from_ratio in f32, ULP", worst_in_format(ratios().map(f32::nearest)), 0.51);
}

#[test]
fn constants_computed_in_micromath() {
    assert_tight("from_ratio in micromath, ULP", worst_in_format(ratios().map(F32::nearest)), 0.51);
}

/// Every f16 from 0 to 1.
#[test]
fn constants_computed_in_f16() {
    let ratios = (0..=f16::ONE.to_bits()).map(f16::from_bits);
    assert_tight("from_ratio in f16, ULP", worst_in_format(ratios), 0.8);
}

/// Worst error of the constants that are computed in integers, in units of their last place.
fn worst_q30<T: Real>(from_ratio: impl Fn(I2F30) -> Result<DistantSphere<T>, LightError>, fraction: u32) -> f64
where
    i128: From<T::Wide>,
{
    worst(exact::ratios_q30(1000).flat_map(|bits| {
        let truth = Truth::of_ratio(fixed(bits.into(), 30));
        let truths = [truth.sin.clone(), square(&truth.sin), truth.cos, truth.versine];
        let computed = wide(&from_ratio(I2F30::from_bits(bits)).unwrap()).map(i128::from);
        [0, 1, 2, 3].map(|i| exact::lsbs(computed[i], fraction, &truths[i]))
    }))
}

#[test]
fn constants_computed_in_integers() {
    let worst = [
        worst_q30(DistantSphere::<I2F14>::from_ratio_q30, 28),
        worst_q30(DistantSphere::<I2F30>::from_ratio_q30, 60),
        worst_q30(DistantSphere::<I16F16>::from_ratio_q30, 32),
    ];
    assert_tight("from_ratio_q30 of I2F14, LSB", worst[0], 1.0);
    assert_tight("from_ratio_q30 of I2F30, LSB", worst[1], 1.0);
    assert_tight("from_ratio_q30 of I16F16, LSB", worst[2], 1.0);
}

#[test]
fn constants_computed_in_integers_at_the_ends() {
    let of = |bits| wide(&DistantSphere::<I2F30>::from_ratio_q30(I2F30::from_bits(bits)).unwrap());
    assert_eq!(of(0), [0, 0, 1 << 60, 0]);
    assert_eq!(of(1 << 30), [1 << 60, 1 << 60, 0, 1 << 60]);
    // Half of 2^-60 is up.
    assert_eq!(of(1), [1 << 30, 1, (1 << 60) - 1, 1]);
}
