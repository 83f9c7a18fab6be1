//! Radiometry in every format against its definitions, and against the integrals that define the definitions.

mod exact;

use std::f64::consts::{FRAC_PI_2, PI};

use exact::{Big, assert_tight, big, pi, square, worse, worst};
use fixed::types::{I2F14, I2F30, I16F16};
use half::f16;
use micromath::F32;
use sunglint::oracle::radiometry::{self as truth, Parts};
use sunglint::radiometry::{
    Patch, RadiometryError, SphereLight, area_radiance, beam_power, diffuse_radiance, flux, irradiance,
    lambertian_radiance, non_directional_radiance, patch_solid_angle, point_intensity, projected_area, radiosity,
    sphere_radiance,
};
use sunglint::raw::{area_radiance_q16, diffuse_radiance_q16, irradiance_q16};
use sunglint::real::Scaled;
use sunglint::trial::lights::STUDY;
use sunglint::trial::radiometry::Formula;
use sunglint::trial::{Format, Found, Visitor};
use sunglint::{Real, SUN, Scalar, oracle};

struct Trial {
    formula: Formula,
    seed: u64,
    count: usize,
}

impl Visitor for Trial {
    type Output = Found;

    fn visit<T: Real>(self) -> Found {
        self.formula.error::<T>(self.seed, self.count)
    }
}

#[test]
fn every_formula_keeps_its_budget_in_every_format() {
    for formula in Formula::ALL {
        for format in Format::ALL {
            let found = format.visit(Trial { formula, seed: 1, count: 20_000 });
            assert!(found.samples > 5_000, "{} {}", formula.name(), found.samples);
            assert_tight(&format!("{} in {}", formula.name(), format.name()), found.max, formula.maximum(format));
        }
    }
}

/// Where the budgets come from.
#[test]
#[ignore = "ten seconds in release: cargo test --release --test radiometry -- --ignored --nocapture"]
fn budgets_are_a_little_more_than_the_worst_of_300_000_inputs() {
    let mut stale = 0;
    for formula in Formula::ALL {
        for format in Format::ALL {
            let maxima = [1, 2, 3].map(|seed| format.visit(Trial { formula, seed, count: 100_000 }).max);
            let suggested = 1.12 * worst(maxima.into_iter());
            let budget = formula.maximum(format);
            println!("{} in {}: {suggested:.3e}, is {budget:e}", formula.name(), format.name());
            // Two digits, rounded up.
            stale += u32::from(!(budget / 1.11..=budget).contains(&suggested));
        }
    }
    assert_eq!(stale, 0);
}

#[test]
fn the_oracle_has_twice_the_digits() {
    let mut source = oorandom::Rand64::new(4);
    let mut next = || 0.01 * 1e4_f64.powf(source.rand_float());
    let errors = (0..2000).map(|_| {
        let [a, b, c, d] = [0; 4].map(|_| next());
        let sum = square(&big(a)) + square(&big(b)) + square(&big(c));
        let exact = [
            (
                truth::quotient(&[[a, 0.0], [b, 0.0]], &[truth::PI, [c, 0.0], [d, 0.0]]),
                big(a) * big(b) / (pi() * big(c) * big(d)),
            ),
            (truth::quotient(&[truth::square([a, b, c])], &[[d, 0.0], [d, 0.0]]), sum / square(&big(d))),
        ];
        let error =
            |([high, low], exact): &(Parts, Big)| ((big(*high) + big(*low) - exact) / exact).to_f64().value().abs();
        worst(exact.iter().map(error))
    });
    assert_tight("oracle", worst(errors), 1e-31);
}

/// Radiance of a sphere, integrated over its surface and all directions, is its power.
#[test]
fn a_sphere_gives_off_its_power() {
    for (power, radius) in [(60.0, 0.03), (3.828e26, 6.957e8)] {
        let radiance = sphere_radiance(power, radius).unwrap();
        assert!((radiance * oracle::sphere_power(radius) / power - 1.0).abs() < 1e-12);
        assert_eq!(radiance, lambertian_radiance(power, 4.0 * PI * radius * radius).unwrap());
    }
}

/// What seems to be the same sphere lights with a quarter of the point's power where its radiance is spread over the
/// whole sphere of directions.
#[test]
fn a_sphere_far_away_is_a_point_if_it_is_lambertian() {
    let (power, radius, distance) = (60.0, 0.03, 50.0);
    let point = irradiance(point_intensity(power).unwrap(), 1.0, distance);
    // The integral of the cosine over the disc.
    let seen = oracle::illuminance(oracle::angular_radius(radius / distance));
    let lambertian = sphere_radiance(power, radius).unwrap() * seen;
    assert!((lambertian / point - 1.0).abs() < 1e-12, "{lambertian} {point}");
    let even = non_directional_radiance(power, 4.0 * PI * radius * radius).unwrap() * seen;
    assert!((even / point - 0.25).abs() < 1e-12, "{even} {point}");
}

