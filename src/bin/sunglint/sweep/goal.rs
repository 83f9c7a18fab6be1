//! What has to be within a tolerance.

use clap::ValueEnum;
use serde::Serialize;

use super::SweepRow;
use crate::failure::Failure;
use crate::number;

/// What a tolerance is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Goal {
    /// The light's edge, in per cent of its radius
    #[default]
    Edge,
    /// The direction to shade with, in radians
    Direction,
    /// The brightness of a lit pixel, root mean square relative to its true value
    Pixel,
}

impl Goal {
    /// The tolerance where none is given.
    pub const fn default_tolerance(self) -> f64 {
        match self {
            Self::Edge => 1.0,
            Self::Direction => 1e-3,
            Self::Pixel => 0.01,
        }
    }

    /// The greatest tolerance that means anything: the radius itself, the opposite direction, no pixel at all.
    const fn most(self) -> f64 {
        match self {
            Self::Edge => 100.0,
            Self::Direction => std::f64::consts::PI,
            Self::Pixel => 1.0,
        }
    }

    /// What tolerances and errors are in.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Edge => "% of the radius",
            Self::Direction => "rad",
            Self::Pixel => "of the pixel, root mean square",
        }
    }

    /// A tolerance that is allowed.
    ///
    /// # Errors
    /// [`Failure::Usage`] with the value and the range.
    pub fn checked(self, tolerance: f64) -> Result<f64, Failure> {
        if tolerance > 0.0 && tolerance <= self.most() {
            return Ok(tolerance);
        }
        let range = format!("above 0 and at most {} {}", number::two_digits(self.most()), self.unit());
        Err(Failure::Usage(format!("a tolerance of {tolerance} is out of range: it has to be {range}")))
    }

    /// The error of `row` in the unit of the tolerance: of the formula and of its arithmetic together. Infinite where
    /// the method fails.
    pub fn error(self, row: &SweepRow) -> f64 {
        let error = match self {
            Self::Edge => row.edge_max.unwrap_or(f64::INFINITY),
            Self::Direction => row.total_max,
            Self::Pixel => row.total_rms,
        };
        if row.failure.is_some() || error.is_nan() { f64::INFINITY } else { error }
    }

    /// An error with its unit.
    pub fn said(self, error: f64) -> String {
        format!("{} {}", number::scientific(error), self.unit())
    }
}
