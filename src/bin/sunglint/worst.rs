//! The worst inputs of every method, each with the command that computes it again.

use clap::Args;

use crate::failure::Failure;
use crate::options::Options;

/// `sunglint worst`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    #[command(flatten)]
    pub options: Options,
}

/// The command.
pub fn run(_arguments: &Arguments) -> Result<(), Failure> {
    Ok(())
}
