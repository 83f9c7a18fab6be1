//! Unit vectors by a fast reciprocal root.

use sunglint::micromath::F32;
use sunglint::oracle;
use sunglint::sampling::Cone;
use sunglint::trial::input;
use sunglint::{DistantSphere, Real, SUN, normalize};

use super::row::{CURE, FAILS, PresetRow, TRUTH, figure, per_cent, worst};
use super::{Effort, Preset};

/// What is reported, and how it is run.
pub const PRESET: Preset = Preset {
    name: "fast-inverse-root",
    source: "crate micromath 2.1.0, whose invsqrt is documented as 5 % off on average; the same trade was discussed \
             for godotengine/godot (pull request 32015, 2019) and g-truc/glm (issue 1224, 2024)",
    question: "Is a vector that a fast reciprocal root has normalised good enough to find the Sun's disc?",
    chart: None,
    measure,
    verdict,
};

const LENGTH: &str = "length off by at most, per cent";
const MISSED: &str = "rays into the Sun that are taken for outside, per cent";

const FAST: &str = "v * invsqrt(v.v), micromath";
const OURS: &str = "normalize, micromath";

type Form = fn([F32; 3]) -> [F32; 3];

fn fast(v: [F32; 3]) -> [F32; 3] {
    let inverse = <F32 as Real>::dot(v, v).invsqrt();
    v.map(|lane| lane * inverse)
}

/// Vectors of many lengths, each beside another of its direction that is turned by half of the Sun's radius.
fn pairs(count: usize) -> impl Iterator<Item = [[F32; 3]; 2]> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    input::random(5, count, 0.1).enumerate().map(|(index, pair)| {
        let share = (index as f64 * GOLDEN).fract();
        let beside = oracle::cone::at(pair.l, SUN.angular_radius() / 2.0, share);
        let length = 4_f64.powf(share - 0.5);
        [pair.l, beside.map(|lane| lane * length)].map(|vector| vector.map(|lane| F32(lane as f32)))
    })
}

fn rows_of(role: &'static str, name: &str, form: Form, count: usize) -> [PresetRow; 2] {
    let sun = DistantSphere::<F32>::of(&SUN);
    let length = |v: [F32; 3]| v.map(|lane| f64::from(lane.0)).iter().map(|lane| lane * lane).sum::<f64>().sqrt();
    let off = worst(pairs(count).map(|[_, ray]| 100.0 * (length(form(ray)) - 1.0).abs()));
    let missed = pairs(count).filter(|&[l, ray]| !Cone::new(normalize(l), &sun).contains(form(ray))).count();
    [
        PresetRow::new(role, name, LENGTH, off).at_most(0.1),
        PresetRow::new(role, name, MISSED, per_cent(missed, count)).at_most(0.1),
    ]
}

fn measure(effort: Effort) -> Vec<PresetRow> {
    let count = effort.count(5000, 100_000);
    let radius = PresetRow::new(TRUTH, "f64", "the Sun's radius, per cent of a unit vector", 100.0 * SUN.sin());
    let rows = [rows_of(FAILS, FAST, fast, count), rows_of(CURE, OURS, normalize, count)].concat();
    [vec![radius], rows].concat()
}

fn verdict(rows: &[PresetRow]) -> String {
    format!(
        "The vectors are up to {} % too long or too short, more than the Sun's radius, and {} % of the rays into the \
         Sun miss it; with normalize {} % and {} %.",
        figure(rows, FAST, LENGTH),
        figure(rows, FAST, MISSED),
        figure(rows, OURS, LENGTH),
        figure(rows, OURS, MISSED)
    )
}

#[cfg(test)]
mod tests {
    use super::super::row::value;
    use super::*;

    /// The root by an exponent alone is 3.4 % off at most.
    #[test]
    fn the_length_is_as_far_off_as_is_known() {
        let off = value(&measure(Effort::Quick), FAST, LENGTH);
        assert!((3.35..=3.45).contains(&off), "{off}");
    }
}
