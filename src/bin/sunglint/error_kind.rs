//! The errors of directions that the study keeps apart.

use crate::frontier::Standing;
use crate::result::Row;

/// Which error a chart, a frontier or a column is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// Computed against the exact value of the same formula.
    Arithmetic,
    /// Computed against the nearest point of the disc: arithmetic and model error together.
    Total,
    /// Of the edge that a highlight draws, in per cent of the light's radius.
    Edge,
    /// The formula's exact value against the nearest point of the disc.
    Model,
}

impl ErrorKind {
    /// Those that have a frontier in every table, in the order in which they are shown.
    pub const ALL: [Self; 2] = [Self::Arithmetic, Self::Total];

    /// Those that the page has charts of.
    pub const CHARTS: [Self; 4] = [Self::Total, Self::Edge, Self::Arithmetic, Self::Model];

    /// Name as a word in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Self::Arithmetic => "arithmetic",
            Self::Total => "total",
            Self::Edge => "edge",
            Self::Model => "model",
        }
    }

    /// What the error is measured against.
    pub fn against(self) -> &'static str {
        match self {
            Self::Arithmetic => "against the exact value of the same formula",
            Self::Total => "against the nearest point of the disc, model error included",
            Self::Edge => "of the drawn edge, how far out or in, for rays within ten radii of the light",
            Self::Model => "of the exact formula against the nearest point of the disc",
        }
    }

    /// Worst error of `row`: in radians, of the edge in per cent of the radius.
    pub fn worst(self, row: &Row) -> f64 {
        match self {
            Self::Arithmetic => row.error_max,
            Self::Total => row.total_max,
            Self::Edge => row.edge_max,
            Self::Model => row.model_max,
        }
    }

    /// How `row` stands by this error at some cost.
    pub fn standing(self, row: &Row, cost: f64) -> Standing {
        Standing { cost, error: self.worst(row), works: row.failure.is_none() }
    }
}
