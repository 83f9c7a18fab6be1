//! The direction methods against the oracle: every budget holds and is tight, over random and hard directions, and the
//! worst that a search has found (`tests/search.rs`).

#[path = "exact/planted.rs"]
#[allow(dead_code, reason = "only one of its formats is of use here")]
mod planted;

use planted::Off;
use sunglint::trial::aim::{Aim, Cell, Place};
use sunglint::trial::found::{self, worse};
use sunglint::trial::judge::DISC_LOST;
use sunglint::trial::{Format, Judgement, Method, Visitor, aim, budget, input, judge, lights, worst};
use sunglint::{DistantLight, DistantSphere, Real, SUN, cap, factored, normalize, oracle, reflect};

const PAIRS: usize = 20_000;

/// What the judging of a contender comes to, without its type.
struct Outcome {
    max: f64,
    rms: f64,
    disc_lost: f64,
    all_undirected: bool,
    undirected: u64,
}

struct Judge {
    method: Method,
    light: DistantLight,
    format: Format,
    epsilon: f64,
}

impl Visitor for Judge {
    type Output = Outcome;

    fn visit<T: Real>(self) -> Outcome {
        let theta = self.light.angular_radius();
        let budgeted = lights::BUDGETED.iter().position(|light| light.light == self.light);
        // Epic's point under a light without a distance is the factored one, and so is its worst.
        let method = if budgeted != Some(0) && self.method == Method::Epic { Method::Factored } else { self.method };
        let worst = budgeted.into_iter().flat_map(|light| worst::under(method, self.format, light));
        let pairs = input::random(1, PAIRS, theta).chain(input::hard(theta)).chain(worst);
        let judgement: Judgement<T> = judge(self.method, &self.light, pairs, self.epsilon);
        Outcome {
            max: judgement.worst.error,
            rms: judgement.mean_square.sqrt(),
            disc_lost: judgement.disc_lost,
            all_undirected: judgement.undirected == judgement.samples,
            undirected: judgement.undirected,
        }
    }
}

fn outcome(method: Method, format: Format, light: DistantLight) -> Outcome {
    format.visit(Judge { method, light, format, epsilon: format.step() })
}

/// Within the budget, and not so far within that the budget says nothing.
fn assert_tight(measured: f64, budget: f64, what: &str) {
    assert!(measured <= budget, "{what}: {measured:e} is over the budget of {budget:e}");
    assert!(measured >= budget / 4.0, "{what}: the budget of {budget:e} is loose, measured {measured:e}");
}

fn keeps_its_budgets(method: Method) {
    for (index, light) in lights::BUDGETED.into_iter().enumerate() {
        for format in Format::ALL {
            let what = format!("{} in {} at {}", method.name(), format.name(), light.name);
            let outcome = outcome(method, format, light.light);
            match budget::maximum(method, format, index) {
                Some(budget) => {
                    assert_eq!(outcome.undirected, 0, "{what}");
                    assert_tight(outcome.max, budget, &what);
                }
                None => assert!(outcome.all_undirected || outcome.disc_lost >= DISC_LOST, "{what} works"),
            }
        }
    }
}

#[test]
fn epic_keeps_its_budgets_where_it_works() {
    keeps_its_budgets(Method::Epic);
}

#[test]
fn factored_keeps_its_budgets() {
    keeps_its_budgets(Method::Factored);
}

#[test]
fn disc_keeps_its_budgets() {
    keeps_its_budgets(Method::Disc);
}

/// Its budgets are those beside the light's opposite, where it turns to any side. Random pairs do not come so near.
#[test]
fn disc_under_the_sun_is_better_where_random_pairs_go() {
    let budgets = [4.0e-13, 1.5e-4, 1.5e-4, 4.6e-2, 8.2e-3, 2.8e-6, 5.2e-3];
    for (format, budget) in Format::ALL.into_iter().zip(budgets) {
        assert_tight(format.visit(Random(Method::Disc, format)), budget, format.name());
    }
}

struct Random(Method, Format);

impl Visitor for Random {
    type Output = f64;

    fn visit<T: Real>(self) -> f64 {
        let pairs = input::random(1, PAIRS, SUN.angular_radius());
        judge::<T>(self.0, &SUN, pairs, self.1.step()).worst.error
    }
}

#[test]
fn cap_keeps_its_budgets() {
    keeps_its_budgets(Method::Cap);
}

#[test]
fn epic_is_nan_at_the_sun_in_f16_and_lost_in_fixed_point() {
    assert!(outcome(Method::Epic, Format::F16, SUN).all_undirected);
    for format in [Format::I2F14, Format::I2F30, Format::I16F16] {
        assert!(outcome(Method::Epic, format, SUN).disc_lost > 1.0);
    }
}

