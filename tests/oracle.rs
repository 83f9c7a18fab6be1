//! The oracle against 192-bit arithmetic, and the two properties that normalisation is for.

mod exact;

use std::f64::consts::{FRAC_PI_2, PI};

use exact::{Big, assert_tight, big, cosine, distance, last_place, pi, spread, square, ulps, versine, worst};
use sunglint::trial::input::{self, Pair};
use sunglint::trial::lights::BUDGETED;
use sunglint::trial::{self, Constants, Format, Method, budget};
use sunglint::{DistantLight, oracle};

type Vector = [f64; 3];
type BigVector = [Big; 3];

/// Random directions per light; with the hard ones more than 10 000 in all.
const SAMPLES: usize = 1400;

fn exactly(v: Vector) -> BigVector {
    v.map(big)
}

fn dot(a: &BigVector, b: &BigVector) -> Big {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &BigVector, b: &BigVector) -> BigVector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn length(v: &BigVector) -> Big {
    dot(v, v).sqrt()
}

fn scale(v: &BigVector, factor: &Big) -> BigVector {
    [0, 1, 2].map(|i| &v[i] * factor)
}

fn sum(a: &BigVector, b: &BigVector) -> BigVector {
    [0, 1, 2].map(|i| &a[i] + &b[i])
}

fn unit(v: &BigVector) -> BigVector {
    scale(v, &(big(1.0) / length(v)))
}

/// The angle between an answer and the truth, both of length 1 and close together.
fn error(answer: Vector, truth: &BigVector) -> f64 {
    let answer = exactly(answer);
    assert!(dot(&answer, truth) > big(0.9), "{answer:?} is far from {truth:?}");
    length(&cross(&answer, truth)).to_f64().value()
}

/// A disc's angular radius with its sine and cosine.
struct Disc {
    theta: f64,
    sin: Big,
    cos: Big,
}

impl Disc {
    fn of(theta: f64) -> Self {
        let (sin, cos) = big(theta).sin_cos();
        Self { theta, sin, cos }
    }

    fn nearest(&self, l: Vector, r: Vector) -> BigVector {
        let (l, r) = (unit(&exactly(l)), unit(&exactly(r)));
        let across = sum(&r, &scale(&l, &-dot(&l, &r)));
        if dot(&l, &r) >= self.cos {
            r
        } else if length(&across) < big(1e-40) {
            l
        } else {
            sum(&scale(&l, &self.cos), &scale(&unit(&across), &self.sin))
        }
    }
}

fn factored(l: Vector, r: Vector, ratio: f64) -> BigVector {
    let (l, r) = (unit(&exactly(l)), unit(&exactly(r)));
    let d = sum(&scale(&r, &dot(&l, &r)), &scale(&l, &big(-1.0)));
    let size = length(&d);
    let saturated = if size <= big(ratio) { big(1.0) } else { big(ratio) / size };
    unit(&sum(&l, &scale(&d, &saturated)))
}

/// The budgeted lights' angular radii, and two discs that are wider than half the sky.
fn discs() -> impl Iterator<Item = f64> {
    let wide = [270.0, 359.99].map(|angle| DistantLight::from_angle(angle).unwrap());
    BUDGETED.map(|light| light.light).into_iter().chain(wide).map(|light| light.angular_radius())
}

fn pairs(theta: f64) -> impl Iterator<Item = Pair> {
    input::random(1, SAMPLES, theta).chain(input::hard(theta))
}

/// Mirror directions so close to `-l` that single steps of f64 decide where the nearest direction lies.
fn beside_opposite() -> impl Iterator<Item = Pair> {
    input::random(2, 300, 1.0).enumerate().map(|(i, Pair { l, r: aside })| {
        let offset = 10.0_f64.powi(-10 - (i % 7) as i32);
        Pair { l, r: [0, 1, 2].map(|lane| -l[lane] + offset * aside[lane]) }
    })
}

fn nearest_error(disc: &Disc, Pair { l, r }: Pair) -> f64 {
    error(oracle::nearest_in_disc(l, r, disc.theta), &disc.nearest(l, r))
}

#[test]
fn nearest_direction_of_a_disc() {
    let errors: Vec<f64> =
        discs().map(Disc::of).flat_map(|disc| pairs(disc.theta).map(move |pair| nearest_error(&disc, pair))).collect();
    println!("{} pairs", errors.len());
    assert!(errors.len() > 10_000);
    assert_tight("nearest_in_disc, rad", worst(errors.into_iter()), 4e-16);
}

#[test]
fn nearest_direction_beside_the_opposite_one() {
    let errors = discs().map(Disc::of).flat_map(|disc| beside_opposite().map(move |pair| nearest_error(&disc, pair)));
    assert_tight("nearest_in_disc beside -l, rad", worst(errors), 4e-16);
}

