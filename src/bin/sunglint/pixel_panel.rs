//! The panel of lit pixels in one case.

use crate::anchors::AnchorRow;
use crate::author::{self, is_peer};
use crate::axis::{Axis, Costs, Price};
use crate::field::{Anchor, Field, Line, Point, Sort};
use crate::frame::Frame;
use crate::frontier;
use crate::key::in_order;
use crate::mean::Mean;
use crate::number;
use crate::pixel_error::{PixelError, PixelKind};
use crate::required;
use crate::result::PixelRow;
use crate::said;

/// One error of those of `rows` that have a cost, and of those `anchors` that are of their case; all rows are of one
/// case.
pub fn field(rows: &[&PixelRow], anchors: &[AnchorRow], error: PixelError, costs: Costs) -> Field {
    let priced = costs.priced(rows, PixelRow::call);
    let rows: Vec<_> = priced.iter().map(|(row, _)| *row).collect();
    let lines = lines(&rows, error);
    let errors = rows.iter().map(|row| error.of(row)).chain(lines.iter().map(|line| line.error));
    let frame = Frame::new(costs.axis, priced.iter().map(|(_, price)| price.cost), errors);
    let on_frontier = frontier::members(&priced, |_| String::new(), |(row, price)| error.standing(row, price.cost));
    Field {
        title: title(error),
        subtitle: subtitle(error),
        call: "pixel",
        axis: costs.axis,
        error_axis: if error.kind.is_steps() { "steps of the display" } else { "error relative to the pixel" }
            .to_owned(),
        per_cent: None,
        frame: if lines.is_empty() { frame } else { frame.with_lane() },
        points: priced.iter().zip(on_frontier).map(|(priced, member)| point(priced, error, member, costs)).collect(),
        // They are far off, so that the axes do not reach for them.
        anchors: anchored(&rows, anchors, error, costs.axis)
            .into_iter()
            .filter(|anchor| frame.holds(anchor.error))
            .collect(),
        lines,
    }
}

fn title(error: PixelError) -> String {
    let mean = error.mean.adjective();
    match error.kind.is_steps() {
        true => format!("{mean} error of a lit pixel in {}", error.kind.name()),
        false => format!("{mean} {} of a lit pixel", error.kind.said()),
    }
}

/// What the error is against, and what the lines mean.
fn subtitle(error: PixelError) -> String {
    match error.kind {
        PixelKind::Total => {
            "against the BRDF integrated over the disc; dashed: the model’s part, which no precision removes"
        }
        _ => error.against(),
    }
    .to_owned()
}

/// What the error is compared with: of the total the model error of each method, of steps the half of one.
fn lines(rows: &[&PixelRow], error: PixelError) -> Vec<Line> {
    match error.kind {
        PixelKind::Total => models(rows, error).into_iter().chain(required::of_shading()).collect(),
        PixelKind::Arithmetic => required::of_shading().into(),
        PixelKind::Model => Vec::new(),
        PixelKind::Steps8 | PixelKind::Steps10 => {
            vec![Line { error: 0.5, name: "half a step".to_owned(), sort: Sort::Size }]
        }
    }
}

fn models(rows: &[&PixelRow], error: PixelError) -> Vec<Line> {
    let first = |name: &String| rows.iter().find(|row| row.method == *name);
    let names = in_order(rows.iter().map(|row| &row.method));
    let line =
        |name: &String| first(name).map(|row| Line { error: error.model(row), name: name.clone(), sort: Sort::Model });
    names.iter().filter_map(line).collect()
}

/// The anchors of the case of `rows`, of the kinds of error that rounding a pixel is part of.
fn anchored(rows: &[&PixelRow], anchors: &[AnchorRow], error: PixelError, axis: Axis) -> Vec<Anchor> {
    let Some(first) = rows.first() else { return Vec::new() };
    let here = |row: &&AnchorRow| row.subject == "pixel" && row.light == first.case;
    let anchor = |row: &AnchorRow| {
        let rounded = match error.mean {
            Mean::Rms => row.rounded_rms,
            Mean::Max => row.rounded_max,
        };
        let cost = (axis == Axis::Host).then_some(row.empty);
        let anchor = Anchor { format: row.format.clone(), cost, error: rounded, tooltip: String::new() };
        let said = format!("max {}, rms {}", number::scientific(row.rounded_max), number::scientific(row.rounded_rms));
        Anchor { tooltip: said::of_anchor(&anchor, &said), ..anchor }
    };
    let shown = match error.kind {
        PixelKind::Total | PixelKind::Arithmetic => anchors,
        _ => &[],
    };
    shown.iter().filter(here).map(anchor).collect()
}

fn point((row, price): &(&PixelRow, Price), error: PixelError, on_frontier: bool, costs: Costs) -> Point {
    let label = [Some(author::label(&row.format, row.by)), row.failure.clone()];
    Point {
        method: row.method.clone(),
        format: row.format.clone(),
        peer: is_peer(row.by),
        cost: price.cost,
        error: error.of(row),
        fails: row.failure.is_some(),
        on_frontier,
        label: label.into_iter().flatten().collect::<Vec<_>>().join(" "),
        bound: (!is_peer(row.by)).then_some(row.bound),
        tooltip: said::of_pixel(row, costs.chip),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{self, HOST};

    #[test]
    fn the_lines_are_those_of_the_error() {
        let rows = [
            sample::pixel("karis", "f32", 5.0, 1e-6),
            sample::pixel("karis", "f16", 90.0, 1e-2),
            sample::pixel("cone_ggx", "f32", 9.0, 1e-6),
        ];
        let rows: Vec<_> = rows.iter().collect();
        let names = |kind| -> Vec<_> {
            let field = field(&rows, &[], PixelError { kind, mean: Mean::Max }, HOST);
            field.lines.into_iter().map(|line| line.name).collect()
        };
        assert_eq!(names(PixelKind::Total), ["karis", "cone_ggx", "GLES lowp", "GLES mediump"]);
        assert_eq!(names(PixelKind::Arithmetic), ["GLES lowp", "GLES mediump"]);
        assert_eq!(names(PixelKind::Steps8), ["half a step"]);
        assert!(names(PixelKind::Model).is_empty());
    }

    #[test]
    fn precision_under_the_model_error_is_not_worth_its_cost() {
        let mut rows = [sample::pixel("karis", "f32", 5.0, 1e-6), sample::pixel("karis", "f64", 6.0, 1e-15)];
        for row in &mut rows {
            row.total_rms = row.error_rms.hypot(0.3);
        }
        let field = field(&rows.iter().collect::<Vec<_>>(), &[], PixelError::default(), HOST);
        assert!(field.points[0].on_frontier && !field.points[1].on_frontier);
    }

    #[test]
    fn anchors_stand_at_the_mean_that_is_shown() {
        let row = sample::pixel("karis", "f32", 5.0, 1e-6);
        let anchors = |error| -> Vec<_> {
            let field = field(&[&row], &sample::anchors(), error, HOST);
            field.anchors.into_iter().map(|anchor| (anchor.cost, anchor.error)).collect()
        };
        assert_eq!(anchors(PixelError { kind: PixelKind::Arithmetic, mean: Mean::Rms }), [(Some(0.5), 5e-6 * 0.4)]);
        assert!(anchors(PixelError::default()).is_empty(), "it is far below");
        assert_eq!(anchors(PixelError { kind: PixelKind::Arithmetic, mean: Mean::Max }), [(Some(0.5), 5e-6)]);
        assert!(anchors(PixelError { kind: PixelKind::Steps8, mean: Mean::Max }).is_empty());
    }
}
