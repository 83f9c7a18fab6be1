//! A hard search for the worst input of a method: random directions and known hard ones, then uphill from each.
//!
//! Random inputs miss what only a few of them reach: all lanes rounded the worst way at once, the mirror ray a step
//! from where the formula ends. A climb finds that from nearby. It moves lanes by single steps of the format and more,
//! and turns the directions before they are rounded.

use core::f64::consts::PI;

use oorandom::Rand64;

use super::aim::{Candidate, Cell, Lit, Place};
use super::format::{Format, Visitor};
use super::input::{self, Pair, on_sphere, turned};
use super::worst;
use crate::real::Real;

/// Best of the first climbs, which are climbed to the end.
const KEPT: usize = 16;

/// Random inputs of which the best is climbed.
const DRAWS: usize = 256;

/// How much is tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Climbs from random inputs.
    pub starts: usize,
    /// Moves of each first climb.
    pub first: usize,
    /// Moves of each climb to the end.
    pub last: usize,
}

impl Effort {
    /// What the budgets are from: over a million inputs for each, of which half a million to 900 000 are unit vectors
    /// in the format and are judged.
    pub const FULL: Self = Self { starts: 1200, first: 500, last: 24_000 };

    /// A few thousand inputs.
    pub const SHORT: Self = Self { starts: 8, first: 60, last: 60 };
}

/// Searches a cell, beginning with what has been recorded as its worst: see [`worst`].
#[derive(Clone, Copy, Debug)]
pub struct Search {
    /// The cell.
    pub cell: Cell,
    /// How much is tried.
    pub effort: Effort,
    /// Seed of all that is random.
    pub seed: u64,
}

/// An input and its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The error.
    pub error: f64,
    /// The input.
    pub at: Candidate,
}

/// What a search found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The worst input.
    pub peak: Peak,
    /// How many inputs were judged for it.
    pub judged: u64,
}

impl Visitor for Search {
    type Output = Outcome;

    fn visit<T: Real>(self) -> Outcome {
        let mut climber = Climber::<T>::new(&self);
        let peak = climber.worst(self.effort);
        Outcome { peak, judged: climber.judged }
    }
}

struct Climber<T: Real> {
    cell: Cell,
    source: Rand64,
    /// Of a place with one light only.
    lit: Option<Lit<T>>,
    judged: u64,
}

impl<T: Real> Climber<T> {
    fn new(search: &Search) -> Self {
        let cell = search.cell;
        let one = matches!(cell.place, Place::Light(_));
        let lit = one.then(|| Lit::of(cell.place.light(0.0)));
        Self { cell, source: Rand64::new(search.seed.into()), lit, judged: 0 }
    }

    fn worst(&mut self, effort: Effort) -> Peak {
        let mut kept = [Peak { error: -1.0, at: self.random() }; KEPT];
        let (aim, format) = (self.cell.aim, self.cell.format);
        for record in worst::recorded().filter(|record| record.cell.aim == aim && record.cell.format == format) {
            self.start(record.at, effort.first, &mut kept);
        }
        for pair in input::hard(self.cell.place.sizes()[1]) {
            let at = Candidate { size: self.size(), pair };
            self.start(at, effort.first, &mut kept);
        }
        for start in 0..effort.starts {
            let at = self.best_of_many(start % 4 == 0);
            self.start(at, effort.first, &mut kept);
        }
        let peaks = kept.map(|peak| self.climb(peak, effort.last));
        let best = peaks.into_iter().fold(kept[0], higher);
        self.climb(best, effort.last)
    }

    /// Climbs from an input for a while, and keeps what comes of it if that is one of the best.
    fn start(&mut self, at: Candidate, moves: usize, kept: &mut [Peak; KEPT]) {
        let [least, most] = self.cell.place.sizes();
        let at = Candidate { size: at.size.clamp(least, most), pair: rounded::<T>(at.pair) };
        let Some(peak) = self.peak(at) else { return };
        let peak = self.climb(peak, moves);
        if let Some(lowest) = kept.iter_mut().min_by(|a, b| a.error.total_cmp(&b.error)) {
            *lowest = higher(*lowest, peak);
        }
    }