/// Luminosity over the sphere at Earth's distance is the solar constant, within the figures' four digits.
#[test]
fn the_sun_by_its_power() {
    let sun = point_intensity(3.828e26).unwrap();
    assert_eq!(format!("{:.0}", irradiance(sun, 1.0, 149_597_870_700.0)), "1361");
    assert_eq!(format!("{:.3e}", sphere_radiance(3.828e26, 6.957e8).unwrap()), "2.003e7");
}

/// A white sky of radiance 1 lights with pi, and a white surface under it has radiance 1: with pi forgotten it glows.
#[test]
fn the_white_furnace_closes() {
    let sky = oracle::illuminance(FRAC_PI_2);
    assert!((sky - PI).abs() < 1e-12);
    fn check<S: Scalar>(sky: f64) {
        let radiance = diffuse_radiance(S::ONE, S::nearest(sky)).exact();
        let forgotten = radiosity(S::ONE, S::nearest(sky)).exact();
        // In f64 the sky's own sum is 3.4e-14 off.
        assert!((radiance - 1.0).abs() < 4e-14 && forgotten > 3.1, "{radiance} {forgotten}");
    }
    check::<f64>(sky);
    check::<f32>(sky);
    check::<F32>(sky);
    check::<f16>(sky);
    check::<Scaled>(sky);
}

/// Patches that tile a rectangle add up to its solid angle, which has a closed form.
#[test]
fn patches_add_up_to_a_rectangle() {
    const SIDE: u32 = 400;
    let (half_width, half_height, distance) = (1.5_f64, 0.7_f64, 1.1_f64);
    let area = 4.0 * half_width * half_height / f64::from(SIDE * SIDE);
    let centre = |index: u32, half: f64| half * ((2.0 * f64::from(index) + 1.0) / f64::from(SIDE) - 1.0);
    let patch = |x: f64, y: f64| {
        let away = (x * x + y * y + distance * distance).sqrt();
        patch_solid_angle(area, distance / away, away)
    };
    let sum: f64 = (0..SIDE * SIDE).map(|i| patch(centre(i % SIDE, half_width), centre(i / SIDE, half_height))).sum();
    let (a, b) = (half_width / distance, half_height / distance);
    let whole = 4.0 * (a * b / ((1.0 + a * a) * (1.0 + b * b)).sqrt()).asin();
    assert!((sum / whole - 1.0).abs() < 1e-5, "{sum} {whole}");
}

/// The flux that one patch sends is what the other receives: radiance does not change along a ray.
struct BothWays;

impl Visitor for BothWays {
    type Output = f64;

    fn visit<T: Real>(self) -> f64 {
        let mut source = oorandom::Rand64::new(9);
        let mut next = |least: f64, most: f64| T::Scalar::nearest(least + (most - least) * source.rand_float());
        worst((0..5000).map(|_| {
            let [sender, receiver] = [0; 2].map(|_| Patch { area: next(0.1, 3.0), cos: next(0.1, 1.0) });
            let (radiance, distance) = (next(1.0, 10.0), next(1.0, 5.0));
            let through = |from: Patch<T::Scalar>, to: Patch<T::Scalar>| {
                radiance * projected_area(from.area, from.cos) * patch_solid_angle(to.area, to.cos, distance)
            };
            let sent = through(sender, receiver).exact();
            let others = [
                through(receiver, sender),
                flux(radiance, sender, receiver, distance),
                flux(radiance, receiver, sender, distance),
            ];
            worst(others.into_iter().map(|other| (other.exact() / sent - 1.0).abs()))
        }))
    }
}

#[test]
fn flux_is_the_same_both_ways() {
    for format in Format::ALL {
        // Both are within the budget of the truth.
        let most = 2.0 * Formula::Flux.maximum(format);
        assert_tight(format.name(), format.visit(BothWays), most);
    }
}

#[test]
fn beams() {
    assert_eq!([projected_area(2.0, 0.5), projected_area(2.0, -0.5), beam_power(1361.0, 2.0)], [1.0, 0.0, 2722.0]);
}

