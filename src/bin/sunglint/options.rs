//! What the user asked for on the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use sunglint::trial::{Format, Light, lights};

use crate::{pictures, presets, repro, snippets, sweep, worst};

/// Seed of the random directions where none is given.
pub const DEFAULT_SEED: u64 = 1;

/// The command line.
#[derive(Clone, Debug, Parser)]
#[command(name = "sunglint", version, about = "Error against cost of every lighting method in every number format")]
#[command(args_conflicts_with_subcommands = true)]
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
    Worst(worst::Arguments),
    /// Compute one input again: the answer, the truth and the error
    Repro(repro::Arguments),
    /// Draw lit spheres, the truth and where the error sits, as PNG
    Render(pictures::Arguments),
    /// How many bits are enough? Try word lengths that types have and that none has
    Sweep(sweep::Arguments),
    /// Run failures that were reported elsewhere, and their cures
    Preset(presets::Arguments),
    /// Print a recommended method in GLSL, HLSL, WGSL or FPCore
    Snippet(snippets::Arguments),
    /// List methods, formats, lights, cases, presets and snippets
    List,
}

/// What is measured, and where it goes.
#[derive(Args, Clone, Debug)]
pub struct Options {
    /// Folder to write to; made if it is missing
    #[arg(long, value_name = "DIR", default_value = "target/sunglint")]
    pub out: PathBuf,

    /// Try fewer directions and pixels, with coarser integrals: a few seconds in place of a minute, less of the worst
    /// cases
    #[arg(long)]
    pub quick: bool,

    /// Seed of the random directions; the same seed gives the same errors
    #[arg(long, value_name = "N", default_value_t = DEFAULT_SEED)]
    pub seed: u64,

    /// Measure only directions, lit pixels and highlights whose light's name holds NAME, such as `mars`
    /// or `lamp`; building blocks and light quantities have no light
    #[arg(long, value_name = "NAME")]
    pub light: Option<String>,

    /// Print no table and show no progress, only the path of the report
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
        lights::STUDY.into_iter().filter(|light| self.wants(light.name)).collect()
    }

    /// Whether the method of this name is to be measured.
    pub fn wants_method(&self, _method: &str) -> bool {
        true
    }

    /// Whether `format` is to be measured.
    pub fn wants_format(&self, _format: Format) -> bool {
        true
    }

    /// Whether `light` is to be measured.
    pub fn wants(&self, light: &str) -> bool {
        let holds = |name: &String| light.to_lowercase().contains(&name.to_lowercase());
        self.light.as_ref().is_none_or(holds)
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

    #[test]
    fn a_light_is_found_by_part_of_its_name_in_any_case() {
        let options = Options::parse_from(["sunglint", "--light", "MARS"]);
        assert!(options.wants("Sun from Mars"));
        assert!(!options.wants("Sun from Earth"));
        assert!(Options::parse_from(["sunglint"]).wants("area light 0.5"));
    }
}
