//! The fourth power of a roughness, which half floats lose.

use std::f64::consts::FRAC_1_PI;

use sunglint::half::f16;
use sunglint::trial::emulated::FlushingF16;
use sunglint::{Float, Real};

use super::pixels::{Found, Lanes, by_this_crate, cosines, half, measure as of_pixels};
use super::row::{CURE, FAILS, PresetRow, TRUTH, figure, per_cent};
use super::{Axes, Effort, Preset};

/// What is reported, and how it is run.
pub const PRESET: Preset = Preset {
    name: "threejs-roughness4",
    source: "mrdoob/three.js, pull request 8349 and issues 9501 and 9515 (2016): black highlights on phones; its \
             clamps of the roughness, 0.04 and later 0.0525, which is for its environment maps",
    question: "How bright is a glossy pixel if GGX takes the fourth power of the roughness, in half floats?",
    chart: Some(Axes {
        title: "Pixels off by a factor of 2 or more, or no number",
        input: "roughness",
        measure: "per cent of the pixels",
        base: 2.0,
        lowest: 0.01,
    }),
    measure,
    verdict,
};

/// The least roughness of three.js in 2016, and later.
const CLAMPS: [f64; 2] = [0.04, 0.0525];

/// On the chart.
const ROUGHNESSES: [f64; 10] = [0.03, 0.04, 0.0525, 0.07, 0.089, 0.12, 0.17, 0.25, 0.4, 0.7];

const LOST: &str = "pixels black, infinite or no number, per cent";
const TWICE: &str = "pixels off by a factor of 2 or more, per cent";
const ALLOWED: f64 = 1.0;

const PLAIN: &str = "roughness^4";
const OURS: &str = "PointGgx";

/// `D V (n.l)` by `alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2)` and Smith by `alpha^2`.
fn highlight<T: Float>([n, v, l]: Lanes<T>, alpha: T) -> f64 {
    let n_dot_h = <T as Real>::dot(n, half(v, l));
    let [n_dot_l, n_dot_v] = cosines([n, v, l]);
    let square = alpha * alpha;
    let rest = n_dot_h * n_dot_h * (square - T::ONE) + T::ONE;
    let density = T::nearest(FRAC_1_PI) * square / (rest * rest);
    let shadow = |cosine: T| (square + (T::ONE - square) * (cosine * cosine)).root();
    let both = n_dot_l * shadow(n_dot_v) + n_dot_v * shadow(n_dot_l);
    (density * (T::nearest(0.5) / both) * n_dot_l).exact()
}

fn plain<T: Float>(roughness: f64, count: usize) -> Found {
    of_pixels::<T>(roughness * roughness, count, highlight)
}

fn ours<T: Float>(roughness: f64, count: usize) -> Found {
    of_pixels::<T>(roughness * roughness, count, by_this_crate)
}

fn judged(role: &'static str, form: &str, found: Found) -> [PresetRow; 2] {
    [(LOST, found.lost), (TWICE, found.twice)]
        .map(|(measure, pixels)| PresetRow::new(role, form, measure, per_cent(pixels, found.pixels)).at_most(ALLOWED))
}

fn curve(count: usize) -> impl Iterator<Item = PresetRow> {
    ROUGHNESSES.into_iter().flat_map(move |roughness| {
        let forms = [
            (format!("{PLAIN}, flushing f16"), plain::<FlushingF16>(roughness, count)),
            (format!("{PLAIN}, f16"), plain::<f16>(roughness, count)),
            (format!("{PLAIN}, f32"), plain::<f32>(roughness, count)),
            (format!("{OURS}, flushing f16"), ours::<FlushingF16>(roughness, count)),
        ];
        forms.map(|(form, found)| PresetRow::point(&form, TWICE, roughness, per_cent(found.twice, found.pixels)))
    })
}

fn form(name: &str, format: &str, roughness: f64) -> String {
    format!("{name}, {format}, roughness {roughness}")
}

fn measure(effort: Effort) -> Vec<PresetRow> {
    let count = effort.count(1000, 20_000);
    let least = CLAMPS[0];
    let mut rows = vec![
        PresetRow::new(TRUTH, "f64", "roughness^4 at 0.04", least.powi(4)),
        PresetRow::new(TRUTH, "f16", "least number that is not flushed", 1.0 / 16384.0),
    ];
    for clamp in CLAMPS {
        rows.extend(judged(FAILS, &form(PLAIN, "flushing f16", clamp), plain::<FlushingF16>(clamp, count)));
    }
    let found = plain::<f16>(least, count);
    let twice = PresetRow::new(FAILS, &form(PLAIN, "f16", least), TWICE, per_cent(found.twice, found.pixels));
    rows.push(twice.at_most(ALLOWED));
    rows.extend(judged(CURE, &form(PLAIN, "f32", least), plain::<f32>(least, count)));
    rows.extend(judged(CURE, &form(OURS, "f16", least), ours::<f16>(least, count)));
    rows.extend(judged(CURE, &form(OURS, "flushing f16", least), ours::<FlushingF16>(least, count)));
    rows.extend(curve(count / 4));
    rows
}

fn verdict(rows: &[PresetRow]) -> String {
    let of = |name, clamp| figure(rows, &form(name, "flushing f16", clamp), LOST);
    format!(
        "Where f16 flushes, {} % of the pixels are black or no number at a roughness of {}, and still {} % at {}; {} \
         % here, at {}.",
        of(PLAIN, CLAMPS[0]),
        CLAMPS[0],
        of(PLAIN, CLAMPS[1]),
        CLAMPS[1],
        of(OURS, CLAMPS[0]),
        CLAMPS[0]
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// It is the arithmetic that fails, not the formula.
    #[test]
    fn the_form_is_right_in_f64() {
        let found = plain::<f64>(CLAMPS[0], 1000);
        assert_eq!((found.pixels, found.tenth), (1000, 0));
    }
}