/// What faces away is dark, and what cannot be is finite.
#[test]
fn what_is_lit_takes_any_input() {
    fn check<S: Scalar>() {
        let [zero, one, most] = [S::ZERO, S::ONE, S::MAX];
        for cos in [-1.0, -1e-4, 0.0, f64::NAN].map(S::nearest) {
            let away = Patch { area: one, cos };
            let toward = Patch { area: one, cos: one };
            assert_eq!(
                [irradiance(one, cos, one), patch_solid_angle(one, cos, one), projected_area(one, cos)],
                [zero; 3]
            );
            assert_eq!([flux(one, away, toward, one), flux(one, toward, away, one)], [zero; 2]);
        }
        for distance in [0.0, -1.0, f64::NAN].map(S::nearest) {
            assert_eq!(irradiance(one, one, distance), zero);
        }
        for bad in [-1.0, f64::NAN].map(S::nearest) {
            assert_eq!([irradiance(bad, one, one), radiosity(bad, one), diffuse_radiance(one, bad)], [zero; 3]);
        }
        let tiny = S::nearest(6.2e-5);
        for answer in [irradiance(most, one, tiny), beam_power(most, most), diffuse_radiance(most, most)] {
            assert!(answer <= most && answer > S::nearest(6e4), "{answer:?}");
        }
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    check::<f16>();
    // Integers do not overflow.
    assert!(beam_power(Scaled::MAX, Scaled::MAX) <= Scaled::MAX);
    assert_eq!(irradiance(Scaled::ONE, Scaled::nearest(-0.5), Scaled::ONE), Scaled::ZERO);
}

/// In f16 the plain formulas leave the range, although inputs and answer are within.
#[test]
fn f16_holds_what_the_plain_formula_overflows() {
    let half = f16::from_f64;
    let near =
        |value: f16, expected: f64| assert!((value.to_f64() / expected - 1.0).abs() < 2e-3, "{value} {expected}");
    // The square of 300 metres is infinite.
    let (intensity, far) = (half(60_000.0), half(300.0));
    assert_eq!(intensity / (far * far), f16::ZERO);
    near(irradiance(intensity, f16::ONE, far), 60_000.0 / 90_000.0);
    // That of 5 millimetres is subnormal, and 1 / r is not; a plain division by r first overflows for strong lights.
    let close = half(0.005);
    assert!((close * close).to_f64() < f16::MIN_POSITIVE.to_f64());
    assert_eq!(half(1000.0) / close * half(1e-3) / close, f16::INFINITY);
    near(
        irradiance(half(1000.0), half(1e-3), close),
        half(1000.0).to_f64() * half(1e-3).to_f64() / close.to_f64().powi(2),
    );
}

#[test]
fn lamps_that_cannot_be_are_refused_with_value_and_range() {
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(point_intensity(bad), Err(RadiometryError::Power(_))));
        assert!(matches!(area_radiance(bad, 1.0, 1.0), Err(RadiometryError::Power(_))));
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(area_radiance(1.0, bad, 1.0), Err(RadiometryError::Area(_))));
        assert!(matches!(area_radiance(1.0, 1.0, bad), Err(RadiometryError::SolidAngle(_))));
        assert!(matches!(sphere_radiance(1.0, bad), Err(RadiometryError::Length(_))));
    }
    assert_eq!(sphere_radiance(f16::from_f64(60.0), f16::from_f64(0.001)), Err(RadiometryError::Overflow));
    let texts = [
        (point_intensity(-2.0).unwrap_err(), "power is -2, allowed is any finite number from 0"),
        (area_radiance(1.0, 0.0, 1.0).unwrap_err(), "area is 0, allowed is any positive finite number"),
        (area_radiance(1.0, 1.0, 0.0).unwrap_err(), "solid angle is 0, allowed is any positive finite number"),
        (sphere_radiance(1.0, -3.0).unwrap_err(), "radius or distance is -3, allowed is any positive finite number"),
        (RadiometryError::Overflow, "the answer is greater than the format's greatest number"),
    ];
    for (error, text) in texts {
        assert_eq!(error.to_string(), text);
    }
    let colour = SphereLight::of_direction([0.0, 0.0, 1.0], 10.0, 1.0, [1.0, -1.0, 1.0]).unwrap_err();
    assert_eq!(colour.to_string(), "colour is -1, allowed is any finite number from 0");
    let inside = SphereLight::of_direction([0.0, 0.0, 1.0], 1.0, 2.0, [1.0; 3]).unwrap_err();
    assert_eq!(inside.to_string(), "radius is 2, allowed is up to the distance 1");
    for direction in [[0.0; 3], [f64::NAN, 0.0, 1.0], [f64::INFINITY, 0.0, 1.0]] {
        let error = SphereLight::of_direction(direction, 1.0, 0.1, [1.0; 3]).unwrap_err();
        assert!(matches!(error, RadiometryError::Length(_)), "{error}");
    }
    // The ends themselves are allowed: the greatest power, and a sphere that touches what it lights.
    assert_eq!(point_intensity(f32::MAX), Ok(f32::MAX / (4.0 * std::f32::consts::PI)));
    assert!(SphereLight::of_direction([0.0, 0.0, 1.0], 2.0, 2.0, [1.0; 3]).is_ok());
    let nowhere = SphereLight::of_point([1.0; 3], [1.0; 3], 0.1, [1.0; 3]).unwrap_err();
    assert_eq!(nowhere, RadiometryError::Length(0.0));
}

