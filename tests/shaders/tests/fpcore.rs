//! The FPCore snippets: well formed, and what they say is what the crate computes.

use std::f64::consts::PI;

use oorandom::Rand64;
use shaders::fpcore::{Core, Expression, cores};
use shaders::sources::{Language, Snippet};
use shaders::{of, source};
use sunglint::highlight::{DiscGgx, Highlight, PointGgx, smith};
use sunglint::oracle;
use sunglint::oracle::highlight::Pixel;
use sunglint::trial::gloss::{CASES, Case};
use sunglint::trial::lights::BUDGETED;
use sunglint::trial::{Format, Method, budget, input, judge_code};
use sunglint::{DistantSphere, cap};

fn core(file: &str, symbol: &str) -> Core {
    let cores = cores(source(file)).expect("well formed");
    cores.into_iter().find(|core| core.symbol == symbol).unwrap_or_else(|| panic!("{file} has no {symbol}"))
}

/// The logarithm evenly.
fn between(from: f64, to: f64, random: &mut Rand64) -> f64 {
    from * (to / from).powf(random.rand_float())
}

fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

#[test]
fn every_core_has_a_name_a_precision_and_a_precondition() {
    for Snippet { file, source, .. } in of(Language::Fpcore) {
        let cores = cores(source).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert!(!cores.is_empty(), "{file}");
        for core in cores {
            let property =
                |key: &str| core.properties.get(key).unwrap_or_else(|| panic!("{} has no {key}", core.symbol));
            assert!(matches!(property(":name"), Expression::Text(_)));
            assert_eq!(property(":precision"), &Expression::Word("binary32".to_owned()));
            let zero = vec![0.0; core.arguments.len()];
            core.admits(&zero).unwrap_or_else(|error| panic!("{}: {error}", core.symbol));
            let far = vec![1e9; core.arguments.len()];
            assert_eq!(core.admits(&far), Ok(false), "{}", core.symbol);
        }
    }
}

#[test]
fn what_is_wrong_is_found() {
    for wrong in ["(FPCore f (x) (+ x 1)", "(FPCore f (x) :name \"a\")", "(f)", ")", "(FPCore f (x) :name \"a\" b c)"] {
        assert!(cores(wrong).is_err(), "{wrong}");
    }
    for wrong in ["(FPCore f (x) (+ x y))", "(FPCore f (x) (plus x x))", "(FPCore f (x) (< x 1))"] {
        let core = &cores(wrong).expect("well formed")[0];
        assert!(core.value(&[1.0], false).is_err(), "{wrong}");
    }
}

#[test]
fn the_versine_does_not_cancel() {
    const BUDGET: f64 = 2.2e-7;
    let core = core("cap.fpcore", "versine");
    let mut random = Rand64::new(1);
    let mut worst: f64 = 0.0;
    for _ in 0..10_000 {
        let x = single(between(1e-6, 1.0, &mut random));
        assert_eq!(core.admits(&[x]), Ok(true));
        let exact = oracle::closed::versine(x);
        let [value, in_f64] = [true, false].map(|single| core.value(&[x], single).expect("a number"));
        assert!((in_f64 / exact - 1.0).abs() < 1e-15);
        // The specification subtracts from 1, which leaves an error of a step of 1.
        assert!((core.specified(&[x]).expect("a number") - exact).abs() < 3e-16);
        worst = worst.max((value / exact - 1.0).abs());
    }
    assert!(worst < BUDGET && worst > BUDGET / 4.0, "{worst:e}");
}

#[test]
fn the_lanes_of_cap_keep_the_budgets_of_f32() {
    let core = core("cap.fpcore", "cap");
    for (place, light) in BUDGETED.iter().enumerate() {
        let x = single(light.light.sin());
        let lane = |l: [f64; 3], r: [f64; 3], first: usize| {
            let [l, r] = [l, r].map(|v| [0, 1, 2].map(|next| v[(first + next) % 3]));
            let arguments = [l[0], l[1], l[2], r[0], r[1], r[2], x];
            let admitted = core.admits(&arguments).expect("a truth");
            (admitted, core.value(&arguments, true).expect("a number") as f32)
        };
        let refused = std::cell::Cell::new(0);
        let code = |l: [f32; 3], r: [f32; 3]| {
            let [l, r] = [l, r].map(|v| v.map(f64::from));
            let lanes = [0, 1, 2].map(|first| lane(l, r, first));
            if lanes.iter().any(|(admitted, _)| !admitted) {
                refused.set(refused.get() + 1);
            }
            lanes.map(|(_, value)| value)
        };
        let theta = light.light.angular_radius();
        let pairs = input::random(1, 5_000, theta).chain(input::hard(theta));
        let judged = judge_code::<f32>(Method::Cap, code, &light.light, pairs, Format::F32.step());
        let budget = budget::maximum(Method::Cap, Format::F32, place).expect("a budget");
        let worst = judged.worst.error;
        assert!(worst <= budget && worst > budget / 4.0, "{}: {worst:e}, budget {budget:e}", light.name);
        // Only opposite directions are outside of the precondition.
        assert!(refused.get() < 150, "{}", refused.get());
    }
}

