//! Light normalisation in every format against 192 bits, and the known ways to get it wrong.

mod exact;

use std::f64::consts::PI;

use ::fixed::types::{I2F30, I16F16, U16F48, U20F12, U52F12};
use exact::{Big, assert_tight, big, fixed, lsbs, pi, ratios_q30, spread, square, ulps, versine, worse, worst};
use half::f16;
use micromath::F32;
use oorandom::Rand64;
use sunglint::normalization::{
    inverse_size_factor, inverse_size_factor_q30, radiance, radiance_q12, size_factor, size_factor_q30, solid_angle,
    solid_angle_q30, sun_radius_at, sun_radius_at_q16, versine as versine_of, versine_q30, white_radiance,
    white_radiance_q30,
};
use sunglint::{DistantLight, Float, LightError, SUN, Scalar};

/// Half of the ratios per format.
const COUNT: u32 = 1000;

/// A quantity of a ratio, as a format has it and as it is; the bound in units in the last place.
struct Quantity<T> {
    name: &'static str,
    computed: fn(T) -> Result<T, LightError>,
    truth: fn(&Big) -> Big,
    bound: f64,
}

fn projected(ratio: &Big) -> Big {
    pi() * square(ratio)
}

fn reciprocal(value: Big) -> Big {
    big(1.0) / value
}

fn sun_ratio() -> Big {
    big(6_957_000.0) / big(1_495_978_707.0)
}

/// Computed with twice the format's digits, so that they have one bound.
fn quantities<T: Float>(bound: f64) -> [Quantity<T>; 6] {
    let quantity = |name, computed, truth, bound| Quantity { name, computed, truth, bound };
    [
        quantity("versine", versine_of, versine, bound),
        quantity("solid_angle", solid_angle, |x| big(2.0) * pi() * versine(x), bound),
        quantity("size_factor", size_factor, projected, bound),
        quantity("inverse_size_factor", inverse_size_factor, |x| reciprocal(projected(x)), bound),
        quantity("white_radiance", white_radiance, |x| reciprocal(square(x)), bound),
        quantity("sun_radius_at", sun_radius_at, |x| x * sun_ratio(), bound),
    ]
}

fn ratios<T: Float>(count: u32) -> impl Iterator<Item = T> {
    spread(count, 1e-6, 1.0).map(T::nearest)
}

/// Holds the quantities to their bounds, and gives for each the greatest ratio that has overflowed.
fn check<T: Float>(ratios: impl Iterator<Item = T> + Clone, bound: f64) -> [f64; 6] {
    let mut overflowed = [0.0; 6];
    for (quantity, overflowed) in quantities::<T>(bound).iter().zip(&mut overflowed) {
        let errors = ratios.clone().map(|ratio| match (quantity.computed)(ratio) {
            Ok(computed) => ulps(computed, &(quantity.truth)(&big(ratio.exact()))),
            Err(LightError::Overflow(format)) if format == T::FORMAT => {
                *overflowed = ratio.exact().max(*overflowed);
                0.0
            }
            Err(error) => panic!("{}: {error}", quantity.name),
        });
        assert_tight(&format!("{} in {}, ULP", quantity.name, T::FORMAT), worst(errors), quantity.bound);
    }
    overflowed
}

/// Holds radiance to its bound for intensities of 0.001 to 60 000.
fn check_radiance<T: Float>(ratios: impl Iterator<Item = T>, bound: f64) {
    check_radiance_of([0.001, 60_000.0], ratios, bound);
}

fn check_radiance_of<T: Float>([least, most]: [f64; 2], ratios: impl Iterator<Item = T>, bound: f64) {
    let mut source = Rand64::new(5);
    let errors = ratios.map(|ratio| {
        let intensity = T::nearest(least * (most / least).powf(source.rand_float()));
        let truth = big(intensity.exact()) / projected(&big(ratio.exact()));
        match radiance(intensity, ratio) {
            Ok(computed) => ulps(computed, &truth),
            Err(error) => {
                assert_eq!(error, LightError::Overflow(T::FORMAT));
                assert!(truth > big(T::MAX.exact()), "{ratio:?} {intensity:?}");
                0.0
            }
        }
    });
    assert_tight(&format!("radiance in {}, ULP", T::FORMAT), worst(errors), bound);
}

#[test]
fn quantities_in_f64() {
    let ratios: Vec<f64> = ratios(COUNT).collect();
    assert_eq!(check(ratios.iter().copied(), 0.51), [0.0; 6]);
    check_radiance(ratios.into_iter(), 0.51);
}

