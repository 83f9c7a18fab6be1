//! The errors of every method in every format, on all cores.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use indicatif::ProgressBar;
use sunglint::Real;
use sunglint::trial::judge::DISC_LOST;
use sunglint::trial::{Format, Judgement, Light, Method, Visitor, input, judge, lights};

use crate::clock::{self, Cost};
use crate::options::Options;
use crate::quantities;
use crate::result::{Row, Study};

/// Random pairs a contender is tried on, beside the hard ones.
const PAIRS: usize = 150_000;

/// The same with `--quick`.
const QUICK_PAIRS: usize = 10_000;

/// A method in a format under a light.
type Contender = (Light, Method, Format);

/// Names of the lights that can be asked for.
pub fn light_names() -> Vec<String> {
    lights::STUDY.iter().map(|light| light.name.to_owned()).collect()
}

/// Measures what `options` asks for: errors on all cores, then costs on a quiet machine.
pub fn run(options: &Options, progress: &ProgressBar) -> Study {
    let lights: Vec<_> = lights::STUDY.into_iter().filter(|light| options.wants(light.name)).collect();
    let contenders: Vec<Contender> = lights.iter().flat_map(|&light| of_light(light)).collect();
    let rounds = clock::rounds(options.quick);
    progress.set_length((contenders.len() + lights.len() * rounds + quantities::COUNT) as u64);
    let mut rows = errors(&contenders, options, progress);
    let quantities = quantities::measure(options, progress);
    for (light, rows) in lights.iter().zip(rows.chunks_mut(Method::ALL.len() * Format::ALL.len())) {
        progress.set_message(format!("timing, {}", light.name));
        for (row, cost) in rows.iter_mut().zip(clock::costs(light, options, progress)) {
            set_cost(row, cost);
        }
    }
    Study {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        seed: options.seed,
        light: options.light.clone(),
        quick: options.quick,
        rows,
        quantities,
    }
}

/// All methods and formats in the order that [`clock::costs`] keeps too.
fn of_light(light: Light) -> impl Iterator<Item = Contender> {
    Method::ALL.into_iter().flat_map(move |method| Format::ALL.map(|format| (light, method, format)))
}

fn set_cost(row: &mut Row, cost: Cost) {
    row.cost = cost.median;
    row.cost_low = cost.lower_quartile;
    row.cost_high = cost.upper_quartile;
}

/// Judges the contenders, each by whichever core is free next.
fn errors(contenders: &[Contender], options: &Options, progress: &ProgressBar) -> Vec<Row> {
    let next = AtomicUsize::new(0);
    let rows = Mutex::new(vec![None; contenders.len()]);
    let work = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(&(light, method, format)) = contenders.get(index) else { break };
            progress.set_message(format!("{}, {} in {}", light.name, method.name(), format.name()));
            let row = format.visit(Judge { light, method, format, options });
            rows.lock().unwrap_or_else(PoisonError::into_inner)[index] = Some(row);
            progress.inc(1);
        }
    };
    let others = thread::available_parallelism().map_or(0, |cores| cores.get() - 1);
    thread::scope(|scope| {
        // A thread that cannot be had leaves its work to the rest.
        (0..others).for_each(|_| drop(thread::Builder::new().spawn_scoped(scope, work)));
        work();
    });
    rows.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter().flatten().collect()
}

struct Judge<'a> {
    light: Light,
    method: Method,
    format: Format,
    options: &'a Options,
}

impl Visitor for Judge<'_> {
    type Output = Row;

    fn visit<T: Real>(self) -> Row {
        let theta = self.light.light.angular_radius();
        let count = if self.options.quick { QUICK_PAIRS } else { PAIRS };
        let pairs = input::random(self.options.seed, count, theta).chain(input::hard(theta));
        let judgement = judge::<T>(self.method, &self.light.light, pairs, self.format.step());
        row(self.light, self.method, self.format, &judgement)
    }
}

fn row<T: Real>(light: Light, method: Method, format: Format, judgement: &Judgement<T>) -> Row {
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
        worst_l: bits(format, l),
        worst_r: bits(format, r),
        frontier: false,
        total_frontier: false,
    }
}

fn failure<T>(judgement: &Judgement<T>) -> Option<String> {
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

/// The raw bits of the three lanes in hexadecimal.
fn bits(format: Format, v: [f64; 3]) -> String {
    let digits = format.width() / 4;
    v.map(|lane| format!("{:0digits$x}", format.bits(lane))).join(" ")
}
