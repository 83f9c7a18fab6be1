//! One input again: what a method makes of raw bits, the truth, and the error.

use clap::Args;

use crate::failure::Failure;
use crate::options::Options;

/// `sunglint repro`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    #[command(flatten)]
    pub options: Options,
}

/// The command.
pub fn run(_arguments: &Arguments) -> Result<(), Failure> {
    Ok(())
}

/// The command that computes a direction again; `l` and `r` are raw bits as in `Row::worst_l`.
pub fn of_direction(light: &str, method: &str, format: &str, [l, r]: [&str; 2]) -> String {
    format!("sunglint repro {method} {format} --light '{light}' --l '{l}' --r '{r}'")
}

/// The command that computes a lit pixel again; the vectors are raw bits as in `PixelRow::worst_n`.
pub fn of_pixel(case: &str, method: &str, format: &str, [n, v, l]: [&str; 3]) -> String {
    format!("sunglint repro '{method}' {format} --light '{case}' --n '{n}' --v '{v}' --l '{l}'")
}

/// The command that finds the worst input of a building block again.
pub fn of_kernel(kernel: &str, format: &str, seed: u64) -> String {
    format!("sunglint worst --method '{kernel}' --format {format} --seed {seed}")
}
