//! Errors and costs of whole lit pixels: every highlight method in every format, on a surface under a light.

mod judged;
mod truths;

pub use judged::Judged;
pub use truths::Truths;

use indicatif::ProgressBar;
use sunglint::Real;
use sunglint::highlight::Highlight;
use sunglint::oracle::highlight::Pixel;
use sunglint::scene::Channel;
use sunglint::trial::gloss::{self, CASES, Case};
use sunglint::trial::{Format, Found, Light, Make, Shading, ShadingVisitor, Visitor, input};

use crate::author::OURS;
use crate::bound;
use crate::clock::{self, Batch, Contender, Pace, lane_bits, level_bits};
use crate::directions;
use crate::options::Options;
use crate::result::PixelRow;
use crate::workers;

/// Random pixels of which the arithmetic error is taken, the model error and the rounding of inputs.
const PIXELS: [usize; 3] = [8000, 4000, 2000];

/// The same with `--quick`.
const QUICK_PIXELS: [usize; 3] = [800, 400, 200];

/// Pixels across the ball whose pixels make a batch.
const SIDE: u32 = 32;

/// Names of the cases, which begin with the light's.
pub fn names() -> impl Iterator<Item = &'static str> {
    CASES.iter().map(|case| case.name)
}

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    wanted(options).len() * (Format::ALL.len() + 1 + rounds(options)) + rows(options)
}

/// How many rows there are.
pub fn rows(options: &Options) -> usize {
    wanted(options).len() * options.highlights().len()
}

/// The cases that were asked for; none where no lit pixel was.
pub fn wanted(options: &Options) -> Vec<Case> {
    if options.highlights().is_empty() { Vec::new() } else { options.cases() }
}

fn pixels(options: &Options) -> [usize; 3] {
    if options.quick { QUICK_PIXELS } else { PIXELS }
}

/// How often every contender has its turn.
pub fn rounds(options: &Options) -> usize {
    if options.quick { 5 } else { 25 }
}

/// The errors of all methods in all formats, on all cores.
pub fn errors(truths: &Truths, options: &Options, progress: &ProgressBar) -> Vec<PixelRow> {
    let cases = wanted(options);
    let models = workers::map(&cases, progress, |case| {
        progress.set_message(format!("{}, models", case.name));
        let pixels = case.pixels(options.seed, pixels(options)[1]);
        gloss::models(case, pixels.zip(truths.levels(case, Format::F64).iter().copied()))
    });
    let contenders: Vec<_> = cases
        .iter()
        .zip(&models)
        .flat_map(|(&case, models)| {
            let judge =
                move |(method, format)| Judge { case, method, format, model: models[method as usize], truths, options };
            options.highlights().into_iter().map(judge)
        })
        .collect();
    workers::map(&contenders, progress, |&contender| {
        let Judge { case, method, format, .. } = contender;
        progress.set_message(format!("{}, {} in {}", case.name, method.name(), format.name()));
        format.visit(contender)
    })
}

/// Adds the costs to `rows`, which are those of [`errors`].
pub fn add_costs(rows: &mut [PixelRow], options: &Options, progress: &ProgressBar) {
    for (case, rows) in wanted(options).iter().zip(rows.chunks_mut(options.highlights().len().max(1))) {
        progress.set_message(format!("timing, {}", case.name));
        let of_all = options.highlights().into_iter();
        let contenders: Vec<_> =
            of_all.map(|(method, format)| contender(method, format, case, Pace::Independent)).collect();
        let baseline = directions::baseline(&Light { name: case.name, light: case.light });
        let costs = clock::costs(&contenders, &baseline, rounds(options), progress);
        for (row, cost) in rows.iter_mut().zip(costs) {
            (row.cost, row.cost_low, row.cost_high) = cost.figures();
        }
    }
}

/// The calls of a method in a format on a surface under a light.
pub fn contender(method: Shading, format: Format, case: &Case, pace: Pace) -> Contender {
    let build = |method| format.visit(Build { method, case, pace });
    Contender { call: build(Some(method)), empty: build(None), inputs: ball().count() }
}

/// Normal and direction to the viewer of the pixels of a ball in scan order.
pub fn ball() -> impl Iterator<Item = [[f64; 3]; 2]> {
    const V: [f64; 3] = [0.0, 0.0, 1.0];
    input::ball(SIDE).map(|pair| {
        // The normal is halfway between the viewer and the mirror ray.
        let sum = [0, 1, 2].map(|i| pair.r[i] + V[i]);
        let length = sum.map(|lane| lane * lane).iter().sum::<f64>().sqrt();
        [sum.map(|lane| lane / length), V]
    })
}

