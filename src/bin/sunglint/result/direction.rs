//! The rows of directions.

use serde::Serialize;

use super::Bound;
use crate::author;

/// One method in one number format under one light.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Row {
    /// Name of the light, such as `Sun from Earth`.
    pub light: String,
    /// Radius over distance of the light.
    pub ratio: f64,
    /// Angular radius of the light, in radians.
    pub theta: f64,
    /// `epic`, `factored`, `disc` or `cap`.
    pub method: String,
    /// Name of the number format, such as `I2F14`.
    pub format: String,
    /// Whose code it is; written only where it is not what the format always runs.
    #[serde(skip_serializing_if = "author::is_ours")]
    pub by: &'static str,
    /// Time of a call over the time of f32 `factored` in the same run: median over the rounds.
    pub cost: f64,
    /// Lower quartile of that ratio.
    pub cost_low: f64,
    /// Upper quartile of that ratio.
    pub cost_high: f64,
    /// Worst arithmetic error in radians: computed against the exact value of the same formula.
    pub error_max: f64,
    /// Root mean square of the arithmetic error, in radians.
    pub error_rms: f64,
    /// Worst model error in radians: the formula's exact value against the nearest point of the disc.
    pub model_max: f64,
    /// Root mean square of the model error, in radians.
    pub model_rms: f64,
    /// Worst error of both together in radians: computed against the nearest point of the disc.
    pub total_max: f64,
    /// Root mean square of both together, in radians.
    pub total_rms: f64,
    /// Worst error in radians that rounding the directions into the format makes by itself, for rays within 90
    /// degrees of the light; in none of the errors above.
    pub input_max: f64,
    /// Root mean square of the error from rounding the directions, in radians.
    pub input_rms: f64,
    /// Directions that were tried and judged.
    pub samples: u64,
    /// Directions that were left out, since the formula has no one answer there: beside the opposite of the light, or
    /// where the representative point falls into the origin.
    pub excluded: u64,
    /// Answers that are no direction: NaN, infinity or the zero vector.
    pub undirected: u64,
    /// `NaN`, `disc lost`, or nothing where the method works.
    pub failure: Option<String>,
    /// Angle between light and mirror direction at the worst arithmetic error, in radians.
    pub worst_angle: f64,
    /// Raw bits of the light direction at the worst arithmetic error, in hexadecimal.
    pub worst_l: String,
    /// Raw bits of the mirror direction at the worst arithmetic error, in hexadecimal.
    pub worst_r: String,
    /// 99th percentile of the arithmetic error, in radians.
    pub error_p99: f64,
    /// Mean of the signed arithmetic error, in radians: how much farther from the light's centre the answer lies than
    /// the exact one.
    pub error_bias: f64,
    /// Worst error of the drawn edge, in per cent of the angular radius: of rays within ten radii of the light, how
    /// much farther out or in the answer lies than the nearest point of the disc.
    pub edge_max: f64,
    /// Root mean square of that.
    pub edge_rms: f64,
    /// Time of a call that waits for the answer of the one before, in the unit of `cost`; median over the rounds.
    pub latency: f64,
    /// What `bound_max` rests on.
    pub bound: Bound,
    /// The worst arithmetic error known of this method, format and light, in radians.
    pub bound_max: f64,
    /// How many inputs that took; those of this run where it is sampled.
    pub bound_samples: u64,
    /// The command that computes the worst known input again.
    pub repro: String,
    /// On the frontier of arithmetic error against cost, among this light's rows.
    pub frontier: bool,
    /// On the frontier of total error against cost, among this light's rows.
    pub total_frontier: bool,
    /// Instructions of a call on a Cortex-M0+, median outside the disc, as counted under the Sun.
    pub m0_instructions: Option<u32>,
    /// On the frontier of arithmetic error against these.
    pub m0_frontier: bool,
    /// On the frontier of total error against these.
    pub m0_total_frontier: bool,
    /// The same on a Cortex-M3.
    pub m3_instructions: Option<u32>,
    /// On the frontier of arithmetic error against these.
    pub m3_frontier: bool,
    /// On the frontier of total error against these.
    pub m3_total_frontier: bool,
    /// The same on a Cortex-M4F.
    pub m4_instructions: Option<u32>,
    /// On the frontier of arithmetic error against these.
    pub m4_frontier: bool,
    /// On the frontier of total error against these.
    pub m4_total_frontier: bool,
}
