//! Errors and costs of the direction methods in every format under every light.

use indicatif::ProgressBar;
use sunglint::trial::input::Pair;
use sunglint::trial::judge::DISC_LOST;
use sunglint::trial::{Constants, Format, Judgement, Light, Method, Visitor, input, judge, lights};
use sunglint::{Real, cap, disc, epic, factored};

use crate::author::OURS;
use crate::bound;
use crate::clock::{self, Batch, Contender, Pace, lane_bits};
use crate::measure::bits;
use crate::options::Options;
use crate::result::Row;
use crate::workers;

/// Random pairs a contender is tried on, beside the hard ones.
const PAIRS: usize = 150_000;

/// The same with `--quick`.
const QUICK_PAIRS: usize = 10_000;

/// Pixels across the ball whose pixels make a batch.
const SIDE: u32 = 64;

/// Names of the lights that can be asked for.
pub fn names() -> impl Iterator<Item = &'static str> {
    lights::STUDY.iter().map(|light| light.name)
}

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    rows(options) + wanted(options).count() * rounds(options)
}

/// How many rows there are.
pub fn rows(options: &Options) -> usize {
    wanted(options).count() * options.directions().len()
}

/// The lights that were asked for; none where no direction was.
pub fn wanted(options: &Options) -> impl Iterator<Item = Light> {
    let lights = if options.directions().is_empty() { Vec::new() } else { options.lights() };
    lights.into_iter()
}

/// How often every contender has its turn.
fn rounds(options: &Options) -> usize {
    if options.quick { 17 } else { 81 }
}

/// The errors of all methods in all formats, on all cores.
pub fn errors(options: &Options, progress: &ProgressBar) -> Vec<Row> {
    let contenders: Vec<_> = wanted(options)
        .flat_map(|light| {
            options.directions().into_iter().map(move |(method, format)| Judge { light, method, format, options })
        })
        .collect();
    workers::map(&contenders, progress, |&contender| {
        let Judge { light, method, format, .. } = contender;
        progress.set_message(format!("{}, {} in {}", light.name, method.name(), format.name()));
        format.visit(contender)
    })
}

/// Adds the costs to `rows`, which are those of [`errors`].
pub fn add_costs(rows: &mut [Row], options: &Options, progress: &ProgressBar) {
    for (light, rows) in wanted(options).zip(rows.chunks_mut(options.directions().len().max(1))) {
        progress.set_message(format!("timing, {}", light.name));
        let of_all = options.directions().into_iter();
        let contenders: Vec<_> =
            of_all.map(|(method, format)| contender(method, format, &light, Pace::Independent)).collect();
        let costs = clock::costs(&contenders, &baseline(&light), rounds(options), progress);
        for (row, cost) in rows.iter_mut().zip(costs) {
            (row.cost, row.cost_low, row.cost_high) = cost.figures();
        }
    }
}

/// f32 `factored` under `light`, whose time is the unit of all costs.
pub fn baseline(light: &Light) -> Contender {
    contender(Method::Factored, Format::F32, light, Pace::Independent)
}

/// The calls of a method in a format under `light`.
pub fn contender(method: Method, format: Format, light: &Light, pace: Pace) -> Contender {
    let build = |method| format.visit(Build { method, light, pace });
    Contender { call: build(Some(method)), empty: build(None), inputs: input::ball(SIDE).count() }
}

/// A batch of calls of a method on the pixels of a ball, or of empty ones.
struct Build<'a> {
    method: Option<Method>,
    light: &'a Light,
    pace: Pace,
}

