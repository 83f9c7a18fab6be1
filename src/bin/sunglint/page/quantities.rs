//! The section of the page about the quantities of a light.

use super::cells::{cell, count, sortable, text};
use crate::result::QuantityRow;
use crate::table;

/// Every quantity, to be sorted by any column.
pub fn all(rows: &[QuantityRow]) -> String {
    const COLUMNS: [&str; 7] =
        ["quantity", "format", "unit", "worst error in units", "worst input", "tried", "refused"];
    let line = |row: &QuantityRow| {
        let cells = [
            text(&row.quantity),
            text(&row.format),
            text(&row.unit),
            cell(row.error_max, &table::units(row.error_max)),
            cell(row.worst_input, &format!("{:e}", row.worst_input)),
            count(row.samples),
            count(row.refused),
        ];
        format!("<tr>{}</tr>\n", cells.concat())
    };
    let lines: String = rows.iter().map(line).collect();
    format!(
        "<p>What a renderer derives once for each light. An input is refused, with an error that says \
         why, where the format holds no value for the answer. The truth is f64’s: of the errors of the 64-bit \
         fixed-point answers up to 0.75 is its own rounding.</p>\n{}",
        sortable("quantities", &COLUMNS, &lines)
    )
}
