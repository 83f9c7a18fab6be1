//! What a call costs: its time over the time of f32 `factored` in the same round, contenders interleaved. The time of
//! an empty call, which loads the same inputs and stores one of them, is taken off both.
//!
//! Directions, whole pixels and building blocks are all in that one unit, so that their costs can be added up and
//! their charts laid side by side.

use std::hint::black_box;
use std::time::{Duration, Instant};

use indicatif::ProgressBar;

/// The least cost that can be told from nothing; what is cheaper counts as this much.
pub const LEAST: f64 = 1.0 / 16.0;

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

impl Cost {
    /// Median, lower and upper quartile.
    pub fn figures(self) -> (f64, f64, f64) {
        (self.median, self.lower_quartile, self.upper_quartile)
    }
}

/// Calls every contender's answer to all inputs once.
pub type Batch = Box<dyn Fn()>;

/// A function in a format, and the empty call in that format.
pub struct Contender {
    /// Calls the function on every input.
    pub call: Batch,
    /// Loads every input and stores a part of it.
    pub empty: Batch,
    /// On how many inputs.
    pub inputs: usize,
}

impl Contender {
    /// The calls of `function` on `inputs`; an empty call stores the `part` of an input.
    pub fn new<I: Clone + 'static, O, P>(
        inputs: Vec<I>,
        function: impl Fn(&I) -> O + 'static,
        part: impl Fn(&I) -> P + 'static,
    ) -> Self {
        let count = inputs.len();
        Self { call: batch(inputs.clone(), function), empty: batch(inputs, part), inputs: count }
    }
}

/// A call of `function` on each of `inputs`.
pub fn batch<I: 'static, O>(inputs: Vec<I>, function: impl Fn(&I) -> O + 'static) -> Batch {
    Box::new(move || {
        for input in &inputs {
            // The reference, since a copy that has just been stored is slow to load.
            black_box(function(black_box(input)));
        }
    })
}

/// The costs of all `contenders` as multiples of the `baseline`, over `rounds` rounds, each a step of `progress`.
pub fn costs(contenders: &[Contender], baseline: &Contender, rounds: usize, progress: &ProgressBar) -> Vec<Cost> {
    let mut ratios = vec![Vec::new(); contenders.len()];
    for _ in 0..rounds {
        for (contender, ratios) in contenders.iter().zip(&mut ratios) {
            // The baseline before and after, so that a clock that drifts is divided out.
            let before = baseline.seconds();
            let own = contender.seconds();
            let after = baseline.seconds();
            ratios.push((2.0 * own / (before + after)).max(LEAST));
        }
        progress.inc(1);
    }
    ratios.into_iter().map(cost).collect()
}

impl Contender {
    /// What a call takes beyond an empty one, which is less than nothing if the processor hides the call behind the
    /// stores.
    fn seconds(&self) -> f64 {
        let call = time(&self.call).as_secs_f64();
        let empty = time(&self.empty).as_secs_f64();
        (call - empty) / self.inputs as f64
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_are_those_of_the_sorted_ratios() {
        let cost = cost(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!([cost.lower_quartile, cost.median, cost.upper_quartile], [2.0, 3.0, 4.0]);
    }

    #[test]
    fn a_round_is_a_ratio_for_each_contender() {
        let contender = || Contender {
            call: batch(vec![1.0; 50], |x: &f64| x.sqrt()),
            empty: batch(vec![1.0; 50], |x| *x),
            inputs: 50,
        };
        let costs = costs(&[contender(), contender()], &contender(), 3, &ProgressBar::hidden());
        assert_eq!(costs.len(), 2);
        assert!(costs.iter().all(|cost| cost.median >= LEAST && cost.lower_quartile <= cost.upper_quartile));
    }
}
