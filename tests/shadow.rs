//! Soft shadows against areas on the sphere, in every format.

mod exact;

use std::f64::consts::{FRAC_PI_2, PI};

use ::fixed::types::{I2F14, I2F30, I16F16};
use exact::{assert_tight, worst};
use half::f16;
use micromath::F32;
use sunglint::oracle::cone;
use sunglint::sampling::{Cone, points};
use sunglint::shadow::soft_shadow;
use sunglint::trial::shadow::{self as trial, COUNTS, LIGHTS, Occluder};
use sunglint::trial::{Format, Visitor};
use sunglint::{DistantLight, DistantSphere, Real, SUN, Scalar};

/// Worst error over all occluders.
struct Error {
    light: DistantLight,
    count: u32,
    scenes: usize,
}

impl Visitor for Error {
    type Output = f64;

    fn visit<T: Real>(self) -> f64 {
        let Self { light, count, scenes } = self;
        worst(Occluder::ALL.into_iter().map(|occluder| trial::error::<T>(&light, occluder, count, 1, scenes).max))
    }
}

fn keeps_its_budgets(count: u32, scenes: usize, lights: usize) {
    for (index, light) in LIGHTS.into_iter().enumerate().take(lights) {
        for format in Format::ALL {
            let error = format.visit(Error { light: light.light, count, scenes });
            let name = format!("{count} directions in {} at {}", format.name(), light.name);
            assert_tight(&name, error, trial::budget(format, index, count));
        }
    }
}

/// The surface, a plane and a sphere before the disc, each at random places: the error falls as `count^-0.75` in all
/// formats.
#[test]
fn shadows_are_the_areas_that_are_seen() {
    for count in COUNTS.into_iter().filter(|&count| count <= 1024) {
        keeps_its_budgets(count, 40, LIGHTS.len());
    }
}

/// Nothing is lost of sums of so many: at the Sun, where formats tell least; the ignored test has the other lights.
#[test]
fn shadows_of_65536_directions() {
    keeps_its_budgets(65536, 9, 1);
}

#[test]
#[ignore = "70 seconds in release: cargo test --release --test shadow -- --ignored --nocapture"]
fn shadows_of_many_scenes() {
    for count in COUNTS {
        keeps_its_budgets(count, if count <= 1024 { 400 } else { 40 }, LIGHTS.len());
    }
}

/// The root mean square falls as fast: from 16 to 1024 directions to a 23rd, for 0.75 is the power of 64 that makes
/// that.
#[test]
fn the_error_falls_with_the_three_quarter_power() {
    let rms = |count| trial::error::<f32>(&SUN, Occluder::Plane, count, 2, 400).rms();
    let power = (rms(16) / rms(1024)).ln() / 64_f64.ln();
    println!("{power}");
    assert!((0.70..0.80).contains(&power), "{power}");
}

/// The oracle's areas by what is known of them otherwise.
#[test]
fn overlaps_of_discs() {
    let area = cone::solid_angle;
    for theta in [0.00465, 0.05, 0.5, 1.2] {
        let half = cone::overlap(theta, FRAC_PI_2, FRAC_PI_2) / area(theta);
        let [apart, within, around] = [(theta, 2.01 * theta), (0.3 * theta, 0.5 * theta), (1.7 * theta, 0.5 * theta)]
            .map(|(other, distance)| cone::overlap(theta, other, distance));
        assert!((half - 0.5).abs() < 1e-9, "{half}");
        assert!(apart == 0.0 && (within / area(0.3 * theta) - 1.0).abs() < 1e-6, "{within}");
        assert!((around / area(theta) - 1.0).abs() < 1e-9, "{around}");
        // The other way about.
        let lens = cone::overlap(theta, 0.7 * theta, 0.8 * theta);
        assert!((cone::overlap(0.7 * theta, theta, 0.8 * theta) / lens - 1.0).abs() < 1e-7);
    }
    // The lens of two circles in a plane.
    let (r, d) = (0.7_f64, 0.8_f64);
    let [a, b] = [(d * d + 1.0 - r * r) / (2.0 * d), (d * d + r * r - 1.0) / (2.0 * d * r)].map(f64::acos);
    let kite = ((1.0 + r - d) * (d + 1.0 - r) * (d - 1.0 + r) * (d + 1.0 + r)).sqrt() / 2.0;
    let plane = a + r * r * b - kite;
    let tiny = 1e-5;
    assert!((cone::overlap(tiny, r * tiny, d * tiny) / (tiny * tiny) / plane - 1.0).abs() < 1e-7);
    // Facing, edge on, and set.
    assert!((cone::mean_cosine(0.5, 0.0) - (1.0 + 0.5_f64.cos()) / 2.0).abs() < 1e-12);
    assert!((cone::mean_cosine(FRAC_PI_2, FRAC_PI_2) - 0.25).abs() < 1e-9);
    assert!(cone::mean_cosine(0.1, 1.7) == 0.0 && (cone::mean_cosine(PI, 1.0) - 0.25).abs() < 1e-9);
}

