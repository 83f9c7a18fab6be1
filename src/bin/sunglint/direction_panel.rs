//! The panel of the direction methods under one light.

use crate::error_kind::ErrorKind;
use crate::field::{Field, Line, Point};
use crate::frame::Frame;
use crate::number;
use crate::result::Row;

/// One kind of error of `rows`, which are all under one light. The axes hold both kinds, so that the panels can be
/// compared.
pub fn field(rows: &[&Row], kind: ErrorKind) -> Field {
    let theta = rows.first().map_or(1.0, |row| row.theta);
    let errors = rows.iter().flat_map(|row| ErrorKind::ALL.map(|kind| kind.worst(row))).chain([theta]);
    Field {
        title: format!("Worst {} error", kind.name()),
        subtitle: kind.against().to_owned(),
        call: "call",
        error_axis: "error in radians".to_owned(),
        per_cent: Some(("error in % of the light's angular radius".to_owned(), theta)),
        frame: Frame::new(rows.iter().map(|row| row.cost), errors),
        points: rows.iter().map(|row| point(row, kind)).collect(),
        // Named in the legend.
        lines: vec![Line { error: theta, name: String::new() }],
    }
}

fn point(row: &Row, kind: ErrorKind) -> Point {
    Point {
        method: row.method.clone(),
        format: row.format.clone(),
        cost: row.cost,
        error: kind.worst(row),
        fails: row.failure.is_some(),
        on_frontier: kind.on_frontier(row),
        label: label(row, kind),
        tooltip: tooltip(row, kind),
    }
}

/// What is written next to the mark of `row`; its shape tells the method.
fn label(row: &Row, kind: ErrorKind) -> String {
    match &row.failure {
        Some(failure) => format!("{} {failure}", row.format),
        None if kind.worst(row) == 0.0 => format!("{} exact", row.format),
        None => row.format.clone(),
    }
}

fn tooltip(row: &Row, kind: ErrorKind) -> String {
    let worst = kind.worst(row);
    let failure = row.failure.as_ref().map(|failure| format!(": {failure}"));
    format!(
        "{} in {}{}\n{} error up to {} rad, {} % of the radius\ncost {}",
        row.method,
        row.format,
        failure.unwrap_or_default(),
        kind.name(),
        number::scientific(worst),
        number::percent(worst, row.theta),
        number::quartiles([row.cost, row.cost_low, row.cost_high]),
    )
}
