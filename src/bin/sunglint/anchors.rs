//! What costs and errors are compared with: the empty call, and the true answer rounded into the format.

use indicatif::ProgressBar;
use serde::Serialize;
use sunglint::trial::gloss::Case;
use sunglint::trial::{Format, Found, Light, Method, Shading, Visitor, input};
use sunglint::{Real, Scalar, oracle};

use crate::clock::{self, Contender, Pace};
use crate::options::Options;
use crate::pixels::Truths;
use crate::{directions, pixels, workers};

/// Of one light or case in one number format.
#[derive(Clone, Debug, Default, Serialize)]
pub struct AnchorRow {
    /// `direction` or `pixel`.
    pub subject: &'static str,
    /// Name of the light, or of the case.
    pub light: String,
    /// Name of the number format.
    pub format: String,
    /// Time of an empty call, which loads the inputs and stores as many lanes as an answer has, in calls of f32
    /// `factored`.
    pub empty: f64,
    /// Worst error of the true answer once it is rounded into the format: in radians, of pixels relative. Zero in f64,
    /// in which the truth is computed.
    pub rounded_max: f64,
    /// Root mean square of that.
    pub rounded_rms: f64,
}

/// Random pairs of directions that are rounded, and with `--quick`.
const PAIRS: [usize; 2] = [20_000, 2000];

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    let places = directions::wanted(options).count() + pixels::wanted(options).len();
    places * (options.formats().count() + rounds(options))
}

/// How often every empty call has its turn.
fn rounds(options: &Options) -> usize {
    if options.quick { 9 } else { 41 }
}

/// All of them: errors on all cores, then times.
pub fn measure(truths: &Truths, options: &Options, progress: &ProgressBar) -> Vec<AnchorRow> {
    let formats: Vec<_> = options.formats().collect();
    let lights: Vec<_> = directions::wanted(options).map(Place::Light).collect();
    let cases = pixels::wanted(options).into_iter().map(Place::Case);
    let places: Vec<_> = lights.into_iter().chain(cases).collect();
    let all: Vec<_> = places.iter().flat_map(|&place| formats.iter().map(move |&format| (place, format))).collect();
    let mut rows = workers::map(&all, progress, |&(place, format)| place.rounded(format, truths, options));
    for (place, rows) in places.iter().zip(rows.chunks_mut(formats.len())) {
        progress.set_message(format!("timing empty calls, {}", place.light().name));
        let contenders: Vec<_> = formats.iter().map(|&format| place.empty(format)).collect();
        let baseline = directions::baseline(&place.light());
        let costs = clock::ratios(&contenders, &baseline, rounds(options), progress);
        rows.iter_mut().zip(costs).for_each(|(row, cost)| row.empty = cost.median);
    }
    rows
}

/// Where something is lit.
#[derive(Clone, Copy)]
enum Place {
    /// Directions under a light.
    Light(Light),
    /// A surface under a light.
    Case(Case),
}

impl Place {
    fn light(self) -> Light {
        match self {
            Self::Light(light) => light,
            Self::Case(Case { name, light, .. }) => Light { name, light },
        }
    }

    /// The row without its time.
    fn rounded(self, format: Format, truths: &Truths, options: &Options) -> AnchorRow {
        let (subject, found) = match self {
            Self::Light(light) => ("direction", format.visit(Directions { light, options })),
            Self::Case(case) => ("pixel", format.visit(Levels(truths.levels(&case, format)))),
        };
        AnchorRow {
            subject,
            light: self.light().name.to_owned(),
            format: format.name().to_owned(),
            empty: f64::NAN,
            rounded_max: found.max,
            rounded_rms: found.rms(),
        }
    }

    /// The empty call, from which nothing is taken off.
    fn empty(self, format: Format) -> Contender {
        let Contender { empty: call, inputs, .. } = match self {
            Self::Light(light) => directions::contender(Method::Cap, format, &light, Pace::Independent),
            Self::Case(case) => pixels::contender(Shading::None, format, &case, Pace::Independent),
        };
        Contender { call, empty: Box::new(|| ()), inputs }
    }
}

/// The exact nearest directions of a disc, rounded.
struct Directions<'a> {
    light: Light,
    options: &'a Options,
}

impl Visitor for Directions<'_> {
    type Output = Found<6>;

    fn visit<T: Real>(self) -> Found<6> {
        let theta = self.light.light.angular_radius();
        let count = PAIRS[usize::from(self.options.quick)];
        let mut found = Found::new();
        for pair in input::random(self.options.seed, count, theta) {
            let [l, r] = [pair.l, pair.r].map(|v| v.map(|lane| T::from_f64(lane).to_f64()));
            let exact = oracle::nearest_in_disc(l, r, theta);
            let rounded = exact.map(|lane| T::from_f64(lane).to_f64());
            found.add(oracle::angle_between(rounded, exact), [l[0], l[1], l[2], r[0], r[1], r[2]]);
        }
        found
    }
}

/// True levels, rounded.
struct Levels<'a>(&'a [f64]);

impl Visitor for Levels<'_> {
    type Output = Found<6>;

    fn visit<T: Real>(self) -> Found<6> {
        let mut found = Found::new();
        for &exact in self.0 {
            let rounded = T::of_level(T::level(T::Scalar::nearest(exact))).exact();
            found.add_signed(rounded / exact - 1.0, [exact, 0.0, 0.0, 0.0, 0.0, 0.0]);
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_off_by_half_a_step_of_the_format() {
        let options = Options::parse_from(["sunglint", "--quick", "--light", "0.05"]);
        let progress = ProgressBar::hidden();
        let truths = Truths::of(&options, &progress);
        let before = progress.position();
        let rows = measure(&truths, &options, &progress);
        assert_eq!((rows.len(), progress.position() - before), (2 * Format::ALL.len(), steps(&options) as u64));
        for row in &rows {
            let format = Format::named(&row.format).expect("a format");
            let steps = row.rounded_max / format.step();
            match (row.subject, format) {
                (_, Format::F64) => assert_eq!(steps, 0.0, "{row:?}"),
                // Three lanes' errors of half a step, at right angles to the direction; floats have finer steps.
                ("direction", _) => assert!((0.6..0.87).contains(&steps), "{row:?}"),
                // Levels of half a last place; fixed point's have other steps than its lanes.
                (_, Format::F32 | Format::Micromath | Format::F16) => {
                    assert!((0.8..=1.0).contains(&steps), "{row:?}");
                }
                _ => assert!(row.rounded_max < 1e-3, "{row:?}"),
            }
            assert!(row.rounded_rms < row.rounded_max || row.rounded_max == 0.0, "{row:?}");
            assert!(row.empty.is_finite(), "{row:?}");
        }
    }
}
