//! The table of all measurements of building blocks.

use super::cells::{self, cell, command, count, foldable, missing, scientific, text};
use super::pack;
use crate::author::{self, is_peer};
use crate::key::in_order;
use crate::number;
use crate::result::{KernelRow, Study};
use crate::said;

/// The groups of columns that can be folded.
const GROUPS: [&str; 2] = ["bound", "worst input"];

const COLUMNS: [(&str, &str); 17] = [
    ("", "group"),
    ("", "function"),
    ("", "format"),
    ("", "unit"),
    ("", "cost"),
    ("", "quartiles"),
    ("", "error max"),
    ("", "error rms"),
    ("", "99 % within"),
    ("", "bias"),
    ("bound", "worst known"),
    ("bound", "bound is"),
    ("bound", "over inputs"),
    ("worst input", "tried"),
    ("worst input", "worst input"),
    ("", "fails"),
    ("", "do it again"),
];

/// Every row, to be sorted by any column, with its choice of function and format.
pub fn all(study: &Study) -> String {
    let every = |names: Vec<String>| [vec![cells::ALL.to_owned()], names].concat();
    let choice = [
        cells::select("Function", "function", &every(in_order(study.all_kernels().map(|row| &row.kernel)))),
        cells::select("Format", "format", &every(in_order(study.all_kernels().map(|row| &row.format)))),
        cells::FIND.to_owned(),
        cells::columns(&GROUPS, &["bound"]),
    ];
    let lines: String = study.all_kernels().map(line).collect();
    cells::form(&choice.concat()) + &pack::packed(&foldable("blocks", &COLUMNS, &lines))
}

fn line(row: &KernelRow) -> String {
    let failure = author::failure_of_peer(&row.kernel, &row.format, row.by);
    let class = if failure.is_some() { " class=\"fails\"" } else { "" };
    let choices = cells::data(&[("function", &row.kernel), ("format", &row.format)]);
    let quartiles = format!("{} to {}", number::cost(row.cost_low), number::cost(row.cost_high));
    let timed = |value: f64, shown: &str| if value.is_finite() { cell(value, shown) } else { missing() };
    let known = |value: f64| if is_peer(row.by) { missing() } else { scientific(value) };
    let cells = [
        text(&row.group),
        cells::method(&row.kernel),
        text(&author::said(&row.format, row.by)),
        text(&row.unit),
        timed(row.cost, &number::cost(row.cost)),
        timed(row.cost_low, &quartiles),
        scientific(row.error_max),
        [row.error_rms, row.error_p99].map(known).concat(),
        row.error_bias.map_or_else(missing, known),
        known(row.bound_max),
        text(if is_peer(row.by) { "" } else { said::bound(row.bound) }),
        if is_peer(row.by) { missing() } else { count(row.bound_samples) },
        count(row.samples),
        text(&row.worst_input),
        text(failure.unwrap_or_default()),
        command(if is_peer(row.by) { "" } else { &row.repro }),
    ];
    format!("<tr{choices}{class}>{}</tr>\n", cells.concat())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn a_line_has_a_cell_for_each_column() {
        let own = sample::kernel("f32", 1.0);
        let peer = KernelRow { by: "fixed 1.31.0", cost: f64::NAN, ..sample::kernel("I2F30", 1e-9) };
        for row in [&own, &peer] {
            assert_eq!(line(row).matches("<td").count(), COLUMNS.len());
        }
        assert!(line(&own).contains(">exhaustive<") && line(&own).contains("sunglint worst"));
        assert!(line(&peer).contains(">wraps<") && !line(&peer).contains("NaN<"), "{}", line(&peer));
    }
}
