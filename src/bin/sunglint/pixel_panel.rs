//! The panel of lit pixels in one case.

use crate::author::{self, is_peer};
use crate::axis::{Costs, Price};
use crate::error_kind::ErrorKind;
use crate::field::{Field, Line, Point};
use crate::frame::Frame;
use crate::frontier;
use crate::key::in_order;
use crate::number;
use crate::pixel_error::PixelError;
use crate::result::PixelRow;

/// One error of those of `rows` that have a cost; all are of one case. With the total error goes a line for each
/// method's model error.
pub fn field(rows: &[&PixelRow], error: PixelError, costs: Costs) -> Field {
    let priced = costs.priced(rows, PixelRow::call);
    let rows: Vec<_> = priced.iter().map(|(row, _)| *row).collect();
    let lines = if error.kind == ErrorKind::Total { lines(&rows, error) } else { Vec::new() };
    let errors = rows.iter().map(|row| error.of(row)).chain(lines.iter().map(|line| line.error));
    let frame = Frame::new(costs.axis, priced.iter().map(|(_, price)| price.cost), errors);
    let on_frontier = frontier::members(&priced, |_| String::new(), |(row, price)| error.standing(row, price.cost));
    Field {
        title: format!("{} {} error of a lit pixel", error.mean.adjective(), error.kind.name()),
        subtitle: subtitle(error),
        call: "pixel",
        axis: costs.axis,
        error_axis: "error relative to the pixel".to_owned(),
        per_cent: None,
        frame: if lines.is_empty() { frame } else { frame.with_lane() },
        points: priced.iter().zip(on_frontier).map(|(priced, member)| point(priced, error, member)).collect(),
        lines,
    }
}

/// What the error is against, and what the lines mean.
fn subtitle(error: PixelError) -> String {
    match error.kind {
        ErrorKind::Total => {
            "against the BRDF integrated over the disc; dashed: the model’s part, which no precision removes"
        }
        ErrorKind::Arithmetic => error.against(),
    }
    .to_owned()
}

/// The model error of each method, which no precision removes.
fn lines(rows: &[&PixelRow], error: PixelError) -> Vec<Line> {
    let first = |name: &String| rows.iter().find(|row| row.method == *name);
    let names = in_order(rows.iter().map(|row| &row.method));
    let line = |name: &String| first(name).map(|row| Line { error: error.model(row), name: name.clone() });
    names.iter().filter_map(line).collect()
}

fn point((row, price): &(&PixelRow, Price), error: PixelError, on_frontier: bool) -> Point {
    Point {
        method: row.method.clone(),
        format: row.format.clone(),
        peer: is_peer(row.by),
        cost: price.cost,
        error: error.of(row),
        fails: row.failure.is_some(),
        on_frontier,
        label: [Some(author::label(&row.format, row.by)), row.failure.clone()]
            .into_iter()
            .flatten()
            .collect::<Vec<_>>()
            .join(" "),
        tooltip: tooltip(row, error, price),
    }
}

fn tooltip(row: &PixelRow, error: PixelError, price: &Price) -> String {
    format!(
        "{} in {}\n{} of the arithmetic error {}, of the model error {}, of both {}\n{}",
        row.method,
        author::said(&row.format, row.by),
        error.mean.name(),
        number::scientific(PixelError { kind: ErrorKind::Arithmetic, ..error }.of(row)),
        number::scientific(error.model(row)),
        number::scientific(PixelError { kind: ErrorKind::Total, ..error }.of(row)),
        price.said,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mean::Mean;
    use crate::sample::{self, HOST};

    #[test]
    fn only_the_total_error_has_lines_and_each_method_one() {
        let rows = [
            sample::pixel("karis", "f32", 5.0, 1e-6),
            sample::pixel("karis", "f16", 90.0, 1e-2),
            sample::pixel("cone_ggx", "f32", 9.0, 1e-6),
        ];
        let rows: Vec<_> = rows.iter().collect();
        let lines = |kind| field(&rows, PixelError { kind, mean: Mean::Max }, HOST).lines;
        assert_eq!(lines(ErrorKind::Total).len(), 2);
        assert!(lines(ErrorKind::Arithmetic).is_empty());
    }

    #[test]
    fn precision_under_the_model_error_is_not_worth_its_cost() {
        let mut rows = [sample::pixel("karis", "f32", 5.0, 1e-6), sample::pixel("karis", "f64", 6.0, 1e-15)];
        for row in &mut rows {
            row.total_rms = row.error_rms.hypot(0.3);
        }
        let field = field(&rows.iter().collect::<Vec<_>>(), PixelError::default(), HOST);
        assert!(field.points[0].on_frontier && !field.points[1].on_frontier);
    }
}
