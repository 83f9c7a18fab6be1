//! The two errors that the study keeps apart.

use crate::frontier::Standing;
use crate::result::Row;

/// Which error a chart, a frontier or a column is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// Computed against the exact value of the same formula.
    Arithmetic,
    /// Computed against the nearest point of the disc: arithmetic and model error together.
    Total,
}

impl ErrorKind {
    /// Both of them, in the order in which they are shown.
    pub const ALL: [Self; 2] = [Self::Arithmetic, Self::Total];

    /// Name as a word in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Self::Arithmetic => "arithmetic",
            Self::Total => "total",
        }
    }

    /// What the error is measured against.
    pub fn against(self) -> &'static str {
        match self {
            Self::Arithmetic => "against the exact value of the same formula",
            Self::Total => "against the nearest point of the disc, model error included",
        }
    }

    /// Worst error of `row`, in radians.
    pub fn worst(self, row: &Row) -> f64 {
        match self {
            Self::Arithmetic => row.error_max,
            Self::Total => row.total_max,
        }
    }

    /// How `row` stands by this error at some cost.
    pub fn standing(self, row: &Row, cost: f64) -> Standing {
        Standing { cost, error: self.worst(row), works: row.failure.is_none() }
    }
}
