//! The marks of a panel: one for each point, with what it says when pointed at.

use kuva::prelude::{MarkerShape, ScatterPlot};

use crate::field::Point;
use crate::key::Key;
use crate::panel::{PAPER, PEER};

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

/// The mark of `point`: filled where it works, hollow and crossed out where it fails.
pub fn of(point: &Point, key: &Key, at: (f64, f64), size: f64) -> Vec<ScatterPlot> {
    let (shape, colour) = (key.shape(&point.method), if point.peer { PEER } else { key.colour(&point.format) });
    let mark = |shape: MarkerShape, colour: &str, size: f64| {
        ScatterPlot::new()
            .with_data([at])
            .with_marker(shape)
            .with_color(colour)
            .with_size(size)
            .with_tooltip_labels([point.tooltip.clone()])
            .with_tooltips()
    };
    let mut marks = vec![mark(shape, PAPER, size + 1.2), mark(shape, colour, size)];
    if point.fails {
        marks.push(mark(shape, PAPER, size - 2.0));
        marks.push(mark(MarkerShape::Cross, colour, size + 3.0));
    }
    marks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::direction_panel;
    use crate::error_kind::ErrorKind;
    use crate::sample::{self, HOST};

    #[test]
    fn covered_marks_are_rings() {
        let pixels = [(10.0, 10.0), (11.0, 10.0), (90.0, 10.0), (10.0, 12.0)];
        assert_eq!(sizes(&pixels), [SIZE + 2.0 * RING, SIZE + RING, SIZE, SIZE]);
    }

    #[test]
    fn a_failure_is_labelled_and_crossed_out() {
        let mut row = sample::row("disc", "f16", 1.0, 0.03);
        let point = |row: &crate::result::Row| direction_panel::field(&[row], ErrorKind::Total, HOST).points.remove(0);
        let key = Key::new([[&row.method, &row.format]].into_iter());
        assert_eq!(of(&point(&row), &key, (0.0, 0.0), SIZE).len(), 2);
        let failure = "disc lost".to_owned();
        let failed = crate::result::Row { failure: Some(failure), ..row.clone() };
        assert_eq!(of(&point(&failed), &key, (0.0, 0.0), SIZE).len(), 4);
        assert_eq!(point(&failed).label, "f16 disc lost");
        row.total_max = 0.0;
        assert_eq!(point(&row).label, "f16 exact");
    }
}
