//! The catalogue of failures of direction methods: the old form fails with the figure stated, the recommended one
//! does not.
//!
//! The scene is that of `trial::input::scene`; theta is the angular radius of the light.

use fixed::types::{I2F14, I2F30};
use half::f16;
use sunglint::light::{ASTRONOMICAL_UNIT_KM, SOLAR_RADIUS_KM};
use sunglint::trial::found::worse;
use sunglint::trial::{Format, Method, budget, input, lights};
use sunglint::{DistantLight, DistantSphere, Real, SUN, UnfactoredSphere, cap, disc, epic, factored, oracle};

const RATIO: f64 = 0.00465;

fn light(ratio: f64) -> DistantLight {
    DistantLight::from_ratio(ratio).unwrap()
}

fn sphere<T: Real>(ratio: f64) -> DistantSphere<T> {
    DistantSphere::of(&light(ratio))
}

/// The scene with the mirror direction at `angle`, in the format `T`.
fn scene<T: Real>(angle: f64) -> ([T; 3], [T; 3]) {
    let pair = input::scene(angle);
    (pair.l.map(T::from_f64), pair.r.map(T::from_f64))
}

/// How far `answer` is from `l`, in units of `theta`.
fn turn<T: Real>(l: [T; 3], answer: [T; 3], theta: f64) -> f64 {
    oracle::angle_between(l.map(T::to_f64), answer.map(T::to_f64)) / theta
}

fn floats<T: Real>(v: [f64; 3]) -> [T; 3] {
    v.map(T::from_f64)
}

/// The budget of `cap` under the budgeted light at `light`, in units of its angular radius.
fn budget_in_radii(format: Format, light: usize) -> f64 {
    let theta = lights::BUDGETED[light].light.angular_radius();
    budget::maximum(Method::Cap, format, light).unwrap() / theta
}

fn assert_near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected}");
}

/// f16 rounds the cosine of the Sun's radius to 1.
#[test]
fn disc_in_f16_takes_what_is_near_the_sun_for_the_sun() {
    let theta = light(RATIO).angular_radius();
    let (l, r) = scene::<f16>(3.0 * theta);
    assert_eq!(disc(l, r, &sphere(RATIO)), r);
    assert_near(turn(l, r, theta), 2.988, 0.0002);
    let far = 7.1 * theta;
    let (l, r) = scene::<f16>(far);
    assert_eq!(disc(l, r, &sphere(RATIO)), r);
    assert_near(turn(l, cap(l, r, &sphere(RATIO)), theta), 1.0, budget_in_radii(Format::F16, 0));
}

/// Of directions at so many radii from the Sun, the share that `disc` in f16 takes to be inside.
fn share_inside(radii: f64) -> f64 {
    const COUNT: usize = 5000;
    let sphere = DistantSphere::<f16>::new(&SUN);
    let inside = input::random(7, COUNT, 0.1).filter(|pair| {
        let l = pair.l;
        // The random mirror direction gives the side to turn to.
        let toward = oracle::nearest_in_disc(l, pair.r, radii * SUN.angular_radius());
        let (l, r) = (l.map(f16::from_f64), toward.map(f16::from_f64));
        oracle::angle_between(l.map(f16::to_f64), r.map(f16::to_f64)) > SUN.angular_radius() && disc(l, r, &sphere) == r
    });
    inside.count() as f64 / COUNT as f64
}

#[test]
fn disc_in_f16_blurs_the_sun_to_five_radii_and_beyond() {
    let shares = [3.0, 5.0, 9.0].map(share_inside);
    assert_near(shares[0], 0.70, 0.01);
    assert_near(shares[1], 0.44, 0.01);
    assert_near(shares[2], 0.03, 0.005);
}

/// From the cosine of the Sun's radius to 1.
#[test]
fn the_cosine_of_the_sun_is_181_steps_of_f32_from_one() {
    assert_eq!(1_f32.to_bits() - (SUN.cos() as f32).to_bits(), 181);
}

/// f32 resolves the cosine of a tiny disc in steps as large as its versine.
#[test]
fn disc_in_f32_cannot_tell_a_tiny_disc() {
    let theta = light(1e-4).angular_radius();
    for angle in [1.5e-4, 3e-4] {
        let (l, r) = scene::<f32>(angle);
        assert_eq!(disc(l, r, &sphere(1e-4)), r);
        assert_near(turn(l, cap(l, r, &sphere(1e-4)), theta), 1.0, budget_in_radii(Format::F32, 1));
    }
    let (l, r) = scene::<f32>(0.5e-4);
    assert_near(turn(l, disc(l, r, &sphere(1e-4)), theta), 1.0, 0.0003);
    assert_eq!(cap(l, r, &sphere(1e-4)), r);
}

