//! The errors that a case gives, beside the budgets for them: one list for the properties that hold them to the budgets
//! and for the search that says what the budgets are (`tests/figures.rs`).

use super::{Broken, Case};

/// A budgeted error: its name, and its budgets in f64, f32, micromath, f16, I2F14, I2F30 and I16F16.
///
/// Each is 1.12 times the worst that `tests/figures.rs` finds with draws and an ascent on their bytes, rounded up to
/// two digits; zero where nothing but zero was found.
pub type Row = (&'static str, [f64; 7]);

/// Errors of one case, each beside the number of its row.
pub type Figures = [Option<(usize, f64)>; 8];

/// No errors: the case has none that are budgeted.
pub const NONE: Figures = [None; 8];

/// Claims that every error is within its budget.
///
/// # Errors
/// [`Broken`] if one is not.
pub fn within(case: &Case, rows: &[Row], figures: Figures) -> Result<(), Broken> {
    for (row, found) in figures.into_iter().flatten() {
        let (name, budgets) = rows[row];
        case.at_most(name, found, budgets[case.format as usize])?;
    }
    Ok(())
}
