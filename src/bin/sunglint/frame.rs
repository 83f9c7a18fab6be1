//! Where a point stands in a panel: the ranges of its axes.

use crate::axis::Axis;
use crate::ticks;

/// Height of the strip above the errors, in decades, that holds the points without a number.
const STRIP: f64 = 1.6;

/// Width of the lane for the names of lines, in widths of what lies left of it.
const LANE: f64 = 0.22;

/// Ranges of a panel's axes. The axes are linear in the logarithms, since the log axes of kuva end at
/// 1e-10 and the errors of f64 lie far below.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Logarithm of the lowest and the highest cost shown: binary for times, decimal for instructions.
    pub x: (f64, f64),
    /// Decimal logarithm of the lowest and the highest error shown, below the strip.
    pub y: (f64, f64),
    /// Right edge of the panel, beyond the lane for the names of lines if there is one.
    pub right: f64,
    /// Upper edge of the panel, above the strip if there is one.
    pub top: f64,
    axis: Axis,
}

impl Frame {
    /// Axes that hold all costs and errors; a strip above them if some errors are no numbers.
    pub fn new(axis: Axis, costs: impl Iterator<Item = f64>, errors: impl Iterator<Item = f64> + Clone) -> Self {
        let x = span(costs.map(|cost| logarithm(axis, cost)));
        let y = span(errors.clone().map(f64::log10));
        let x = match axis {
            Axis::Host => ((x.0 - 0.3).floor(), (x.1 + 0.3).ceil()),
            Axis::Chip(_) => (ticks::below(x.0 - 0.04), ticks::above(x.1 + 0.04)),
        };
        let y = ((y.0 - 0.5).floor(), (y.1 + 0.3).ceil());
        let all_numbers = errors.into_iter().all(f64::is_finite);
        Self { x, y, right: x.1, top: if all_numbers { y.1 } else { y.1 + STRIP }, axis }
    }

    /// The same with a lane on the right for the names of lines.
    pub fn with_lane(self) -> Self {
        Self { right: self.x.1 + LANE * (self.x.1 - self.x.0), ..self }
    }

    /// The same from one cost's logarithm to another's.
    pub fn with_costs(self, x: (f64, f64)) -> Self {
        let lane = (self.right - self.x.1) / (self.x.1 - self.x.0);
        Self { x, right: x.1 + lane * (x.1 - x.0), ..self }
    }

    /// Place of `cost` along the chart.
    pub fn across(&self, cost: f64) -> f64 {
        logarithm(self.axis, cost).clamp(self.x.0, self.x.1)
    }

    /// Whether `error` is a number within the panel.
    pub fn holds(&self, error: f64) -> bool {
        error.is_finite() && (self.y.0..=self.y.1).contains(&error.log10())
    }

    /// Place of `error` up the chart. Zero lies on the lower edge, whatever is no number in the strip.
    pub fn up(&self, error: f64) -> f64 {
        if error.is_finite() { error.log10().max(self.y.0) } else { (self.y.1 + self.top) / 2.0 }
    }
}

fn logarithm(axis: Axis, cost: f64) -> f64 {
    match axis {
        Axis::Host => cost.log2(),
        Axis::Chip(_) => cost.log10(),
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

    #[test]
    fn every_error_finds_a_place_inside() {
        let errors = [f64::NAN, f64::INFINITY, 0.0, 3e-16, 1.0];
        let frame = Frame::new(Axis::Host, [1.0].into_iter(), errors.into_iter());
        for error in errors {
            let place = frame.up(error);
            assert!((frame.y.0..frame.top).contains(&place), "{place} {frame:?}");
        }
        assert!(frame.up(f64::NAN) > frame.up(1.0));
    }

    #[test]
    fn there_is_a_strip_only_for_what_is_no_number() {
        let frame = |errors: [f64; 2]| Frame::new(Axis::Host, [1.0, 2.0].into_iter(), errors.into_iter());
        assert!(frame([1e-3, f64::NAN]).top > frame([1e-3, 1e-4]).top);
        let frame = frame([1e-3, 1e-4]);
        assert_eq!((frame.top, frame.right), (frame.y.1, frame.x.1));
        assert!(frame.with_lane().right > frame.x.1);
    }

    #[test]
    fn instructions_begin_and_end_at_a_tick() {
        let frame = Frame::new(Axis::ALL[1], [64.0, 4722.0].into_iter(), [1e-3].into_iter());
        assert_eq!([frame.x.0, frame.x.1].map(|x| 10f64.powf(x).round()), [50.0, 10_000.0]);
        assert!((frame.x.0..frame.x.1).contains(&frame.across(64.0)));
    }

    #[test]
    fn no_rows_still_make_a_frame() {
        let frame = Frame::new(Axis::Host, [].into_iter(), [].into_iter());
        assert!(frame.x.0 < frame.x.1 && frame.y.0 < frame.y.1);
    }
}
