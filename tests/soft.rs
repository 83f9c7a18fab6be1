//! f32 in integers: directions against the oracle, beside what float arithmetic makes of the same inputs, and the
//! special cases.

mod exact;

use exact::assert_tight;
use oorandom::Rand64;
use sunglint::raw::{SUN_Q30, SphereQ30};
use sunglint::trial::{Format, Method, budget, input, lights};
use sunglint::{DistantLight, DistantSphere, oracle, soft, specular};

const PAIRS: usize = 100_000;

fn wide(v: [f32; 3]) -> [f64; 3] {
    v.map(f64::from)
}

/// Greatest and root mean square.
#[derive(Clone, Copy, Default)]
struct Errors {
    max: f64,
    squares: f64,
    count: f64,
}

impl Errors {
    fn add(&mut self, error: f64) {
        self.max = if error > self.max || error.is_nan() { error } else { self.max };
        self.squares += error * error;
        self.count += 1.0;
    }

    fn rms(self) -> f64 {
        (self.squares / self.count).sqrt()
    }
}

/// Errors of `cap` by integers, less what rounding the lanes to Q30 does beside `-l`, where the rim's side hangs on
/// them; and away from there those by integers, by floats, and of storing the exact answer in f32.
fn errors_of_cap(light: &DistantLight, seed: u64) -> [Errors; 4] {
    let (sphere, floats) = (SphereQ30::of(light), DistantSphere::<f32>::of(light));
    let theta = light.angular_radius();
    let mut errors = [Errors::default(); 4];
    for pair in input::random(seed, PAIRS, theta).chain(input::hard(theta)) {
        let (l, r) = (pair.l.map(|lane| lane as f32), pair.r.map(|lane| lane as f32));
        if !Method::Cap.is_defined(wide(l), wide(r), light, Format::F32.step()) {
            continue;
        }
        let truth = oracle::nearest_in_disc(wide(l), wide(r), theta);
        let off = |answer: [f32; 3]| oracle::angle_between(wide(answer), truth);
        let gap = oracle::angle_between(wide(l), wide(r).map(|lane| -lane));
        let answer = off(soft::cap(l, r, &sphere));
        errors[0].add((answer - BESIDE * light.sin() / gap).max(0.0));
        if gap > 0.1 {
            errors[1].add(answer);
            errors[2].add(off(specular::cap(l, r, &floats)));
            errors[3].add(off(truth.map(|lane| lane as f32)));
        }
    }
    errors
}

/// The root of six times half a step of Q30: how far rounding can move `l` and `r` against each other.
const BESIDE: f64 = 1.15e-9;

#[test]
fn cap_is_off_by_little_more_than_its_answer_takes_to_store() {
    for (light, bound) in lights::BUDGETED.into_iter().zip(budget::SOFT_CAP) {
        let [all, soft, floats, stored] = errors_of_cap(&light.light, 1);
        println!(
            "{}: rms {:.3e}, {:.3e} in floats, {:.3e} to store",
            light.name,
            soft.rms(),
            floats.rms(),
            stored.rms()
        );
        println!(
            "max {:.3e}, {:.3e} in floats, {:.3e} to store; all {:.3e}",
            soft.max, floats.max, stored.max, all.max
        );
        assert_tight(light.name, all.max, bound);
        assert!(soft.rms() <= 1.01 * floats.rms() && soft.rms() <= 2.0 * stored.rms());
    }
}

#[test]
fn reflections_and_unit_vectors_are_off_by_little_more_than_they_take_to_store() {
    let (mut reflected, mut turned) = (0.0_f64, 0.0_f64);
    let mut source = Rand64::new(7);
    for pair in input::random(2, PAIRS, 0.1) {
        let (n, v) = (pair.l.map(|lane| lane as f32), pair.r.map(|lane| lane as f32));
        let dot: f64 = (0..3).map(|i| f64::from(n[i]) * f64::from(v[i])).sum();
        let answer = soft::reflect(n, v);
        for i in 0..3 {
            let exact = 2.0 * dot * f64::from(n[i]) - f64::from(v[i]);
            reflected = reflected.max((f64::from(answer[i]) - exact).abs());
        }
        // From the least numbers to the greatest.
        let length = 2.0_f64.powf(source.rand_float() * 270.0 - 143.0);
        let long = pair.l.map(|lane| (lane * length) as f32);
        let unit = soft::normalize(long);
        turned = turned.max(oracle::angle_between(wide(unit), wide(long)));
        let size = wide(unit).map(|lane| lane * lane).iter().sum::<f64>().sqrt();
        assert!((size - 1.0).abs() < 6e-8, "{long:?}: {size}");
    }
    assert_tight("reflect", reflected, 6.1e-8);
    assert_tight("normalize", turned, budget::SOFT_NORMALIZE);
}

