//! Whole highlights against the truth: what each method makes of a disc's light, integrated over all viewers.

use indicatif::ProgressBar;
use sunglint::oracle::highlight::Glossy;
use sunglint::oracle::quadrature::{Lobe, Quadrature};
use sunglint::trial::Shading;
use sunglint::trial::gloss::F0;
use sunglint::{DistantLight, SUN};

use crate::filter;
use crate::options::Options;
use crate::result::LobeRow;
use crate::workers;

/// Names of the lights of the study; the ratios are those of [`ratio`].
const LIGHTS: [&str; 4] = ["Sun", "lamp 0.0001", "lamp 0.05", "lamp 0.3"];

/// GGX widths, the mirror first.
const ALPHAS: [f64; 7] = [0.0, 5e-4, 2e-3, 8e-3, 0.0625, 0.25, 1.0];

/// Degrees between the normal and the light.
const INCIDENCES: [u32; 6] = [0, 30, 45, 60, 70, 80];

/// The same with `--quick`.
const QUICK_INCIDENCES: [u32; 4] = [0, 45, 60, 80];

/// A highlight to integrate.
#[derive(Clone, Copy)]
struct Case {
    light: &'static str,
    ratio: f64,
    alpha: f64,
    incidence: u32,
}

/// Names of the lights.
pub fn names() -> impl Iterator<Item = &'static str> {
    LIGHTS.into_iter()
}

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    cases(options).len()
}

/// Name and ratio of the lights that were asked for; none where no highlight was.
fn lights(options: &Options) -> Vec<(&'static str, f64)> {
    let wanted = options.shadings().next().is_some();
    match options.filter.own() {
        _ if !wanted => Vec::new(),
        None => LIGHTS.into_iter().filter(|light| options.wants(light)).map(|light| (light, ratio(light))).collect(),
        Some(own) if filter::has_pixels(&own.light) => vec![(own.name, own.light.sin())],
        Some(_) => Vec::new(),
    }
}

fn cases(options: &Options) -> Vec<Case> {
    let alphas = options.filter.alpha.map_or(ALPHAS.to_vec(), |alpha| vec![alpha]);
    let incidences: &[u32] = if options.quick { &QUICK_INCIDENCES } else { &INCIDENCES };
    let mut cases = Vec::new();
    for (light, ratio) in lights(options) {
        for &incidence in incidences {
            cases.extend(alphas.iter().map(|&alpha| Case { light, ratio, alpha, incidence }));
        }
    }
    cases
}

/// All methods' highlights, on all cores.
pub fn measure(options: &Options, progress: &ProgressBar) -> Vec<LobeRow> {
    let rows = workers::map(&cases(options), progress, |case| {
        let Case { light, alpha, incidence, .. } = case;
        progress.set_message(format!("{light}, alpha {alpha}, {incidence} degrees, all viewers"));
        if options.quick { rows::<8>(case) } else { rows::<12>(case) }
    });
    rows.into_iter().flatten().filter(|row| options.wants_method(&row.method)).collect()
}

fn ratio(light: &str) -> f64 {
    let lamp = light.strip_prefix("lamp ").and_then(|ratio| ratio.parse().ok());
    lamp.and_then(|ratio| DistantLight::from_ratio(ratio).ok()).unwrap_or(SUN).sin()
}

fn rows<const N: usize>(case: &Case) -> [LobeRow; Shading::ALL.len()] {
    let glossy = Glossy { alpha: case.alpha, f0: F0, ratio: case.ratio };
    let methods = |pixel: &_| Shading::ALL.map(|method| method.truth(&glossy, pixel));
    let lobes = Quadrature::<N>::new().lobes(&glossy, f64::from(case.incidence).to_radians(), methods);
    let row = |place: usize| {
        let Lobe { truth, energy, peak, relative_l1 } = lobes[place];
        LobeRow {
            light: case.light.to_owned(),
            ratio: glossy.ratio,
            alpha: case.alpha,
            incidence: case.incidence,
            method: Shading::ALL[place].name().to_owned(),
            truth,
            energy,
            peak,
            relative_l1,
            nodes: N,
        }
    };
    std::array::from_fn(row)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_the_ratio() {
        assert_eq!(LIGHTS.map(ratio), [SUN.sin(), 1e-4, 0.05, 0.3]);
    }

    #[test]
    fn the_exact_method_is_nearer_to_the_truth_than_none() {
        let rows = rows::<4>(&Case { light: "lamp 0.05", ratio: 0.05, alpha: 0.0625, incidence: 45 });
        let [none, .., cone, _] = &rows;
        assert!(cone.relative_l1 < 0.1 * none.relative_l1, "{rows:?}");
        assert!((cone.energy - 1.0).abs() < 0.05 && none.energy > 1.1, "{rows:?}");
    }

    #[test]
    fn a_light_is_taken_by_its_name() {
        let options = |light| Options::parse_from(["sunglint", "--light", light]);
        assert_eq!(steps(&options("sun")), ALPHAS.len() * INCIDENCES.len());
        assert_eq!(steps(&options("mars")), 0);
        let own = Options::parse_from(["sunglint", "--ratio", "0.01", "--alpha", "0.1"]);
        assert_eq!(steps(&own), INCIDENCES.len());
        assert_eq!(steps(&Options::parse_from(["sunglint", "--method", "cap"])), 0);
    }
}
