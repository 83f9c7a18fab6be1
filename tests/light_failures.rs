//! The catalogue of what goes wrong with the size of a light elsewhere, each with its figure, and that it does not
//! here.

use std::f64::consts::PI;

use fixed::types::{I2F14, I2F30};
use half::f16;
use sunglint::normalization::{
    inverse_size_factor, size_factor, size_factor_q30, solid_angle, versine, white_radiance,
};
use sunglint::oracle::{self, closed};
use sunglint::sampling::Cone;
use sunglint::{DistantLight, DistantSphere, LightError, SUN, Scalar};

fn assert_near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected}");
}

fn light(ratio: f64) -> DistantLight {
    DistantLight::from_ratio(ratio).unwrap()
}

/// Two forms with a switch between them, `x^2 / 2` for small discs, step where they meet.
#[test]
fn a_switch_to_half_the_square_steps() {
    let square = 1.5_f64.to_radians().sin().powi(2);
    for (square, step) in [(4e-4, 1.0e-4), (square, 1.7e-4)] {
        let x = square.sqrt();
        let old = (1.0 - (1.0 - square).sqrt()) / (square / 2.0) - 1.0;
        let places = x as f32;
        let [below, above] = [places, places.next_up()].map(|x| f64::from(versine(x).unwrap()));
        println!("at {x}: {old:e}, here {:e}", above / below - 1.0);
        assert_near(old, step, 0.05e-4);
        // Neighbours differ by two of their last places, and what two roundings add.
        assert!(above >= below && above / below - 1.0 < 4.0 * f64::from(f32::EPSILON));
    }
}

/// What every formula of this table starts with has no place in the formats that hold unit vectors.
#[test]
fn pi_fits_no_format_of_unit_vectors() {
    assert!(I2F14::checked_from_num(PI).is_none() && I2F30::checked_from_num(PI).is_none());
    assert_near(I2F14::wrapping_from_num(PI).to_num(), PI - 4.0, 1e-4);
    // Of numbers up to 65536, 48 bits below the point.
    let factor: f64 = size_factor_q30(I2F30::from_num(SUN.sin())).unwrap().to_num();
    assert_near(factor / SUN.size_factor(), 1.0, 4e-7);
}

/// Reciprocals that f16 does not hold are errors, not infinities.
#[test]
fn reciprocals_of_small_lights_overflow_f16() {
    let x = f16::nearest(2e-3);
    let plain = f16::ONE / (f16::nearest(PI) * x * x);
    assert!(plain.is_infinite() && (f16::ONE / (x * x)).is_infinite());
    let overflow = Err(LightError::Overflow("f16"));
    assert_eq!([inverse_size_factor(x), white_radiance(x)], [overflow, overflow]);
    let cone = Cone::new([0.0, 0.6, 0.8].map(f16::nearest), &DistantSphere::from_ratio(x).unwrap());
    assert_eq!(cone.pdf(), overflow);
    // (d / R)^2 from the ratio 1/256 on.
    let edge = f16::nearest(1.0 / 256.0);
    let below = f16::from_bits(edge.to_bits() - 1);
    assert_eq!(white_radiance(below), overflow);
    assert!(white_radiance(f16::from_bits(edge.to_bits() + 1)).is_ok());
}

/// The slips that compile: diameter for radius, degrees for radians, the angle by `atan`.
#[test]
fn slips_of_units_and_of_functions() {
    let degrees = 2.0 * SUN.angular_radius().to_degrees();
    let of = |angle: f64| DistantLight::from_angle(angle).unwrap().size_factor() / SUN.size_factor();
    assert_near(of(degrees), 1.0, 1e-14);
    let diameter = of(2.0 * degrees);
    let radians = (PI * (degrees / 2.0).sin().powi(2)) / SUN.size_factor();
    println!("diameter for radius {diameter:.4}, degrees for radians {radians:.0}");
    assert_near(diameter, 4.0, 1e-4);
    assert_near(radians, 3206.0, 1.0);
    // `atan(R / d)` in place of `asin`: the Sun's radius, and the solid angle of a lamp.
    let radius = SUN.sin().atan() / SUN.angular_radius() - 1.0;
    let lamp = oracle::solid_angle(0.5_f64.atan()) / closed::solid_angle(0.5) - 1.0;
    println!("by the tangent {radius:e}, {lamp:.4}");
    assert_near(radius, -1.08e-5, 0.01e-5);
    assert_near(lamp, -0.212, 0.0005);
    let ours = [SUN.sin(), 0.5].map(|x| solid_angle(x).unwrap() / closed::solid_angle(x) - 1.0);
    assert!(ours.into_iter().all(|error| error.abs() < 1e-15), "{ours:?}");
}