/// Relative error of a core in f32 against itself in f64, over inputs that `draw` makes.
fn rounding(core: &Core, count: usize, mut draw: impl FnMut(&mut Rand64) -> Vec<f64>) -> f64 {
    let mut random = Rand64::new(2);
    let mut worst: f64 = 0.0;
    for _ in 0..count {
        let arguments: Vec<_> = draw(&mut random).into_iter().map(single).collect();
        if core.admits(&arguments) == Ok(true) {
            let [rounded, exact] = [true, false].map(|single| core.value(&arguments, single).expect("a number"));
            worst = worst.max((rounded / exact - 1.0).abs());
        }
    }
    worst
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    v.map(|lane| lane / dot(v, v).sqrt())
}

/// What of the normal's part across the half vector of `v` and `l` is across `l - v` and along it, squared, and the
/// cosine between the viewer and the half vector.
fn seen(&Pixel { n, v, .. }: &Pixel, l: [f64; 3]) -> [f64; 3] {
    let h = unit([0, 1, 2].map(|lane| l[lane] + v[lane]));
    let apart = [0, 1, 2].map(|lane| n[lane] - h[lane]);
    let radial = dot(apart, h);
    let side = [0, 1, 2].map(|lane| apart[lane] - radial * h[lane]);
    let along = dot(side, unit([0, 1, 2].map(|lane| l[lane] - v[lane])));
    let along = along * along;
    [(dot(side, side) - along).max(0.0), along, dot(v, h)]
}

/// The density of half vectors that a method has made its highlight of.
fn density(highlight: impl Highlight<f64>, Case { alpha, .. }: Case, pixel: &Pixel, l: [f64; 3]) -> f64 {
    let gloss = highlight.shade(pixel.n, pixel.v, pixel.l);
    gloss.level * gloss.gain / smith(dot(pixel.n, l), dot(pixel.n, pixel.v), alpha)
}

#[test]
fn disc_ggx_is_the_crate_s() {
    let core = core("disc_ggx_dir.fpcore", "disc_ggx");
    for case in CASES {
        let sphere = DistantSphere::<f64>::of(&case.light);
        let mut tried = 0;
        for pixel in case.pixels(1, 2000).map(|pixel| pixel.unit()) {
            let [across, along, vh] = seen(&pixel, pixel.l);
            let arguments = [across, along, vh, case.alpha, case.light.versine()];
            if core.admits(&arguments) != Ok(true) {
                continue;
            }
            let own = density(DiscGgx::directional(&sphere, case.alpha), case, &pixel, pixel.l);
            let value = core.value(&arguments, false).expect("a number");
            let facing = 1.0 - case.light.versine() / 2.0;
            assert!((value / (own * facing) - 1.0).abs() < 1e-9, "{}: {value:e}, {own:e}", case.name);
            tried += 1;
        }
        assert!(tried > 1000, "{}: {tried}", case.name);
    }
    const BUDGET: f64 = 7.1e-6;
    let worst = rounding(&core, 50_000, |random| {
        let w = between(1e-9, 0.1, random);
        let m = (between(0.1, 10.0, random) * w).min(0.25);
        let share = random.rand_float();
        vec![m * share, m - m * share, between(0.1, 1.0, random), between(5e-4, 1.0, random), w]
    });
    assert!(worst < BUDGET && worst > BUDGET / 4.0, "{worst:e}");
}

#[test]
fn karis_is_the_crate_s() {
    let core = core("karis.fpcore", "karis");
    for case in CASES {
        let sphere = DistantSphere::<f64>::of(&case.light);
        for pixel in case.pixels(1, 1000).map(|pixel| pixel.unit()) {
            let twice = 2.0 * dot(pixel.n, pixel.v);
            let nearest = cap(pixel.l, [0, 1, 2].map(|lane| twice * pixel.n[lane] - pixel.v[lane]), &sphere);
            let [across, along, _] = seen(&pixel, nearest);
            let arguments = [across + along, case.alpha, case.light.sin()];
            if core.admits(&arguments) == Ok(true) && dot(pixel.n, nearest) > 0.0 {
                let own = density(PointGgx::karis(&sphere, case.alpha), case, &pixel, nearest);
                let value = core.value(&arguments, false).expect("a number");
                assert!((value / own - 1.0).abs() < 1e-8, "{}: {value:e}, {own:e}", case.name);
            }
        }
    }
    const BUDGET: f64 = 7.0e-7;
    let worst = rounding(&core, 50_000, |random| {
        vec![between(1e-9, 0.5, random), between(5e-4, 1.0, random), between(1e-6, 1.0, random)]
    });
    assert!(worst < BUDGET && worst > BUDGET / 4.0, "{worst:e}");
    // A facet that faces the viewer under a point is as bright as the peak.
    let peak = core.value(&[0.0, 0.5, 0.0], false).expect("a number");
    assert!((peak * PI * 0.25 - 1.0).abs() < 1e-15);
}
