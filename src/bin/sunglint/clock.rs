//! What a call costs: its time over the time of f32 `factored` in the same round, contenders interleaved.

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

/// Pairs in a batch: inside the disc, about its rim, and all over the sphere.
const PAIRS: usize = 500;

/// Batches that are timed as one, so that the clock's own step does not count.
const REPEATS: u32 = 8;

/// How often every contender has its turn.
pub const fn rounds(quick: bool) -> usize {
    if quick { 15 } else { 81 }
}

/// The costs of all methods in all formats, method by method.
pub fn costs(light: &Light, options: &Options, progress: &ProgressBar) -> Vec<Cost> {
    let batches: Vec<Batch> =
        Method::ALL.into_iter().flat_map(|method| of_method(method, light, options.seed)).collect();
    let baseline = Format::F32.visit(Build { method: Method::Factored, light, seed: options.seed });
    let mut ratios = vec![Vec::new(); batches.len()];
    for _ in 0..rounds(options.quick) {
        for (batch, ratios) in batches.iter().zip(&mut ratios) {
            // The baseline before and after, so that a clock that drifts is divided out.
            let before = time(&baseline);
            let own = time(batch);
            let after = time(&baseline);
            ratios.push(2.0 * own.as_secs_f64() / (before + after).as_secs_f64());
        }
        progress.inc(1);
    }
    ratios.into_iter().map(cost).collect()
}

fn of_method(method: Method, light: &Light, seed: u64) -> [Batch; 7] {
    Format::ALL.map(|format| format.visit(Build { method, light, seed }))
}

fn time(batch: &Batch) -> Duration {
    let start = Instant::now();
    for _ in 0..REPEATS {
        batch();
    }
    start.elapsed()
}

fn cost(mut ratios: Vec<f64>) -> Cost {
    ratios.sort_by(f64::total_cmp);
    let at = |quarter: usize| ratios[(ratios.len() - 1) * quarter / 4];
    Cost { median: at(2), lower_quartile: at(1), upper_quartile: at(3) }
}

struct Build<'a> {
    method: Method,
    light: &'a Light,
    seed: u64,
}

impl Visitor for Build<'_> {
    type Output = Batch;

    fn visit<T: Real>(self) -> Batch {
        let Constants { sphere, unfactored } = Constants::<T>::of(&self.light.light);
        let pairs = input::random(self.seed, PAIRS, self.light.light.angular_radius());
        let pairs: Vec<_> = pairs.map(|pair| (pair.l.map(T::from_f64), pair.r.map(T::from_f64))).collect();
        // One closure a method, so that the compiler sees which one it is.
        match self.method {
            Method::Epic => batch(pairs, move |l, r| epic(l, r, &unfactored)),
            Method::Factored => batch(pairs, move |l, r| factored(l, r, &sphere)),
            Method::Disc => batch(pairs, move |l, r| disc(l, r, &sphere)),
            Method::Cap => batch(pairs, move |l, r| cap(l, r, &sphere)),
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