#[test]
fn quantities_in_f32() {
    let ratios: Vec<f32> = ratios(COUNT).collect();
    assert_eq!(check(ratios.iter().copied(), 0.51), [0.0; 6]);
    check_radiance(ratios.into_iter(), 0.51);
}

#[test]
fn quantities_in_micromath() {
    let ratios: Vec<F32> = ratios(COUNT).collect();
    assert_eq!(check(ratios.iter().copied(), 0.51), [0.0; 6]);
    check_radiance(ratios.into_iter(), 0.51);
}

/// Every f16 above 0 and up to 1.
#[test]
fn quantities_in_f16() {
    let ratios: Vec<f16> = (1..=f16::ONE.to_bits()).map(f16::from_bits).collect();
    let overflowed = check(ratios.iter().copied(), 0.8);
    // 1 / (pi x^2) and 1 / x^2 reach 65 520, from where f16 rounds to infinity.
    assert_eq!(overflowed, [0.0, 0.0, 0.0, 0.002_202_987_670_898_437_5, 1.0 / 256.0, 0.0]);
    // Below, the square of the ratio has few digits to spare.
    check_radiance(ratios.into_iter().filter(|ratio| ratio.to_f64() >= 1.0 / 2048.0), 0.8);
}

/// Intensities and ratios of which the quotient is out of the range in which it keeps its digits, though the answer is
/// not.
#[test]
fn radiance_of_the_faintest_and_the_farthest() {
    let far = || spread(COUNT, 1e-27, 1e-9);
    check_radiance_of([1e-38, 1e-20], far().map(f32::nearest), 0.51);
    check_radiance_of([1e-38, 1e-20], far().map(F32::nearest), 0.51);
    check_radiance_of([1e-307, 1e-200], spread(COUNT, 1e-150, 1e-30), 0.51);
}

/// Zero, and what is refused.
fn check_ends<T: Float + PartialEq>() {
    let [zero, one, infinity] = [0.0, 1.0, f64::INFINITY].map(T::nearest);
    assert_eq!([versine_of(zero), solid_angle(zero)], [Ok(zero); 2]);
    assert_eq!([size_factor(zero), inverse_size_factor(zero), radiance(one, zero)], [Ok(one); 3]);
    assert_eq!(white_radiance(zero), Err(LightError::Overflow(T::FORMAT)));
    for ratio in [-1.0, 1.125, f64::INFINITY, f64::NAN].map(T::nearest) {
        let functions =
            [versine_of, solid_angle, size_factor, inverse_size_factor, white_radiance, |x| radiance(T::ONE, x)];
        for answer in functions.map(|function| function(ratio)) {
            assert!(matches!(answer, Err(LightError::Ratio(_))), "{ratio:?} {answer:?}");
        }
    }
    for intensity in [-1.0, f64::INFINITY, f64::NAN].map(T::nearest) {
        assert!(matches!(radiance(intensity, one), Err(LightError::Intensity(_))));
    }
    assert!(radiance(T::MAX, one).is_ok_and(|radiance| radiance.exact() > T::MAX.exact() / 3.2));
    for distance in [-1.0, 0.0, f64::NAN].map(T::nearest).into_iter().chain([infinity]) {
        assert!(matches!(sun_radius_at(distance), Err(LightError::Distance(_))));
    }
}

#[test]
fn ends_and_errors_in_float_formats() {
    check_ends::<f64>();
    check_ends::<f32>();
    check_ends::<F32>();
    check_ends::<f16>();
}

/// Worst error in units of the last place over ratios in Q30.
fn worst_q30(
    ratios: impl Iterator<Item = i32>,
    fraction: u32,
    computed: impl Fn(I2F30) -> u64,
    truth: impl Fn(&Big) -> Big,
) -> f64 {
    worst(ratios.map(|bits| {
        let computed = computed(I2F30::from_bits(bits));
        lsbs(computed.into(), fraction, &truth(&fixed(bits.into(), 30)))
    }))
}