    fn climb(&mut self, mut peak: Peak, moves: usize) -> Peak {
        for _ in 0..moves {
            let at = self.moved(peak.at);
            if let Some(next) = self.peak(at) {
                peak = higher(peak, next);
            }
        }
        peak
    }

    /// The error of an input that is one.
    fn peak(&mut self, at: Candidate) -> Option<Peak> {
        let format = self.cell.format;
        let admitted = may_be_unit(format, at.pair.l) && may_be_unit(format, at.pair.r);
        let lit = || self.lit.unwrap_or_else(|| Lit::of(self.cell.place.light(at.size)));
        let error = if admitted { self.cell.aim.error(format, &lit(), &at) } else { None };
        self.judged += u64::from(error.is_some());
        error.map(|error| Peak { error, at })
    }

    fn best_of_many(&mut self, parallel: bool) -> Candidate {
        let mut best = Peak { error: -1.0, at: self.random() };
        for _ in 0..DRAWS {
            let at = if parallel { self.parallel() } else { self.random() };
            let at = Candidate { pair: rounded::<T>(at.pair), ..at };
            best = self.peak(at).map_or(best, |peak| higher(best, peak));
        }
        best.at
    }

    fn random(&mut self) -> Candidate {
        let size = self.size();
        let pair = input::random(self.source.rand_u64(), 5, size).nth(self.source.rand_range(0..5) as usize);
        Candidate { size, pair: pair.unwrap_or(input::scene(size)) }
    }

    /// A few steps from parallel or opposite, which no angle reaches in f64.
    fn parallel(&mut self) -> Candidate {
        let Candidate { size, pair } = self.random();
        let l = rounded::<T>(pair).l;
        let sign = if self.source.rand_u64() & 1 == 0 { 1.0 } else { -1.0 };
        let mut pair = Pair { l, r: l.map(|lane| sign * lane) };
        self.step_lanes(&mut pair);
        Candidate { size, pair }
    }

    fn size(&mut self) -> f64 {
        let [least, most] = self.cell.place.sizes();
        let part = self.source.rand_float();
        match self.source.rand_range(0..8) {
            0 => least,
            1 => most,
            2 => most - (most - least) * libm::pow(1e-12, part),
            3..5 => least + (most - least) * part,
            // Down to a ten-thousandth of the greatest where there is no least.
            _ => {
                let from = least.max(1e-4 * most);
                if from > 0.0 { from * libm::pow(most / from, part) } else { most }
            }
        }
    }

    /// An input beside another one.
    fn moved(&mut self, at: Candidate) -> Candidate {
        let mut next = at;
        match self.source.rand_range(0..8) {
            0..4 => self.step_lanes(&mut next.pair),
            4 => next.pair.r = self.nudged(at.pair.r),
            5 => next.pair.l = self.nudged(at.pair.l),
            6 => {
                let (axis, angle) = (on_sphere(&mut self.source), self.small());
                next.pair = Pair { l: rotated(at.pair.l, axis, angle), r: rotated(at.pair.r, axis, angle) };
            }
            // About the light, so that the angle between the two stays.
            _ => next.pair.r = rotated(at.pair.r, at.pair.l, self.small()),
        }
        let [least, most] = self.cell.place.sizes();
        if least < most && self.source.rand_range(0..2) == 0 {
            let sign = if self.source.rand_u64() & 1 == 0 { 1.0 } else { -1.0 };
            next.size = (at.size * (1.0 + sign * self.small() / PI)).clamp(least, most);
        }
        Candidate { pair: rounded::<T>(next.pair), ..next }
    }

