//! The snippets run: what they compute against the oracle, as exactly as the crate's own f32 and f16, and with roots
//! and quotients as far off as Vulkan allows.

use std::f64::consts::PI;

use half::f16;
use shaders::machine::Width;
use shaders::program::whole;
use shaders::sources::Language;
use shaders::{Arithmetic, Program, Value, source, without_precision};
use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::trial::gloss::{ALBEDO, CASES, Case, F0};
use sunglint::trial::lights::BUDGETED;
use sunglint::trial::{Format, Judgement, Light, Method, Shading, budget, input, judge_code};
use sunglint::{Real, SUN};

/// A snippet in GLSL, which is HLSL in other words (`tests/translation.rs`), and in WGSL.
fn programs(stem: &str) -> [(&'static str, Program); 2] {
    let glsl = whole(Language::Glsl, source(&format!("{stem}.glsl")), stem);
    let wgsl = whole(Language::Wgsl, source(&format!("{stem}.wgsl")), stem);
    [("GLSL", Program::glsl(&without_precision(&glsl)).expect("valid")), ("WGSL", Program::wgsl(&wgsl).expect("valid"))]
}

/// Random and hard pairs.
const PAIRS: usize = 100_000;

struct Direction<'a> {
    program: &'a Program,
    function: &'a str,
    arithmetic: &'a Arithmetic,
}

impl Direction<'_> {
    fn of<T: Real>(&self, l: [T; 3], r: [T; 3], light: &Light) -> [T; 3] {
        let constant = |value: f64| Value::Number(T::from_f64(value).to_f64());
        let [l, r] = [l, r].map(|v| Value::Vector(v.map(T::to_f64)));
        let [x, w] = [light.light.sin(), light.light.versine()].map(constant);
        self.program.call(self.function, &[l, r, x, w], self.arithmetic).vector().map(T::from_f64)
    }

    fn judged<T: Real>(&self, light: &Light, format: Format, pairs: usize) -> Judgement<T> {
        let theta = light.light.angular_radius();
        let pairs = input::random(1, pairs, theta).chain(input::hard(theta));
        judge_code::<T>(Method::Cap, |l, r| self.of(l, r, light), &light.light, pairs, format.step())
    }
}

fn tight(worst: f64, budget: f64, what: &str) {
    println!("{what}: {worst:.2e}, budget {budget:.2e}");
    assert!(worst <= budget && worst > budget / 4.0, "{what}: {worst:e}, budget {budget:e}");
}

#[test]
fn cap_keeps_the_crate_s_budgets_of_f32() {
    let arithmetic = Arithmetic::exact(Width::Single);
    for (language, program) in &programs("cap") {
        for (place, light) in BUDGETED.iter().enumerate() {
            let direction = Direction { program, function: "cap", arithmetic: &arithmetic };
            let pairs = if place == 0 { PAIRS } else { PAIRS / 10 };
            let judged = direction.judged::<f32>(light, Format::F32, pairs);
            assert_eq!(judged.undirected, 0);
            let budget = budget::maximum(Method::Cap, Format::F32, place).expect("a budget");
            tight(judged.worst.error, budget, &format!("cap in {language} under {}", light.name));
        }
    }
}

/// Radians under the Sun and each of the other lights with a budget, where roots and quotients are as far off as Vulkan
/// allows, products fused or not, and subnormals are zero.
const CAP_ON_VULKAN: [f64; 6] = [5.1e-8, 4.8e-8, 6.2e-8, 2.2e-7, 3.3e-7, 1.8e-7];

#[test]
fn cap_where_roots_are_off() {
    for (place, light) in BUDGETED.iter().enumerate() {
        let [_, (_, program)] = &programs("cap");
        let worst = Arithmetic::as_vulkan_allows(Width::Single).map(|arithmetic| {
            let direction = Direction { program, function: "cap", arithmetic: &arithmetic };
            direction.judged::<f32>(light, Format::F32, PAIRS / 5).worst.error
        });
        let worst = worst.into_iter().fold(0.0, f64::max);
        tight(worst, CAP_ON_VULKAN[place], &format!("cap on Vulkan under {}", light.name));
    }
}

#[test]
fn cap_half_keeps_the_crate_s_budgets_of_f16() {
    for (language, program) in &programs("cap_half") {
        for (place, light) in BUDGETED.iter().enumerate() {
            let arithmetic = Arithmetic::exact(Width::Half);
            let direction = Direction { program, function: "cap_half", arithmetic: &arithmetic };
            let judged = direction.judged::<f16>(light, Format::F16, PAIRS / 5);
            assert_eq!(judged.undirected, 0);
            let budget = budget::maximum(Method::Cap, Format::F16, place).expect("a budget");
            tight(judged.worst.error, budget, &format!("cap_half in {language} under {}", light.name));
        }
    }
}

/// The same in f16, with subnormals flushed.
const CAP_HALF_ON_VULKAN: [f64; 6] = [4.0e-4, 1.3e-4, 6.0e-4, 4.9e-3, 4.1e-3, 3.4e-3];

