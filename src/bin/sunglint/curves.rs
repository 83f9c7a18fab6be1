//! Errors along the angle between mirror ray and light, and along the ratio of the light.

mod place;

use indicatif::ProgressBar;
use serde::Serialize;
use sunglint::Real;
use sunglint::oracle::highlight::Pixel;
use sunglint::oracle::quadrature::Quadrature;
use sunglint::trial::gloss::{self, Case};
use sunglint::trial::{Format, Found, Method, Shading, Visitor, judge};

use crate::options::Options;
use crate::workers;
use place::{ALPHA, Place, Subject, places};

/// One method in one number format at one place.
#[derive(Clone, Debug, Default, Serialize)]
pub struct CurveRow {
    /// `direction` or `pixel`.
    pub subject: &'static str,
    /// Name of the method.
    pub method: String,
    /// Name of the number format.
    pub format: String,
    /// GGX width of the surface; none for directions.
    pub alpha: Option<f64>,
    /// Radius over distance of the light.
    pub ratio: f64,
    /// What varies: `angle` (radians between mirror ray and light, under the Sun), `to opposite` (radians from mirror
    /// ray to the light's opposite, under the Sun) or `ratio`.
    pub along: &'static str,
    /// Its value; of a range the geometric middle.
    pub at: f64,
    /// Worst arithmetic error there: radians, of pixels relative. Infinite where an answer is no number.
    pub error_max: f64,
    /// Root mean square of that.
    pub error_rms: f64,
    /// Worst model error there; the same in every format.
    pub model_max: f64,
    /// Inputs tried.
    pub samples: u64,
}

/// Random inputs of each row of directions and of pixels, and of each model of pixels.
const INPUTS: [usize; 3] = [2000, 500, 50];

/// The same with `--quick`.
const QUICK_INPUTS: [usize; 3] = [150, 40, 5];

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    let places = places();
    let of = |subject: Subject| places.iter().filter(|place| place.subject == subject).count();
    of(Subject::Direction) * options.directions().len() + of(Subject::Pixel)
}

fn inputs(options: &Options) -> [usize; 3] {
    if options.quick { QUICK_INPUTS } else { INPUTS }
}

/// All of them, on all cores.
pub fn measure(options: &Options, progress: &ProgressBar) -> Vec<CurveRow> {
    let (lit, shaded): (Vec<_>, Vec<_>) = places().into_iter().partition(|place| place.subject == Subject::Direction);
    let lit: Vec<_> = options
        .directions()
        .into_iter()
        .flat_map(|(method, format)| lit.iter().map(move |&place| Direction { place, method, format, options }))
        .collect();
    let of_directions = workers::map(&lit, progress, |&direction| {
        progress.set_message(format!("curves, {} in {}", direction.method.name(), direction.format.name()));
        direction.format.visit(direction)
    });
    let of_pixels = workers::map(&shaded, progress, |place| {
        progress.set_message(format!("curves, pixels, {} {:.1e}", place.along.name(), place.at()));
        place.pixels(options)
    });
    // A place where no input has one answer has no error.
    let rows = of_directions.into_iter().chain(of_pixels.into_iter().flatten());
    rows.filter(|row| row.samples > 0).collect()
}

impl Place {
    /// The rows of all methods in all formats.
    fn pixels(self, options: &Options) -> Vec<CurveRow> {
        if options.quick { self.pixels_by::<8>(options) } else { self.pixels_by::<12>(options) }
    }

    fn pixels_by<const N: usize>(self, options: &Options) -> Vec<CurveRow> {
        let (case, rule) = (self.case(), Quadrature::<N>::new());
        let [_, count, of_model] = inputs(options);
        let lit = self.lit(options.seed, count);
        let truths = lit.iter().take(of_model).map(|pixel| (*pixel, gloss::integral::<f64, N>(&case, pixel, &rule)));
        let models = gloss::models(&case, truths);
        let row = |(method, format): (Shading, Format)| {
            let found = format.visit(Arithmetic { method, case, lit: &lit });
            CurveRow {
                subject: "pixel",
                method: method.name().to_owned(),
                format: format.name().to_owned(),
                alpha: Some(ALPHA),
                ratio: case.light.sin(),
                along: self.along.name(),
                at: self.at(),
                error_max: found.max,
                error_rms: found.rms(),
                model_max: models[method as usize].max,
                samples: found.samples,
            }
        };
        options.highlights().into_iter().map(row).collect()
    }
}

