//! How lights are described: ranges and errors, the Sun's figures, and their constants in every format.

mod exact;

use std::f64::consts::PI;

use ::fixed::types::{I2F14, I2F30, I16F16};
use exact::{Big, assert_tight, big, cosine, distance, fixed, last_place, spread, square, ulps, versine, worst};
use half::f16;
use micromath::F32;
use sunglint::{DistantLight, DistantSphere, Float, LightError, Real, SUN};

/// What the sine, cosine and versine of an angular radius are.
struct Truth {
    sin: Big,
    cos: Big,
    versine: Big,
}

impl Truth {
    fn of_ratio(ratio: Big) -> Self {
        Self { cos: cosine(&ratio), versine: versine(&ratio), sin: ratio }
    }

    fn of_angle(theta: &Big) -> Self {
        let (sin, cos) = theta.sin_cos();
        let half = (theta / big(2.0)).sin();
        Self { sin, cos, versine: big(2.0) * square(&half) }
    }

    /// In units of a turn, so that the zeros at 180 and 360 degrees are zeros.
    fn of_degrees(angle: f64) -> Self {
        let (sin, cos) = big(angle).sin_cos_unit(720);
        let half = big(angle).sin_unit(1440);
        Self { sin, cos, versine: big(2.0) * square(&half) }
    }
}

fn ratios() -> impl Iterator<Item = f64> {
    spread(1000, 1e-6, 1.0).chain([0.0, 1e-12, 1.0_f64.next_down()])
}

fn angles() -> impl Iterator<Item = f64> {
    let neighbours = [90.0_f64, 180.0, 270.0, 360.0].into_iter().flat_map(|angle| [angle.next_down(), angle]);
    let named = [0.0, 1e-6, 0.53, 179.999, 180.0_f64.next_up(), 180.001, 359.99];
    spread(1000, 1e-6, 360.0).chain(neighbours).chain(named)
}

fn angular_radii() -> impl Iterator<Item = f64> {
    let quarter = PI / 2.0;
    spread(1000, 1e-6, PI).chain([0.0, quarter.next_down(), quarter, quarter.next_up(), PI.next_down()])
}

fn by_ratio() -> impl Iterator<Item = (DistantLight, Truth)> {
    ratios().map(|ratio| (DistantLight::from_ratio(ratio).unwrap(), Truth::of_ratio(big(ratio))))
}

fn by_distance() -> impl Iterator<Item = (DistantLight, Truth)> {
    ratios().map(|ratio| {
        let (radius, distance) = (ratio * 149_597_870.7, 149_597_870.7);
        let light = DistantLight::from_radius_and_distance(radius, distance).unwrap();
        (light, Truth::of_ratio(big(radius) / big(distance)))
    })
}

fn by_angular_radius() -> impl Iterator<Item = (DistantLight, Truth)> {
    angular_radii().map(|theta| (DistantLight::from_angular_radius(theta).unwrap(), Truth::of_angle(&big(theta))))
}

fn by_angle() -> impl Iterator<Item = (DistantLight, Truth)> {
    angles().map(|angle| (DistantLight::from_angle(angle).unwrap(), Truth::of_degrees(angle)))
}

fn lights() -> impl Iterator<Item = (DistantLight, Truth)> {
    by_ratio().chain(by_distance()).chain(by_angular_radius()).chain(by_angle())
}

#[test]
fn ratio_is_0_to_1() {
    for ratio in [0.0, -0.0, 5e-324, 1.0] {
        assert!(DistantLight::from_ratio(ratio).is_ok(), "{ratio}");
    }
    for ratio in [-1.0, -5e-324, 1.0_f64.next_up(), 2.0, f64::INFINITY, f64::NAN] {
        let error = DistantLight::from_ratio(ratio).unwrap_err();
        assert!(matches!(error, LightError::Ratio(value) if value.to_bits() == ratio.to_bits()));
        assert_eq!(error.to_string(), format!("radius over distance is {ratio}, allowed is 0 to 1"));
    }
}

#[test]
fn radius_is_0_to_the_distance() {
    for (radius, distance) in [(0.0, 1.0), (3.0, 3.0), (695_700.0, 149_597_870.7), (1e-320, 1e-310)] {
        assert!(DistantLight::from_radius_and_distance(radius, distance).is_ok(), "{radius} {distance}");
    }
    for radius in [-1.0, 3.0_f64.next_up(), f64::INFINITY, f64::NAN] {
        let error = DistantLight::from_radius_and_distance(radius, 3.0).unwrap_err();
        assert!(matches!(error, LightError::Radius { distance: 3.0, .. }));
        assert_eq!(error.to_string(), format!("radius is {radius}, allowed is 0 to the distance 3"));
    }
    for distance in [0.0, -2.0, f64::INFINITY, f64::NAN] {
        let error = DistantLight::from_radius_and_distance(1.0, distance).unwrap_err();
        assert!(matches!(error, LightError::Distance(_)));
        assert_eq!(error.to_string(), format!("distance is {distance}, allowed is any positive finite number"));
    }
}

