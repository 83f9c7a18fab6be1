//! How many bits are enough? Every method over word lengths that types have and that none has.

use clap::Args;
use indicatif::ProgressBar;
use serde::Serialize;

use crate::failure::Failure;
use crate::options::Options;

/// One method in one word.
#[derive(Clone, Debug, Default, Serialize)]
pub struct SweepRow {
    /// `direction` or `pixel`.
    pub subject: &'static str,
    /// Name of the light.
    pub light: String,
    /// Radius over distance of the light.
    pub ratio: f64,
    /// GGX width of the surface; none for directions.
    pub alpha: Option<f64>,
    /// Name of the method.
    pub method: String,
    /// `fixed`, `float` or `flushing float`.
    pub family: &'static str,
    /// Fraction bits, or digits of the significand.
    pub bits: u32,
    /// Name of the word, such as `Q14 in 16 bits` or `p 11, e 5, flushing`.
    pub word: String,
    /// Name of the number format that is this word, if one is.
    pub format: Option<&'static str>,
    /// Worst arithmetic error: radians, of pixels relative.
    pub error_max: f64,
    /// Root mean square of that.
    pub error_rms: f64,
    /// Worst total error.
    pub total_max: f64,
    /// Root mean square of that.
    pub total_rms: f64,
    /// Worst error of the drawn edge, in per cent of the radius; none for pixels.
    pub edge_max: Option<f64>,
    /// Inputs tried.
    pub samples: u64,
    /// Name of what failed, or nothing.
    pub failure: Option<String>,
}

/// `sunglint sweep`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    #[command(flatten)]
    pub options: Options,
}

/// Steps of the progress bar in the main job.
pub fn steps(_options: &Options) -> usize {
    0
}

/// The rows of the main job, on all cores.
pub fn measure(_options: &Options, _progress: &ProgressBar) -> Vec<SweepRow> {
    Vec::new()
}

/// The command.
pub fn run(_arguments: &Arguments) -> Result<(), Failure> {
    Ok(())
}
