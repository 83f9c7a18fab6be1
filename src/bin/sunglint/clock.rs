//! What a call costs: its time over the time of f32 `factored` in the same round, contenders interleaved. The time of
//! an empty call, which loads the same inputs and stores one of them, is taken off both.
//!
//! Directions, whole pixels and building blocks are all in that one unit, so that their costs can be added up and
//! their charts laid side by side.
//!
//! Calls are independent of each other, so that a processor works on several at once: that is throughput. Latency is
//! the time of a call that waits for the one before, in the same unit.

use std::hint::black_box;
use std::time::{Duration, Instant};

use indicatif::ProgressBar;
use sunglint::{Real, Scalar};

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

/// The same where each call waits for the answer before: which input is next hangs on that answer's `bits`.
///
/// To which input they lead is not known before the answer is, to compiler and processor alike, though it is always the
/// one that follows: of the bits, only what a mask hides from both, which is nothing, counts. So the value is never
/// touched, NaN and infinity do no harm, and an empty chain takes as long to fetch an input and to read the bits.
pub fn chain<I: 'static, O>(
    inputs: Vec<I>,
    function: impl Fn(&I) -> O + 'static,
    bits: impl Fn(&O) -> u64 + 'static,
) -> Batch {
    Box::new(move || {
        let nothing = black_box(0);
        let mut index = 0;
        while let Some(input) = inputs.get(index) {
            let answer = black_box(function(black_box(input)));
            index += 1 + (bits(&answer) & nothing) as usize;
        }
    })
}

/// Whether calls wait for each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// A [`batch`].
    Independent,
    /// A [`chain`].
    Waiting,
}

impl Pace {
    /// The calls of `function` at this pace.
    pub fn calls<I: 'static, O>(
        self,
        inputs: Vec<I>,
        function: impl Fn(&I) -> O + 'static,
        bits: impl Fn(&O) -> u64 + 'static,
    ) -> Batch {
        match self {
            Self::Independent => batch(inputs, function),
            Self::Waiting => chain(inputs, function, bits),
        }
    }
}

/// All bits of a direction, as of f64.
pub fn lane_bits<T: Real>(lanes: &[T; 3]) -> u64 {
    lanes.iter().fold(0, |bits, lane| bits ^ lane.to_f64().to_bits())
}

/// All bits of a level, as of f64.
pub fn level_bits<T: Real>(&level: &T::Level) -> u64 {
    T::of_level(level).exact().to_bits()
}

/// The costs of all `contenders` as multiples of the `baseline`, over `rounds` rounds, each a step of `progress`; at
/// least [`LEAST`].
pub fn costs(contenders: &[Contender], baseline: &Contender, rounds: usize, progress: &ProgressBar) -> Vec<Cost> {
    let at_least = |Cost { median, lower_quartile, upper_quartile }| Cost {
        median: f64::max(median, LEAST),
        lower_quartile: f64::max(lower_quartile, LEAST),
        upper_quartile: f64::max(upper_quartile, LEAST),
    };
    ratios(contenders, baseline, rounds, progress).into_iter().map(at_least).collect()
}

/// The same as they were found, below nothing too where the processor hides a call behind its stores.
pub fn ratios(contenders: &[Contender], baseline: &Contender, rounds: usize, progress: &ProgressBar) -> Vec<Cost> {
    let mut ratios = vec![Vec::new(); contenders.len()];
    for _ in 0..rounds {
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
    use std::cell::RefCell;
    use std::rc::Rc;

    use super::*;

    #[test]
    fn quartiles_are_those_of_the_sorted_ratios() {
        let cost = cost(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!([cost.lower_quartile, cost.median, cost.upper_quartile], [2.0, 3.0, 4.0]);
    }

    #[test]
    fn a_chain_calls_every_input_once_whatever_it_answers() {
        for answer in [0.5, -0.0, f64::NAN, f64::NEG_INFINITY] {
            let seen = Rc::new(RefCell::new(Vec::new()));
            let kept = Rc::clone(&seen);
            let function = move |&input: &u32| {
                kept.borrow_mut().push(input);
                answer
            };
            chain(vec![3, 1, 4, 1, 5], function, |answer: &f64| answer.to_bits())();
            assert_eq!(*seen.borrow(), [3, 1, 4, 1, 5]);
        }
    }

    #[test]
    fn bits_hang_on_every_lane() {
        let lanes = [sunglint::half::f16::ONE, sunglint::half::f16::NAN, sunglint::half::f16::EPSILON];
        for place in 0..3 {
            let mut other = lanes;
            other[place] = sunglint::half::f16::ZERO;
            assert_ne!(lane_bits(&lanes), lane_bits(&other));
        }
        assert_ne!(level_bits::<f32>(&1.0), level_bits::<f32>(&1.5));
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