impl Visitor for Build<'_> {
    type Output = Batch;

    fn visit<T: Real>(self) -> Batch {
        let Constants { sphere, unfactored } = Constants::<T>::of(&self.light.light);
        let (pairs, pace) = (input::ball(SIDE), self.pace);
        let pairs: Vec<_> = pairs.map(|pair| [pair.l.map(T::from_f64), pair.r.map(T::from_f64)]).collect();
        // One closure a method, so that the compiler sees which one it is.
        match self.method {
            Some(Method::Epic) => pace.calls(pairs, move |&[l, r]| epic(l, r, &unfactored), lane_bits),
            Some(Method::Factored) => pace.calls(pairs, move |&[l, r]| factored(l, r, &sphere), lane_bits),
            Some(Method::Disc) => pace.calls(pairs, move |&[l, r]| disc(l, r, &sphere), lane_bits),
            Some(Method::Cap) => pace.calls(pairs, move |&[l, r]| cap(l, r, &sphere), lane_bits),
            None => pace.calls(pairs, |&[l, _]| l, lane_bits),
        }
    }
}

#[derive(Clone, Copy)]
struct Judge<'a> {
    light: Light,
    method: Method,
    format: Format,
    options: &'a Options,
}

impl Visitor for Judge<'_> {
    type Output = Row;

    fn visit<T: Real>(self) -> Row {
        let pairs = pairs(&self.light, self.options);
        let judgement = judge::<T>(self.method, &self.light.light, pairs, self.format.step());
        let row = row(self.light, self.method, self.format, &judgement);
        bound::of_direction(row, self.method, self.format, &self.light)
    }
}

/// What all direction methods are tried on.
pub fn pairs(light: &Light, options: &Options) -> impl Iterator<Item = Pair> + use<> {
    let theta = light.light.angular_radius();
    let count = if options.quick { QUICK_PAIRS } else { PAIRS };
    input::random(options.seed, count, theta).chain(input::hard(theta))
}

/// A row without costs, whose bound is this run's.
pub fn row<T: Real>(light: Light, method: Method, format: Format, judgement: &Judgement<T>) -> Row {
    let failed = judgement.undirected == judgement.samples;
    let shown = |error: f64| if failed { f64::NAN } else { error };
    let worst = &judgement.worst;
    let [l, r] = [worst.l, worst.r].map(|v| v.map(T::to_f64));
    Row {
        light: light.name.to_owned(),
        ratio: light.light.sin(),
        theta: light.light.angular_radius(),
        method: method.name().to_owned(),
        format: format.name().to_owned(),
        by: OURS,
        cost: f64::NAN,
        cost_low: f64::NAN,
        cost_high: f64::NAN,
        error_max: shown(worst.error),
        error_rms: shown(judgement.mean_square.sqrt()),
        model_max: shown(judgement.model_max),
        model_rms: shown(judgement.model_mean_square.sqrt()),
        total_max: shown(judgement.total_max),
        total_rms: shown(judgement.total_mean_square.sqrt()),
        input_max: judgement.input_max,
        input_rms: judgement.input_mean_square.sqrt(),
        samples: judgement.samples,
        excluded: judgement.excluded,
        undirected: judgement.undirected,
        failure: failure(judgement),
        worst_angle: sunglint::oracle::angle_between(l, r),
        worst_l: bits(format, &l),
        worst_r: bits(format, &r),
        // Of the worst errors' bin the middle may be beyond them.
        error_p99: shown(judgement.spread.percentile(0.99).min(worst.error)),
        error_bias: shown(judgement.bias),
        edge_max: shown(100.0 * judgement.edge_max),
        edge_rms: shown(100.0 * judgement.edge_mean_square.sqrt()),
        latency: f64::NAN,
        bound_max: shown(worst.error),
        bound_samples: judgement.samples,
        // Frontiers and counts come later.
        ..Row::default()
    }
}

/// How a method fails, if it does.
pub fn failure<T>(judgement: &Judgement<T>) -> Option<String> {
    let failure = if judgement.undirected == judgement.samples {
        "NaN"
    } else if judgement.disc_lost >= DISC_LOST {
        "disc lost"
    } else if judgement.undirected > 0 {
        "undirected"
    } else {
        return None;
    };
    Some(failure.to_owned())
}
