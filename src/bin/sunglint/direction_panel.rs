//! The panel of the direction methods under one light.

use crate::anchors::AnchorRow;
use crate::author::{self, is_peer};
use crate::axis::{Axis, Costs, Price};
use crate::error_kind::ErrorKind;
use crate::field::{Anchor, Field, Line, Point, Sort};
use crate::frame::Frame;
use crate::frontier;
use crate::key::in_order;
use crate::number;
use crate::required;
use crate::result::Row;
use crate::said;

/// One kind of error of those of `rows` that have a cost, and of those `anchors` that are under their light; all rows
/// are under one light. The axes of the arithmetic and of the total error hold both, so that they can be compared.
pub fn field(rows: &[&Row], anchors: &[AnchorRow], kind: ErrorKind, costs: Costs) -> Field {
    let theta = rows.first().map_or(1.0, |row| row.theta);
    // Nobody has judged the edges that peers draw.
    let judged = |row: &&Row| kind != ErrorKind::Edge || !is_peer(row.by);
    let rows: Vec<_> = rows.iter().copied().filter(judged).collect();
    let priced = costs.priced(&rows, Row::call);
    let on_frontier = frontier::members(&priced, |_| String::new(), |(row, price)| kind.standing(row, price.cost));
    let anchors = anchored(&rows, anchors, kind, costs.axis);
    let lines = lines(&rows, kind, theta);
    let shown: &[ErrorKind] = if ErrorKind::ALL.contains(&kind) { &ErrorKind::ALL } else { &[kind] };
    let errors = rows.iter().flat_map(|row| shown.iter().map(|kind| kind.worst(row)));
    let errors = errors.chain(lines.iter().map(|line| line.error));
    let paid = priced.iter().map(|(_, price)| price.cost).chain(anchors.iter().filter_map(|anchor| anchor.cost));
    let frame = Frame::new(costs.axis, paid, errors).with_lane();
    Field {
        title: format!("Worst {} error", kind.name()),
        subtitle: subtitle(kind, costs.axis),
        call: "call",
        axis: costs.axis,
        error_axis: if kind == ErrorKind::Edge {
            "error in % of the light's angular radius"
        } else {
            "error in radians"
        }
        .to_owned(),
        per_cent: (kind != ErrorKind::Edge && theta > 0.0)
            .then(|| ("error in % of the light's angular radius".to_owned(), theta)),
        frame,
        points: priced.iter().zip(on_frontier).map(|(priced, member)| point(priced, kind, member, costs)).collect(),
        anchors: anchors.into_iter().filter(|anchor| frame.holds(anchor.error)).collect(),
        lines,
    }
}

/// What the error is against, and which calls the instructions are of.
fn subtitle(kind: ErrorKind, axis: Axis) -> String {
    match axis {
        Axis::Host => kind.against().to_owned(),
        Axis::Chip(_) => format!("{}; instructions: median outside the disc", kind.against()),
    }
}

/// The light's radius, a hundredth of it, the model's errors where they are part of `kind`, and what standards ask for.
fn lines(rows: &[&Row], kind: ErrorKind, theta: f64) -> Vec<Line> {
    let radius = if kind == ErrorKind::Edge { 100.0 } else { theta };
    let size = |part: f64, name: &str| Line { error: part * radius, name: name.to_owned(), sort: Sort::Size };
    let sizes = [size(1.0, "radius"), size(0.01, "1 % of radius")];
    let models = if kind == ErrorKind::Total { models(rows) } else { Vec::new() };
    let required = if kind == ErrorKind::Edge { Vec::new() } else { required::of_shading().into() };
    // A point has no radius.
    sizes.into_iter().chain(models).chain(required).filter(|line| line.error > 0.0).collect()
}