    /// Up to three lanes by steps of their own size or of the format's, up to 64 of them.
    fn step_lanes(&mut self, pair: &mut Pair) {
        for _ in 0..self.source.rand_range(1..4) {
            let bits = self.source.rand_u64();
            let vector = if bits & 1 == 0 { &mut pair.l } else { &mut pair.r };
            let lane = &mut vector[(bits >> 1) as usize % 3];
            let format = self.cell.format;
            let step = if bits & 8 == 0 { format.ulp(*lane) } else { format.step() };
            let steps = (1 << (self.source.rand_range(0..13) / 2)) as f64;
            *lane += if bits & 16 == 0 { step * steps } else { -step * steps };
        }
    }

    fn nudged(&mut self, v: [f64; 3]) -> [f64; 3] {
        let aside = on_sphere(&mut self.source);
        turned(v, aside, self.small())
    }

    /// An angle from well below a step of the format to a right one.
    fn small(&mut self) -> f64 {
        let least = self.cell.format.step() / 8.0;
        least * libm::pow(PI / 2.0 / least, self.source.rand_float())
    }
}

/// The worse of the two; the second where they are as bad, so that a climb crosses plateaus.
fn higher(a: Peak, b: Peak) -> Peak {
    if b.error >= a.error { b } else { a }
}

fn rounded<T: Real>(pair: Pair) -> Pair {
    let round = |v: [f64; 3]| v.map(|lane| T::from_f64(lane).to_f64());
    Pair { l: round(pair.l), r: round(pair.r) }
}

/// `v` about `axis` (Rodrigues).
fn rotated(v: [f64; 3], axis: [f64; 3], angle: f64) -> [f64; 3] {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let [a, b, c] = axis;
    let along = (1.0 - cos) * (a * v[0] + b * v[1] + c * v[2]);
    let across = [b * v[2] - c * v[1], c * v[0] - a * v[2], a * v[1] - b * v[0]];
    input::unit([0, 1, 2].map(|i| cos * v[i] + sin * across[i] + along * axis[i]))
}

/// Whether some vector of length 1 is `v` once its lanes are rounded to nearest: whether the box of half a step about
/// `v` holds a point of length 1.
pub fn may_be_unit(format: Format, v: [f64; 3]) -> bool {
    let lanes = v.map(libm::fabs);
    // How much shorter and longer the squares can be than v's own.
    let (mut shorter, mut longer) = (0.0, 0.0);
    for lane in lanes {
        let outward = format.ulp(lane) / 2.0;
        // Below a power of two the steps are half as wide.
        let inward = (format.ulp(lane.next_down()) / 2.0).min(lane);
        longer += (2.0 * lane + outward) * outward;
        shorter += (2.0 * lane - inward) * inward;
    }
    let excess = excess(lanes);
    -longer <= excess && excess <= shorter
}

/// `x^2 + y^2 + z^2 - 1` with the rounding of every product and sum put back.
fn excess(lanes: [f64; 3]) -> f64 {
    let (mut sum, mut lost) = (-1.0, 0.0);
    for lane in lanes {
        let square = lane * lane;
        let next: f64 = sum + square;
        let kept = next - sum;
        lost += libm::fma(lane, lane, -square) + ((sum - (next - kept)) + (square - kept));
        sum = next;
    }
    sum + lost
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounding_makes_of_unit_vectors_is_admitted_and_no_more() {
        let step = Format::I2F14.step();
        assert!(may_be_unit(Format::I2F14, [1.0, 0.0, 0.0]));
        assert!(!may_be_unit(Format::I2F14, [1.0 + step, 0.0, 0.0]));
        assert!(may_be_unit(Format::I2F14, [1.0 - step, 180.0 * step, 0.0]));
        assert!(!may_be_unit(Format::I2F14, [1.0 - step, 0.0, 0.0]));
        // sqrt(2 - 2^-12) 2^-5.5 is the longest that rounds to 1 beside it.
        assert!(may_be_unit(Format::F16, [1.0, 0.0221, 0.0]));
        assert!(!may_be_unit(Format::F16, [1.0, 0.0223, 0.0]));
        assert!(!may_be_unit(Format::F32, [0.6, 0.0, 0.8 + 2e-7]));
    }
}