/// A method's pixels in a format.
struct Arithmetic<'a> {
    method: Shading,
    case: Case,
    lit: &'a [Pixel],
}

impl Visitor for Arithmetic<'_> {
    type Output = Found<9>;

    fn visit<T: Real>(self) -> Found<9> {
        gloss::arithmetic::<T>(self.method, &self.case, self.lit.iter().copied())
    }
}

/// A method's directions in a format at a place.
#[derive(Clone, Copy)]
struct Direction<'a> {
    place: Place,
    method: Method,
    format: Format,
    options: &'a Options,
}

impl Visitor for Direction<'_> {
    type Output = CurveRow;

    fn visit<T: Real>(self) -> CurveRow {
        let Self { place, method, format, options } = self;
        let light = place.light();
        let [count, ..] = inputs(options);
        let judged = judge::<T>(method, &light, place.pairs(options.seed, count), format.step());
        let infinite = judged.undirected > 0;
        let shown = |error: f64| if infinite { f64::INFINITY } else { error };
        CurveRow {
            subject: "direction",
            method: method.name().to_owned(),
            format: format.name().to_owned(),
            alpha: None,
            ratio: light.sin(),
            along: place.along.name(),
            at: place.at(),
            error_max: shown(judged.worst.error),
            error_rms: shown(judged.mean_square.sqrt()),
            model_max: judged.model_max,
            samples: judged.samples,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured() -> Vec<CurveRow> {
        let options = Options::parse_from(["sunglint", "--quick"]);
        let progress = ProgressBar::hidden();
        let rows = measure(&options, &progress);
        assert_eq!(progress.position(), steps(&options) as u64);
        rows
    }

    fn curve<'a>(rows: &'a [CurveRow], of: [&str; 4]) -> Vec<&'a CurveRow> {
        rows.iter().filter(|row| [row.subject, &row.method, &row.format, row.along] == of).collect()
    }

    #[test]
    fn curves_show_where_methods_break() {
        let rows = measured();
        // A small light is lost in f16, whose square of its sine is a subnormal or nothing.
        let small = curve(&rows, ["direction", "cap", "f16", "ratio"]);
        assert_eq!((small.len(), small[0].at, small[18].at), (19, 1e-6, 1.0));
        // `cap` has no model error; `factored` has most of it for great lights.
        let [cap, factored] = ["cap", "factored"].map(|method| curve(&rows, ["direction", method, "f64", "ratio"]));
        assert!(cap.iter().all(|row| row.model_max == 0.0 && row.error_max < 1e-14), "{cap:?}");
        assert!(factored[18].model_max > 100.0 * factored[3].model_max, "{factored:?}");
        // Near the light a formula's error is at most the format's; far off, `factored` leaves the nearest point.
        let angles = curve(&rows, ["direction", "factored", "f32", "angle"]);
        assert_eq!(angles.len(), 26);
        assert!(angles.iter().all(|row| row.error_max > 1e-9 && row.error_max < 1e-6), "{angles:?}");
        assert!(angles[22].model_max > 10.0 * angles[0].model_max);
        assert_eq!(curve(&rows, ["direction", "disc", "f32", "to opposite"]).len(), 25);
    }

    #[test]
    fn highlights_have_curves_of_their_own() {
        let rows = measured();
        let [karis, cone] = ["karis", "cone_ggx"].map(|method| curve(&rows, ["pixel", method, "f32", "ratio"]));
        assert_eq!((karis.len(), cone.len()), (19, 19));
        assert!(karis[15].model_max > 2.0 * cone[15].model_max, "{:?} {:?}", karis[15], cone[15]);
        let half = curve(&rows, ["pixel", "cone_ggx", "f16", "angle"]);
        let single = curve(&rows, ["pixel", "cone_ggx", "f32", "angle"]);
        assert_eq!(half.len(), 25);
        assert!(half.iter().zip(single).all(|(half, single)| half.error_max > 10.0 * single.error_max));
    }
}