/// The accuracy that makes each format good for the Sun; held also where `r` is as near to `-l` as the format can say
/// (f16: a tenth of a step; I2F14: half of one, within which the answer is `l`).
#[test]
fn cap_at_the_sun_is_good_enough_at_every_angle() {
    let needed = [
        (Format::F32, 8e-8, 0.0),
        (Format::F16, 4.5e-4, 0.1),
        (Format::I2F14, 1.0e-4, 0.5),
        (Format::I2F30, 2.1e-9, 0.0),
        (Format::I16F16, 2.8e-5, 0.0),
    ];
    for (format, needed, steps) in needed {
        let outcome = format.visit(Judge { method: Method::Cap, light: SUN, format, epsilon: steps * format.step() });
        let budget = budget::maximum(Method::Cap, format, 0).unwrap();
        assert_tight(outcome.max, budget, format.name());
        let worst = worst::recorded()
            .find(|record| record.cell == Cell { aim: Aim::Direction(Method::Cap), format, place: Place::Light(0) });
        assert!(worst.unwrap().error <= needed, "{}", format.name());
    }
}

#[test]
fn cap_at_the_sun_has_its_root_mean_square() {
    for format in Format::ALL {
        let outcome = outcome(Method::Cap, format, SUN);
        assert_tight(outcome.rms, budget::cap_rms_at_the_sun(format), format.name());
    }
}

/// Discs beyond half the sky: UsdLux angles above 180 degrees.
#[test]
fn cap_turns_by_more_than_a_right_angle() {
    for format in Format::ALL {
        let parts = [181.0, 200.0, 270.0, 350.0].map(|angle| {
            let light = DistantLight::from_angle(angle).unwrap();
            let outcome = outcome(Method::Cap, format, light);
            assert_eq!(outcome.undirected, 0, "{} at {angle}", format.name());
            outcome.max / budget::of_any_light(Method::Cap, format, light.angular_radius()).unwrap()
        });
        assert_tight(found::worst(parts.into_iter()), 1.0, format.name());
    }
}

/// What is along `l` of a tangent whose lanes are subnormal is rounded with them.
#[test]
fn cap_in_f16_leaves_the_rim_a_little_within_a_step_of_the_opposite() {
    let half_the_sky = DistantLight::from_ratio(1.0).unwrap();
    let l = [-0.442_138_671_875, 0.896_972_656_25, -0.001_057_624_816_894_531_3].map(half::f16::from_f64);
    let r = [0.442_382_812_5, -0.897_460_937_5, 0.001_057_624_816_894_531_3].map(half::f16::from_f64);
    let answer = cap(l, r, &DistantSphere::<half::f16>::new(&half_the_sky));
    let turn = oracle::angle_between(l.map(half::f16::to_f64), answer.map(half::f16::to_f64));
    let beyond = turn - half_the_sky.angular_radius();
    let budget = budget::cap_beyond_the_rim(Format::F16);
    assert!(beyond <= budget && beyond >= budget / 1.2, "{beyond:e}");
}

/// The full sphere has every direction inside.
struct FullSphere;

impl Visitor for FullSphere {
    type Output = ();

    fn visit<T: Real>(self) {
        let full = DistantSphere::<T>::of(&DistantLight::from_angle(360.0).unwrap());
        for pair in input::random(5, PAIRS, 3.0).chain(input::hard(3.0)) {
            let (l, r) = (pair.l.map(T::from_f64), pair.r.map(T::from_f64));
            assert_eq!(cap(l, r, &full), r);
        }
    }
}

/// A gap of 4e-10 about the opposite, which the cosine has lost, is no part of the disc. A fuzzer found it.
#[test]
fn almost_the_full_sphere_keeps_its_gap() {
    const GAP: f64 = 3.7e-10;
    let light = DistantLight::from_angular_radius(std::f64::consts::PI - GAP).unwrap();
    let answer = cap([0.0, 0.0, 1.0], [1e-10, 0.0, -1.0], &DistantSphere::<f64>::new(&light));
    assert!((answer[0] / light.sin() - 1.0).abs() < 1e-9 && answer[2] == -1.0, "{answer:?}");
}

#[test]
fn the_full_sphere_gives_the_mirror_direction() {
    Format::ALL.into_iter().for_each(|format| format.visit(FullSphere));
}

/// Greatest difference of the answer's length from 1, over discs of ratios up to 1.
struct Length;

impl Visitor for Length {
    type Output = f64;