/// The `*` of the fixed crate rounds each product back to the format.
#[test]
fn factored_with_every_product_rounded_has_no_disc() {
    let theta = light(RATIO).angular_radius();
    let (mut strict, mut wide) = (0.0_f64, 0.0_f64);
    for step in 1..100 {
        let (l, r) = scene::<I2F14>(f64::from(step) * 0.1 * theta);
        let exact = oracle::factored_direction(l.map(I2F14::to_f64), r.map(I2F14::to_f64), RATIO);
        let error = |answer: [I2F14; 3]| oracle::angle_between(answer.map(I2F14::to_f64), exact) / theta;
        strict = worse(strict, error(strictly_factored(l, r)));
        wide = worse(wide, error(factored(l, r, &sphere(RATIO))));
    }
    assert_near(strict, 0.69, 0.005);
    // The budget of `factored` in units of the radius.
    let budget = budget::maximum(Method::Factored, Format::I2F14, 0).unwrap() / theta;
    assert!(wide <= budget && wide >= budget / 4.0, "{wide}");
}

fn strictly_factored(l: [I2F14; 3], r: [I2F14; 3]) -> [I2F14; 3] {
    let ratio = I2F14::from_num(RATIO);
    shifted_strictly(l, r, |square| ratio.checked_div(square.sqrt()).unwrap_or(I2F14::ONE).min(I2F14::ONE))
}

/// The representative point whose shift is `D` times a factor of its square, each product rounded.
fn shifted_strictly(l: [I2F14; 3], r: [I2F14; 3], factor: impl Fn(I2F14) -> I2F14) -> [I2F14; 3] {
    let dot = |a: [I2F14; 3], b: [I2F14; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let along = dot(l, r);
    let d = [0, 1, 2].map(|i| along * r[i] - l[i]);
    let factor = factor(dot(d, d));
    [0, 1, 2].map(|i| l[i] + factor * d[i])
}

/// A hundredth of a radius within the rim, by the reciprocal root: 215, of which I2F14 holds 2, and so of the shift a
/// hundredth.
#[test]
fn factored_with_every_product_rounded_snaps_to_the_light() {
    let theta = light(RATIO).angular_radius();
    let (l, r) = scene::<I2F14>(0.99 * theta);
    let old = shifted_strictly(l, r, |square| {
        let root = square.sqrt();
        I2F14::from_num(RATIO) * I2F14::ONE.checked_div(root).unwrap_or(I2F14::MAX)
    });
    let [strict, wide] = [old, factored(l, r, &sphere(RATIO))].map(|answer| turn(l, answer, theta));
    println!("strict {strict:.3}, wide {wide:.3} of the radius");
    assert_near(strict, 0.0061, 0.0005);
    assert_near(wide, 0.99, budget::maximum(Method::Factored, Format::I2F14, 0).unwrap() / theta + 0.01);
}

/// The distance to the Sun overflows f16 in kilometres, and its square f32 in no unit; without it there is nothing to
/// overflow.
#[test]
fn epic_keeps_the_distance_which_f32_holds_and_f16_does_not() {
    fn error<T: Real>(kilometre: f64) -> f64 {
        let (radius, distance) = (SOLAR_RADIUS_KM * kilometre, ASTRONOMICAL_UNIT_KM * kilometre);
        let sun = DistantLight::from_radius_and_distance(radius, distance).unwrap();
        let (l, r) = scene::<T>(1.5 * sun.angular_radius());
        let exact = oracle::factored_direction(l.map(T::to_f64), r.map(T::to_f64), sun.sin());
        let answer = epic(l, r, &UnfactoredSphere::of(&sun)).map(T::to_f64);
        oracle::angle_between(answer, exact)
    }
    let budget = budget::maximum(Method::Epic, Format::F32, 0).unwrap();
    for kilometre in [1.0, 1000.0] {
        let f32_error = error::<f32>(kilometre);
        assert!(f32_error <= budget, "{f32_error:e}");
        assert!(error::<f16>(kilometre).is_nan());
    }
    assert!(f16::from_f64(ASTRONOMICAL_UNIT_KM).is_infinite());
}

/// As shaders have it: the tangent of opposite directions is the zero vector at length one.
#[test]
fn disc_without_a_guard_is_nan_for_opposite_directions() {
    fn unguarded([l, r]: [[f32; 3]; 2], [sin, cos]: [f32; 2]) -> [f32; 3] {
        let l_dot_r = f32::dot(l, r);
        let tangent = [0, 1, 2].map(|i| r[i] - l_dot_r * l[i]);
        let length = f32::dot(tangent, tangent).sqrt();
        [0, 1, 2].map(|i| cos * l[i] + sin * (tangent[i] / length))
    }
    for l in [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]] {
        let r = l.map(|lane: f32| -lane);
        let sun = DistantSphere::<f32>::of(&light(RATIO));
        assert!(unguarded([l, r], [sun.sin(), sun.cos()]).iter().all(|lane| lane.is_nan()));
        assert_eq!([disc(l, r, &sun), cap(l, r, &sun)], [l; 2]);
    }
    // The difference of the two is the edge of I2F30, and beyond it the other way round.
    let [up, down] = [I2F30::ONE, -I2F30::ONE];
    assert_eq!(down.checked_sub(up), Some(I2F30::MIN));
    assert_eq!(up.checked_sub(down), None);
}

