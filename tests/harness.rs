//! What judges is judged: the measures on values worked out by hand, and a wrong method that is found out.

mod exact;
#[path = "exact/planted.rs"]
#[allow(dead_code, reason = "only one of its formats is of use here")]
mod planted;

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::panic::catch_unwind;

use exact::{assert_tight, big, distance, last_place, lsbs, ulps, worst};
use half::f16;
use planted::Off;
use sunglint::oracle::angle_between;
use sunglint::trial::input::Pair;
use sunglint::trial::property::{Case, inputs};
use sunglint::trial::{Draw, Format, Found, Method, judge};
use sunglint::{DistantLight, Real, SUN};

const FLOATS: [Format; 4] = [Format::F64, Format::F32, Format::Micromath, Format::F16];

const FIXED: [Format; 3] = [Format::I2F14, Format::I2F30, Format::I16F16];

fn power(exponent: i32) -> f64 {
    2.0_f64.powi(exponent)
}

#[test]
fn last_places_by_hand() {
    let places = |value: f64| FLOATS.map(|format| format.ulp(value));
    assert_eq!(places(1.0), [-52, -23, -23, -10].map(power));
    assert_eq!(places(-1.999), [-52, -23, -23, -10].map(power));
    assert_eq!(places(0.999), [-53, -24, -24, -11].map(power));
    assert_eq!(places(-3.0), [-51, -22, -22, -9].map(power));
    // The greatest of f16 is 65504, and 65472 the one before.
    assert_eq!(Format::F16.ulp(65_504.0), 32.0);
    // Below the least normal number, and at zero, the step of subnormals.
    for tiny in [power(-14), power(-15), 1e-7, 0.0] {
        assert_eq!(Format::F16.ulp(tiny), power(-24));
    }
    assert_eq!([Format::F32.ulp(1e-40), Format::F64.ulp(5e-324)], [f64::from(f32::from_bits(1)), f64::from_bits(1)]);
    for value in [0.0, 1e-9, -0.3, 1.9] {
        assert_eq!(FIXED.map(|format| format.ulp(value)), [-14, -30, -16].map(power));
    }
}

#[test]
fn steps_by_hand() {
    assert_eq!(Format::F64.step(), 1.0 - 1.0_f64.next_down());
    assert_eq!(Format::F32.step(), f64::from(1.0 - 1.0_f32.next_down()));
    assert_eq!(Format::Micromath.step(), Format::F32.step());
    assert_eq!(Format::F16.step(), 1.0 - f16::from_bits(0x3bff).to_f64());
    assert_eq!(FIXED.map(Format::step), [-14, -30, -16].map(power));
}

#[test]
fn bits_by_hand() {
    let known = [
        (Format::F64, 1.5, 0x3ff8_0000_0000_0000),
        (Format::F32, -2.0, 0xc000_0000),
        (Format::Micromath, 0.25, 0x3e80_0000),
        (Format::F16, 1.5, 0x3e00),
        (Format::F16, -0.0, 0x8000),
        (Format::I2F14, 1.0, 0x4000),
        (Format::I2F14, -2.0, 0x8000),
        (Format::I2F30, 0.5, 0x2000_0000),
        (Format::I2F30, -1.0, 0xc000_0000),
        (Format::I16F16, -1.5, 0xfffe_8000),
        (Format::I16F16, 32_767.0, 0x7fff_0000),
    ];
    for (format, value, bits) in known {
        assert_eq!(format.bits(value), bits, "{} {value}", format.name());
        assert_eq!(format.value(bits).to_bits(), value.to_bits(), "{} {bits:x}", format.name());
    }
    assert_eq!(Format::ALL.map(Format::width), [64, 32, 32, 16, 16, 32, 32]);
    // The list is in the order of its numbers, by which budgets are looked up.
    for (index, format) in Format::ALL.into_iter().enumerate() {
        assert_eq!(format as usize, index);
    }
}

