//! What a run of the study found: the rows that every output shows.

mod direction;
mod pixel;

use serde::Serialize;

pub use direction::Row;
pub use pixel::PixelRow;

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
    /// A search that goes uphill from random and from hard inputs, over half a million or more, and this run.
    Searched,
    /// The inputs of this run, from its seed, and hard ones.
    #[default]
    Sampled,
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
    /// One row per light or case and format: the true answer as the format holds it, at the cost of an empty call.
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