#[test]
fn angular_radius_is_0_to_pi() {
    for theta in [0.0, 5e-324, PI] {
        assert!(DistantLight::from_angular_radius(theta).is_ok(), "{theta}");
    }
    for theta in [-1.0, PI.next_up(), f64::INFINITY, f64::NAN] {
        let error = DistantLight::from_angular_radius(theta).unwrap_err();
        assert!(matches!(error, LightError::AngularRadius(_)));
        assert_eq!(error.to_string(), format!("angular radius is {theta} radians, allowed is 0 to pi"));
    }
}

#[test]
fn angle_is_0_to_360_degrees() {
    for angle in [0.0, 5e-324, 180.0, 360.0] {
        assert!(DistantLight::from_angle(angle).is_ok(), "{angle}");
    }
    for angle in [-1.0, 360.0_f64.next_up(), 400.0, f64::INFINITY, f64::NAN] {
        let error = DistantLight::from_angle(angle).unwrap_err();
        assert!(matches!(error, LightError::Angle(_)));
        assert_eq!(error.to_string(), format!("angle is {angle} degrees, allowed is 0 to 360"));
    }
}

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

/// Digits of `numerator / denominator` after the point, cut off.
fn digits(numerator: u128, denominator: u128, count: u32) -> u128 {
    numerator * 10_u128.pow(count) / denominator
}

#[test]
fn figures_of_the_sun() {
    let truth = Truth::of_ratio(big(6_957_000.0) / big(1_495_978_707.0));
    assert_eq!(digits(6_957_000, 1_495_978_707, 14), 465_046_726_096);
    assert!(ulps(SUN.sin(), &truth.sin) <= 1.0);
    assert_eq!(format!("{:.10}", SUN.sin()), "0.0046504673");
    let diameter = (2.0 * SUN.angular_radius()).to_degrees();
    println!("the Sun is {diameter} degrees wide");
    assert_eq!(format!("{diameter:.4}"), "0.5329");
}

/// Renderers take 695 700 km over 149 597 870 km, shaders 695 800 over 149 600 000.
#[test]
fn rounded_figures_of_the_sun_differ_late_and_early() {
    let sun = digits(6_957_000, 1_495_978_707, 12);
    let [first, second] = [(695_700, 149_597_870), (695_800, 149_600_000)].map(|(r, d)| digits(r, d, 12));
    println!("Sun {sun}, rounded {first} and {second}");
    // In the ninth significant digit, and in the fourth.
    assert_eq!([sun, first, second], [4_650_467_260, 4_650_467_282, 4_651_069_518]);
}

/// Sine, cosine and versine of `light` in units of the last place of f64.
fn f64_errors((light, truth): (DistantLight, Truth)) -> [f64; 3] {
    [(light.sin(), &truth.sin), (light.cos(), &truth.cos), (light.versine(), &truth.versine)]
        .map(|(computed, truth)| ulps(computed, truth))
}

#[test]
fn light_in_f64_by_ratio() {
    assert_tight("from_ratio, ULP", worst(by_ratio().flat_map(f64_errors)), 2.0);
}

#[test]
fn light_in_f64_by_radius_and_distance() {
    assert_tight("from_radius_and_distance, ULP", worst(by_distance().flat_map(f64_errors)), 3.0);
}

#[test]
fn light_in_f64_by_angular_radius() {
    assert_tight("from_angular_radius, ULP", worst(by_angular_radius().flat_map(f64_errors)), 3.0);
}

#[test]
fn light_in_f64_by_angle() {
    assert_tight("from_angle, ULP", worst(by_angle().flat_map(f64_errors)), 4.0);
}

#[test]
fn whole_and_half_of_the_sky_are_exact() {
    let of = |angle| DistantLight::from_angle(angle).unwrap();
    let constants = |light: DistantLight| [light.sin(), light.cos(), light.versine()];
    assert_eq!(constants(of(0.0)), [0.0, 1.0, 0.0]);
    assert_eq!(constants(of(180.0))[..2], [1.0, 0.0]);
    assert_eq!(constants(of(360.0)), [0.0, -1.0, 2.0]);
    assert_eq!(constants(DistantLight::from_ratio(1.0).unwrap()), [1.0, 0.0, 1.0]);
}

/// By what the squared sine's root is scaled.
fn scale<T: Real>() -> Big {
    big(if T::NAME == "f16" { 64.0 } else { 1.0 })
}

/// The truth of the four constants: sine, its square in the format's scale, least cosine, versine.
fn constants_of<T: Real>(truth: &Truth, light: &DistantLight) -> [Big; 4] {
    // All directions are inside the whole sky, also those whose dot product is a rounding below -1.
    let cos = if light.versine() >= 2.0 { big(-2.0) } else { truth.cos.clone() };
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
