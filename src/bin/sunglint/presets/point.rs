//! A sphere of ratio 0.005 treated as a point.

use std::f64::consts::FRAC_PI_4;

use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::oracle::quadrature::{Lobe, Quadrature};
use sunglint::trial::Shading;
use sunglint::trial::gloss::F0;

use super::row::{CURE, FAILS, PresetRow, TRUTH, figure};
use super::{Axes, Effort, Preset};

/// What is reported, and how it is run.
pub const PRESET: Preset = Preset {
    name: "sphere-as-point",
    source: "KhronosGroup/glTF-Sample-Viewer, issue 547 (2024): no highlight of a light on the smoothest surfaces; \
             o3de's manual (2022) gives directional lights an angular diameter against that",
    question: "What is the highlight of a sphere of ratio 0.005, about the Sun, treated as a point?",
    chart: Some(Axes {
        title: "Difference of the whole highlight from the integral over the disc",
        input: "alpha, the GGX width",
        measure: "relative L1, per cent",
        base: 10.0,
        lowest: 0.001,
    }),
    measure,
    verdict,
};

const RATIO: f64 = 0.005;
const INCIDENCE: f64 = FRAC_PI_4;
const POLISH: f64 = 5e-4;
const ALPHAS: [f64; 8] = [POLISH, 1e-3, 2e-3, 4e-3, 0.01, 0.02, 0.05, 0.1];
const QUICK_ALPHAS: [f64; 4] = [POLISH, 4e-3, 0.02, 0.1];

/// What is good enough, in per cent.
const GOOD: f64 = 1.0;
const ALLOWED: f64 = 10.0;

const L1: &str = "whole highlight off by (relative L1), per cent";
const ENERGY: &str = "all light that is sent out, off by, per cent";
const PEAK: &str = "brightest value off by, per cent";
const WIDTH: &str = "width at half of the brightest value off by, per cent";
const ENOUGH: &str = "alpha from which 1 % is kept";

const POINT: &str = "GGX at the centre, a point";
const METHODS: [Shading; 2] = [Shading::Directional, Shading::ConeGgx];

fn glossy(alpha: f64) -> Glossy {
    Glossy { alpha, f0: F0, ratio: RATIO }
}

/// Whole highlights of the point and of [`METHODS`].
fn lobes(alpha: f64, effort: Effort) -> [Lobe; 3] {
    let glossy = glossy(alpha);
    let values = |pixel: &Pixel| {
        let [directional, cone] = METHODS.map(|method| method.truth(&glossy, pixel));
        [glossy.brdf(pixel), directional, cone]
    };
    match effort {
        Effort::Quick => Quadrature::<6>::new().lobes(&glossy, INCIDENCE, values),
        Effort::Full => Quadrature::<10>::new().lobes(&glossy, INCIDENCE, values),
    }
}

/// The difference from the truth in per cent.
fn off(lobe: &Lobe) -> f64 {
    100.0 * lobe.relative_l1
}

/// A viewer who sees the light's centre mirrored, turned by `away` in the plane of incidence.
fn viewer(away: f64) -> Pixel {
    let (sin, cos) = INCIDENCE.sin_cos();
    let (aside, up) = (INCIDENCE + away).sin_cos();
    Pixel { n: [0.0, 0.0, 1.0], v: [-aside, 0.0, up], l: [sin, 0.0, cos] }
}

/// How far off the mirror direction a highlight falls to half of its value there, in radians.
fn half_width(value: impl Fn(&Pixel) -> f64) -> f64 {
    let half = value(&viewer(0.0)) / 2.0;
    let (mut near, mut far) = (0.0, 0.5);
    for _ in 0..40 {
        let middle = (near + far) / 2.0;
        if value(&viewer(-middle)) > half { near = middle } else { far = middle }
    }
    near
}

/// Peak and width of a form on the polish, in per cent off the true ones.
fn shape(role: &'static str, form: &str, value: impl Fn(&Pixel) -> f64) -> [PresetRow; 2] {
    let (glossy, rule) = (glossy(POLISH), Quadrature::<16>::new());
    let truth = |pixel: &Pixel| rule.highlight(&glossy, pixel);
    let peak = 100.0 * (value(&viewer(0.0)) / truth(&viewer(0.0)) - 1.0).abs();
    let width = 100.0 * (half_width(value) / half_width(truth) - 1.0).abs();
    [PresetRow::new(role, form, PEAK, peak).at_most(ALLOWED), PresetRow::new(role, form, WIDTH, width).at_most(ALLOWED)]
}

