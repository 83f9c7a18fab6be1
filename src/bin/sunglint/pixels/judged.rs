//! Pixels against the exact value of their formula, and against what a display should show.

use std::cell::RefCell;

use sunglint::Real;
use sunglint::trial::gloss::{self, Case};
use sunglint::trial::{Format, Found, Shading};

use super::arithmetic;
use crate::display::{self, WHITES};
use crate::measure::bits;
use crate::options::Options;
use crate::result::PixelRow;

/// What code made of the pixels, and its arithmetic error.
pub struct Judged {
    error: Found<9>,
    /// Over the level of white.
    levels: Vec<f64>,
}

impl Judged {
    /// Of `code`, which computes what `method` does.
    pub fn of<T: Real>(method: Shading, case: &Case, options: &Options, code: impl Fn([[T; 3]; 3]) -> f64) -> Self {
        let levels = RefCell::new(Vec::new());
        let error = gloss::arithmetic_of_code(method, case, arithmetic(case, options), |lanes| {
            let level = code(lanes);
            levels.borrow_mut().push(level);
            level
        });
        Self { error, levels: levels.into_inner() }
    }

    /// `row` with the arithmetic error, with the total that this makes with its model's, and with what a display shows
    /// of the difference from the true levels.
    pub fn row(&self, row: PixelRow, format: Format, truths: &[f64]) -> PixelRow {
        let error = &self.error;
        let [worst_n, worst_v, worst_l] = [0, 3, 6].map(|first| bits(format, &error.worst[first..first + 3]));
        let shown = display::difference(self.levels.iter().zip(truths).map(|(&level, &truth)| [level, truth]));
        let [steps8, steps10] = WHITES.map(|white| [white * shown.max, white * shown.rms]);
        PixelRow {
            error_max: error.max,
            error_rms: error.rms(),
            total_max: error.max.hypot(row.model_max),
            total_rms: error.rms().hypot(row.model_rms),
            samples: error.samples,
            failure: (!error.max.is_finite()).then(|| "NaN".to_owned()),
            worst_n,
            worst_v,
            worst_l,
            error_p99: error.p99(),
            error_bias: error.bias().unwrap_or(f64::NAN),
            steps8_max: steps8[0],
            steps8_rms: steps8[1],
            steps10_max: steps10[0],
            steps10_rms: steps10[1],
            latency: f64::NAN,
            bound_max: error.max,
            bound_samples: error.samples,
            ..row
        }
    }
}
