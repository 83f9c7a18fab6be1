//! What nothing can be cheaper or more exact than: the empty call, and the true answer rounded into the format.

use indicatif::ProgressBar;
use serde::Serialize;

use crate::options::Options;

/// Of one light or case in one number format.
#[derive(Clone, Debug, Default, Serialize)]
pub struct AnchorRow {
    /// `direction` or `pixel`.
    pub subject: &'static str,
    /// Name of the light, or of the case.
    pub light: String,
    /// Name of the number format.
    pub format: String,
    /// Time of an empty call, which loads the inputs and stores as many lanes as an answer has, in calls of f32
    /// `factored`.
    pub empty: f64,
    /// Worst error of the true answer once it is rounded into the format: in radians, of pixels relative.
    pub rounded_max: f64,
    /// Root mean square of that.
    pub rounded_rms: f64,
}

/// Steps of the progress bar.
pub fn steps(_options: &Options) -> usize {
    0
}

/// All of them.
pub fn measure(_options: &Options, _progress: &ProgressBar) -> Vec<AnchorRow> {
    Vec::new()
}