/// The model error of each method that has one.
fn models(rows: &[&Row]) -> Vec<Line> {
    let worst = |name: &String| {
        let models = rows.iter().filter(|row| row.method == *name && row.model_max.is_finite());
        models.map(|row| row.model_max).fold(0.0, f64::max)
    };
    let line = |name: &String| Line { error: worst(name), name: format!("{name} model"), sort: Sort::Model };
    let lines = in_order(rows.iter().map(|row| &row.method)).iter().map(line).collect::<Vec<_>>();
    lines.into_iter().filter(|line| line.error > 0.0).collect()
}

/// The anchors under the light of `rows`, of the kinds of error that rounding an answer is part of.
fn anchored(rows: &[&Row], anchors: &[AnchorRow], kind: ErrorKind, axis: Axis) -> Vec<Anchor> {
    let Some(first) = rows.first() else { return Vec::new() };
    let here = |row: &&AnchorRow| row.subject == "direction" && row.light == first.light;
    let anchor = |row: &AnchorRow| {
        let cost = (axis == Axis::Host).then_some(row.empty);
        let anchor = Anchor { format: row.format.clone(), cost, error: row.rounded_max, tooltip: String::new() };
        let error = format!(
            "up to {} rad, {} % of the radius",
            number::scientific(row.rounded_max),
            number::percent(row.rounded_max, first.theta)
        );
        Anchor { tooltip: said::of_anchor(&anchor, &error), ..anchor }
    };
    let shown = if ErrorKind::ALL.contains(&kind) { anchors } else { &[] };
    shown.iter().filter(here).map(anchor).collect()
}

fn point((row, price): &(&Row, Price), kind: ErrorKind, on_frontier: bool, costs: Costs) -> Point {
    Point {
        method: row.method.clone(),
        format: row.format.clone(),
        peer: is_peer(row.by),
        cost: price.cost,
        error: kind.worst(row),
        fails: row.failure.is_some(),
        on_frontier,
        label: label(row, kind),
        bound: (!is_peer(row.by)).then_some(row.bound),
        tooltip: said::of_direction(row, costs.chip),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{self, HOST};

    fn shown(kind: ErrorKind) -> Field {
        let rows = [sample::row("cap", "f32", 1.0, 1e-7), sample::row("disc", "f16", 2.0, 1e-3)];
        let rows = rows.map(|row| Row { model_max: if row.method == "cap" { 0.0 } else { 1e-4 }, ..row });
        field(&rows.iter().collect::<Vec<_>>(), &sample::anchors(), kind, HOST)
    }

    #[test]
    fn the_models_are_lines_of_the_total_error_alone() {
        let names = |kind| -> Vec<_> { shown(kind).lines.into_iter().map(|line| line.name).collect() };
        let always = ["radius", "1 % of radius", "GLES lowp", "GLES mediump"];
        assert_eq!(names(ErrorKind::Arithmetic), always);
        assert_eq!(names(ErrorKind::Total), [&always[..2], &["disc model"], &always[2..]].concat());
        assert_eq!(names(ErrorKind::Edge), always[..2]);
    }

    #[test]
    fn anchors_stand_where_rounding_is_part_of_the_error() {
        let anchors = |kind| shown(kind).anchors.len();
        assert_eq!(ErrorKind::CHARTS.map(anchors), [2, 0, 2, 0]);
        let first = &shown(ErrorKind::Total).anchors[0];
        assert_eq!((first.cost, first.error), (Some(0.25), 3e-8));
        assert!(first.tooltip.contains("an empty call: 0.25"), "{}", first.tooltip);
    }

    #[test]
    fn the_edge_is_in_per_cent_and_not_known_of_peers() {
        let rows = ["sunglint", "libm 0.2.16"].map(|by| Row { by, ..sample::row("cap", "f32", 1.0, 1e-7) });
        let field = field(&rows.iter().collect::<Vec<_>>(), &[], ErrorKind::Edge, HOST);
        assert_eq!((field.points.len(), field.points[0].error), (1, 0.3));
        assert!(field.per_cent.is_none());
    }
}