#[test]
fn inside_the_disc_the_answer_is_the_mirror_ray_itself() {
    let l = [0.6, 0.0, 0.8];
    for r in [[0.6, 0.0, 0.8], [0.601, 0.001, 0.799_249_67], [0.598_5, -0.002, 0.801_118_1]] {
        let answer = soft::cap(l, r, &SUN_Q30);
        // Lanes below 2^-7 are rounded to 2^-30.
        assert!((0..3).all(|i| answer[i] == r[i] || (answer[i] - r[i]).abs() < 4.7e-10), "{answer:?}");
    }
}

const BROKEN: [f32; 8] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 2.0, -2.0, 1e10, f32::MAX, f32::MIN];

#[test]
fn what_is_no_direction_has_the_documented_answers() {
    let (l, r, zero) = ([0.0, 0.6, 0.8], [0.8, 0.0, 0.6], [0.0; 3]);
    for broken in BROKEN {
        for place in 0..3 {
            let with = |mut v: [f32; 3]| {
                v[place] = broken;
                v
            };
            assert_eq!(soft::cap(with(l), r, &SUN_Q30), zero);
            assert_eq!(soft::cap(l, with(r), &SUN_Q30), l);
            assert_eq!([soft::reflect(with(l), r), soft::reflect(l, with(r))], [zero; 2]);
            let direction = soft::normalize(with(zero));
            let unit = if broken.is_finite() { with(zero).map(|lane| lane / broken.abs()) } else { zero };
            assert_eq!(direction, unit);
        }
    }
    assert_eq!(soft::cap(l, zero, &SUN_Q30), zero);
    assert_eq!(soft::cap(l, l.map(|lane| -lane), &SUN_Q30), l);
    assert_eq!(soft::normalize(zero), zero);
    assert_eq!(soft::normalize([-0.0, 0.0, -0.0]), zero);
}

#[test]
fn lengths_at_the_ends_of_f32_have_their_direction() {
    for length in [1e-45, 4e-45, f32::MIN_POSITIVE / 2.0, f32::MIN_POSITIVE, 1e-19, 1.0, 1e19, f32::MAX] {
        assert_eq!(soft::normalize([0.0, -length, 0.0]), [0.0, -1.0, 0.0], "{length:e}");
    }
    // 3, 4 and 5 of the least number.
    let [three, four] = [3, 4].map(f32::from_bits);
    assert_eq!(soft::normalize([three, 0.0, -four]), [0.6, 0.0, -0.8]);
    assert_eq!(soft::normalize([f32::MAX, f32::from_bits(1), 0.0]), [1.0, 0.0, 0.0]);
}

/// All inputs are in `tests/exhaustive.rs`.
#[test]
fn roots_are_those_of_the_definition() {
    assert_eq!([soft::root(2.25), soft::reciprocal_root(0.0625)], [1.5, 4.0]);
    assert_eq!(soft::root(-0.0).to_bits(), (-0.0_f32).to_bits());
    assert_eq!([soft::reciprocal_root(0.0), soft::reciprocal_root(-0.0)], [f32::INFINITY, f32::NEG_INFINITY]);
    assert_eq!([soft::root(f32::INFINITY), soft::reciprocal_root(f32::INFINITY)], [f32::INFINITY, 0.0]);
    for number in [-1.0, -1e-45, f32::NEG_INFINITY, f32::NAN] {
        assert!(soft::root(number).is_nan() && soft::reciprocal_root(number).is_nan(), "{number}");
    }
    for bits in (0..0x7f80_0000).step_by(9973) {
        let x = f32::from_bits(bits);
        assert_eq!(soft::root(x), x.sqrt(), "{x:e}");
        assert_eq!(soft::reciprocal_root(x), (1.0 / f64::from(x).sqrt()) as f32, "{x:e}");
    }
}
