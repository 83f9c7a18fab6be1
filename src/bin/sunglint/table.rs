//! The tables on the terminal.

mod chip;
mod kernels;
mod lobes;
mod pixels;

use comfy_table::presets::NOTHING;
use comfy_table::{CellAlignment, ContentArrangement, Table, TableComponent};

use crate::chart::{direction_key, under_light};
use crate::key::in_order;
use crate::number;
use crate::result::{QuantityRow, Row, Study};

/// All tables of `study`, each under a line that says what it shows.
pub fn all(study: &Study) -> String {
    let lights = in_order(study.rows.iter().map(|row| &row.light));
    let mut parts = Vec::new();
    if let Some((first, others)) = lights.split_first() {
        parts.push(one_light(&under_light(&study.rows, first)));
        parts.extend((!others.is_empty()).then(|| other_lights(study, others)));
    }
    parts.extend(Some(chip::all(study)).filter(|table| !table.is_empty()));
    parts.extend((!study.pixels.is_empty()).then(|| pixels::all(study)));
    parts.extend((!study.lobes.is_empty()).then(|| lobes::all(study)));
    parts.extend((!study.kernels.is_empty()).then(|| kernels::all(study)));
    parts.extend((!study.quantities.is_empty()).then(|| quantities(&study.quantities)));
    parts.join("\n")
}

/// Every row of one light, along the frontier.
fn one_light(rows: &[&Row]) -> String {
    let (name, theta) = rows.first().map_or(("", 0.0), |row| (row.light.as_str(), row.theta));
    let mut sorted = rows.to_vec();
    sorted.sort_by(|a, b| rank(a).cmp(&rank(b)).then(a.cost.total_cmp(&b.cost)));
    let mut table = table(&[
        "method",
        "format",
        "cost",
        "arithmetic\nmax rad",
        "\nrms rad",
        "max in %\nof radius",
        "total\nmax rad",
        "failure",
        "frontier",
    ]);
    for group in sorted.chunk_by(|a, b| rank(a) == rank(b)) {
        add_group(&mut table, group.iter().map(|row| cells(row).to_vec()));
    }
    align_right(&mut table, 2..7);
    let theta = number::scientific(theta);
    format!(
        "{name}, angular radius {theta} rad, along the frontier; cost in calls of f32 factored\n\
         Arithmetic error is against the exact value of the same formula,\n\
         total error against the nearest point of the disc. Disc lost: off by half of\n\
         the radius or more within ten radii of the light.\n{}\n",
        table.trim_fmt()
    )
}

/// Frontier first, then the beaten, then the failed.
fn rank(row: &Row) -> u8 {
    match (&row.failure, row.frontier) {
        (Some(_), _) => 2,
        (None, false) => 1,
        (None, true) => 0,
    }
}

fn cells(row: &Row) -> [String; 9] {
    [
        row.method.clone(),
        row.format.clone(),
        number::cost(row.cost),
        number::scientific(row.error_max),
        number::scientific(row.error_rms),
        number::percent(row.error_max, row.theta),
        number::scientific(row.total_max),
        row.failure.clone().unwrap_or_default(),
        frontier(row).to_owned(),
    ]
}

/// Which frontiers `row` is on, in words.
pub fn frontier(row: &Row) -> &'static str {
    match (row.frontier, row.total_frontier) {
        (true, true) => "both",
        (true, false) => "arithmetic",
        (false, true) => "total",
        (false, false) => "",
    }
}

/// Worst total error of each method and format under the lights that have no table of their own.
fn other_lights(study: &Study, lights: &[String]) -> String {
    let key = direction_key(study);
    let mut header = vec!["light", "method"];
    header.extend(key.formats.iter().map(String::as_str));
    let mut table = table(&header);
    for light in lights {
        let rows = under_light(&study.rows, light);
        let lines = key.methods.iter().map(|method| line(light, method, &rows, &key));
        add_group(&mut table, lines);
    }
    align_right(&mut table, 2..header.len());
    format!("Worst total error in radians under the other lights\n{}\n", table.trim_fmt())
}