/// A light behind all three planes of the axes, and one whose lanes differ in sign and size: as bright as its mirror
/// image.
#[test]
fn a_sphere_light_does_not_mind_the_sign_of_its_place() {
    fn check<T: Real>() {
        let levels = |v: [f64; 3]| v.map(T::Scalar::nearest);
        let bits = |light: Result<SphereLight<T::Scalar>, _>| {
            let light: SphereLight<T::Scalar> = light.map_err(|_: RadiometryError<T::Scalar>| ()).unwrap();
            light.radiance().unwrap().map(Scalar::exact)
        };
        let (scalar, colour) = (T::Scalar::nearest, levels([1.0, 0.5, 0.25]));
        for place in [[1.0, 2.0, 2.0], [0.5, 300.0, 20.0], [2.0, 2.0, 1.0]] {
            let all: Vec<_> = [[1.0; 3], [-1.0; 3], [1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, 1.0, -1.0]]
                .into_iter()
                .map(|sign: [f64; 3]| {
                    let place = levels([0, 1, 2].map(|i| sign[i] * place[i]));
                    let lit = levels([0.0; 3]);
                    let point = bits(SphereLight::of_point(place, lit, scalar(2.0), colour));
                    [point, bits(SphereLight::of_direction(place, scalar(64.0), scalar(1.0), colour))]
                })
                .collect();
            assert!(all.iter().all(|levels| *levels == all[0]), "{}: {all:?}", T::NAME);
        }
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    check::<f16>();
    check::<I2F14>();
    check::<I2F30>();
}

/// A white surface that faces the sphere shows the light's colour: the disc's illuminance times the radiance, over
/// pi.
#[test]
fn a_small_sphere_gives_a_white_surface_the_lights_colour() {
    let colour = [1.0, 0.5, 0.25];
    let lights = [
        SphereLight::of_point([3.0, -2.0, 7.0], [1.0, 0.0, 0.5], 0.001, colour),
        SphereLight::of_direction([1.0, 2.0, 2.0], 1e6, 500.0, colour),
        SphereLight::like_the_sun([1.0, 2.0, 2.0], 1e6, colour),
        // Not so small, and exact all the same.
        SphereLight::of_direction([0.0, 1.0, 0.0], 1.0, 0.8, colour),
    ];
    for light in lights.map(Result::unwrap) {
        let seen = oracle::illuminance(oracle::angular_radius(light.ratio()));
        for (radiance, colour) in light.radiance().unwrap().into_iter().zip(colour) {
            assert!((diffuse_radiance(1.0, radiance * seen) / colour - 1.0).abs() < 1e-12);
        }
    }
    let sun = lights[2].unwrap();
    assert!((sun.ratio() / SUN.sin() - 1.0).abs() < 1e-15);
    let expected = [1e6 / 3.0, 2e6 / 3.0, 2e6 / 3.0];
    assert!(sun.centre().into_iter().zip(expected).all(|(a, b)| (a / b - 1.0).abs() < 1e-15), "{:?}", sun.centre());
}

/// The Sun from Earth is just within f16 and U16F16, from Mars in neither; the light itself is fine everywhere.
#[test]
fn a_format_that_cannot_hold_the_radiance_says_so() {
    fn radiance<T: Real>(ratio: f64) -> Result<f64, RadiometryError<T::Scalar>> {
        let number = T::Scalar::nearest;
        let [x, y, z] = [0.0, 0.6, 0.8].map(number);
        let light =
            SphereLight::of_direction([x, y, z], number(100.0), number(100.0 * ratio), [T::Scalar::ONE; 3]).unwrap();
        assert_eq!(light.colour(), [T::Scalar::ONE; 3]);
        light.radiance_levels::<T>().map(|[level, _, _]| T::of_level(level).exact())
    }
    let [earth, mars] = [STUDY[0].light.sin(), STUDY[1].light.sin()];
    assert_eq!([earth, mars].map(|ratio| (1.0 / (ratio * ratio)).round()), [46_239.0, 107_352.0]);
    for (name, earths, marss) in [
        ("f32", radiance::<f32>(earth).ok(), radiance::<f32>(mars).ok()),
        ("I2F30", radiance::<I2F30>(earth).ok(), radiance::<I2F30>(mars).ok()),
        ("f64", radiance::<f64>(earth).ok(), radiance::<f64>(mars).ok()),
    ] {
        assert!((earths.unwrap() - 46_239.0).abs() < 1.0 && (marss.unwrap() - 107_352.0).abs() < 1.0, "{name}");
    }
    for earths in [radiance::<I2F14>(earth), radiance::<I16F16>(earth)] {
        assert!((earths.unwrap() - 46_239.0).abs() < 1.0);
    }
    assert_eq!([radiance::<I2F14>(mars), radiance::<I16F16>(mars)], [Err(RadiometryError::Overflow); 2]);
    assert!((radiance::<f16>(earth).unwrap() / 46_239.0 - 1.0).abs() < 3e-3);
    assert_eq!(radiance::<f16>(mars), Err(RadiometryError::Overflow));
    // A brighter Sun than 1.417 leaves f16.
    let half = f16::from_f64;
    let bright =
        |level: f64| SphereLight::like_the_sun([half(0.0), half(0.0), half(1.0)], half(100.0), [half(level); 3]);
    assert!(bright(1.4).unwrap().radiance().is_ok() && bright(1.43).unwrap().radiance().is_err());
}

/// The raw entries are off by the rounding to Q16, which is half a last place, and by the budget of their formula.
#[test]
fn raw_bits_are_within_their_last_place() {
    let mut source = oorandom::Rand64::new(8);
    let mut next = |least: f64, most: f64| (least * (most / least).powf(source.rand_float()) * 65_536.0) as u32;
    let value = |bits: u32| f64::from(bits) / 65_536.0;
    let mut errors = [0.0_f64; 3];
    for _ in 0..20_000 {
        let [a, b, c] = [0; 3].map(|_| next(1e-3, 1e4));
        let cos = (next(1e-3, 1.0) / 4) as i16;
        let fraction = f64::from(cos) / 16_384.0;
        let truths =
            [value(a) * fraction / (value(b) * value(b)), fraction * value(a) / PI, value(a) / (value(b) * value(c))];
        let answers =
            [irradiance_q16(a, cos, b), diffuse_radiance_q16(cos, a), area_radiance_q16(a, b, c).unwrap_or(u32::MAX)];
        for i in 0..3 {
            let truth = 65_536.0 * truths[i];
            if truth < 4_294_967_000.0 {
                errors[i] = worse(errors[i], ((f64::from(answers[i]) - truth).abs() - 0.5) / truth);
            } else if truth >= 4_294_968_000.0 {
                assert_eq!(answers[i], u32::MAX);
            }
        }
    }
    let formulas = [Formula::Irradiance, Formula::DiffuseRadiance, Formula::AreaRadiance];
    for (formula, error) in formulas.into_iter().zip(errors) {
        assert_tight(formula.name(), error, formula.maximum(Format::I16F16));
    }
    assert_eq!(
        [irradiance_q16(65_536, -1, 65_536), irradiance_q16(65_536, 16_384, 0), diffuse_radiance_q16(-1, 1)],
        [0; 3]
    );
    assert!(matches!(area_radiance_q16(1, 0, 1), Err(RadiometryError::Area(_))));
    assert_eq!(area_radiance_q16(u32::MAX, 65_535, 65_536), Err(RadiometryError::Overflow));
}

/// Factors whose reciprocals f16 does not have: 1 over 7.6e-6 is infinite, 1 over 60 000 is subnormal.
#[test]
fn f16_holds_answers_whose_factors_have_no_reciprocal() {
    let half = f16::from_f64;
    assert_eq!(area_radiance(f16::ZERO, half(7.6e-6), f16::ONE), Ok(f16::ZERO));
    let near = |value: f16, truth: f64| assert!((value.to_f64() / truth - 1.0).abs() < 2.1e-3, "{value} {truth}");
    // 40 000 W/sr at 200 m, and a patch of 60 000 m^2 seen from 60 000 / 250 m, far from the middle of the range.
    near(irradiance(half(40_000.0), f16::ONE, half(200.0)), 1.0);
    let patch = Patch { area: half(60_000.0), cos: f16::ONE };
    near(flux(half(1.5), patch, patch, half(60_000.0)), 1.5);
    assert_eq!(irradiance(half(1e-7), half(1e-4), half(1.0)), f16::ZERO);
}