fn named(method: Shading) -> &'static str {
    match method {
        Shading::Directional => "DiscGgx::directional",
        _ => "ConeGgx",
    }
}

fn measure(effort: Effort) -> Vec<PresetRow> {
    let alphas: &[f64] = if effort == Effort::Quick { &QUICK_ALPHAS } else { &ALPHAS };
    let found: Vec<_> = alphas.iter().map(|&alpha| (alpha, lobes(alpha, effort))).collect();
    let energy = found.first().map_or(f64::NAN, |(_, [point, ..])| 100.0 * (point.energy - 1.0).abs());
    let glossy = glossy(POLISH);
    let mut rows = vec![
        PresetRow::new(TRUTH, "f64", "radius of the disc, degrees", libm::asin(RATIO).to_degrees()),
        PresetRow::new(TRUTH, POINT, ENERGY, energy),
    ];
    rows.extend(shape(FAILS, POINT, |pixel| glossy.brdf(pixel)));
    for method in METHODS {
        rows.extend(shape(CURE, named(method), |pixel| method.truth(&glossy, pixel)));
    }
    let forms = [POINT, named(METHODS[0]), named(METHODS[1])];
    for (place, form) in forms.into_iter().enumerate() {
        let role = if place == 0 { FAILS } else { CURE };
        let polish = found.first().map_or(f64::NAN, |(_, lobes)| off(&lobes[place]));
        rows.push(PresetRow::new(role, form, L1, polish).at_most(ALLOWED));
        rows.extend(found.iter().map(|(alpha, lobes)| PresetRow::point(form, L1, *alpha, off(&lobes[place]))));
    }
    let points: Vec<_> = found.iter().map(|(alpha, [point, ..])| [*alpha, off(point)]).collect();
    rows.push(PresetRow::new(TRUTH, POINT, ENOUGH, enough(&points)));
    rows
}

/// The width from which the point is within [`GOOD`]: on the straight line, in logarithms, between two that were
/// integrated.
fn enough(points: &[[f64; 2]]) -> f64 {
    let last_above = points.iter().rposition(|[_, off]| *off > GOOD);
    let around = last_above.and_then(|place| points.get(place).zip(points.get(place + 1)));
    let Some((&[a, high], &[b, low])) = around else {
        return f64::NAN;
    };
    let share = (high / GOOD).ln() / (high / low).ln();
    (a.ln() + share * (b / a).ln()).exp()
}

fn verdict(rows: &[PresetRow]) -> String {
    format!(
        "On a polish (alpha {POLISH}) a point is {} % too bright and {} % too narrow; DiscGgx::directional is within \
         {} % and ConeGgx within {} % of the whole highlight. From alpha {} on a point is good to 1 %.",
        figure(rows, POINT, PEAK),
        figure(rows, POINT, WIDTH),
        figure(rows, named(METHODS[0]), L1),
        figure(rows, named(METHODS[1]), L1),
        figure(rows, POINT, ENOUGH)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a straight line says that a point is good to one per cent, the integral says so too.
    #[test]
    fn the_width_from_which_a_point_is_enough_is_where_it_should_be() {
        let error = |alpha: f64| off(&lobes(alpha, Effort::Quick)[0]);
        let all = ALPHAS.map(|alpha| [alpha, error(alpha)]);
        let alpha = enough(&all);
        let [above, below] = [0.9, 1.1].map(|factor| error(factor * alpha));
        assert!(above > GOOD && below < GOOD, "{alpha}: {above} {below}");
        assert!(enough(&[]).is_nan() && enough(&all[..2]).is_nan());
    }

    /// A light in one direction makes `D V F (n.l)` itself, and a viewer `away` sees as much less as GGX says.
    #[test]
    fn the_half_width_of_a_point_is_that_of_ggx() {
        let glossy = glossy(POLISH);
        // D falls to a half at a tangent of alpha sqrt(sqrt(2) - 1) of the half vector, which turns half as far.
        let expected = 2.0 * POLISH * (2_f64.sqrt() - 1.0).sqrt();
        let found = half_width(|pixel| glossy.brdf(pixel));
        assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    }
}
