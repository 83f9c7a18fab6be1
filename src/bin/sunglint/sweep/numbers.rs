//! What a method is computed in: a word, or a format.

use sunglint::trial::emulated::Word;
use sunglint::trial::{Format, Visitor};

use super::SweepRow;

/// Names of the families, as rows have them.
const FAMILIES: [&str; 3] = ["fixed", "float", "flushing float"];

/// What it is computed in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Numbers {
    /// A word, by the formulas that all formats share.
    Word(Word),
    /// A format, with what it does by hand.
    Format(Format),
}

impl Numbers {
    /// Calls `visitor` with the type; nothing where a word has none.
    pub fn visit<V: Visitor>(self, visitor: V) -> Option<V::Output> {
        match self {
            Self::Word(word) => word.visit(visitor),
            Self::Format(format) => Some(format.visit(visitor)),
        }
    }

    /// Name of the word or format.
    pub fn name(self) -> String {
        match self {
            Self::Word(word) => word.to_string(),
            Self::Format(format) => format.name().to_owned(),
        }
    }

    /// The step between numbers just below 1.
    pub fn step(self) -> f64 {
        match self {
            Self::Word(word) => word.step(),
            Self::Format(format) => format.step(),
        }
    }

    /// A row with the numbers' columns.
    pub fn row(self) -> SweepRow {
        match self {
            Self::Format(format) => SweepRow {
                width: format.width() as u32,
                word: format.name().to_owned(),
                format: Some(format.name()),
                ..SweepRow::default()
            },
            Self::Word(word) => {
                let (family, exponent) = match word {
                    Word::Fixed { .. } => (FAMILIES[0], None),
                    Word::Float { exponent, flushing, .. } => (FAMILIES[1 + usize::from(flushing)], Some(exponent)),
                };
                SweepRow {
                    family,
                    exponent,
                    bits: word.digits(),
                    width: word.width(),
                    word: word.to_string(),
                    format: word.format().map(Format::name),
                    ..SweepRow::default()
                }
            }
        }
    }
}