#[test]
fn nearest_direction_does_not_depend_on_lengths() {
    let disc = Disc::of(0.05);
    let errors = pairs(disc.theta)
        .take(500)
        .map(|Pair { l, r }| nearest_error(&disc, Pair { l: l.map(|lane| lane * 3e7), r: r.map(|lane| lane * 1e-5) }));
    assert_tight("nearest_in_disc of any length, rad", worst(errors), 4e-16);
}

#[test]
fn nearest_direction_where_the_two_are_parallel() {
    let l = [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0];
    let opposite = l.map(|lane| -lane);
    let answers = [(l, 0.1, l), (opposite, 0.1, l), (opposite, PI, opposite), (opposite, 3.0, l), (l, 0.0, l)];
    for (r, theta, expected) in answers {
        let angle = oracle::angle_between(oracle::nearest_in_disc(l, r, theta), expected);
        assert!(angle < 1e-16, "{r:?} {theta}: {angle}");
    }
    assert!(oracle::angle_between(oracle::factored_direction(l, opposite, 0.1), l) < 1e-16);
    assert_eq!(oracle::angle_between(l, opposite), PI);
}

/// Leaves out where P is shorter than 0.1, since its direction hangs on the last bits of the inputs there.
#[test]
fn factored_direction() {
    let errors: Vec<f64> = BUDGETED
        .iter()
        .flat_map(|light| {
            let ratio = light.light.sin();
            let kept = move |pair: &Pair| oracle::factored_length(pair.l, pair.r, ratio) > 0.1;
            let pairs = input::random(3, 1700, light.light.angular_radius()).chain(input::hard(0.1)).filter(kept);
            pairs.map(move |Pair { l, r }| error(oracle::factored_direction(l, r, ratio), &factored(l, r, ratio)))
        })
        .collect();
    println!("{} pairs", errors.len());
    assert!(errors.len() > 10_000);
    assert_tight("factored_direction, rad", worst(errors.into_iter()), 5e-16);
}

/// Small angles to all their digits, so the error is relative.
#[test]
fn angle_between_two_directions() {
    let errors = discs().flat_map(|theta| input::random(4, 1300, theta)).chain(beside_opposite());
    let errors = errors.map(|Pair { l, r }| {
        let (l, r) = (exactly(l), exactly(r));
        let computed = oracle::angle_between(l.clone().map(f64_of), r.clone().map(f64_of));
        let truth = length(&cross(&l, &r)).atan2(&dot(&l, &r));
        ((big(computed) - &truth) / truth).to_f64().value().abs()
    });
    assert_tight("angle_between, relative", worst(errors), 6e-16);
}

fn f64_of(value: Big) -> f64 {
    value.to_f64().value()
}

#[test]
fn angular_radius_of_a_ratio() {
    let errors = spread(1000, 1e-9, 1.0).map(|ratio| {
        let truth = big(ratio).atan2(&cosine(&big(ratio)));
        distance(&big(oracle::angular_radius(ratio)), &truth, last_place::<f64>(&truth))
    });
    assert_tight("angular_radius, ULP", worst(errors), 2.0);
    assert_eq!([0.0, 1.0].map(oracle::angular_radius), [0.0, FRAC_PI_2]);
}

/// UsdLux angles, of discs up to the whole sky.
fn angles() -> impl Iterator<Item = f64> {
    spread(200, 0.01, 360.0).chain([0.53, 90.0, 180.0, 270.0, 359.99])
}

fn relative(value: f64, truth: f64) -> f64 {
    (value / truth - 1.0).abs()
}

/// Property 1: whatever its size, a normalised light gives its intensity as illuminance.
#[test]
fn normalised_light_gives_its_intensity() {
    let errors = angles().map(|angle| {
        let light = DistantLight::from_angle(angle).unwrap();
        let illuminance = oracle::illuminance(angle / 2.0 * PI / 180.0) * light.radiance(120_000.0).unwrap();
        relative(illuminance, 120_000.0)
    });
    assert_tight("property 1, relative", worst(errors), 1e-13);
}

/// Property 2: a sphere of constant power gives the same illuminance whatever its size, sizeFactor being in
/// proportion to its area.
#[test]
fn sphere_of_constant_power_gives_constant_illuminance() {
    const DISTANCE: f64 = 7.0;
    let expected = 1.0 / (4.0 * PI * DISTANCE * DISTANCE);
    let errors = spread(200, 1e-3, FRAC_PI_2).flat_map(|theta| {
        let power = oracle::sphere_power(DISTANCE * theta.sin());
        let light = DistantLight::from_angular_radius(theta).unwrap();
        // Power is pi times the area.
        let per_area = light.size_factor() / (power / PI);
        [relative(oracle::illuminance(theta) / power, expected), relative(per_area, expected * PI)]
    });
    assert_tight("property 2, relative", worst(errors), 1e-13);
}

