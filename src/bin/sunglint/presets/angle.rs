//! The angle between two vectors by the arc cosine of their dot product.

use sunglint::oracle::{self, angle_between};
use sunglint::trial::input;
use sunglint::{Real, SUN};

use super::row::{CURE, FAILS, PresetRow, TRUTH, figure, per_cent, worst};
use super::{Effort, Preset};

/// What is reported, and how it is run.
pub const PRESET: Preset = Preset {
    name: "angle-by-acos",
    source: "opentk/opentk, issue 222 (2015), cured by a clamp; godotengine/godot, issue 8111 (2017): no number for \
             vectors that are parallel",
    question: "What is the angle between a unit vector and itself, or one that is a Sun's radius away, in f32?",
    chart: None,
    measure,
    verdict,
};

const NO_NUMBER: &str = "vectors whose angle to themselves is no number, per cent";
const ITSELF: &str = "angle of a vector to itself at most, per cent of the Sun's radius";
const BESIDE: &str = "angle of the Sun's radius off by at most, per cent";

const PLAIN: &str = "acos(a.b), f32";
const CLAMPED: &str = "acos(clamp(a.b, -1, 1)), f32";
const CROSS: &str = "atan2(|a x b|, a.b), f32";
const CHORD: &str = "2 asin(|a - b| / 2), f32";

type Form = fn([f32; 3], [f32; 3]) -> f32;

fn plain(a: [f32; 3], b: [f32; 3]) -> f32 {
    libm::acosf(<f32 as Real>::dot(a, b))
}

fn clamped(a: [f32; 3], b: [f32; 3]) -> f32 {
    libm::acosf(<f32 as Real>::dot(a, b).clamp(-1.0, 1.0))
}

fn by_cross_product(a: [f32; 3], b: [f32; 3]) -> f32 {
    let cross = [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
    libm::atan2f(<f32 as Real>::dot(cross, cross).sqrt(), <f32 as Real>::dot(a, b))
}

/// By the chord, as this crate compares directions everywhere.
fn chord(a: [f32; 3], b: [f32; 3]) -> f32 {
    let square = <f32 as Real>::square([0, 1, 2].map(|i| a[i] - b[i]));
    2.0 * libm::asinf(square.sqrt() / 2.0)
}

/// Unit vectors, and others a Sun's radius away.
fn pairs(count: usize) -> impl Iterator<Item = [[f32; 3]; 2]> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    input::random(9, count, 0.1).enumerate().map(|(index, pair)| {
        let beside = oracle::cone::at(pair.l, SUN.angular_radius(), (index as f64 * GOLDEN).fract());
        [pair.l, beside].map(|vector| vector.map(|lane| lane as f32))
    })
}

fn rows_of(form: &str, angle: Form, count: usize) -> [(f64, &'static str, String); 3] {
    let itself: Vec<_> = pairs(count).map(|[a, _]| f64::from(angle(a, a))).collect();
    let lost = itself.iter().filter(|angle| angle.is_nan()).count();
    let greatest = worst(itself.iter().copied().filter(|angle| !angle.is_nan()));
    let off = pairs(count).map(|[a, b]| {
        let truth = angle_between(a.map(f64::from), b.map(f64::from));
        100.0 * (f64::from(angle(a, b)) / truth - 1.0).abs()
    });
    let radius = SUN.angular_radius();
    [
        (per_cent(lost, count), NO_NUMBER, form.to_owned()),
        (100.0 * greatest / radius, ITSELF, form.to_owned()),
        (worst(off), BESIDE, form.to_owned()),
    ]
}

fn measure(effort: Effort) -> Vec<PresetRow> {
    let count = effort.count(10_000, 100_000);
    let mut rows = vec![PresetRow::new(TRUTH, "f64", "angle of a vector to itself", 0.0)];
    let [lost, itself, _] = rows_of(PLAIN, plain, count);
    let [_, still, _] = rows_of(CLAMPED, clamped, count);
    let row = |role, (value, measure, form): (f64, &str, String), limit| {
        PresetRow::new(role, &form, measure, value).at_most(limit)
    };
    rows.extend([row(FAILS, lost, 0.0), row(FAILS, itself, 1.0), row(FAILS, still, 1.0)]);
    for (name, form) in [(CROSS, by_cross_product as Form), (CHORD, chord)] {
        let [lost, itself, beside] = rows_of(name, form, count);
        rows.extend([row(CURE, lost, 0.0), row(CURE, itself, 1.0), row(CURE, beside, 0.1)]);
    }
    rows
}

fn verdict(rows: &[PresetRow]) -> String {
    format!(
        "By acos {} % of the vectors have no angle to themselves; with a clamp they have one, but still up to {} % \
         of the Sun's radius. By the chord it is {}.",
        figure(rows, PLAIN, NO_NUMBER),
        figure(rows, CLAMPED, ITSELF),
        figure(rows, CHORD, ITSELF)
    )
}

#[cfg(test)]
mod tests {
    use super::super::row::value;
    use super::*;

    /// As `tests/failures.rs` has it, of the same vectors.
    #[test]
    fn the_figures_are_those_on_record() {
        let rows = measure(Effort::Quick);
        assert_eq!(value(&rows, PLAIN, NO_NUMBER), per_cent(430, 10_000));
        let greatest = value(&rows, PLAIN, ITSELF) / 100.0 * SUN.angular_radius();
        assert!((greatest - 4.883e-4).abs() < 1e-7, "{greatest}");
    }
}
