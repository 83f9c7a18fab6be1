//! The section of the page about building blocks.

use super::cells::{self, bits, cell, count, scientific, sortable, text};
use crate::chart;
use crate::kernel_panel;
use crate::key::{Key, in_order};
use crate::mean::Mean;
use crate::number;
use crate::result::{KernelRow, Study};

const INTRODUCTION: &str = "<p>What a lit pixel is made of, each part by itself: its error against f64 at the inputs as they were \
rounded into the format, and its cost. In f64 the errors are the truth’s own rounding as much.</p>";

const COLUMNS: [&str; 9] = [
    "function",
    "format",
    "unit",
    "cost",
    "cost quartiles",
    "error max",
    "error rms",
    "tried",
    "worst input, raw bits",
];

/// Width and height of a panel, of which several stand side by side.
const PANEL: (f64, f64) = (430.0, 340.0);

/// A small chart for each function and a table of all.
pub fn all(study: &Study) -> String {
    let rows = &study.kernels;
    let names = in_order(rows.iter().map(|row| &row.kernel));
    let key = Key::new(rows.iter().map(|row| [&row.kernel, &row.format]));
    let group = |mean: Mean| {
        let panels: String = names.iter().map(|name| panel(rows, name, mean, &key)).collect();
        format!("<figure class=\"several\" data-mean=\"{}\">{panels}</figure>\n", mean.name())
    };
    let choice = cells::form(&cells::radio("Error", "mean", &Mean::ALL.map(Mean::name)));
    let lines: String = rows.iter().map(line).collect();
    format!("{INTRODUCTION}\n{choice}{}{}", Mean::ALL.map(group).concat(), sortable("blocks", &COLUMNS, &lines))
}

fn panel(rows: &[KernelRow], name: &str, mean: Mean, key: &Key) -> String {
    let rows: Vec<_> = rows.iter().filter(|row| row.kernel == name).collect();
    let name = format!("{name}: {} error against cost", mean.name());
    let svg = chart::small_panel(&kernel_panel::field(&rows, mean), key, PANEL, &name);
    format!("<div>{svg}</div>")
}

fn line(row: &KernelRow) -> String {
    let cells = [
        text(&row.kernel),
        text(&row.format),
        text(&row.unit),
        cell(row.cost, &number::cost(row.cost)),
        cell(row.cost_low, &format!("{} to {}", number::cost(row.cost_low), number::cost(row.cost_high))),
        scientific(row.error_max),
        scientific(row.error_rms),
        count(row.samples),
        bits(&row.worst_input),
    ];
    format!("<tr>{}</tr>\n", cells.concat())
}
