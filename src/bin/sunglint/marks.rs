//! The marks of a panel: one for each row, with what it says when pointed at.

use kuva::prelude::{MarkerShape, ScatterPlot};

use crate::error_kind::ErrorKind;
use crate::key::Key;
use crate::number;
use crate::panel::PAPER;
use crate::result::Row;

/// Half the width of a mark, in pixels.
const SIZE: f64 = 6.0;
/// How much wider a mark is drawn for each one that lies on top of it, in pixels.
const RING: f64 = 2.5;
/// Marks nearer to each other than this lie on top of each other, in pixels.
const ON_TOP: f64 = 6.0;

/// Half the width of each mark, given where they are drawn. A mark that others cover grows to a ring
/// around them, so that none is hidden.
pub fn sizes(pixels: &[(f64, f64)]) -> Vec<f64> {
    let covers = |a: (f64, f64), b: &(f64, f64)| (a.0 - b.0).hypot(a.1 - b.1) < ON_TOP;
    let covering = |(i, at): (usize, &(f64, f64))| pixels[i + 1..].iter().filter(|later| covers(*at, later)).count();
    let counts = pixels.iter().enumerate().map(covering);
    counts.map(|count| SIZE + RING * count as f64).collect()
}

/// The mark of `row`: filled where it works, hollow and crossed out where it fails.
pub fn of(row: &Row, kind: ErrorKind, key: &Key, at: (f64, f64), size: f64) -> Vec<ScatterPlot> {
    let (shape, colour) = (key.shape(&row.method), key.colour(&row.format));
    let mark = |shape: MarkerShape, colour: &str, size: f64| {
        ScatterPlot::new()
            .with_data([at])
            .with_marker(shape)
            .with_color(colour)
            .with_size(size)
            .with_tooltip_labels([tooltip(row, kind)])
            .with_tooltips()
    };
    let mut marks = vec![mark(shape, PAPER, size + 1.2), mark(shape, colour, size)];
    if row.failure.is_some() {
        marks.push(mark(shape, PAPER, size - 2.0));
        marks.push(mark(MarkerShape::Cross, colour, size + 3.0));
    }
    marks
}

/// What is written next to the mark of `row`; its shape tells the method.
pub fn label(row: &Row, kind: ErrorKind) -> String {
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
        "{} in {}{}\n{} error up to {} rad, {} % of the radius\ncost {} ({} to {})",
        row.method,
        row.format,
        failure.unwrap_or_default(),
        kind.name(),
        number::scientific(worst),
        number::percent(worst, row.theta),
        number::cost(row.cost),
        number::cost(row.cost_low),
        number::cost(row.cost_high),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn covered_marks_are_rings() {
        let pixels = [(10.0, 10.0), (11.0, 10.0), (90.0, 10.0), (10.0, 12.0)];
        assert_eq!(sizes(&pixels), [SIZE + 2.0 * RING, SIZE + RING, SIZE, SIZE]);
    }

    #[test]
    fn a_failure_is_labelled_and_crossed_out() {
        let mut row = sample::row("disc", "f16", 1.0, 0.03);
        let key = Key::new(std::slice::from_ref(&row));
        assert_eq!(of(&row, ErrorKind::Total, &key, (0.0, 0.0), SIZE).len(), 2);
        row.failure = Some("disc lost".to_owned());
        assert_eq!(of(&row, ErrorKind::Total, &key, (0.0, 0.0), SIZE).len(), 4);
        assert_eq!(label(&row, ErrorKind::Total), "f16 disc lost");
    }
}
