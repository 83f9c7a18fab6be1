//! What a call costs on the pixels of a ball: its time over the time of f32 `factored` in the same round, contenders
//! interleaved. The time of an empty call, which loads the same directions and stores one of them, is taken off both.

use std::hint::black_box;
use std::time::{Duration, Instant};

use indicatif::ProgressBar;
use sunglint::trial::{Constants, Format, Light, Method, Visitor, input};
use sunglint::{Real, cap, disc, epic, factored};

use crate::options::Options;

/// Median and quartiles of a contender's ratio to the baseline over the rounds.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// Half of the rounds were cheaper.
    pub median: f64,
    /// A quarter of the rounds was cheaper.
    pub lower_quartile: f64,
    /// A quarter of the rounds was dearer.
    pub upper_quartile: f64,
}

/// Calls every contender's answer to all pairs once.
type Batch = Box<dyn Fn()>;

/// Pixels across the ball whose pixels make a batch.
const SIDE: u32 = 64;

/// How often every contender has its turn.
pub const fn rounds(quick: bool) -> usize {
    if quick { 17 } else { 81 }
}

/// The costs of all methods in all formats, method by method.
pub fn costs(light: &Light, options: &Options, progress: &ProgressBar) -> Vec<Cost> {
    let build = |method, format: Format| format.visit(Build { method, light });
    let contenders: Vec<Contender> = Method::ALL
        .into_iter()
        .flat_map(|method| Format::ALL.map(|format| (Some(method), format)))
        .map(|(method, format)| Contender { call: build(method, format), empty: build(None, format) })
        .collect();
    let baseline = Contender { call: build(Some(Method::Factored), Format::F32), empty: build(None, Format::F32) };
    let mut ratios = vec![Vec::new(); contenders.len()];
    for _ in 0..rounds(options.quick) {
        for (contender, ratios) in contenders.iter().zip(&mut ratios) {
            // The baseline before and after, so that a clock that drifts is divided out.
            let before = baseline.seconds();
            let own = contender.seconds();
            let after = baseline.seconds();
            ratios.push(2.0 * own / (before + after));
        }
        progress.inc(1);
    }
    ratios.into_iter().map(cost).collect()
}

/// A method in a format, and the empty call in that format.
struct Contender {
    call: Batch,
    empty: Batch,
}

impl Contender {
    /// What the calls take beyond empty ones; never quite nothing, since ratios are drawn on a logarithmic axis.
    fn seconds(&self) -> f64 {
        let call = time(&self.call).as_secs_f64();
        let empty = time(&self.empty).as_secs_f64();
        (call - empty).max(call / 1000.0)
    }
}

fn time(batch: &Batch) -> Duration {
    let start = Instant::now();
    batch();
    start.elapsed()
}

fn cost(mut ratios: Vec<f64>) -> Cost {
    ratios.sort_by(f64::total_cmp);
    let at = |quarter: usize| ratios[(ratios.len() - 1) * quarter / 4];
    Cost { median: at(2), lower_quartile: at(1), upper_quartile: at(3) }
}

/// A batch of calls of a method, or of empty ones.
struct Build<'a> {
    method: Option<Method>,
    light: &'a Light,
}

impl Visitor for Build<'_> {
    type Output = Batch;

    fn visit<T: Real>(self) -> Batch {
        let Constants { sphere, unfactored } = Constants::<T>::of(&self.light.light);
        let pairs = input::ball(SIDE);
        let pairs: Vec<_> = pairs.map(|pair| (pair.l.map(T::from_f64), pair.r.map(T::from_f64))).collect();
        // One closure a method, so that the compiler sees which one it is.
        match self.method {
            Some(Method::Epic) => batch(pairs, move |l, r| epic(l, r, &unfactored)),
            Some(Method::Factored) => batch(pairs, move |l, r| factored(l, r, &sphere)),
            Some(Method::Disc) => batch(pairs, move |l, r| disc(l, r, &sphere)),
            Some(Method::Cap) => batch(pairs, move |l, r| cap(l, r, &sphere)),
            None => batch(pairs, |l, _| l),
        }
    }
}

/// A pair of directions in a format.
type Directions<T> = ([T; 3], [T; 3]);

fn batch<T: Real>(pairs: Vec<Directions<T>>, method: impl Fn([T; 3], [T; 3]) -> [T; 3] + 'static) -> Batch {
    Box::new(move || {
        for &(l, r) in &pairs {
            black_box(method(black_box(l), black_box(r)));
        }
    })
}

#[cfg(test)]
mod tests {
    use super::cost;

    #[test]
    fn quartiles_are_those_of_the_sorted_ratios() {
        let cost = cost(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!([cost.lower_quartile, cost.median, cost.upper_quartile], [2.0, 3.0, 4.0]);
    }
}
