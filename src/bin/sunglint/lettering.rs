//! The labels of a panel, from the places of the marks to what kuva draws.

use kuva::prelude::{LinePlot, Plot, ScatterPlot, VolcanoLabelStyle};

use crate::labels::{self, Area, Label, Mark};
use crate::sheet::Sheet;

/// How far kuva writes a text above its point, less half the height of a letter, in pixels.
const RISE: f64 = 6.0;
/// Colour of what leads from a mark to its label.
pub const LEADER: &str = "#9a9a9a";

/// Texts and leaders for `marks`, off the areas that are `taken`.
pub fn plots(marks: &[Mark], taken: &[Area], sheet: &Sheet) -> Vec<Plot> {
    let labels = labels::place(marks, sheet.area, taken);
    let far = labels.iter().filter(|label| label.is_far());
    let mut plots: Vec<_> = far.map(|label| Plot::Line(leader(label, sheet))).collect();
    plots.push(Plot::Scatter(texts(&labels, sheet)));
    plots
}

/// Unpainted marks whose labels kuva writes.
pub fn texts(labels: &[Label], sheet: &Sheet) -> ScatterPlot {
    let point = |label: &Label| sheet.data((label.at.0, label.at.1 + RISE));
    ScatterPlot::new()
        .with_data(labels.iter().map(point))
        .with_color("none")
        .with_size(0.0)
        .with_labels(labels.iter().map(|label| label.text.clone()))
        .with_label_style(VolcanoLabelStyle::Exact)
}

fn leader(label: &Label, sheet: &Sheet) -> LinePlot {
    LinePlot::new()
        .with_data([sheet.data(label.foot()), sheet.data(label.mark)])
        .with_color(LEADER)
        .with_stroke_width(0.8)
}
