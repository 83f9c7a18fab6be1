//! How lights are described: ranges and errors, the Sun's figures, and sine, cosine and versine in f64.

mod exact;

use std::f64::consts::PI;

use exact::lights::{Truth, by_angle, by_angular_radius, by_distance, by_ratio};
use exact::{assert_tight, big, ulps, worst};
use sunglint::{DistantLight, LightError, SUN};

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