#[test]
fn cap_half_where_roots_are_off_and_subnormals_are_zero() {
    let [_, (_, program)] = &programs("cap_half");
    for (place, light) in BUDGETED.iter().enumerate() {
        let worst = Arithmetic::as_vulkan_allows(Width::Half).map(|arithmetic| {
            let direction = Direction { program, function: "cap_half", arithmetic: &arithmetic };
            direction.judged::<f16>(light, Format::F16, PAIRS / 10).worst.error
        });
        let worst = worst.into_iter().fold(0.0, f64::max);
        tight(worst, CAP_HALF_ON_VULKAN[place], &format!("cap_half on Vulkan under {}", light.name));
    }
}

/// What the sources say of their errors is what is held here.
#[test]
fn the_sources_tell_their_budgets() {
    let told = [("cap", Format::F32, CAP_ON_VULKAN[0]), ("cap_half", Format::F16, CAP_HALF_ON_VULKAN[0])];
    for (stem, format, on_vulkan) in told {
        let budget = budget::maximum(Method::Cap, format, 0).expect("a budget");
        assert!(on_vulkan <= budget, "{stem}");
        for ending in ["glsl", "hlsl", "wgsl"] {
            assert!(source(&format!("{stem}.{ending}")).contains(&format!("ithin {budget:e} rad")), "{stem}.{ending}");
        }
    }
    let versine = format!("{:.4e} for the Sun from Earth", SUN.versine());
    assert!(source("disc_ggx_dir.wgsl").contains(&versine), "{versine}");
    assert!(source("cap.glsl").contains(&format!("{:.5} for the Sun from Earth", SUN.sin())));
}

/// Squares that are not scaled are what mediump is known to fail by: the test can tell.
#[test]
fn cap_in_f16_fails_where_squares_are_not_scaled() {
    let [_, (_, program)] = &programs("cap");
    let arithmetic = Arithmetic::exact(Width::Half).flushing();
    let direction = Direction { program, function: "cap", arithmetic: &arithmetic };
    let judged = direction.judged::<f16>(&BUDGETED[0], Format::F16, PAIRS / 10);
    assert!(judged.worst.error > 1e-3, "{:e}", judged.worst.error);
}

#[test]
fn the_ends_of_cap_are_as_documented() {
    let [x, w] = [SUN.sin(), SUN.versine()].map(|value| Value::Number(f64::from(value as f32)));
    let l = [0.0, 0.6, 0.8].map(|lane: f64| f64::from(lane as f32));
    for stem in ["cap", "cap_half"] {
        for (language, program) in &programs(stem) {
            let arithmetic = Arithmetic::exact(Width::Single);
            let turned = |l: [f64; 3], r: [f64; 3]| {
                program.call(stem, &[Value::Vector(l), Value::Vector(r), x, w], &arithmetic).vector()
            };
            let opposite = l.map(|lane| -lane);
            assert_eq!(turned(l, l), l, "{language}");
            assert_eq!(turned(l, opposite), l, "{language}");
            assert_eq!(turned(l, [0.0; 3]), [0.0; 3], "{language}");
            assert!(turned([0.0; 3], l).into_iter().all(f64::is_finite), "{language}");
            let axis = [0.0, 0.0, 1.0];
            let beside = turned(axis, [1e-25, 0.0, -1.0].map(|lane: f64| f64::from(lane as f32)));
            assert!(beside[2] > 0.9, "{language}: {beside:?}");
        }
    }
}

/// One channel of a pixel in a format, of a snippet.
fn level(program: &Program, method: Shading, case: &Case, pixel: &Pixel, arithmetic: &Arithmetic) -> f64 {
    let scalar = |value: f64| f64::from(value as f32);
    let number = |value: f64| Value::Number(scalar(value));
    let colour = |value: f64| Value::Vector([scalar(value); 3]);
    let [n, v, l] = [pixel.n, pixel.v, pixel.l].map(Value::Vector);
    let w = number(case.light.versine());
    let [alpha, f0] = [number(case.alpha), colour(F0)];
    let answer = if method == Shading::Karis {
        program.call("karis_ggx", &[n, v, l, number(case.light.sin()), w, alpha, f0], arithmetic)
    } else {
        program.call("lit_pixel", &[n, v, l, w, alpha, f0, colour(ALBEDO), colour(PI)], arithmetic)
    };
    answer.vector()[1]
}

/// What that is exactly.
fn truth(method: Shading, case: &Case, pixel: &Pixel) -> f64 {
    let rounded = |value: f64| f64::from(value as f32);
    let glossy = Glossy { alpha: rounded(case.alpha), f0: rounded(F0), ratio: case.light.sin() };
    let highlight = method.truth(&glossy, pixel);
    if method == Shading::Karis {
        return highlight;
    }
    let Pixel { n, l, .. } = pixel.unit();
    let cosine: f64 = (0..3).map(|lane| n[lane] * l[lane]).sum();
    rounded(ALBEDO) * cosine.max(0.0) + PI * highlight
}