#[test]
fn quantities_in_integers() {
    let versines = worst_q30(ratios_q30(COUNT), 48, |x| versine_q30(x).unwrap().to_bits(), versine);
    assert_tight("versine_q30, LSB", versines, 0.51);
    let angles =
        worst_q30(ratios_q30(COUNT), 48, |x| solid_angle_q30(x).unwrap().to_bits(), |x| big(2.0) * pi() * versine(x));
    assert_tight("solid_angle_q30, LSB", angles, 0.51);
    let positive = || ratios_q30(COUNT).filter(|&bits| bits > 0);
    let factors = worst_q30(positive(), 48, |x| size_factor_q30(x).unwrap().to_bits(), projected);
    assert_tight("size_factor_q30, LSB", factors, 0.51);
    // The least ratios have answers of 2^52 and more.
    let held = || ratios_q30(COUNT).filter(|&bits| bits > 16);
    let inverses =
        worst_q30(held(), 12, |x| inverse_size_factor_q30(x).unwrap().to_bits(), |x| reciprocal(projected(x)));
    assert_tight("inverse_size_factor_q30, LSB", inverses, 0.51);
    let whites = worst_q30(held(), 12, |x| white_radiance_q30(x).unwrap().to_bits(), |x| reciprocal(square(x)));
    assert_tight("white_radiance_q30, LSB", whites, 0.51);
}

#[test]
fn ends_and_errors_in_integers() {
    let [zero, least, one] = [0, 1, 1 << 30].map(I2F30::from_bits);
    assert_eq!([versine_q30(zero), solid_angle_q30(zero)], [Ok(U16F48::ZERO); 2]);
    assert_eq!([size_factor_q30(zero), versine_q30(one)], [Ok(U16F48::ONE); 2]);
    assert_eq!([inverse_size_factor_q30(zero), white_radiance_q30(one)], [Ok(U52F12::ONE); 2]);
    let overflow = LightError::Overflow("U52F12");
    assert_eq!([zero, least].map(white_radiance_q30), [Err(overflow); 2]);
    for bits in [-1, i32::MIN, (1 << 30) + 1, i32::MAX] {
        let (ratio, error) = (I2F30::from_bits(bits), LightError::RatioQ30(bits));
        assert_eq!([versine_q30, solid_angle_q30, size_factor_q30].map(|function| function(ratio)), [Err(error); 3]);
        assert_eq!([inverse_size_factor_q30, white_radiance_q30].map(|function| function(ratio)), [Err(error); 2]);
    }
}

/// Where 64 bits end: the first ratio that is held is the one above the last that is not.
#[test]
fn reciprocals_in_integers_overflow_where_the_docs_say() {
    let first = |function: fn(I2F30) -> Result<U52F12, LightError>| {
        (1..).find(|&bits| function(I2F30::from_bits(bits)).is_ok()).unwrap()
    };
    println!("inverse from {} raw, white from {} raw", first(inverse_size_factor_q30), first(white_radiance_q30));
    assert_eq!([inverse_size_factor_q30, white_radiance_q30].map(first), [10, 17]);
}

#[test]
fn radiance_in_integers() {
    let mut source = Rand64::new(6);
    let errors = ratios_q30(COUNT).map(|bits| {
        let intensity = source.rand_u64() as u32 >> (source.rand_u64() % 24);
        // Zero stands for the point, whose sizeFactor is 1.
        let divisor = size_factor_q30(I2F30::from_bits(bits)).unwrap().to_bits().max(1);
        match radiance_q12(U20F12::from_bits(intensity), U16F48::from_bits(divisor)) {
            Ok(computed) => {
                lsbs(computed.to_bits().into(), 12, &(fixed(intensity.into(), 12) / fixed(divisor.into(), 48)))
            }
            Err(error) => {
                assert_eq!(error, LightError::Overflow("U52F12"));
                assert!(u128::from(intensity) << 48 >= u128::from(divisor) << 63);
                0.0
            }
        }
    });
    assert_tight("radiance_q12, LSB", worst(errors), 0.51);
    assert_eq!(radiance_q12(U20F12::ONE, U16F48::ZERO), Err(LightError::Overflow("U52F12")));
}

#[test]
fn sun_radius_in_integers() {
    let distances = spread(COUNT, 1.0, f64::from(i32::MAX)).map(|bits| bits as i32).chain([1, i32::MAX]);
    let errors = distances.map(|bits| {
        let computed = sun_radius_at_q16(I16F16::from_bits(bits)).unwrap();
        lsbs(computed.to_bits().into(), 16, &(fixed(bits.into(), 16) * sun_ratio()))
    });
    assert_tight("sun_radius_at_q16, LSB", worst(errors), 0.51);
    for bits in [0, -1, i32::MIN] {
        assert_eq!(sun_radius_at_q16(I16F16::from_bits(bits)), Err(LightError::DistanceBits(bits)));
    }
}