#[test]
fn what_was_found_by_hand() {
    let mut found = Found::<2>::new();
    assert_eq!((found.max, found.samples, found.rms()), (0.0, 0, 0.0));
    for (error, input) in [(3.0, [1.0, 2.0]), (4.0, [3.0, 4.0]), (0.0, [5.0, 6.0]), (4.0, [7.0, 8.0])] {
        found.add(error, input);
    }
    // sqrt((9 + 16 + 0 + 16) / 4), and the first of two that are as bad.
    assert_eq!((found.max, found.worst, found.samples, found.rms()), (4.0, [3.0, 4.0], 4, 10.25_f64.sqrt()));
    found.add(f64::NAN, [9.0, 9.0]);
    assert_eq!((found.max, found.worst, found.rms()), (f64::INFINITY, [9.0, 9.0], f64::INFINITY));
    // No later one hides it.
    found.add(5.0, [0.0, 0.0]);
    assert_eq!((found.max, found.worst), (f64::INFINITY, [9.0, 9.0]));
}

#[test]
fn angles_by_hand() {
    let x = [1.0, 0.0, 0.0];
    assert_eq!(angle_between(x, x), 0.0);
    assert_eq!(angle_between(x, [0.0, -3.0, 0.0]), FRAC_PI_2);
    assert_eq!(angle_between(x, [-2.0, 0.0, 0.0]), PI);
    assert_eq!(angle_between([1.0, 1.0, 0.0], x), FRAC_PI_4);
    assert_eq!(angle_between(x, [0.0; 3]), 0.0);
    // Where the cosine is 1 in f64, and beside -x.
    for tiny in [1e-8, 1e-16, 1e-300] {
        assert_eq!(angle_between(x, [1.0, 0.0, tiny]), tiny);
        assert_eq!(angle_between([-1.0, 0.0, tiny.max(1e-15)], x), PI - tiny.max(1e-15));
    }
    assert!(angle_between(x, [f64::NAN, 0.0, 0.0]).is_nan());
}

#[test]
fn distances_by_hand() {
    // Three quarters of a place from 1, in the places below 1 and above it.
    let truth = big(1.0) + big(0.75 * power(-23));
    assert_eq!(ulps(1.0_f32, &truth), 0.75);
    assert_eq!(ulps(1.0_f32.next_up(), &truth), 0.25);
    assert_eq!(ulps(1.0_f32, &big(1.0 - power(-24))), 1.0);
    assert_eq!(ulps(f16::from_bits(1), &big(0.0)), 1.0);
    // f64 that is off by less than it can tell.
    assert_eq!(ulps(1.0_f64, &(big(1.0) + big(power(-60)))), power(-8));
    assert_eq!(distance(&big(-1.0), &big(1.0), -1), 4.0);
    assert_eq!([lsbs(-3, 1, &big(-1.0)), lsbs(1 << 40, 48, &big(power(-8) + power(-50)))], [1.0, 0.25]);
    let places = [big(1.0), big(0.999), big(-2.0), big(1e-30)].map(|value| last_place::<f16>(&value));
    assert_eq!(places, [-10, -11, -9, -24]);
    assert_eq!([last_place::<f64>(&big(1.0)), last_place::<f32>(&big(0.0))], [-52, -149]);
}

#[test]
fn a_bound_is_neither_broken_nor_loose() {
    let passes = |worst: f64, bound: f64| catch_unwind(|| assert_tight("", worst, bound)).is_ok();
    assert!(passes(1.0, 1.0) && passes(0.25, 1.0));
    assert!(!passes(1.0_f64.next_up(), 1.0) && !passes(0.25_f64.next_down(), 1.0));
    assert!(!passes(f64::NAN, 1.0) && !passes(1.0, f64::NAN) && !passes(1.0, f64::INFINITY));
    assert!(worst([1.0, f64::NAN, 2.0].into_iter()).is_nan());
    assert_eq!(worst([1.0, 3.0, 2.0].into_iter()), 3.0);
}

fn pair(l: [f64; 3], r: [f64; 3]) -> Pair {
    Pair { l, r }
}

fn assert_near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected}");
}

/// Half of a radius: a light of 30 degrees about `z`, and a mirror ray along `y`, a right angle away.
fn lamp() -> (DistantLight, Pair) {
    (DistantLight::from_ratio(0.5).unwrap(), pair([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]))
}