/// Worst and root mean square of the relative error of pixels.
fn pixel_error(program: &Program, method: Shading, case: &Case, arithmetic: &Arithmetic) -> [f64; 2] {
    let (mut worst, mut squares, mut count) = (0.0_f64, 0.0, 0);
    for pixel in case.pixels(1, 10_000) {
        let rounded = |v: [f64; 3]| v.map(|lane| f64::from(lane as f32));
        let pixel = Pixel { n: rounded(pixel.n), v: rounded(pixel.v), l: rounded(pixel.l) };
        let truth = truth(method, case, &pixel);
        let value = level(program, method, case, &pixel, arithmetic);
        if truth == 0.0 {
            assert_eq!(value, 0.0);
            continue;
        }
        let error = (value / truth - 1.0).abs();
        assert!(error.is_finite());
        worst = worst.max(error);
        squares += error * error;
        count += 1;
    }
    [worst, (squares / f64::from(count)).sqrt()]
}

/// Worst and root mean square of the relative error of pixels, case by case.
type Pixels = [[f64; 2]; CASES.len()];

const DISC_GGX: Pixels = [[1.6e-4, 1.2e-5], [3.4e-6, 4.0e-7], [7.5e-7, 1.3e-7], [1.5e-5, 9.4e-7], [2.0e-6, 2.0e-7]];
const DISC_GGX_ON_VULKAN: Pixels =
    [[6.4e-4, 5.5e-5], [1.1e-5, 2.0e-6], [1.9e-6, 3.6e-7], [6.3e-5, 4.6e-6], [6.4e-6, 6.1e-7]];
const KARIS: Pixels = [[1.9e-4, 1.4e-5], [3.0e-6, 4.8e-7], [9.9e-7, 2.5e-7], [2.0e-5, 1.5e-6], [2.9e-6, 3.7e-7]];
const KARIS_ON_VULKAN: Pixels =
    [[6.1e-4, 6.2e-5], [1.2e-5, 2.1e-6], [2.7e-6, 9.7e-7], [5.9e-5, 6.2e-6], [6.4e-6, 1.3e-6]];

fn hold(stem: &str, method: Shading, exact: &Pixels, on_vulkan: &Pixels) {
    let programs = programs(stem);
    for (place, case) in CASES.iter().enumerate() {
        let arithmetic = Arithmetic::exact(Width::Single);
        for (language, program) in &programs {
            let [worst, rms] = pixel_error(program, method, case, &arithmetic);
            tight(worst, exact[place][0], &format!("{stem} in {language}, {}, worst", case.name));
            tight(rms, exact[place][1], &format!("{stem} in {language}, {}, rms", case.name));
        }
        let [_, (_, program)] = &programs;
        let off = Arithmetic::as_vulkan_allows(Width::Single)
            .map(|arithmetic| pixel_error(program, method, case, &arithmetic));
        let [worst, rms] = [0, 1].map(|figure| off.iter().map(|found| found[figure]).fold(0.0, f64::max));
        tight(worst, on_vulkan[place][0], &format!("{stem} on Vulkan, {}, worst", case.name));
        tight(rms, on_vulkan[place][1], &format!("{stem} on Vulkan, {}, rms", case.name));
    }
}

#[test]
fn disc_ggx_keeps_its_budgets() {
    hold("disc_ggx_dir", Shading::Directional, &DISC_GGX, &DISC_GGX_ON_VULKAN);
}

#[test]
fn karis_keeps_its_budgets() {
    hold("karis", Shading::Karis, &KARIS, &KARIS_ON_VULKAN);
}

#[test]
fn what_faces_away_is_dark() {
    for (stem, function) in [("disc_ggx_dir", "disc_ggx"), ("karis", "karis_ggx")] {
        for (language, program) in &programs(stem) {
            let call = |n: [f64; 3], v: [f64; 3], l: [f64; 3]| {
                let [n, v, l] = [n, v, l].map(Value::Vector);
                let numbers: &[f64] = if stem == "karis" { &[0.0046, 1e-5, 0.01] } else { &[1e-5, 0.01] };
                let numbers = numbers.iter().map(|&number| Value::Number(f64::from(number as f32)));
                let arguments: Vec<_> = [n, v, l].into_iter().chain(numbers).chain([Value::Vector([0.5; 3])]).collect();
                program.call(function, &arguments, &Arithmetic::exact(Width::Single)).vector()
            };
            let up = [0.0, 0.0, 1.0];
            assert!(call(up, up, up)[0] > 1.0, "{language}");
            for (v, l) in
                [([0.0, 0.6, -0.8], up), (up, [0.0, 0.6, -0.8]), (up, [0.0, 0.0, -1.0]), ([1.0, 0.0, 0.0], up)]
            {
                assert_eq!(call(up, v, l), [0.0; 3], "{stem} in {language}: {v:?} {l:?}");
            }
        }
    }
}