/// UsdLux angles in degrees of all three branches, with the neighbours of the switch at 180.
fn angles() -> impl Iterator<Item = f64> {
    let switch = [180.0_f64.next_down(), 180.0, 180.0_f64.next_up()];
    spread(COUNT, 1e-4, 360.0).chain(switch).chain([0.0, 0.53, 270.0, 359.99])
}

/// sizeFactor and solid angle of a UsdLux angle.
fn truth_of_angle(angle: f64) -> [Big; 2] {
    let (sine, half) = (big(angle).sin_unit(720), big(angle).sin_unit(1440));
    let factor = match angle {
        0.0 => big(1.0),
        small if small <= 180.0 => projected(&sine),
        _ => pi() * (big(2.0) - square(&sine)),
    };
    [factor, big(4.0) * pi() * square(&half)]
}

#[test]
fn light_in_f64_and_64_bits() {
    let mut errors = [0.0_f64; 5];
    for angle in angles() {
        let light = DistantLight::from_angle(angle).unwrap();
        let [factor, solid] = truth_of_angle(angle);
        let inverse = light.inverse_size_factor_q12().unwrap();
        let all = [
            ulps(light.size_factor(), &factor),
            ulps(light.solid_angle(), &solid),
            lsbs(light.size_factor_q48().to_bits().into(), 48, &factor),
            lsbs(light.solid_angle_q48().to_bits().into(), 48, &solid),
            lsbs(inverse.to_bits().into(), 12, &reciprocal(factor)),
        ];
        errors = [0, 1, 2, 3, 4].map(|i| worse(errors[i], all[i]));
    }
    assert_tight("DistantLight::size_factor, ULP", errors[0], 6.0);
    assert_tight("DistantLight::solid_angle, ULP", errors[1], 6.0);
    assert_tight("size_factor_q48, LSB", errors[2], 1.0);
    assert_tight("solid_angle_q48, LSB", errors[3], 1.0);
    assert_tight("inverse_size_factor_q12, LSB", errors[4], 2.0);
    // On either side of 2^51.
    let inverse = |ratio: f64| DistantLight::from_ratio(ratio).unwrap().inverse_size_factor_q12();
    assert!(inverse(1.2e-8).is_ok());
    assert_eq!(inverse(1.18e-8), Err(LightError::Overflow("U52F12")));
}

#[test]
fn size_factor_goes_on_at_180_degrees_and_jumps_at_0() {
    let of = |angle: f64| DistantLight::from_angle(angle).unwrap().size_factor();
    assert_eq!([180.0_f64.next_down(), 180.0, 180.0_f64.next_up()].map(of), [PI; 3]);
    assert_eq!([0.0, 360.0].map(of), [1.0, 2.0 * PI]);
    // A point is not the limit of small discs. The square of the last two is below f64's least number.
    assert_eq!([1e-160, 1e-170, 5e-324].map(|x| DistantLight::from_ratio(x).unwrap().size_factor())[1..], [0.0; 2]);
    assert_eq!(DistantLight::from_ratio(1e-170).unwrap().radiance(1.0), Err(LightError::Overflow("f64")));
    assert_eq!(DistantLight::from_ratio(0.0).unwrap().radiance(1.0), Ok(1.0));
}

#[test]
fn radiance_of_a_light_refuses_what_is_no_intensity() {
    for intensity in [-1.0, f64::INFINITY, f64::NAN] {
        let error = SUN.radiance(intensity).unwrap_err();
        assert!(matches!(error, LightError::Intensity(_)));
        assert_eq!(error.to_string(), format!("intensity is {intensity}, allowed is any finite number from 0"));
    }
    assert_eq!(SUN.radiance(f64::MAX), Err(LightError::Overflow("f64")));
    // The greatest of a point, and nothing of any: also where sizeFactor has underflowed.
    assert_eq!(DistantLight::from_ratio(0.0).unwrap().radiance(f64::MAX), Ok(f64::MAX));
    assert_eq!([0.0, 1e-170, 1.0].map(|ratio| DistantLight::from_ratio(ratio).unwrap().radiance(0.0)), [Ok(0.0); 3]);
    assert_eq!(DistantLight::from_ratio(0.0).unwrap().white_radiance(), Err(LightError::Overflow("f64")));
    let white = SUN.white_radiance().unwrap();
    assert!(ulps(white, &reciprocal(square(&sun_ratio()))) <= 3.0, "{white}");
}

