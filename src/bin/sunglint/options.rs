//! What the user asked for on the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use sunglint::trial::gloss::Case;
use sunglint::trial::{Format, Light, Method, Shading};

use crate::failure::Failure;
use crate::filter::Filter;
use crate::{measure, pictures, presets, repro, snippets, sweep, worst};

/// Seed of the random directions where none is given.
pub const DEFAULT_SEED: u64 = 1;

/// What every help of the whole tool ends with.
const MANNERS: &str = "\
Examples:
  sunglint                                  measure all of it
  sunglint --quick --method cap --method factored --light mars
  sunglint --angle 0.53 --alpha 0.1 --format f16
  sunglint worst --method cap --light earth
  sunglint list                             all names

Exit codes: 0 done, 1 a file could not be written, 2 wrong command line, 130 interrupted by Ctrl-C.
Ctrl-C leaves the files of an earlier run as they were; a second one ends at once.";

/// The command line.
#[derive(Clone, Debug, Parser)]
#[command(name = "sunglint", version, about = "Error against cost of every lighting method in every number format")]
#[command(args_conflicts_with_subcommands = true, after_help = MANNERS)]
pub struct Cli {
    /// What to do; `chart` where nothing is named.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Options of `chart`.
    #[command(flatten)]
    pub options: Options,
}

/// What to do.
#[derive(Clone, Debug, Subcommand)]
pub enum Command {
    /// Measure, print the tables and write the report with all its files (the default)
    Chart(Options),
    /// Print the worst input of every method, each with the command that computes it again
    #[command(mut_arg("out", |out| out.hide(true)))]
    Worst(worst::Arguments),
    /// Compute one input again: the answer, the truth and the error
    Repro(repro::Arguments),
    /// Draw lit spheres, the truth and where the error sits, as PNG
    Render(pictures::Arguments),
    /// How many bits are enough? Try word lengths that types have and that none has
    #[command(mut_arg("out", |out| out.hide(true)))]
    Sweep(sweep::Arguments),
    /// Run failures that were reported elsewhere, and their cures
    Preset(presets::Arguments),
    /// Print a recommended method in GLSL, HLSL, WGSL or FPCore
    Snippet(snippets::Arguments),
    /// List methods, formats, lights, cases, presets and snippets
    List,
}

impl Command {
    /// What it measures, if it does.
    pub fn options(&self) -> Option<&Options> {
        match self {
            Self::Chart(options) => Some(options),
            Self::Worst(arguments) => Some(&arguments.options),
            Self::Render(arguments) => Some(&arguments.options),
            Self::Sweep(arguments) => Some(&arguments.options),
            Self::Repro(_) | Self::Preset(_) | Self::Snippet(_) | Self::List => None,
        }
    }
}

/// What is measured, and where it goes.
#[derive(Args, Clone, Debug)]
pub struct Options {
    /// Folder to write to; made if it is missing
    #[arg(long, value_name = "DIR", default_value = "target/sunglint")]
    pub out: PathBuf,

    /// Try fewer inputs: a few seconds, but less of the worst cases
    ///
    /// Fewer directions and pixels, and coarser integrals.
    #[arg(long)]
    pub quick: bool,

    /// Seed of the random inputs; the same seed gives the same errors
    #[arg(long, value_name = "N", default_value_t = DEFAULT_SEED)]
    pub seed: u64,

    /// Which part of it is measured.
    #[command(flatten)]
    pub filter: Filter,

    /// Show no progress; of `chart` print no table, only the path of the report
    #[arg(short, long)]
    pub quiet: bool,
}

impl Options {
    /// Those of a command line without a subcommand.
    #[cfg(test)]
    pub fn parse_from<const N: usize>(arguments: [&str; N]) -> Self {
        Cli::parse_from(arguments).options
    }

    /// The lights of the directions.
    pub fn lights(&self) -> Vec<Light> {
        self.filter.lights()
    }

    /// Lights and roughnesses of the lit pixels.
    pub fn cases(&self) -> Vec<Case> {
        self.filter.cases()
    }

    /// Whether the method of this name is to be measured.
    pub fn wants_method(&self, method: &str) -> bool {
        self.filter.wants_method(method)
    }

    /// Whether `format` is to be measured.
    pub fn wants_format(&self, format: Format) -> bool {
        self.filter.wants_format(format)
    }

    /// The formats that are to be measured.
    pub fn formats(&self) -> impl Iterator<Item = Format> + '_ {
        Format::ALL.into_iter().filter(|&format| self.wants_format(format))
    }

    /// The direction methods that are to be measured.
    pub fn methods(&self) -> impl Iterator<Item = Method> + '_ {
        Method::ALL.into_iter().filter(|method| self.wants_method(method.name()))
    }

    /// The highlight methods that are to be measured.
    pub fn shadings(&self) -> impl Iterator<Item = Shading> + '_ {
        Shading::ALL.into_iter().filter(|method| self.wants_method(method.name()))
    }

    /// Those of directions in those formats, method by method.
    pub fn directions(&self) -> Vec<(Method, Format)> {
        self.methods().flat_map(|method| self.formats().map(move |format| (method, format))).collect()
    }

    /// Those of highlights in those formats, method by method.
    pub fn highlights(&self) -> Vec<(Shading, Format)> {
        self.shadings().flat_map(|method| self.formats().map(move |format| (method, format))).collect()
    }

    /// Whether `light` is to be measured.
    pub fn wants(&self, light: &str) -> bool {
        self.filter.wants(light)
    }

    /// Refuses what no single argument shows to be wrong.
    pub fn check(&self) -> Result<(), Failure> {
        self.filter.check(&measure::light_names())
    }

    /// The command line that measures the same again.
    pub fn command(&self) -> String {
        format!("sunglint{}{}", if self.quick { " --quick" } else { "" }, self.filter.arguments()) + &self.seeded()
    }

    /// The seed as an argument, unless it is the default.
    pub fn seeded(&self) -> String {
        if self.seed == DEFAULT_SEED { String::new() } else { format!(" --seed {}", self.seed) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_sound() {
        Cli::command().debug_assert();
    }
}
