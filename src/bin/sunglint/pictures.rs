//! Pictures: lit spheres, the truth, and where the error sits.

use std::path::PathBuf;

use clap::Args;
use indicatif::ProgressBar;

use crate::failure::Failure;
use crate::options::Options;

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The sphere as the method lights it.
    Lit,
    /// The sphere as it is.
    Truth,
    /// The error, on a scale of decades.
    Error,
    /// Many of them with their names.
    Sheet,
}

/// A picture, encoded.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Name of its file without its ending, such as `cap-f16-lit`.
    pub name: String,
    /// `direction` or `pixel`.
    pub subject: &'static str,
    /// Name of the method; of the truth `truth`.
    pub method: String,
    /// Name of the number format, or of the failing form; of the truth `f64`.
    pub format: String,
    /// What it shows.
    pub kind: Kind,
    /// What one sees on it, in a sentence, for those who cannot.
    pub caption: String,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The PNG file.
    pub png: Vec<u8>,
}

/// `sunglint render`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    #[command(flatten)]
    pub options: Options,
    /// Pixels across a sphere
    #[arg(long, value_name = "PIXELS", default_value_t = 256)]
    pub size: u32,
    /// Folder to write to in place of OUT/pictures
    #[arg(long, value_name = "DIR")]
    pub to: Option<PathBuf>,
}

/// Steps of the progress bar in the main job.
pub fn steps(_options: &Options) -> usize {
    0
}

/// The pictures of the main job, small enough for the page, and the contact sheets, on all cores.
pub fn draw(_options: &Options, _progress: &ProgressBar) -> Vec<Picture> {
    Vec::new()
}

/// The command.
pub fn run(_arguments: &Arguments) -> Result<(), Failure> {
    Ok(())
}