/// Direction to the light of a ball, which is that of `input::ball`.
pub fn ball_light() -> [f64; 3] {
    [1.0, 2.0, 3.0].map(|lane: f64| lane / 14_f64.sqrt())
}

/// A batch of a method's calls on the pixels of a ball, or of empty ones.
struct Build<'a> {
    method: Option<Shading>,
    case: &'a Case,
    pace: Pace,
}

impl Visitor for Build<'_> {
    type Output = Batch;

    fn visit<T: Real>(self) -> Batch {
        let pixels: Vec<_> = ball().map(|pixel| pixel.map(|vector| vector.map(T::from_f64))).collect();
        let Self { method, case, pace } = self;
        match (method, pace) {
            (Some(method), _) => method.visit(Calls { case, pixels, pace }),
            (None, Pace::Independent) => pace.calls(pixels, |&[n, _]| n, lane_bits),
            // An answer is a level, whose bits take as long to read here as there.
            (None, Pace::Waiting) => {
                let levels: Vec<_> = pixels.into_iter().map(|[[x, ..], _]| T::level(T::of_lane(x))).collect();
                pace.calls(levels, |&level| level, level_bits::<T>)
            }
        }
    }
}

struct Calls<'a, T> {
    case: &'a Case,
    pixels: Vec<[[T; 3]; 2]>,
    pace: Pace,
}

impl<T: Real> ShadingVisitor<T> for Calls<'_, T> {
    type Output = Batch;

    fn visit<H: Highlight<T> + 'static>(self, method: Make<T, H>) -> Batch {
        let scene = gloss::scene(self.case, ball_light().map(T::from_f64), method)
            .expect("the cases are within every format's ranges");
        self.pace.calls(self.pixels, move |&[n, v]| scene.shade_channel(n, v, Channel::Green), level_bits::<T>)
    }
}

#[derive(Clone, Copy)]
struct Judge<'a> {
    case: Case,
    method: Shading,
    format: Format,
    model: Found<9>,
    truths: &'a Truths,
    options: &'a Options,
}

impl Visitor for Judge<'_> {
    type Output = PixelRow;

    fn visit<T: Real>(self) -> PixelRow {
        let Self { case, method, format, model, truths, options } = self;
        let judged = Judged::of(method, &case, options, |lanes| gloss::level::<T>(method, &case, lanes));
        let input = gloss::input::<T>(method, &case, case.pixels(options.seed, pixels(options)[2]));
        let row = PixelRow {
            case: case.name.to_owned(),
            ratio: case.light.sin(),
            alpha: case.alpha,
            method: method.name().to_owned(),
            format: format.name().to_owned(),
            by: OURS,
            cost: f64::NAN,
            cost_low: f64::NAN,
            cost_high: f64::NAN,
            error_max: f64::NAN,
            error_rms: f64::NAN,
            model_max: model.max,
            model_rms: model.rms(),
            total_max: f64::NAN,
            total_rms: f64::NAN,
            input_max: input.max,
            input_rms: input.rms(),
            samples: 0,
            model_samples: model.samples,
            failure: None,
            // The arithmetic comes next, costs later.
            ..PixelRow::default()
        };
        bound::of_pixel(judged.row(row, format, truths.levels(&case, format)))
    }
}

/// The pixels of which arithmetic errors are taken.
pub fn arithmetic(case: &Case, options: &Options) -> impl Iterator<Item = Pixel> + use<> {
    case.pixels(options.seed, pixels(options)[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ball_has_unit_normals_that_face_the_viewer() {
        for [n, _] in ball() {
            let square: f64 = n.iter().map(|lane| lane * lane).sum();
            assert!((square - 1.0).abs() < 1e-12 && n[2] > 0.0, "{n:?}");
        }
        assert_eq!(ball().count(), input::ball(SIDE).count());
    }

    #[test]
    fn every_method_can_be_timed_in_every_format_in_every_case() {
        for case in &CASES {
            for format in Format::ALL {
                for method in Shading::ALL {
                    for pace in [Pace::Independent, Pace::Waiting] {
                        (contender(method, format, case, pace).call)();
                    }
                }
            }
        }
    }
}