fn line(light: &str, method: &str, rows: &[&Row], key: &crate::key::Key) -> Vec<String> {
    let outcome = |format: &String| {
        let row = rows.iter().find(|row| row.method == method && &row.format == format);
        row.map_or_else(String::new, |row| row.failure.clone().unwrap_or_else(|| number::scientific(row.total_max)))
    };
    let mut line = vec![light.to_owned(), method.to_owned()];
    line.extend(key.formats.iter().map(outcome));
    line
}

fn quantities(rows: &[QuantityRow]) -> String {
    let mut table = table(&["quantity", "format", "unit", "max error", "tried", "refused"]);
    let cells = |row: &QuantityRow| {
        [
            row.quantity.clone(),
            row.format.clone(),
            row.unit.clone(),
            units(row.error_max),
            number::count(row.samples),
            number::count(row.refused),
        ]
    };
    table.add_rows(rows.iter().map(cells));
    align_right(&mut table, 3..6);
    format!("Quantities of the light; refused: answered with an error, since no value fits\n{}\n", table.trim_fmt())
}

/// An error in units of the last place: plain as long as it is small.
pub fn units(error: f64) -> String {
    if (0.01..1000.0).contains(&error) { format!("{error:.2}") } else { number::scientific(error) }
}

/// An empty table that never wraps, so that a file and a terminal get the same text.
pub fn table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_preset(NOTHING);
    table.set_style(TableComponent::HeaderLines, '─');
    table.set_style(TableComponent::MiddleHeaderIntersections, '─');
    table.set_content_arrangement(ContentArrangement::Disabled);
    table.set_header(header);
    for column in table.column_iter_mut() {
        column.set_padding((0, 1));
    }
    table
}

/// Adds `rows`, with an empty line between them and the rows before.
fn add_group(table: &mut Table, rows: impl Iterator<Item = Vec<String>>) {
    if !table.is_empty() {
        table.add_row([""]);
    }
    table.add_rows(rows);
}

/// Figures stand under each other by their last digit.
pub fn align_right(table: &mut Table, columns: std::ops::Range<usize>) {
    for column in table.column_iter_mut().skip(columns.start).take(columns.len()) {
        column.set_cell_alignment(CellAlignment::Right);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{frontier, sample};

    fn study() -> Study {
        let mut failed = sample::row("epic", "f16", 0.2, f64::NAN);
        failed.failure = Some("NaN".to_owned());
        let mut mars = sample::row("cap", "f32", 1.0, 2e-7);
        mars.light = "Sun from Mars".to_owned();
        let rows = vec![
            failed,
            sample::row("disc", "f32", 0.9, 9e-4),
            sample::row("cap", "f16", 0.8, 3e-4),
            sample::row("cap", "f64", 1.5, 0.0),
            mars,
        ];
        let mut study = sample::whole_study(rows);
        frontier::mark(&mut study);
        study
    }

    #[test]
    fn the_frontier_comes_first_and_failures_last() {
        let text = all(&study());
        let at = |pieces: [&str; 2]| {
            let holds = |line: &str| pieces.iter().all(|piece| line.contains(piece));
            text.lines().position(holds).expect("a line")
        };
        let places = [["cap", "f16"], ["cap", "f64"], ["disc", "f32"], ["epic", "NaN"]].map(at);
        assert!(places.is_sorted(), "{places:?}\n{text}");
    }

    #[test]
    fn everything_is_shown() {
        let text = all(&study());
        for name in ["Sun from Mars", "size_factor", "Sun, alpha 0.001", "relative L1", "normalize"] {
            assert!(text.contains(name), "{name}\n{text}");
        }
    }

    #[test]
    fn a_hundred_columns_are_enough() {
        let widest = all(&study()).lines().map(|line| line.chars().count()).max();
        assert!(widest.is_some_and(|width| width <= 100), "{widest:?}");
    }

    #[test]
    fn no_rows_make_no_table() {
        assert!(all(&sample::study(Vec::new())).is_empty());
    }
}
