//! Ticks of an axis of instructions: 1, 2 and 5 times the powers of ten, in plain digits.
//!
//! Drawn as lines and texts of their own: the log axes of kuva leave out 2 and 5 where the range touches four powers of
//! ten.

use kuva::prelude::{LinePlot, Plot};

use crate::field::Field;
use crate::labels::{Label, width};
use crate::lettering;
use crate::panel::GRID;
use crate::sheet::Sheet;

/// Decimal logarithms of 1, 2 and 5.
const STEPS: [f64; 3] = [0.0, std::f64::consts::LOG10_2, 1.0 - std::f64::consts::LOG10_2];

/// From the lower edge of a panel to the middle of its ticks' texts, in pixels.
const DOWN: f64 = 13.0;

/// How far a text may stand out to the right, which is less than any chart has there, in pixels.
const OUT: f64 = 9.0;

/// Space between two texts, in pixels.
const GAP: f64 = 6.0;

/// What rounding may move a tick by.
const TOLERANCE: f64 = 1e-9;

/// The last tick up to the logarithm `x`.
pub fn below(x: f64) -> f64 {
    let whole = x.floor();
    STEPS.map(|step| whole + step).into_iter().filter(|tick| *tick <= x + TOLERANCE).fold(whole, f64::max)
}

/// The first tick from the logarithm `x` on.
pub fn above(x: f64) -> f64 {
    let whole = x.floor();
    STEPS.map(|step| whole + step).into_iter().filter(|tick| *tick >= x - TOLERANCE).fold(whole + 1.0, f64::min)
}

/// Logarithms of the ticks of a range.
fn all((low, high): (f64, f64)) -> Vec<f64> {
    let wholes = low.floor() as i32..=high.floor() as i32;
    let ticks = wholes.flat_map(|whole| STEPS.map(|step| f64::from(whole) + step));
    ticks.filter(|tick| (low - TOLERANCE..high + TOLERANCE).contains(tick)).collect()
}

/// Lines and texts at the ticks.
pub fn plots(field: &Field, sheet: &Sheet) -> Vec<Plot> {
    let frame = &field.frame;
    let ticks = all(frame.x);
    let inner = ticks.iter().filter(|&&x| x > frame.x.0 + TOLERANCE && x < frame.right - TOLERANCE);
    let line =
        |&x: &f64| LinePlot::new().with_data([(x, frame.y.0), (x, frame.top)]).with_color(GRID).with_stroke_width(1.0);
    let mut plots: Vec<_> = inner.map(|x| Plot::Line(line(x))).collect();
    plots.push(Plot::Scatter(lettering::texts(&texts(&ticks, sheet), sheet)));
    plots
}

/// The powers of ten, and of the other ticks those whose texts have room.
fn texts(ticks: &[f64], sheet: &Sheet) -> Vec<Label> {
    let label = |&x: &f64| {
        let text = format!("{:.0}", 10f64.powf(x));
        let rightmost = sheet.area.x.1 + OUT - width(&text) / 2.0;
        let at = (sheet.pixels((x, 0.0)).0.min(rightmost), sheet.area.y.1 + DOWN);
        Label { text, at, mark: at }
    };
    let is_power = |x: &&f64| (**x - x.round()).abs() < TOLERANCE;
    let (powers, others): (Vec<_>, Vec<_>) = ticks.iter().partition(is_power);
    let mut labels: Vec<Label> = powers.into_iter().map(label).collect();
    for other in others.into_iter().map(label) {
        let apart =
            |known: &Label| (known.at.0 - other.at.0).abs() >= (width(&known.text) + width(&other.text)) / 2.0 + GAP;
        if labels.iter().all(apart) {
            labels.push(other);
        }
    }
    labels
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(logarithms: impl IntoIterator<Item = f64>) -> Vec<f64> {
        logarithms.into_iter().map(|x| 10f64.powf(x).round()).collect()
    }

    #[test]
    fn ticks_are_plain_numbers() {
        let range = (50f64.log10(), 2000f64.log10());
        assert_eq!(values(all(range)), [50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0]);
    }

    #[test]
    fn a_tick_is_its_own_neighbour() {
        for value in [1.0_f64, 20.0, 50.0, 500.0, 1000.0] {
            assert_eq!(values([below(value.log10()), above(value.log10())]), [value; 2]);
        }
        assert_eq!(values([below(64f64.log10()), above(64f64.log10())]), [50.0, 100.0]);
        assert_eq!(values([below(199f64.log10()), above(501f64.log10())]), [100.0, 1000.0]);
    }
}
