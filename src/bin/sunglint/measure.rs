//! Stand-in for the measurement: numbers of a plausible size, so that the outputs can be looked at.

use indicatif::ProgressBar;

use crate::options::Options;
use crate::result::{QuantityRow, Row, Study};

const LIGHTS: [(&str, f64); 5] = [
    ("Sun from Earth", 0.004650467),
    ("Sun from Mars", 0.0030521),
    ("Sun from Jupiter", 0.000893566),
    ("area light 0.05", 0.05),
    ("area light 0.5", 0.5),
];
const METHODS: [&str; 4] = ["epic", "factored", "disc", "cap"];
const FORMATS: [(&str, f64, f64); 7] = [
    ("f64", 3e-16, 1.3),
    ("f32", 7e-8, 1.0),
    ("micromath", 1e-7, 0.62),
    ("f16", 3.9e-4, 6.5),
    ("I2F14", 9e-5, 0.5),
    ("I2F30", 2e-9, 0.9),
    ("I16F16", 2.6e-5, 1.1),
];

/// Names of the lights that can be asked for.
pub fn light_names() -> Vec<String> {
    LIGHTS.iter().map(|(name, _)| (*name).to_owned()).collect()
}

/// Measures what `options` asks for.
pub fn run(options: &Options, progress: &ProgressBar) -> Study {
    let lights: Vec<_> = LIGHTS.iter().filter(|light| options.wants(light.0)).collect();
    progress.set_length((lights.len() * METHODS.len() * FORMATS.len()) as u64);
    let mut rows = Vec::new();
    for light in lights {
        for (method, name) in METHODS.iter().enumerate() {
            for format in 0..FORMATS.len() {
                progress.set_message(format!("{}, {name}", light.0));
                rows.push(row(light, method, format));
                progress.inc(1);
            }
        }
    }
    Study {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        seed: options.seed,
        quick: options.quick,
        rows,
        quantities: quantities(),
    }
}

fn row(&(light, ratio): &(&str, f64), method: usize, format: usize) -> Row {
    let (name, base, pace) = FORMATS[format];
    let theta = ratio.asin();
    let cost = pace * [1.25, 1.0, 0.8, 1.1][method] * (1.0 + 0.03 * format as f64);
    let (factor, failure) = outcome(method, name, theta);
    let error = base * factor * (1.0 + 0.1 * ratio);
    let model = if method < 2 { 0.4 * theta.powi(2) } else { 1e-17 };
    Row {
        light: light.to_owned(),
        ratio,
        theta,
        method: METHODS[method].to_owned(),
        format: name.to_owned(),
        cost,
        cost_low: cost * 0.97,
        cost_high: cost * 1.04,
        error_max: error,
        error_rms: error * 0.37,
        model_max: model,
        model_rms: model * 0.5,
        total_max: error + model,
        total_rms: (error + model) * 0.4,
        samples: 2_000_000,
        non_finite: if error.is_nan() { 2_000_000 } else { 0 },
        failure,
        worst_angle: theta * 1.3,
        worst_l: "0x3f7f1234 00000000 bc8a11ff".to_owned(),
        worst_r: "0x3f7f12aa 3a000000 3c8a11ff".to_owned(),
        frontier: false,
        total_frontier: false,
    }
}

fn outcome(method: usize, format: &str, theta: f64) -> (f64, Option<String>) {
    let fixed = format.starts_with('I');
    match (METHODS[method], format) {
        ("epic", "f16") => (f64::NAN, Some("NaN".to_owned())),
        ("epic", "I2F14") => (1.1e4, Some("disc lost".to_owned())),
        ("epic", "I16F16") => (3.3e4, Some("disc lost".to_owned())),
        ("epic", _) if fixed => (4.7e8, Some("disc lost".to_owned())),
        ("disc", "f16") if theta < 0.04 => (77.0, Some("disc lost".to_owned())),
        ("epic", _) => (60.0, None),
        ("disc", _) => (3.0, None),
        ("factored", _) => (1.15, None),
        _ => (1.0, None),
    }
}

fn quantities() -> Vec<QuantityRow> {
    let names = ["size_factor", "sin_theta", "cos_theta", "solid_angle"];
    let formats = [("f32", "ULP", 0.5), ("U16F48", "LSB", 0.9), ("f16", "ULP", 0.5)];
    let each = |name: &str| {
        let name = name.to_owned();
        formats.map(|(format, unit, error)| QuantityRow {
            quantity: name.clone(),
            format: format.to_owned(),
            unit: unit.to_owned(),
            error_max: error,
            worst_input: 0.0046,
            samples: 100_000,
            refused: if format == "f16" { 412 } else { 0 },
        })
    };
    names.into_iter().flat_map(each).collect()
}
