//! The errors of a lit pixel that charts and frontiers are about.

use crate::frontier::Standing;
use crate::mean::Mean;
use crate::number;
use crate::result::PixelRow;

/// What an error of a lit pixel is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelKind {
    /// Arithmetic and model error together.
    Total,
    /// Computed against the exact value of the same formula.
    Arithmetic,
    /// The formula's exact value against the integral over the disc.
    Model,
    /// All of it, in steps of an 8-bit display.
    Steps8,
    /// The same in steps of a 10-bit display.
    Steps10,
}

impl PixelKind {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 5] = [Self::Total, Self::Arithmetic, Self::Model, Self::Steps8, Self::Steps10];

    /// Short name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Total => "total",
            Self::Arithmetic => "arithmetic",
            Self::Model => "model",
            Self::Steps8 => "8-bit steps",
            Self::Steps10 => "10-bit steps",
        }
    }

    /// What it is as the object of a sentence.
    pub fn said(self) -> &'static str {
        match self {
            Self::Total => "total error",
            Self::Arithmetic => "arithmetic error",
            Self::Model => "model error",
            Self::Steps8 => "error on an 8-bit display",
            Self::Steps10 => "error on a 10-bit display",
        }
    }

    /// Whether it is in steps of a display.
    pub fn is_steps(self) -> bool {
        matches!(self, Self::Steps8 | Self::Steps10)
    }
}

/// An error of a lit pixel: relative to its true value, or in steps of a display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelError {
    /// Of what.
    pub kind: PixelKind,
    /// Which mean.
    pub mean: Mean,
}

impl Default for PixelError {
    /// The one that decides: all of the error, over all of the pixels.
    fn default() -> Self {
        Self { kind: PixelKind::Total, mean: Mean::Rms }
    }
}

impl PixelError {
    /// What the error is measured against.
    pub fn against(self) -> &'static str {
        match self.kind {
            PixelKind::Arithmetic => "against the exact value of the same formula",
            PixelKind::Total => "against the BRDF integrated over the disc: arithmetic and model error together",
            PixelKind::Model => "of the exact formula against the BRDF integrated over the disc",
            PixelKind::Steps8 | PixelKind::Steps10 => {
                "in steps of sRGB, against the BRDF integrated over the disc; a white surface that faces the light is 1"
            }
        }
    }

    /// The error of `row`.
    pub fn of(self, row: &PixelRow) -> f64 {
        let [max, rms] = match self.kind {
            PixelKind::Arithmetic => [row.error_max, row.error_rms],
            PixelKind::Total => [row.total_max, row.total_rms],
            PixelKind::Model => [row.model_max, row.model_rms],
            PixelKind::Steps8 => [row.steps8_max, row.steps8_rms],
            PixelKind::Steps10 => [row.steps10_max, row.steps10_rms],
        };
        match self.mean {
            Mean::Rms => rms,
            Mean::Max => max,
        }
    }

    /// The part of it that no precision removes.
    pub fn model(self, row: &PixelRow) -> f64 {
        Self { kind: PixelKind::Model, ..self }.of(row)
    }

    /// How `row` stands by this error at some cost. What is less than the second digit is no reason to pay more: where
    /// the model rules, a wider format gains nothing else.
    pub fn standing(self, row: &PixelRow, cost: f64) -> Standing {
        Standing { cost, error: number::two_digits(self.of(row)), works: row.failure.is_none() }
    }
}