/// An error along `x`, across the answer `(0, 1/2, sqrt(3)/2)`: it turns the answer by the angle whose tangent it is.
#[test]
fn a_wrong_method_has_the_error_that_was_planted() {
    type Wrong = Off<fixed::types::I2F14, 200>;
    let (light, outside) = lamp();
    let inside = pair(outside.l, outside.l);
    let planted = (200.0 / 16_384.0_f64).atan();
    let found = judge::<Wrong>(Method::Cap, &light, [outside, inside].into_iter(), 1e-3);
    assert_eq!((found.samples, found.excluded, found.undirected), (2, 0, 0));
    // The answer's own rounding.
    let step = 1.0 / 16_384.0;
    assert_near(found.worst.error, planted, step);
    assert_eq!(found.worst.r.map(Real::to_f64), outside.r);
    // Of two, the one inside being right.
    assert_near(found.mean_square.sqrt(), found.worst.error / 2.0_f64.sqrt(), 1e-12);
    assert_near(found.disc_lost, found.worst.error / (PI / 6.0), 1e-12);
    // `cap` has no model error, and the inputs are exact.
    assert_near(found.model_max, 0.0, 1e-12);
    assert_eq!((found.total_max, found.total_mean_square), (found.worst.error, found.mean_square));
    assert_eq!((found.input_max, found.input_mean_square), (0.0, 0.0));
}

#[test]
fn what_has_no_answer_is_counted() {
    let (light, outside) = lamp();
    let opposite = |off: f64| pair(outside.l, [off.sin(), 0.0, -off.cos()]);
    let pairs = [outside, opposite(0.0), opposite(0.5e-3), opposite(2e-3)];
    let found = judge::<f64>(Method::Cap, &light, pairs.into_iter(), 1e-3);
    assert_eq!((found.samples, found.excluded, found.undirected), (2, 2, 0));
    // The Sun's distance in f16 is infinite: all answers are NaN, none counts as right.
    let found = judge::<f16>(Method::Epic, &SUN, pairs.into_iter(), 1e-3);
    assert_eq!((found.samples, found.excluded, found.undirected), (4, 0, 4));
    assert_eq!(found.worst.l.map(Real::to_f64), outside.l);
    let none = judge::<f64>(Method::Cap, &light, [].into_iter(), 1e-3);
    assert_eq!((none.samples, none.worst.error, none.mean_square), (0, 0.0, 0.0));
}

/// Where the representative point is 60 degrees off it is short: `atan(m cos / (1 - m sin))` in place of 30 degrees.
#[test]
fn the_models_error_is_apart_from_the_arithmetic() {
    let (light, _) = lamp();
    let pairs = [pair([0.0, 0.0, 1.0], [0.75_f64.sqrt(), 0.0, 0.5])];
    let found = judge::<f64>(Method::Factored, &light, pairs.into_iter(), 1e-3);
    let short = PI / 6.0 - (0.25 / (1.0 - 0.5 * 0.75_f64.sqrt())).atan();
    assert_near(found.model_max, short, 1e-15);
    assert_near(found.total_max, short, 1e-15);
    assert!(found.worst.error < 1e-15);
}

/// A mirror ray that a format cannot hold is off by what rounding does to it, for which no method is blamed.
#[test]
fn rounding_of_the_inputs_is_apart() {
    let light = DistantLight::from_ratio(0.9).unwrap();
    // 1.25 steps of I2F14 off the axis: a quarter of one is lost.
    let off = 1.25 / 16_384.0;
    let beside = pair([0.0, 0.0, 1.0], [off, 0.0, (1.0 - off * off).sqrt()]);
    let found = judge::<fixed::types::I2F14>(Method::Cap, &light, [beside].into_iter(), 1e-3);
    assert_near(found.input_max, 0.25 / 16_384.0, 1e-12);
    assert_near(found.input_mean_square.sqrt(), found.input_max, 1e-12);
    assert_eq!((found.worst.error, found.total_max), (0.0, 0.0));
}

