//! The rows of lit pixels.

use serde::Serialize;

use super::Bound;
use crate::author;

/// One highlight method in one number format on one surface under one light. Errors are relative to the whole
/// pixel's true value.
#[derive(Clone, Debug, Default, Serialize)]
pub struct PixelRow {
    /// Light and roughness, such as `Sun, alpha 0.001`.
    pub case: String,
    /// Radius over distance of the light.
    pub ratio: f64,
    /// GGX width of the surface.
    pub alpha: f64,
    /// Name of the highlight method, such as `cone_ggx`.
    pub method: String,
    /// Name of the number format, such as `I2F14`.
    pub format: String,
    /// Whose code it is; written only where it is not what the format always runs.
    #[serde(skip_serializing_if = "author::is_ours")]
    pub by: &'static str,
    /// Time of a pixel over the time of f32 `factored` in the same run: median over the rounds.
    pub cost: f64,
    /// Lower quartile of that ratio.
    pub cost_low: f64,
    /// Upper quartile of that ratio.
    pub cost_high: f64,
    /// Worst arithmetic error: computed against the exact value of the same formula.
    pub error_max: f64,
    /// Root mean square of the arithmetic error.
    pub error_rms: f64,
    /// Worst model error: the formula's exact value against the integral over the disc; the same in every format.
    pub model_max: f64,
    /// Root mean square of the model error.
    pub model_rms: f64,
    /// The worst of both, combined: the root of the sum of their squares.
    pub total_max: f64,
    /// Root mean square of both together.
    pub total_rms: f64,
    /// Worst error that rounding directions, roughness and reflectances into the format makes by itself; in none of
    /// the errors above.
    pub input_max: f64,
    /// Root mean square of the error from rounding the inputs.
    pub input_rms: f64,
    /// Pixels whose arithmetic was judged.
    pub samples: u64,
    /// Pixels whose model was judged.
    pub model_samples: u64,
    /// `NaN` where some answer was no number, or nothing.
    pub failure: Option<String>,
    /// Raw bits of the normal at the worst arithmetic error, in hexadecimal.
    pub worst_n: String,
    /// Raw bits of the direction to the viewer there.
    pub worst_v: String,
    /// Raw bits of the direction to the light there.
    pub worst_l: String,
    /// 99th percentile of the arithmetic error's size.
    pub error_p99: f64,
    /// Mean of the signed arithmetic error: above zero where the pixel is too bright.
    pub error_bias: f64,
    /// Worst total error in steps of an 8-bit display: computed against the integral over the disc, both as sRGB, with
    /// a white surface that faces the light at 1 and whatever is brighter clipped.
    pub steps8_max: f64,
    /// Root mean square of that.
    pub steps8_rms: f64,
    /// The same in steps of a 10-bit display.
    pub steps10_max: f64,
    /// Root mean square of that.
    pub steps10_rms: f64,
    /// Time of a pixel that waits for the one before, in the unit of `cost`; median over the rounds.
    pub latency: f64,
    /// What `bound_max` rests on.
    pub bound: Bound,
    /// The worst arithmetic error known of this method, format and case.
    pub bound_max: f64,
    /// How many inputs that took; those of this run where it is sampled.
    pub bound_samples: u64,
    /// The command that computes the worst known input again.
    pub repro: String,
    /// On the frontier of total root mean square against cost, among this case's rows; totals count as equal where
    /// their first two digits are.
    pub frontier: bool,
}