    fn visit<T: Real>(self) -> f64 {
        let mut worst = 0.0_f64;
        for light in lights::BUDGETED {
            let sphere = DistantSphere::<T>::of(&light.light);
            for pair in input::random(6, PAIRS, light.light.angular_radius()) {
                let answer = cap(pair.l.map(T::from_f64), pair.r.map(T::from_f64), &sphere).map(T::to_f64);
                worst = worse(worst, (answer.iter().map(|lane| lane * lane).sum::<f64>().sqrt() - 1.0).abs());
            }
        }
        worst
    }
}

#[test]
fn cap_gives_length_one_without_normalizing() {
    for format in Format::ALL {
        assert_tight(format.visit(Length), budget::cap_length(format, 1.0), format.name());
    }
}

/// Worst error of direction in radians and of length, over lengths from `shortest` to `longest`.
struct Normalize {
    shortest: f64,
    longest: f64,
}

impl Visitor for Normalize {
    type Output = [f64; 2];

    fn visit<T: Real>(self) -> [f64; 2] {
        let mut worst = [0.0_f64; 2];
        let pairs = input::random(2, PAIRS, 0.1);
        for (index, pair) in pairs.enumerate() {
            let part = index as f64 / PAIRS as f64;
            let length = self.shortest * (self.longest / self.shortest).powf(part);
            let v = pair.l.map(|lane| T::from_f64(lane * length));
            let unit = normalize(v).map(T::to_f64);
            worst[0] = worse(worst[0], oracle::angle_between(unit, v.map(T::to_f64)));
            worst[1] = worse(worst[1], (unit.iter().map(|lane| lane * lane).sum::<f64>().sqrt() - 1.0).abs());
        }
        worst
    }
}

/// The measure of `normalize` in a format whose answers are a step off in one lane.
struct StepOff(Normalize);

impl Visitor for StepOff {
    type Output = [f64; 2];

    fn visit<T: Real>(self) -> [f64; 2] {
        self.0.visit::<Off<T, 1>>()
    }
}

#[test]
fn a_step_in_one_lane_is_seen() {
    for format in Format::ALL {
        let [aim::Span { from, to, .. }] = aim::LENGTHS[format as usize];
        let found = format.visit(StepOff(Normalize { shortest: from, longest: to }));
        let [direction, _] = budget::normalize(format);
        println!("{}: {:.2} of the budget", format.name(), found[0] / direction);
        assert!(found[0] > direction, "{}", format.name());
    }
}

#[test]
fn normalize_keeps_direction_and_gives_length_one() {
    for format in Format::ALL {
        let [aim::Span { from, to, .. }] = aim::LENGTHS[format as usize];
        let worst = format.visit(Normalize { shortest: from, longest: to });
        let [direction, length] = budget::normalize(format);
        assert_tight(worst[0], direction, &format!("direction in {}", format.name()));
        assert_tight(worst[1], length, &format!("length in {}", format.name()));
    }
}

/// Worst error of the mirror direction's lanes against exact arithmetic on the same inputs.
struct Reflect;

impl Visitor for Reflect {
    type Output = f64;

    fn visit<T: Real>(self) -> f64 {
        let mut worst = 0.0_f64;
        for pair in input::random(3, PAIRS, 0.1) {
            let (n, v) = (pair.l.map(T::from_f64), pair.r.map(T::from_f64));
            let answer = reflect(n, v).map(T::to_f64);
            let (n, v) = (n.map(T::to_f64), v.map(T::to_f64));
            let twice = 2.0 * (n[0] * v[0] + n[1] * v[1] + n[2] * v[2]);
            for lane in 0..3 {
                worst = worse(worst, (answer[lane] - (twice * n[lane] - v[lane])).abs());
            }
        }
        worst
    }
}

#[test]
fn reflect_is_within_a_step_in_fixed_point() {
    let budgets = [
        (Format::F32, 4.0e-7),
        (Format::Micromath, 4.0e-7),
        (Format::F16, 3.0e-3),
        (Format::I2F14, 0.5005 / 16384.0),
        (Format::I2F30, 1.001 / 1_073_741_824.0),
        (Format::I16F16, 0.501 / 65536.0),
    ];
    for (format, budget) in budgets {
        assert_tight(format.visit(Reflect), budget, format.name());
    }
}

/// The shader that the formula was published with calls `reflect` with the surface-to-camera direction, which gives
/// `-r`; its formula does not mind.
#[test]
fn factored_is_even_in_the_mirror_direction() {
    let sphere = DistantSphere::<f32>::new(&SUN);
    for pair in input::random(4, PAIRS, SUN.angular_radius()) {
        let (l, r) = (pair.l.map(f32::from_f64), pair.r.map(f32::from_f64));
        assert_eq!(factored(l, r, &sphere), factored(l, r.map(|lane| -lane), &sphere));
    }
}