/// The first two branches of sizeFactor at every angle: zero for the full sphere, whose intensity is then divided by
/// it.
#[test]
fn one_branch_for_all_angles_divides_by_zero() {
    let one_branch = |angle: f64| PI * (angle / 2.0).to_radians().sin().powi(2);
    let over = |angle: f64| DistantLight::from_angle(angle).unwrap().size_factor() / one_branch(angle);
    let figures = [270.0, 359.99, 360.0].map(over);
    println!("{figures:?} times too bright");
    assert_near(figures[0], 3.0, 1e-12);
    assert_near(figures[1] / 2.63e8, 1.0, 0.01);
    assert!(figures[2] > 1e31, "{figures:?}");
}

/// From within the sphere there is no disc: the published form is the root of a negative number.
#[test]
fn inside_the_sphere_there_is_no_disc() {
    let published =
        |radius: f64, distance: f64| 2.0 * PI * (1.0 - (distance * distance - radius * radius).sqrt() / distance);
    assert!(published(2.0, 1.0).is_nan());
    assert_eq!(published(1.0, 1.0), 2.0 * PI);
    let error = DistantLight::from_radius_and_distance(2.0, 1.0).unwrap_err();
    assert!(matches!(error, LightError::Radius { radius: 2.0, distance: 1.0 }), "{error}");
    assert_eq!(DistantLight::from_radius_and_distance(1.0, 1.0).unwrap().solid_angle(), 2.0 * PI);
    assert!(solid_angle(1.0_f32.next_up()).is_err() && size_factor(2.0_f32).is_err());
}

/// No angle is a light at infinity: nothing is divided by its solid angle.
#[test]
fn a_point_at_infinity_divides_by_nothing() {
    assert!((1.0 / (PI * 0.0_f64)).is_infinite());
    let point = DistantLight::from_angle(0.0).unwrap();
    assert_eq!((point.size_factor(), point.radiance(7.0)), (1.0, Ok(7.0)));
    assert_eq!([size_factor(0.0_f32), inverse_size_factor(0.0)], [Ok(1.0), Ok(1.0)]);
}

/// Illuminance is not radiance: the Sun's 128 thousand lux are two thousand million candelas a square metre.
#[test]
fn the_suns_illuminance_taken_for_its_luminance() {
    let factor = SUN.radiance(1.28e5).unwrap() / 1.28e5;
    println!("{factor} times");
    assert_near(factor / 14_718.3, 1.0, 1e-5);
}

/// A density from the subtraction, of a light a fiftieth of a degree wide: a quarter of what it is.
#[test]
fn a_density_by_subtraction_loses_three_quarters_at_a_fiftieth_of_a_degree() {
    let light = light(0.01_f64.to_radians().sin());
    let x = light.sin() as f32;
    let old = 1.0 / (2.0 * std::f32::consts::PI * (1.0 - (1.0 - x * x).sqrt()));
    let cone = Cone::new([0.0, 0.0, 1.0], &DistantSphere::from_ratio(x).unwrap());
    let off = |pdf: f32| f64::from(pdf) * closed::solid_angle(x.into()) - 1.0;
    let [old, new] = [old, cone.pdf().unwrap()].map(off);
    println!("{old:.3}, here {new:e}");
    assert_near(old, -0.744, 0.001);
    assert!(new.abs() < 3e-7, "{new:e}");
}

/// The sine of a sample by `sqrt(1 - cos^2)`, its cosine as published: what the cosine cannot tell from 1 is the
/// centre.
#[test]
fn a_sample_by_its_cosine_is_the_centre() {
    const COUNT: u32 = 1 << 20;
    let sine = |z: f32, x: f32| {
        let cosine = 1.0 - z + z * (1.0 - x * x).sqrt();
        (1.0 - cosine * cosine).sqrt()
    };
    let share = |x: f32| {
        let centre = (1..=COUNT).filter(|&i| sine(i as f32 / COUNT as f32, x) == 0.0);
        centre.count() as f64 / f64::from(COUNT)
    };
    let shares = [SUN.sin() as f32, 1e-3, 1e-4].map(share);
    println!("{shares:?}");
    assert_near(shares[0], 2.76e-3, 0.01e-3);
    assert_near(shares[1], 0.059, 0.0005);
    assert_eq!(shares[2], 1.0);
    // Here the sines of as many are the square roots of their numbers, but for the last places.
    let cone = Cone::new([0.0, 0.0, 1.0], &DistantSphere::from_ratio(1e-4_f32).unwrap());
    for z in [1e-6_f32, 1e-3, 0.5, 1.0] {
        let [x, y, _] = cone.direction([z, 0.3]);
        assert_near(f64::from(x.hypot(y)) / (1e-4 * f64::from(z).sqrt()), 1.0, 1e-6);
    }
}
