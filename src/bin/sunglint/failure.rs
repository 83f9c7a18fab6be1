//! Why a command ended without its result, and the exit code that says so.

use std::fmt;

use crate::output::WriteError;

/// Why a command could not do its work.
#[derive(Debug)]
pub enum Failure {
    /// A file could not be written: exit code 1.
    Write(WriteError),
    /// The command line asks for what there is not; holds the value and what is allowed: exit code 2.
    Usage(String),
    /// Ctrl-C: exit code 130.
    Interrupted,
}

impl Failure {
    /// What the process exits with.
    pub fn code(&self) -> u8 {
        match self {
            Self::Write(_) => 1,
            Self::Usage(_) => 2,
            Self::Interrupted => 130,
        }
    }
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        Self::Write(error)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Write(error) => error.fmt(f),
            Self::Usage(message) => f.write_str(message),
            Self::Interrupted => f.write_str("interrupted; no file is half written"),
        }
    }
}