/// Opposite directions have no nearest point on the rim; the answer is the centre, in all formats and on axes too.
#[test]
fn opposite_directions_give_the_centre() {
    fn check<T: Real>() {
        for l in [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [0.6, 0.0, 0.8], [0.36, 0.48, 0.8]].map(floats::<T>) {
            let r = l.map(|lane| T::sub(T::ZERO, lane));
            for ratio in [0.0, RATIO, 0.9, 1.0] {
                assert_eq!(cap(l, r, &sphere(ratio)), l);
            }
            for angle in [200.0, 270.0, 355.0, 359.0, 359.9] {
                assert_eq!(cap(l, r, &DistantSphere::of(&DistantLight::from_angle(angle).unwrap())), l);
            }
        }
    }
    check::<f64>();
    check::<f32>();
    check::<micromath::F32>();
    check::<f16>();
    check::<I2F14>();
    check::<I2F30>();
    check::<fixed::types::I16F16>();
}

/// The representative point falls into the origin where the sphere reaches from the light to the mirror ray's
/// perpendicular.
#[test]
fn factored_has_no_direction_at_a_right_angle_to_a_full_disc() {
    let (l, r) = (floats::<f64>([0.0, 0.0, 1.0]), floats([1.0, 0.0, 0.0]));
    assert_eq!(factored(l, r, &sphere(1.0)), [0.0; 3]);
    assert_eq!(cap(l, r, &sphere(1.0)), r);
    // A step below, what is left of it has the direction of `l` where any has; the rim is at `r`.
    let below = 1.0_f64.next_down();
    assert_eq!(factored(l, r, &sphere(below)), l);
    assert_near(oracle::angle_between(cap(l, r, &sphere(below)), r), 0.0, 2e-8);
}

/// Rust's `clamp` keeps a NaN, `max` and `min` drop it: by `rsqrt` the one gives no direction and the other the light.
#[test]
fn zero_times_infinity_survives_clamp() {
    let factor = |x: f32, square: f32| x * (1.0 / square.sqrt());
    let nan = factor(0.0, 0.0);
    assert!(nan.is_nan() && nan.clamp(0.0, 1.0).is_nan());
    #[expect(clippy::manual_clamp, reason = "the difference is the point")]
    let dropped = nan.max(0.0).min(1.0);
    assert_eq!(dropped, 0.0);
    assert_eq!(factor(0.00465, 0.0).clamp(0.0, 1.0), 1.0);
}

/// The same vector twice, whose dot product f32 rounds to a step beside 1: by `acos` not a number, or a tenth of the
/// Sun's radius.
#[test]
fn the_angle_between_a_vector_and_itself_by_its_cosine() {
    let vectors = || input::random(9, 10_000, 0.1).map(|pair| pair.l.map(|lane| lane as f32));
    let angles: Vec<f32> = vectors().map(|v| f32::dot(v, v).acos()).collect();
    let nan = angles.iter().filter(|angle| angle.is_nan()).count();
    let most = angles.iter().fold(0.0_f32, |most, angle| most.max(*angle));
    println!("{nan} of {} are no number, the others up to {most:e}", angles.len());
    assert_eq!(nan, 430);
    assert_near(most.into(), 4.883e-4, 1e-7);
    for v in vectors() {
        assert_eq!(oracle::angle_between(v.map(f64::from), v.map(f64::from)), 0.0);
        for ratio in [0.0, 1e-4, RATIO, 1.0] {
            assert_eq!(cap(v, v, &sphere(ratio)), v);
        }
    }
}

/// 0 times infinity, as the representative point has it for parallel directions.
#[test]
fn parallel_directions_and_a_point_light_give_the_light() {
    fn check<T: Real>() {
        let (l, _) = scene::<T>(0.0);
        for ratio in [0.0, RATIO] {
            assert_eq!(cap(l, l, &sphere(ratio)), l);
            assert_eq!(turn(l, factored(l, l, &sphere(ratio)), 1.0), 0.0);
        }
    }
    check::<f32>();
    check::<f16>();
    check::<I2F14>();
    check::<I2F30>();
}

