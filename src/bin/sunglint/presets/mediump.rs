//! `1 - (n.h)^2` in half floats, as phones have it, and by the cross product.

use std::f64::consts::FRAC_1_PI;

use sunglint::half::f16;
use sunglint::highlight::smith;
use sunglint::trial::emulated::FlushingF16;
use sunglint::{Float, Real, Scalar};

use super::pixels::{Found, Lanes, by_this_crate, cosines, half, measure as of_pixels};
use super::row::{CURE, FAILS, PresetRow, TRUTH, figure, per_cent};
use super::{Effort, Preset};

/// What is reported, and how it is run.
pub const PRESET: Preset = Preset {
    name: "filament-mediump",
    source: "google/filament, \"Physically Based Rendering in Filament\" (2018), on GGX in \
             half floats; its shader takes the cross product on phones, as Unreal's GGX_Mobile does",
    question: "How bright is a glossy pixel where GGX is computed in half floats (mediump)?",
    chart: None,
    measure,
    verdict,
};

/// The least roughness that Filament lets a phone have, squared.
const ALPHA: f64 = 0.089 * 0.089;

const OFF: &str = "pixels off by more than 10 %, per cent";
const TWICE: &str = "pixels off by a factor of 2 or more, per cent";
const ALLOWED: f64 = 1.0;

const PLAIN: &str = "1 - (n.h)^2, f16";
const CROSS: &str = "|n x h|^2, f16";
const CROSS_FLUSHED: &str = "|n x h|^2, flushing f16";
const OURS: &str = "PointGgx, flushing f16";

/// How `1 - (n.h)^2` is formed.
#[derive(Clone, Copy)]
enum Tilt {
    Subtracted,
    Cross,
}

/// `D V (n.l)` with Filament's `D`, all else being this crate's.
fn highlight<T: Float>(tilt: Tilt, [n, v, l]: Lanes<T>, alpha: T) -> f64 {
    let h = half(v, l);
    let n_dot_h = <T as Real>::dot(n, h);
    let rest = match tilt {
        Tilt::Subtracted => T::ONE - n_dot_h * n_dot_h,
        Tilt::Cross => {
            let cross = [0, 1, 2].map(|i| n[(i + 1) % 3] * h[(i + 2) % 3] - n[(i + 2) % 3] * h[(i + 1) % 3]);
            <T as Real>::dot(cross, cross)
        }
    };
    let along = n_dot_h * alpha;
    let slope = alpha / (rest + along * along);
    let density = slope * slope * T::nearest(FRAC_1_PI);
    let density = if density <= T::MAX { density } else { T::MAX };
    let [n_dot_l, n_dot_v] = cosines([n, v, l]);
    density.exact() * smith(n_dot_l, n_dot_v, alpha).exact()
}

/// The cross product cures where its small squares are kept.
fn rows_of<T: Float>(format: &str, cross: &'static str, count: usize) -> Vec<PresetRow> {
    let forms: [(&str, &str, Found); 3] = [
        (FAILS, "1 - (n.h)^2", of_pixels::<T>(ALPHA, count, |lanes, alpha| highlight(Tilt::Subtracted, lanes, alpha))),
        (cross, "|n x h|^2", of_pixels::<T>(ALPHA, count, |lanes, alpha| highlight(Tilt::Cross, lanes, alpha))),
        (CURE, "PointGgx", of_pixels::<T>(ALPHA, count, by_this_crate)),
    ];
    let rows = |(role, form, found): (&'static str, &str, Found)| {
        let form = format!("{form}, {format}");
        [(OFF, found.tenth), (TWICE, found.twice)].map(|(measure, pixels)| {
            PresetRow::new(role, &form, measure, per_cent(pixels, found.pixels)).at_most(ALLOWED)
        })
    };
    forms.into_iter().flat_map(rows).collect()
}

fn measure(effort: Effort) -> Vec<PresetRow> {
    let count = effort.count(2000, 40_000);
    let exact = PresetRow::new(TRUTH, "f64", "1 - (n.h)^2 a width off the middle", ALPHA * ALPHA);
    let step = PresetRow::new(TRUTH, "f16", "step of n.h below 1", f16::ONE.exact() - f16::from_bits(0x3bff).exact());
    [vec![exact, step], rows_of::<f16>("f16", CURE, count), rows_of::<FlushingF16>("flushing f16", FAILS, count)]
        .concat()
}

fn verdict(rows: &[PresetRow]) -> String {
    let of = |form| figure(rows, form, OFF);
    format!(
        "By the subtraction {} % of the pixels are off by more than a tenth. The cross product leaves {} %, but {} % \
         where f16 flushes its small squares; PointGgx leaves {} % there.",
        of(PLAIN),
        of(CROSS),
        of(CROSS_FLUSHED),
        of(OURS)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// It is the arithmetic that fails, not the formula.
    #[test]
    fn both_forms_are_right_in_f64() {
        for tilt in [Tilt::Subtracted, Tilt::Cross] {
            let found = of_pixels::<f64>(ALPHA, 1000, |lanes, alpha| highlight(tilt, lanes, alpha).min(1e300));
            assert_eq!((found.pixels, found.tenth), (1000, 0));
        }
    }
}