#[test]
fn solid_angle_is_the_integral_over_the_disc() {
    let errors = angles().map(|angle| {
        let light = DistantLight::from_angle(angle).unwrap();
        relative(oracle::solid_angle(angle / 2.0 * PI / 180.0), light.solid_angle())
    });
    assert_tight("solid angle, relative", worst(errors), 1e-13);
}

/// Simpson's rule against the closed form in 192 bits, so that the two above stand on more than each other.
#[test]
fn illuminance_by_its_closed_form() {
    let errors = spread(200, 1e-3, PI).map(|theta| {
        let square = square(&big(theta).sin());
        let projected = if theta <= FRAC_PI_2 { square } else { big(2.0) - square };
        relative(oracle::illuminance(theta), f64_of(pi() * projected))
    });
    assert_tight("illuminance, relative", worst(errors), 1e-13);
}

/// The first branch alone, `pi sin^2`, at 270 degrees.
#[test]
fn without_the_third_branch_270_degrees_are_3_times_too_bright() {
    let theta = 0.75 * PI;
    let illuminance = oracle::illuminance(theta) / (PI * theta.sin() * theta.sin());
    println!("pi sin^2 at 270 degrees: {illuminance}");
    assert!((illuminance - 3.0).abs() < 1e-12);
}

#[test]
fn divided_by_the_solid_angle_180_degrees_are_half_as_bright() {
    let illuminance = oracle::illuminance(FRAC_PI_2) / oracle::solid_angle(FRAC_PI_2);
    println!("solid angle at 180 degrees: {illuminance}");
    assert!((illuminance - 0.5).abs() < 1e-12);
}

/// sizeFactor's third branch counts both sides of the plane.
#[test]
fn one_side_of_a_plane_receives_two_thirds_at_270_degrees() {
    let light = DistantLight::from_angle(270.0).unwrap();
    let one_side = oracle::illuminance(FRAC_PI_2) * light.radiance(1.0).unwrap();
    println!("one side at 270 degrees: {one_side}");
    assert!((one_side - 2.0 / 3.0).abs() < 1e-12);
}

/// The truth of the study's quantities and of the exhaustive tests.
#[test]
fn closed_forms_are_right_to_a_few_last_places() {
    type Pair = (&'static str, fn(f64) -> f64, fn(&Big) -> Big);
    let forms: [Pair; 3] = [
        ("versine", oracle::closed::versine, versine),
        ("solid_angle", oracle::closed::solid_angle, |x| big(2.0) * pi() * versine(x)),
        ("size_factor", oracle::closed::size_factor, |x| pi() * square(x)),
    ];
    for (name, computed, truth) in forms {
        let errors = spread(1000, 1e-6, 1.0).map(|ratio| ulps(computed(ratio), &truth(&big(ratio))));
        assert_tight(&format!("{name}, ULP"), worst(errors), 6.0);
    }
}

/// The oracle's own rounding is as large as the error of a method in f64, so that one has to be held to its budget
/// without it.
fn worst_in_f64(method: Method, index: usize, truth: impl Fn(&Disc, Pair) -> BigVector) -> f64 {
    let light = &BUDGETED[index].light;
    let sin = big(light.sin());
    let disc = Disc { theta: light.angular_radius(), cos: cosine(&sin), sin };
    let constants = Constants::<f64>::of(light);
    // The worst that a search has found with the oracle for a judge is among them.
    let all = pairs(disc.theta).chain(trial::worst::under(method, Format::F64, index));
    let defined = all.filter(|pair| method.is_defined(pair.l, pair.r, light, Format::F64.step()));
    worst(defined.map(|pair| {
        let answer = method.direction(pair.l, pair.r, &constants);
        let truth = truth(&disc, pair);
        // An answer's length may be a rounding off 1, which is not an error of its direction.
        error(answer, &truth) / length(&exactly(answer)).to_f64().value()
    }))
}

#[test]
fn methods_in_f64_keep_their_budgets_against_192_bits() {
    for (index, light) in BUDGETED.into_iter().enumerate() {
        let budget = |method| budget::maximum(method, Format::F64, index).unwrap();
        let cap = worst_in_f64(Method::Cap, index, |disc, pair| disc.nearest(pair.l, pair.r));
        assert_tight(&format!("cap in f64 at {}, rad", light.name), cap, budget(Method::Cap));
        let ratio = light.light.sin();
        let point = worst_in_f64(Method::Factored, index, |_, pair| factored(pair.l, pair.r, ratio));
        assert_tight(&format!("factored in f64 at {}, rad", light.name), point, budget(Method::Factored));
    }
}
