//! What a run of the study found: the rows that every output shows.

use serde::Serialize;

use crate::anchors::AnchorRow;
use crate::author;
use crate::chip::ChipRow;
use crate::curves::CurveRow;
use crate::pictures::Picture;
use crate::presets::PresetRow;
use crate::rivals::Rivals;
use crate::sweep::SweepRow;

/// What a bound of an error rests on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Bound {
    /// Every input has been tried.
    Exhaustive,
    /// A search that climbs from the worst of a million inputs.
    Searched,
    /// The inputs of this run, from its seed, and hard ones.
    #[default]
    Sampled,
}

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
    /// Worst error of the drawn edge, in per cent of the angular radius: of rays within ten radii of the light, how much
    /// farther out or in the answer lies than the nearest point of the disc.
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

/// One light quantity (sizeFactor, solid angle, ...) in one number format.
#[derive(Clone, Debug, Serialize)]
pub struct QuantityRow {
    /// Name of the quantity, such as `size_factor`.
    pub quantity: String,
    /// Name of the number format of the result, such as `f32` or `U16F48`.
    pub format: String,
    /// `ULP` or `LSB`.
    pub unit: String,
    /// Worst error in that unit.
    pub error_max: f64,
    /// Input at the worst error.
    pub worst_input: f64,
    /// Inputs that were tried.
    pub samples: u64,
    /// Inputs that were refused with a typed error, since the format cannot hold the answer.
    pub refused: u64,
}

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
    /// Worst total error in steps of an 8-bit display: computed against the integral over the disc, both as sRGB, with a
    /// white surface that faces the light at 1 and whatever is brighter clipped.
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

/// One method's whole highlight on one surface under one light, against the integral over the disc.
#[derive(Clone, Debug, Serialize)]
pub struct LobeRow {
    /// Name of the light.
    pub light: String,
    /// Radius over distance of the light.
    pub ratio: f64,
    /// GGX width of the surface.
    pub alpha: f64,
    /// Degrees between the normal and the light.
    pub incidence: u32,
    /// Name of the highlight method, such as `cone_ggx`.
    pub method: String,
    /// All light that the true highlight sends out, over the light that comes in on a facing plane.
    pub truth: f64,
    /// All light that the method sends out over that.
    pub energy: f64,
    /// The method's brightest value over the true one.
    pub peak: f64,
    /// The integral of the difference's size over that of the truth.
    pub relative_l1: f64,
    /// Nodes of the integrals' rule.
    pub nodes: usize,
}

/// One building block in one number format.
#[derive(Clone, Debug, Default, Serialize)]
pub struct KernelRow {
    /// What it is for, such as `Colour`.
    pub group: String,
    /// Name of the function.
    pub kernel: String,
    /// What its errors are in.
    pub unit: String,
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
    /// Worst error.
    pub error_max: f64,
    /// Root mean square of the error.
    pub error_rms: f64,
    /// Inputs that were tried.
    pub samples: u64,
    /// Input at the worst error: names and exact values.
    pub worst_input: String,
    /// 99th percentile of the error.
    pub error_p99: f64,
    /// Mean of the signed error, where it has a sign; else nothing.
    pub error_bias: Option<f64>,
    /// What `bound_max` rests on.
    pub bound: Bound,
    /// The worst error known of this building block in this format.
    pub bound_max: f64,
    /// How many inputs that took; those of this run where it is sampled.
    pub bound_samples: u64,
    /// The command that computes the worst known input again.
    pub repro: String,
}

/// Everything that a run found.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Study {
    /// Version of the crate.
    pub version: String,
    /// Seed of the random directions.
    pub seed: u64,
    /// What `--light` asked for.
    pub light: Option<String>,
    /// The command line that makes the same study again.
    pub command: String,
    /// Whether this was a `--quick` run.
    pub quick: bool,
    /// One row per light, method and format.
    pub rows: Vec<Row>,
    /// One row per light quantity and format.
    pub quantities: Vec<QuantityRow>,
    /// One row per case, highlight method and format.
    pub pixels: Vec<PixelRow>,
    /// The same by other code than a format always runs.
    pub rivals: Rivals,
    /// One row per light, incidence, roughness and highlight method.
    pub lobes: Vec<LobeRow>,
    /// One row per building block and format.
    pub kernels: Vec<KernelRow>,
    /// One row per function, format, author and case that was counted on microcontrollers.
    pub chip: Vec<ChipRow>,
    /// One row per light or case and format: what nothing can be cheaper or more exact than.
    pub anchors: Vec<AnchorRow>,
    /// One row per method, format and place along an angle or a ratio.
    pub curves: Vec<CurveRow>,
    /// One row per method and word: how many bits are enough.
    pub sweep: Vec<SweepRow>,
    /// One row per reported failure and form.
    pub presets: Vec<PresetRow>,
    /// Lit spheres and where their errors sit.
    #[serde(skip)]
    pub pictures: Vec<Picture>,
}
