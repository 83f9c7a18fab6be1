//! The brightness of a distant light by its solid angle.

use std::f32::consts::PI;

use sunglint::DistantLight;
use sunglint::normalization::{inverse_size_factor, solid_angle};
use sunglint::oracle;

use super::row::{CURE, FAILS, PresetRow, TRUTH, figure};
use super::{Axes, Effort, Preset};

/// What is reported, and how it is run.
pub const PRESET: Preset = Preset {
    name: "distant-light-angle",
    source: "LuxCoreRender/LuxCore, issue 298 (2020), which gives 1 / (2 pi (1 - cos theta)) with the cosine kept \
             below 1, which is left out here; PixarAnimationStudios/OpenUSD, pull request 3182 (2025), on UsdLux \
             DistantLight, whose sizeFactor is 1 at an angle of 0",
    question: "By what does a distant light grow brighter as its angle shrinks, 1 / solid angle, in f32?",
    chart: Some(Axes {
        title: "Factor of a distant light, f32",
        input: "angle (diameter), degrees",
        measure: "error, per cent",
        base: 10.0,
        lowest: 1e-6,
    }),
    measure,
    verdict,
};

const ANGLES: [f64; 3] = [0.53, 0.1, 0.02];

/// On the chart.
const CHARTED: [f64; 16] = [0.03, 0.04, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.53, 0.8, 1.5, 3.0, 6.0, 15.0, 60.0];

const PLAIN: &str = "1 / (2 pi (1 - cos theta)), f32";
const OURS: &str = "1 / solid_angle(x), f32";
const POINT: &str = "inverse_size_factor(0), f32";

fn plain(theta: f32) -> f64 {
    (1.0 / (2.0 * PI * (1.0 - libm::cosf(theta)))).into()
}

/// Of the sine, which is what a light described by radius and distance has anyway.
fn ours(x: f32) -> f64 {
    solid_angle(x).map_or(f64::NAN, |angle| (1.0 / angle).into())
}

/// Errors of both in per cent, each of what was rounded into f32.
fn errors(angle: f64) -> [f64; 2] {
    let theta = (angle / 2.0).to_radians() as f32;
    let x = DistantLight::from_angle(angle).map_or(f32::NAN, |light| light.sin() as f32);
    let off = |factor: f64, theta: f64| 100.0 * (factor * oracle::solid_angle(theta) - 1.0).abs();
    [off(plain(theta), theta.into()), off(ours(x), libm::asin(x.into()))]
}

fn off_at(angle: f64) -> String {
    format!("off at {angle} degrees, per cent")
}

const AT_ZERO: &str = "factor at 0 degrees";
const OFF: &str = "off, per cent";

fn measure(_effort: Effort) -> Vec<PresetRow> {
    let mut rows = vec![PresetRow::new(TRUTH, "UsdLux, a light without size", AT_ZERO, 1.0)];
    for angle in ANGLES {
        let [plain, ours] = errors(angle);
        rows.push(PresetRow::new(FAILS, PLAIN, &off_at(angle), plain).at_most(0.1));
        rows.push(PresetRow::new(CURE, OURS, &off_at(angle), ours).at_most(0.1));
    }
    let zero = inverse_size_factor(0.0_f32).map_or(f64::NAN, f64::from);
    rows.push(PresetRow::new(FAILS, PLAIN, AT_ZERO, plain(0.0)).at_most(1.0));
    rows.push(PresetRow::new(CURE, POINT, AT_ZERO, zero).at_most(1.0));
    for angle in CHARTED {
        let [plain, ours] = errors(angle);
        rows.extend([PresetRow::point(PLAIN, OFF, angle, plain), PresetRow::point(OURS, OFF, angle, ours)]);
    }
    rows
}

fn verdict(rows: &[PresetRow]) -> String {
    format!(
        "By the cosine the factor is {} % off for the Sun's angle and {} % at {} degrees, and at 0 it is {}; by the \
         sine {} %, {} %, and {} for a light without size.",
        figure(rows, PLAIN, &off_at(ANGLES[0])),
        figure(rows, PLAIN, &off_at(ANGLES[1])),
        ANGLES[1],
        figure(rows, PLAIN, AT_ZERO),
        figure(rows, OURS, &off_at(ANGLES[0])),
        figure(rows, OURS, &off_at(ANGLES[1])),
        figure(rows, POINT, AT_ZERO)
    )
}
