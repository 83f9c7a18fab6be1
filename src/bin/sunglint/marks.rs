//! The marks of a panel: one for each point, with what it says when pointed at.

use kuva::prelude::{MarkerShape, ScatterPlot};

use crate::field::{Anchor, Point};
use crate::key::Key;
use crate::mark_groups;
use crate::panel::{PAPER, PEER, RIM};
use crate::result::Bound;

/// Half the width of a mark, in pixels.
const SIZE: f64 = 6.0;
/// The same of an anchor's mark.
pub const ANCHOR: f64 = 4.5;
/// Radius of the dot in a mark whose bound is sampled, in pixels.
const DOT: f64 = 1.8;
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

/// The mark of `point`: filled where it works, hollow and crossed out where it fails. A dark rim says that its bound is
/// exhaustive, a light dot in the middle that it is only sampled.
pub fn of(point: &Point, key: &Key, at: (f64, f64), size: f64) -> Vec<ScatterPlot> {
    let (shape, colour) = (key.shape(&point.method), if point.peer { PEER } else { key.colour(&point.format) });
    let title = mark_groups::title(&point.method, &point.tooltip);
    let mark = |shape: MarkerShape, colour: &str, size: f64| part(&title, at, shape, colour, size);
    let rim = if point.bound == Some(Bound::Exhaustive) { RIM } else { PAPER };
    let mut marks = vec![mark(shape, rim, size + 1.6), mark(shape, colour, size)];
    if point.fails {
        marks.push(mark(shape, PAPER, size - 2.0));
        marks.push(mark(MarkerShape::Cross, colour, size + 3.0));
    } else if point.bound == Some(Bound::Sampled) {
        marks.push(mark(MarkerShape::Circle, PAPER, DOT));
    }
    marks
}

/// The mark of the true answer as the format holds it: small and hollow.
pub fn of_anchor(anchor: &Anchor, key: &Key, at: (f64, f64)) -> [ScatterPlot; 2] {
    let title = mark_groups::title("", &anchor.tooltip);
    let mark = |colour: &str, size: f64| part(&title, at, MarkerShape::Hexagon, colour, size);
    [mark(key.colour(&anchor.format), ANCHOR), mark(PAPER, ANCHOR - 2.0)]
}

/// One shape of a mark.
fn part(title: &str, at: (f64, f64), shape: MarkerShape, colour: &str, size: f64) -> ScatterPlot {
    ScatterPlot::new()
        .with_data([at])
        .with_marker(shape)
        .with_color(colour)
        .with_size(size)
        .with_tooltip_labels([title])
        .with_tooltips()
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
        let point =
            |row: &crate::result::Row| direction_panel::field(&[row], &[], ErrorKind::Total, HOST).points.remove(0);
        let key = Key::new([[&row.method, &row.format]].into_iter());
        assert_eq!(of(&point(&row), &key, (0.0, 0.0), SIZE).len(), 2);
        let failure = "disc lost".to_owned();
        let failed = crate::result::Row { failure: Some(failure), ..row.clone() };
        assert_eq!(of(&point(&failed), &key, (0.0, 0.0), SIZE).len(), 4);
        assert_eq!(point(&failed).label, "f16 disc lost");
        row.total_max = 0.0;
        assert_eq!(point(&row).label, "f16 exact");
    }

    #[test]
    fn a_mark_shows_what_its_bound_rests_on() {
        let parts = |bound| {
            let row = crate::result::Row { bound, ..sample::row("cap", "f32", 1.0, 1e-7) };
            let point = direction_panel::field(&[&row], &[], ErrorKind::Total, HOST).points.remove(0);
            let marks = of(&point, &Key::default(), (0.0, 0.0), SIZE);
            (marks[0].color.clone(), marks.len())
        };
        assert_eq!(parts(Bound::Exhaustive), (RIM.to_owned(), 2));
        assert_eq!(parts(Bound::Searched), (PAPER.to_owned(), 2));
        assert_eq!(parts(Bound::Sampled), (PAPER.to_owned(), 3));
    }
}
