//! Errors along the angle between mirror ray and light, and along the ratio of the light.

use indicatif::ProgressBar;
use serde::Serialize;

use crate::options::Options;

/// One method in one number format at one place.
#[derive(Clone, Debug, Default, Serialize)]
pub struct CurveRow {
    /// `direction` or `pixel`.
    pub subject: &'static str,
    /// Name of the method.
    pub method: String,
    /// Name of the number format.
    pub format: String,
    /// GGX width of the surface; none for directions.
    pub alpha: Option<f64>,
    /// Radius over distance of the light.
    pub ratio: f64,
    /// What varies: `angle` (radians between mirror ray and light, under the Sun) or `ratio`.
    pub along: &'static str,
    /// Its value; of a range the geometric middle.
    pub at: f64,
    /// Worst arithmetic error there: radians, of pixels relative. Infinite where an answer is no number.
    pub error_max: f64,
    /// Root mean square of that.
    pub error_rms: f64,
    /// Worst model error there; the same in every format.
    pub model_max: f64,
    /// Inputs tried.
    pub samples: u64,
}

/// Steps of the progress bar.
pub fn steps(_options: &Options) -> usize {
    0
}

/// All of them, on all cores.
pub fn measure(_options: &Options, _progress: &ProgressBar) -> Vec<CurveRow> {
    Vec::new()
}
