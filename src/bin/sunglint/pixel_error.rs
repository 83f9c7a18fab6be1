//! The errors of a lit pixel that charts and frontiers are about.

use crate::error_kind::ErrorKind;
use crate::frontier::Standing;
use crate::mean::Mean;
use crate::number;
use crate::result::PixelRow;

/// An error of a lit pixel, relative to the pixel's true value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelError {
    /// Of what.
    pub kind: ErrorKind,
    /// Which mean.
    pub mean: Mean,
}

impl Default for PixelError {
    /// The one that decides: all of the error, over all of the pixels.
    fn default() -> Self {
        Self { kind: ErrorKind::Total, mean: Mean::Rms }
    }
}

impl PixelError {
    /// What the error is measured against.
    pub fn against(self) -> &'static str {
        match self.kind {
            ErrorKind::Arithmetic => "against the exact value of the same formula",
            ErrorKind::Total => "against the BRDF integrated over the disc: arithmetic and model error together",
        }
    }

    /// The error of `row`.
    pub fn of(self, row: &PixelRow) -> f64 {
        match (self.kind, self.mean) {
            (ErrorKind::Arithmetic, Mean::Rms) => row.error_rms,
            (ErrorKind::Arithmetic, Mean::Max) => row.error_max,
            (ErrorKind::Total, Mean::Rms) => row.total_rms,
            (ErrorKind::Total, Mean::Max) => row.total_max,
        }
    }

    /// The part of it that no precision removes.
    pub fn model(self, row: &PixelRow) -> f64 {
        match self.mean {
            Mean::Rms => row.model_rms,
            Mean::Max => row.model_max,
        }
    }

    /// How `row` stands by this error at some cost. What is less than the second digit is no reason to pay more: where
    /// the model rules, a wider format gains nothing else.
    pub fn standing(self, row: &PixelRow, cost: f64) -> Standing {
        Standing { cost, error: number::two_digits(self.of(row)), works: row.failure.is_none() }
    }
}