/// The representative point's shift is perpendicular to the line of `r`, so that behind the surface it moves away
/// from `r`.
#[test]
fn factored_moves_away_from_rays_behind_the_light() {
    let theta = light(RATIO).angular_radius();
    for degrees in [91.0_f64, 120.0, 179.0] {
        let (l, r) = scene::<f64>(degrees.to_radians());
        let angle = oracle::angle_between(l, r);
        let from_factored = oracle::angle_between(factored(l, r, &sphere(RATIO)), r);
        let from_cap = oracle::angle_between(cap(l, r, &sphere(RATIO)), r);
        assert!(from_factored > angle, "{degrees}");
        assert_near(angle - from_cap, theta, 5e-16);
    }
    let (l, r) = scene::<f64>(2.5);
    let away = r.map(|lane| -lane);
    assert_near(oracle::angle_between(factored(l, r, &sphere(0.999)), away), 0.0, 2e-16);
}

/// A squared distance of 3 does not fit I2F30, nor does a difference of 2.
#[test]
fn cap_holds_far_directions_in_fixed_point() {
    let theta = light(RATIO).angular_radius();
    let far = [3_f64.sqrt() / 2.0, 0.0, -0.5];
    let (l, r) = (floats::<I2F30>([0.0, 0.0, 1.0]), floats::<I2F30>(far));
    let e = [0, 1, 2].map(|i| (r[i] - l[i]).checked_mul(r[i] - l[i]));
    assert_eq!([e[0].is_some(), e[2].is_some()], [true, false]);
    assert_near(turn(l, cap(l, r, &sphere(RATIO)), theta), 1.0, budget_in_radii(Format::I2F30, 0));
    let (l, r) = (floats::<I2F14>([0.0, 0.0, -1.0]), floats(far.map(|lane| -lane)));
    assert_near(turn(l, cap(l, r, &sphere(RATIO)), theta), 1.0, budget_in_radii(Format::I2F14, 0));
}

/// The answer is continuous across the rim: both sides are within twice the worst error of each other.
#[test]
fn cap_is_continuous_across_the_rim() {
    fn check<T: Real>(format: Format) {
        let theta = light(RATIO).angular_radius();
        let budget = budget::maximum(Method::Cap, format, 0).unwrap();
        for step in [1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
            for angle in [theta * (1.0 - step), theta * (1.0 + step)] {
                let (l, r) = scene::<T>(angle);
                let exact = oracle::nearest_in_disc(l.map(T::to_f64), r.map(T::to_f64), theta);
                let error = oracle::angle_between(cap(l, r, &sphere(RATIO)).map(T::to_f64), exact);
                assert!(error <= budget, "{} at {angle}: {error:e}", T::NAME);
            }
        }
    }
    check::<f64>(Format::F64);
    check::<f32>(Format::F32);
    check::<f16>(Format::F16);
    check::<I2F14>(Format::I2F14);
    check::<I2F30>(Format::I2F30);
}

/// The worst angle from `l`, in degrees, of `l + s - l` for half the sky, with the tangent `s` of `r - l` by one
/// projection, beside `-l`.
fn unguarded<T: Real>() -> f64 {
    let mut worst = 0.0_f64;
    for (index, pair) in (0..2000).zip(input::random(13, 2000, 1.0)) {
        let away = std::f64::consts::PI - 1e-3 * f64::from(index) / 2000.0;
        let (l, r) = (floats::<T>(pair.l), floats::<T>(oracle::nearest_in_disc(pair.l, pair.r, away)));
        let e = [0, 1, 2].map(|i| T::sub(r[i], l[i]));
        let s = T::normalize(T::diff(T::WIDE_ONE, e, T::dot(e, l), l));
        worst = worse(worst, turn(l, s, 1.0).to_degrees());
    }
    worst
}

/// Beside the opposite of a disc of half the sky, what the projection leaves along `l` must not turn the answer to
/// `-l`.
#[test]
fn cap_never_leaves_the_hemisphere() {
    let [f16_lost, i2f14_lost] = [unguarded::<f16>(), unguarded::<I2F14>()];
    println!("with one projection, degrees from l: f16 {f16_lost:.1}, I2F14 {i2f14_lost:.1}");
    assert_near(f16_lost, 175.5, 0.5);
    assert_near(i2f14_lost, 150.5, 0.5);

    fn check<T: Real>(format: Format) {
        // A right angle, and what the worst answer under half the sky is off.
        let most = std::f64::consts::FRAC_PI_2 + budget::maximum(Method::Cap, format, 5).unwrap();
        for ratio in [0.999, 0.9999, 1.0] {
            for index in 0..2000 {
                let away = std::f64::consts::PI - 1e-3 * f64::from(index) / 2000.0;
                let (l, r) = scene::<T>(away);
                let answer = cap(l, r, &sphere(ratio));
                let angle = turn(l, answer, 1.0);
                assert!(angle <= most, "{}: {angle} at {away}", T::NAME);
            }
        }
    }
    check::<f16>(Format::F16);
    check::<I2F14>(Format::I2F14);
    check::<f32>(Format::F32);
}
