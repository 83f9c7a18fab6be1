//! What the user asked for on the command line.

use std::path::PathBuf;

use clap::Parser;

/// Seed of the random directions where none is given.
pub const DEFAULT_SEED: u64 = 1;

/// Measures the error and the cost of every method in every number format, prints the result and
/// writes results.csv, pixels.csv, lobes.csv, kernels.csv, chip.csv, results.json, chart.svg, chips.svg,
/// pixels.svg and report.html. Instructions on microcontrollers are not measured but taken from the table
/// that tests/firmware/run has counted.
#[derive(Clone, Debug, Parser)]
#[command(name = "sunglint", version)]
pub struct Options {
    /// Folder to write to; made if it is missing
    #[arg(long, value_name = "DIR", default_value = "target/sunglint")]
    pub out: PathBuf,

    /// Try fewer directions and pixels, with coarser integrals: four seconds in place of some thirty, less of the worst
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
        Options::command().debug_assert();
    }

    #[test]
    fn a_light_is_found_by_part_of_its_name_in_any_case() {
        let options = Options::parse_from(["sunglint", "--light", "MARS"]);
        assert!(options.wants("Sun from Mars"));
        assert!(!options.wants("Sun from Earth"));
        assert!(Options::parse_from(["sunglint"]).wants("area light 0.5"));
    }
}
