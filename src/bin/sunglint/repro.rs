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
