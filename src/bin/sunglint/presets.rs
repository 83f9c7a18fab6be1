//! Failures that users of other software have reported, run as named: the form that fails and its cure.

use clap::Args;
use indicatif::ProgressBar;
use serde::Serialize;

use crate::failure::Failure;
use crate::options::Options;

/// One form of one preset.
#[derive(Clone, Debug, Default, Serialize)]
pub struct PresetRow {
    /// Name of the preset, such as `filament-mediump`.
    pub preset: &'static str,
    /// Where it was reported, or seen.
    pub source: &'static str,
    /// What is computed, in a sentence.
    pub question: &'static str,
    /// `fails`, `cure` or `truth`.
    pub role: &'static str,
    /// The form: its formula and number format.
    pub form: String,
    /// What was measured, such as `pixels that are no number, per cent`.
    pub measure: String,
    /// Its value.
    pub value: f64,
    /// Whether the form fails by the preset's own criterion.
    pub fails: bool,
}

/// `sunglint preset`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Name of a preset, as `sunglint list` has it; all of them where none is given
    pub name: Option<String>,
}

/// Names and what each is about.
pub fn names() -> Vec<(&'static str, &'static str)> {
    Vec::new()
}

/// Steps of the progress bar in the main job.
pub fn steps(_options: &Options) -> usize {
    0
}

/// All presets.
pub fn measure(_options: &Options, _progress: &ProgressBar) -> Vec<PresetRow> {
    Vec::new()
}

/// The command.
pub fn run(_arguments: &Arguments) -> Result<(), Failure> {
    Ok(())
}
