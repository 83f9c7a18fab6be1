//! The panel of the direction methods under one light.

use crate::author::{self, is_peer};
use crate::axis::{Axis, Costs, Price};
use crate::error_kind::ErrorKind;
use crate::field::{Field, Line, Point};
use crate::frame::Frame;
use crate::frontier;
use crate::number;
use crate::result::Row;

/// One kind of error of those of `rows` that have a cost; all are under one light. The axes hold both kinds, so that
/// the panels can be compared.
pub fn field(rows: &[&Row], kind: ErrorKind, costs: Costs) -> Field {
    let theta = rows.first().map_or(1.0, |row| row.theta);
    let priced = costs.priced(rows, Row::call);
    let on_frontier = frontier::members(&priced, |_| String::new(), |(row, price)| kind.standing(row, price.cost));
    let errors = rows.iter().flat_map(|row| ErrorKind::ALL.map(|kind| kind.worst(row))).chain([theta]);
    Field {
        title: format!("Worst {} error", kind.name()),
        subtitle: subtitle(kind, costs.axis),
        call: "call",
        axis: costs.axis,
        error_axis: "error in radians".to_owned(),
        per_cent: (theta > 0.0).then(|| ("error in % of the light's angular radius".to_owned(), theta)),
        frame: Frame::new(costs.axis, priced.iter().map(|(_, price)| price.cost), errors),
        points: priced.iter().zip(on_frontier).map(|(priced, member)| point(priced, kind, member)).collect(),
        // Named in the legend.
        lines: (theta > 0.0).then(|| Line { error: theta, name: String::new() }).into_iter().collect(),
    }
}

/// What the error is against, and which calls the instructions are of.
fn subtitle(kind: ErrorKind, axis: Axis) -> String {
    match axis {
        Axis::Host => kind.against().to_owned(),
        Axis::Chip(_) => format!("{}; instructions: median outside the disc", kind.against()),
    }
}

fn point((row, price): &(&Row, Price), kind: ErrorKind, on_frontier: bool) -> Point {
    Point {
        method: row.method.clone(),
        format: row.format.clone(),
        peer: is_peer(row.by),
        cost: price.cost,
        error: kind.worst(row),
        fails: row.failure.is_some(),
        on_frontier,
        label: label(row, kind),
        tooltip: tooltip(row, kind, price),
    }
}

/// What is written next to the mark of `row`; its shape tells the method.
fn label(row: &Row, kind: ErrorKind) -> String {
    let label = author::label(&row.format, row.by);
    match &row.failure {
        Some(failure) => format!("{label} {failure}"),
        None if kind.worst(row) == 0.0 => format!("{label} exact"),
        None => label,
    }
}

fn tooltip(row: &Row, kind: ErrorKind, price: &Price) -> String {
    let worst = kind.worst(row);
    let failure = row.failure.as_ref().map(|failure| format!(": {failure}"));
    format!(
        "{} in {}{}\n{} error up to {} rad, {} % of the radius\n{}",
        row.method,
        author::said(&row.format, row.by),
        failure.unwrap_or_default(),
        kind.name(),
        number::scientific(worst),
        number::percent(worst, row.theta),
        price.said,
    )
}