#[test]
fn a_case_says_what_is_broken() {
    let case = Case { format: Format::F16, inputs: inputs([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]) };
    assert_eq!(case.inputs, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!([case.at_most("", 1.0, 1.0), case.at_most("", -1.0, 0.0), case.holds("", true)], [Ok(()); 3]);
    for (found, allowed) in [(1.0_f64.next_up(), 1.0), (f64::NAN, 1.0), (f64::INFINITY, f64::MAX), (1.0, f64::NAN)] {
        let broken = case.at_most("a bound", found, allowed).unwrap_err();
        assert_eq!((broken.property, broken.format, broken.inputs), ("a bound", Format::F16, case.inputs));
        assert_eq!([broken.found, broken.allowed].map(f64::to_bits), [found, allowed].map(f64::to_bits));
    }
    let broken = case.holds("so", false).unwrap_err();
    assert!(broken.to_string().starts_with("so in f16: 1e0, allowed is 0e0, at [1.0, 2.0"), "{broken}");
}

fn bytes(seed: u64) -> Vec<u8> {
    let mut source = oorandom::Rand64::new(seed.into());
    (0..256).map(|_| source.rand_u64() as u8).collect()
}

#[test]
fn bytes_by_hand() {
    let mut draw = Draw::new(&[7, 1, 0, 0, 0, 0, 0, 0, 0x80, 9]);
    assert_eq!((draw.byte(), draw.bits()), (7, 0x8000_0000_0000_0001));
    // One byte is left, then zeros.
    assert_eq!((draw.one_of([10, 20, 30, 40]), draw.byte(), draw.bits()), (20, 0, 0));
    let half = [0, 0, 0, 0, 0, 0, 0, 0x80];
    assert_eq!(Draw::new(&half).fraction(), 0.5);
    assert_eq!(Draw::new(&half).between(-1.0, 3.0), 1.0);
    assert_near(Draw::new(&half).logarithmic(1e-4, 1.0), 1e-2, 1e-16);
    let most = [255; 8];
    assert_eq!([Draw::new(&most).fraction(), Draw::new(&[]).fraction()], [1.0_f64.next_down(), 0.0]);
    assert_eq!(Draw::new(&[3]).format(), Format::F16);
    assert_eq!(Draw::new(&[10]).format(), Format::F16);
    // Kind 0 is an axis: the first, downwards for the lowest height.
    assert_eq!(Draw::new(&[]).direction(), [-1.0, 0.0, 0.0]);
    assert_eq!(Draw::new(&[]).sphere().sin(), SUN.sin());
    // 180 degrees, the lowest of those beyond half of the sky.
    assert_eq!(Draw::new(&[]).light().cos(), DistantLight::from_angle(180.0).unwrap().cos());
    // Kind 7 is one of four: the same direction.
    let l = [0.0, 0.6, 0.8];
    let beside = Draw::new(&[7, 0]).beside(l, 0.1);
    assert_near(angle_between(l, beside), 0.0, 1e-15);
    assert_near(angle_between(l, Draw::new(&[7, 1]).beside(l, 0.1)), PI, 1e-15);
    assert_near(angle_between(l, Draw::new(&[7, 2]).beside(l, 0.1)), 0.1, 1e-15);
    // Raw bits of a format: the low three say which kind.
    assert_eq!(Draw::new(&0x3e00_u64.wrapping_mul(8).wrapping_add(2).to_le_bytes()).any(Format::F16), 1.5);
    assert!(Draw::new(&(4_u64 << 3).to_le_bytes()).any(Format::F16).is_nan());
    assert_eq!(Draw::new(&1_u64.to_le_bytes()).any(Format::I2F14), 2.0 - power(-14));
}

#[test]
fn the_same_bytes_are_the_same_case_and_all_are_in_range() {
    for seed in 0..2000 {
        let bytes = bytes(seed);
        let case = |mut draw: Draw<'_>| {
            let (format, light) = (draw.format(), draw.light());
            let l = draw.direction();
            let r = draw.beside(l, light.angular_radius());
            let sphere = draw.sphere();
            let numbers = [draw.fraction(), draw.between(2.0, 3.0), draw.logarithmic(1e-6, 1e-3)];
            (format, light, l, r, sphere, numbers)
        };
        let (format, light, l, r, sphere, numbers) = case(Draw::new(&bytes));
        assert_eq!((format, light, l, r, sphere, numbers), case(Draw::new(&bytes)));
        for v in [l, r] {
            assert_near(v.iter().map(|lane| lane * lane).sum(), 1.0, 1e-14);
        }
        assert!((0.0..=PI).contains(&light.angular_radius()) && sphere.cos() >= 0.0);
        let [fraction, between, logarithmic] = numbers;
        assert!((0.0..1.0).contains(&fraction) && (2.0..3.0).contains(&between));
        assert!((1e-6..=1e-3).contains(&logarithmic), "{logarithmic}");
    }
}