/// A surface that faces an unhidden light reflects `rho E / pi`, whatever the light's size; beyond half the sky half of
/// the illuminance that counts both sides is on this one at 360 degrees.
struct Facing(DistantLight);

impl Visitor for Facing {
    type Output = [f64; 2];

    fn visit<T: Real>(self) -> [f64; 2] {
        let l = [0.0, 0.6, 0.8].map(T::from_f64);
        let cone = Cone::new(l, &DistantSphere::of(&self.0));
        let seen = soft_shadow(&cone, l, 5, 1024, |_| true);
        let [albedo, illuminance] =
            [0.5, 3.0].map(|value| T::of_lane(T::from_f64(value / 2.0)) + T::of_lane(T::from_f64(value / 2.0)));
        [seen.visible.exact(), seen.radiance(albedo, illuminance).exact() * PI / 1.5]
    }
}

#[test]
fn an_unhidden_light_reflects_its_illuminance() {
    for format in Format::ALL {
        // Each of 1024 points is worth 1e-3; and some steps of the format.
        let slack = 2.0 / 1024.0 + 4.0 * format.step();
        for x in [0.0, 0.00465, 0.5, 1.0] {
            let [visible, reflected] = format.visit(Facing(DistantLight::from_ratio(x).unwrap()));
            println!("{} at {x}: {visible} {reflected}", format.name());
            assert!(
                (visible - 1.0).abs() <= 2e-3 && (reflected - 1.0).abs() <= slack,
                "{} {x}: {visible} {reflected}",
                format.name()
            );
        }
        let [visible, reflected] = format.visit(Facing(DistantLight::from_angle(360.0).unwrap()));
        assert!(
            (visible - 0.5).abs() <= 5e-3 && (reflected - 0.5).abs() <= 5e-3,
            "{}: {visible} {reflected}",
            format.name()
        );
    }
}

/// The algorithm as the lectures have it, sample by sample: `rho / pi` times the mean of `L V cos / pdf`.
#[test]
fn the_mean_is_that_of_the_estimator() {
    for x in [0.00465, 0.3, 1.0] {
        let light = DistantLight::from_ratio(x).unwrap();
        let (l, n) = ([0.0, 0.6, 0.8], [0.36, 0.48, 0.8]);
        let cone = Cone::new(l, &DistantSphere::<f64>::new(&light));
        let sees = |direction: [f64; 3]| direction[0] > 0.1 * x;
        let (albedo, illuminance, count) = (0.7, 2.5, 500);
        let radiance = light.radiance(illuminance).unwrap();
        let mut sum = 0.0;
        for point in points(9, count) {
            let direction = cone.direction(point);
            let cosine = f64::dot(n, direction);
            if cosine > 0.0 && sees(direction) {
                sum += radiance * cosine / cone.pdf().unwrap();
            }
        }
        let estimate = albedo / PI * sum / f64::from(count);
        let here = soft_shadow(&cone, n, 9, count, sees).radiance(albedo, illuminance);
        // Cosines in the sum are cut at 2^-31.
        assert!((here / estimate - 1.0).abs() < 2e-9, "{x}: {here} {estimate}");
    }
}

#[test]
fn no_directions_see_nothing_and_hidden_ones_are_not_asked_for() {
    fn check<T: Real>() {
        let up = [0.0, 0.0, 1.0].map(T::from_f64);
        let down = [0.0, 0.0, -1.0].map(T::from_f64);
        let cone = Cone::new(up, &DistantSphere::<T>::of(&SUN));
        let none = soft_shadow(&cone, up, 0, 0, |_| true);
        assert_eq!((none.visible, none.cosine), (T::Scalar::ZERO, T::Scalar::ZERO));
        let set = soft_shadow(&cone, down, 0, 64, |_| panic!("under the surface"));
        assert_eq!((set.visible, set.cosine), (T::Scalar::ZERO, T::Scalar::ZERO));
        let mut asked = 0;
        let dark = soft_shadow(&cone, up, 0, 64, |_| {
            asked += 1;
            false
        });
        assert_eq!(
            (asked, dark.visible, dark.radiance(T::Scalar::ONE, T::Scalar::ONE)),
            (64, T::Scalar::ZERO, T::Scalar::ZERO)
        );
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    check::<f16>();
    check::<I2F14>();
    check::<I2F30>();
    check::<I16F16>();
}
