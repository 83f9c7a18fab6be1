//! The table of all measurements of lit pixels.

use super::cells::{self, bits, cell, command, count, foldable, missing, scientific, text};
use super::{pack, pixels};
use crate::author;
use crate::key::in_order;
use crate::number;
use crate::result::{PixelRow, Study};
use crate::said;

/// The groups of columns that can be folded.
const GROUPS: [&str; 7] = ["cost", "arithmetic", "model", "display", "bound", "inputs", "worst input"];

/// Those that are open at first.
const OPEN: [&str; 4] = ["cost", "arithmetic", "display", "bound"];

const COLUMNS: [(&str, &str); 30] = [
    ("", "case"),
    ("", "method"),
    ("", "format"),
    ("", "cost"),
    ("cost", "quartiles"),
    ("cost", "latency"),
    ("", "total rms"),
    ("", "total max"),
    ("", "outcome"),
    ("", "frontier"),
    ("arithmetic", "arithmetic rms"),
    ("arithmetic", "arithmetic max"),
    ("arithmetic", "99 % within"),
    ("arithmetic", "bias"),
    ("model", "model rms"),
    ("model", "model max"),
    ("display", "8-bit steps, rms"),
    ("display", "max"),
    ("display", "10-bit steps, rms"),
    ("display", "max"),
    ("bound", "worst known"),
    ("bound", "bound is"),
    ("bound", "over inputs"),
    ("inputs", "rounded inputs, rms"),
    ("inputs", "tried"),
    ("inputs", "model tried"),
    ("worst input", "normal, raw bits"),
    ("worst input", "viewer, raw bits"),
    ("worst input", "light, raw bits"),
    ("", "do it again"),
];

/// Every row, to be sorted by any column, with its choice of case, method and format.
pub fn all(study: &Study) -> String {
    let rows = &study.pixels;
    let every = |names: Vec<String>| [vec![cells::ALL.to_owned()], names].concat();
    let cases = [pixels::cases(study), vec![cells::ALL.to_owned()]].concat();
    let choice = [
        cells::select("Light and roughness", "case", &cases),
        cells::select("Method", "method", &every(in_order(rows.iter().map(|row| &row.method)))),
        cells::select("Format", "format", &every(in_order(rows.iter().map(|row| &row.format)))),
        cells::FIND.to_owned(),
        cells::columns(&GROUPS, &OPEN),
    ];
    let lines: String = study.all_pixels().map(line).collect();
    format!("{}{}", cells::form(&choice.concat()), pack::packed(&foldable("lit-pixels", &COLUMNS, &lines)))
}

fn line(row: &PixelRow) -> String {
    let class = if row.failure.is_some() { " class=\"fails\"" } else { "" };
    let choices = cells::data(&[("case", &row.case), ("method", &row.method), ("format", &row.format)]);
    let outcome = row.failure.as_ref().map_or("works".to_owned(), |why| format!("fails: {why}"));
    let quartiles = format!("{} to {}", number::cost(row.cost_low), number::cost(row.cost_high));
    let timed = |value: f64, shown: &str| if value.is_finite() { cell(value, shown) } else { missing() };
    let [arithmetic, model] = [[row.error_p99, row.error_bias], [row.model_rms, row.model_max]];
    let steps = [row.steps8_rms, row.steps8_max, row.steps10_rms, row.steps10_max];
    let cells = [
        text(&row.case),
        cells::method(&row.method),
        text(&author::said(&row.format, row.by)),
        timed(row.cost, &number::cost(row.cost)),
        timed(row.cost_low, &quartiles),
        timed(row.latency, &number::cost(row.latency)),
        [row.total_rms, row.total_max].map(scientific).concat(),
        text(&outcome),
        text(if row.frontier { "yes" } else { "no" }),
        [row.error_rms, row.error_max].map(scientific).concat(),
        arithmetic.into_iter().chain(model).chain(steps).map(scientific).collect(),
        scientific(row.bound_max),
        text(said::bound(row.bound)),
        count(row.bound_samples),
        scientific(row.input_rms),
        [row.samples, row.model_samples].map(count).concat(),
        [&row.worst_n, &row.worst_v, &row.worst_l].map(|lanes| bits(lanes)).concat(),
        command(&row.repro),
    ];
    format!("<tr{choices}{class}>{}</tr>\n", cells.concat())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn a_line_has_a_cell_for_each_column_and_no_group_is_forgotten() {
        assert_eq!(line(&sample::pixel("karis", "f32", 5.0, 1e-6)).matches("<td").count(), COLUMNS.len());
        let named = COLUMNS.iter().filter(|(group, _)| !group.is_empty());
        assert!(named.clone().all(|(group, _)| GROUPS.contains(group)));
        assert!(GROUPS.iter().all(|group| named.clone().any(|(other, _)| other == group)));
    }

    #[test]
    fn a_failure_and_the_steps_are_shown() {
        let html = line(&sample::pixel("karis/3", "f16", 90.0, f64::INFINITY));
        for shown in [
            "class=\"fails\"",
            ">fails: NaN<",
            ">8.0<",
            ">sampled<",
            "#method-karis-3",
            "sunglint repro &#39;karis/3&#39;",
        ] {
            assert!(html.contains(shown), "{shown}: {html}");
        }
    }
}
