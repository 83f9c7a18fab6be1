//! The table of all measurements of directions.

use super::cells::{self, bits, cell, command, count, foldable, percent, scientific, text};
use super::{directions, pack};
use crate::author;
use crate::key::in_order;
use crate::number;
use crate::result::{Row, Study};
use crate::said;
use crate::table;

/// The groups of columns that can be folded.
const GROUPS: [&str; 7] = ["cost", "arithmetic", "model", "edge", "bound", "inputs", "worst input"];

/// Those that are open at first.
const OPEN: [&str; 4] = ["cost", "arithmetic", "edge", "bound"];

const COLUMNS: [(&str, &str); 32] = [
    ("", "light"),
    ("", "method"),
    ("", "format"),
    ("", "cost"),
    ("cost", "quartiles"),
    ("cost", "latency"),
    ("cost", "M0+"),
    ("cost", "M3"),
    ("cost", "M4F"),
    ("", "total max, rad"),
    ("", "in % of radius"),
    ("", "outcome"),
    ("", "frontier"),
    ("arithmetic", "arithmetic max, rad"),
    ("arithmetic", "in % of radius"),
    ("arithmetic", "rms, rad"),
    ("arithmetic", "99 % within, rad"),
    ("arithmetic", "bias, rad"),
    ("model", "model max, rad"),
    ("model", "total rms, rad"),
    ("edge", "edge max, % of radius"),
    ("edge", "edge rms, %"),
    ("bound", "worst known, rad"),
    ("bound", "bound is"),
    ("bound", "over inputs"),
    ("inputs", "tried"),
    ("inputs", "left out"),
    ("inputs", "no direction"),
    ("worst input", "at angle, rad"),
    ("worst input", "light, raw bits"),
    ("worst input", "mirror direction, raw bits"),
    ("", "do it again"),
];

/// Every row, to be sorted by any column, with its choice of light, method and format.
pub fn all(study: &Study) -> String {
    let rows = &study.rows;
    let every = |names: Vec<String>| [vec![cells::ALL.to_owned()], names].concat();
    let lights = [directions::lights(study), vec![cells::ALL.to_owned()]].concat();
    let choice = [
        cells::select("Light", "light", &lights),
        cells::select("Method", "method", &every(in_order(rows.iter().map(|row| &row.method)))),
        cells::select("Format", "format", &every(in_order(rows.iter().map(|row| &row.format)))),
        cells::FIND.to_owned(),
        cells::columns(&GROUPS, &OPEN),
    ];
    let lines: String = study.all_directions().map(line).collect();
    format!("{}{}", cells::form(&choice.concat()), pack::packed(&foldable("measurements", &COLUMNS, &lines)))
}

fn line(row: &Row) -> String {
    let class = if row.failure.is_some() { " class=\"fails\"" } else { "" };
    let choices = cells::data(&[("light", &row.light), ("method", &row.method), ("format", &row.format)]);
    let outcome = row.failure.as_ref().map_or("works".to_owned(), |why| format!("fails: {why}"));
    let frontier = table::frontier(row);
    let cells = [
        text(&row.light),
        cells::method(&row.method),
        text(&author::said(&row.format, row.by)),
        costs(row),
        scientific(row.total_max),
        percent(row.total_max, row.theta),
        text(&outcome),
        text(if frontier.is_empty() { "no" } else { frontier }),
        scientific(row.error_max),
        percent(row.error_max, row.theta),
        [row.error_rms, row.error_p99, row.error_bias, row.model_max, row.total_rms].map(scientific).concat(),
        [row.edge_max, row.edge_rms].map(|edge| percent(edge, 100.0)).concat(),
        scientific(row.bound_max),
        text(said::bound(row.bound)),
        [row.bound_samples, row.samples, row.excluded, row.undirected].map(count).concat(),
        scientific(row.worst_angle),
        bits(&row.worst_l),
        bits(&row.worst_r),
        command(&row.repro),
    ];
    format!("<tr{choices}{class}>{}</tr>\n", cells.concat())
}

/// Time with its quartiles, latency, and instructions on the three cores.
fn costs(row: &Row) -> String {
    let instructions = [row.m0_instructions, row.m3_instructions, row.m4_instructions];
    let instructions = instructions.map(|count| count.map_or_else(cells::missing, |count| cells::count(count.into())));
    let quartiles = format!("{} to {}", number::cost(row.cost_low), number::cost(row.cost_high));
    let timed = |value: f64, shown: &str| if value.is_finite() { cell(value, shown) } else { cells::missing() };
    [
        timed(row.cost, &number::cost(row.cost)),
        timed(row.cost_low, &quartiles),
        timed(row.latency, &number::cost(row.latency)),
        instructions.concat(),
    ]
    .concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn a_failure_is_said_in_words_and_bits_are_shown() {
        let mut row = sample::row("epic", "f16", 1.0, f64::NAN);
        row.failure = Some("NaN".to_owned());
        let html = line(&row);
        assert!(html.contains("fails: NaN") && html.contains(&row.worst_l));
    }

    #[test]
    fn a_line_has_a_cell_for_each_column_and_no_group_is_forgotten() {
        assert_eq!(line(&sample::row("cap", "f32", 1.0, 1e-7)).matches("<td").count(), COLUMNS.len());
        let named = COLUMNS.iter().filter(|(group, _)| !group.is_empty());
        assert!(named.clone().all(|(group, _)| GROUPS.contains(group)));
        assert!(GROUPS.iter().all(|group| named.clone().any(|(other, _)| other == group)));
    }

    #[test]
    fn figures_and_commands_are_shown() {
        let html = line(&sample::row("cap", "f32", 1.0, 1e-7));
        for shown in
            [">8.0e-8<", ">-1.0e-8<", ">0.30<", ">searched<", ">1.50<", "sunglint repro cap f32", "#method-cap"]
        {
            assert!(html.contains(shown), "{shown}: {html}");
        }
    }
}
