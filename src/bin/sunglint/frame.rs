//! Where a row stands in a chart: the axes of one light.

use crate::error_kind::ErrorKind;
use crate::result::Row;

/// Height of the strip above the errors, in decades, that holds the rows without a number.
const STRIP: f64 = 1.6;

/// Ranges of a chart's axes. The axes are linear in the logarithms, since the log axes of kuva end at
/// 1e-10 and the errors of f64 lie far below.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Binary logarithm of the lowest and the highest cost shown.
    pub x: (f64, f64),
    /// Decimal logarithm of the lowest and the highest error shown, below the strip.
    pub y: (f64, f64),
    /// Decimal logarithm of the light's angular radius.
    pub radius: f64,
}

impl Frame {
    /// Axes that hold every row and both kinds of error, so that the panels can be compared.
    pub fn new(rows: &[&Row]) -> Self {
        let costs = rows.iter().map(|row| row.cost.log2());
        let errors = rows.iter().flat_map(|row| ErrorKind::ALL.map(|kind| kind.worst(row)));
        let theta = rows.first().map_or(1.0, |row| row.theta);
        let x = span(costs);
        let y = span(errors.chain([theta]).map(f64::log10));
        Self {
            x: ((x.0 - 0.3).floor(), (x.1 + 0.3).ceil()),
            y: ((y.0 - 0.5).floor(), (y.1 + 0.3).ceil()),
            radius: theta.log10(),
        }
    }

    /// Place of `cost` along the chart.
    pub fn across(&self, cost: f64) -> f64 {
        cost.log2().clamp(self.x.0, self.x.1)
    }

    /// Place of `error` up the chart. Zero lies on the lower edge, whatever is no number in the strip.
    pub fn up(&self, error: f64) -> f64 {
        if error.is_finite() { error.log10().max(self.y.0) } else { self.y.1 + STRIP / 2.0 }
    }

    /// Upper edge of the chart, strip included.
    pub fn top(&self) -> f64 {
        self.y.1 + STRIP
    }
}

/// Least and greatest of the numbers among `values`, or 0 and 1 if there are none.
fn span(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let numbers = values.filter(|value| value.is_finite());
    let widen = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
    let (low, high) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), widen);
    if low <= high { (low, high) } else { (0.0, 1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn every_error_finds_a_place_inside() {
        let rows = [f64::NAN, f64::INFINITY, 0.0, 3e-16, 1.0];
        let rows = rows.map(|error| sample::row("cap", "f32", 1.0, error));
        let frame = Frame::new(&rows.iter().collect::<Vec<_>>());
        for row in &rows {
            let place = frame.up(row.error_max);
            assert!((frame.y.0..frame.top()).contains(&place), "{place} {frame:?}");
        }
        assert!(frame.up(f64::NAN) > frame.up(1.0));
    }

    #[test]
    fn no_rows_still_make_a_frame() {
        let frame = Frame::new(&[]);
        assert!(frame.x.0 < frame.x.1 && frame.y.0 < frame.y.1);
    }
}
