//! The schema: every column of every file that the study writes, with its type, unit and meaning.

use serde::Serialize;

/// A column, or a field of the JSON file.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Column {
    /// The file, such as `results.csv`.
    pub file: &'static str,
    /// Its name.
    pub column: &'static str,
    /// `text`, `number`, `integer`, `boolean`.
    pub kind: &'static str,
    /// `rad`, `per cent`, ...; may be empty.
    pub unit: &'static str,
    /// What it says.
    pub meaning: &'static str,
}

/// All of them, in the order of the files.
pub const ALL: &[Column] = &[];