/// Neighbouring ratios in f32, 2000 about each of many places.
fn neighbours() -> impl Iterator<Item = [f32; 2]> {
    let places = [1e-6, 1e-4, 1.7e-4, 3e-4, 1e-3, 0.00465, 0.05, 0.3, 0.5, 0.7, 0.714, 0.9, 0.999].map(f32::to_bits);
    let near_one = 1.0_f32.to_bits() - 2001;
    places
        .into_iter()
        .chain([near_one])
        .flat_map(|place| (place..place + 2000).map(|bits| [bits, bits + 1].map(f32::from_bits)))
}

#[test]
fn quantities_have_no_step_in_f32() {
    for [a, b] in neighbours() {
        assert!(versine_of(a).unwrap() <= versine_of(b).unwrap(), "{a}");
        assert!(solid_angle(a).unwrap() <= solid_angle(b).unwrap(), "{a}");
        assert!(size_factor(a).unwrap() <= size_factor(b).unwrap(), "{a}");
        assert!(inverse_size_factor(a).unwrap() >= inverse_size_factor(b).unwrap(), "{a}");
        assert!(white_radiance(a).unwrap() >= white_radiance(b).unwrap(), "{a}");
    }
}

#[test]
fn quantities_have_no_step_in_integers() {
    let places = [1074, 1 << 14, 1 << 20, 4_993_401, 1 << 29, (1 << 30) - 2000];
    for bits in places.into_iter().flat_map(|place| place..place + 2000) {
        let [a, b] = [bits, bits + 1].map(I2F30::from_bits);
        for function in [versine_q30, solid_angle_q30, size_factor_q30] {
            assert!(function(a).unwrap() <= function(b).unwrap(), "{bits}");
        }
        for function in [inverse_size_factor_q30, white_radiance_q30] {
            assert!(function(a).unwrap() >= function(b).unwrap(), "{bits}");
        }
    }
}

#[test]
fn versine_by_subtraction_loses_digits_and_then_all_in_f32() {
    let subtracted = |x: f32| 1.0 - (1.0 - x * x).sqrt();
    let figures = [1e-3, 3e-4, 1.7e-4].map(subtracted);
    println!("1 - sqrt(1 - x^2): {figures:?}, in place of {:?}", [1e-3, 3e-4, 1.7e-4].map(versine_of::<f32>));
    assert_eq!(figures.map(|w| format!("{w:.2e}")), ["5.36e-7", "5.96e-8", "0.00e0"]);
    assert_eq!(format!("{:.2e}", versine_of(1e-3_f32).unwrap()), "5.00e-7");
}

/// What hardware that flushes subnormals makes of an f16.
fn flushed(value: f16) -> f16 {
    if value.is_normal() { value } else { f16::ZERO }
}

#[test]
fn square_of_the_sun_is_lost_where_f16_flushes() {
    let [pi, x] = [PI, SUN.sin()].map(f16::nearest);
    let square = x * x;
    let (lost, kept) = (flushed(pi * flushed(square)), flushed(flushed(pi * x) * x));
    println!("x^2 {square:e}, pi (x x) {lost:e}, (pi x) x {kept:e}");
    assert!(!square.is_normal());
    assert_eq!(lost, f16::ZERO);
    assert!((size_factor(x).unwrap().to_f64() / SUN.size_factor() - 1.0).abs() < 1e-3);
    assert!((kept.to_f64() / SUN.size_factor() - 1.0).abs() < 1e-3);
}

#[test]
fn white_radiance_of_the_sun_fits_f16_on_earth_and_not_on_mars() {
    let earth = SUN.white_radiance().unwrap();
    let mars = SUN.sin() / 1.523_71;
    println!("(d/R)^2 {earth} on Earth, {} on Mars", 1.0 / (mars * mars));
    assert_eq!(earth.round(), 46_239.0);
    assert!(white_radiance(f16::nearest(SUN.sin())).is_ok());
    assert_eq!(white_radiance(f16::nearest(mars)), Err(LightError::Overflow("f16")));
}

#[test]
fn reciprocal_of_the_suns_size_factor_fits_f16_and_its_radiance_does_not() {
    let inverse = inverse_size_factor(f16::nearest(SUN.sin())).unwrap();
    let radiance = SUN.radiance(1.28e5).unwrap();
    println!("1 / sizeFactor {inverse}, {} exactly; 1.28e5 lx are {radiance:e} cd/m2", 1.0 / SUN.size_factor());
    assert_eq!(format!("{:.1e}", inverse.to_f64()), "1.5e4");
    assert_eq!(format!("{radiance:.2e}"), "1.88e9");
    assert!(f16::nearest(radiance).is_infinite());
}
