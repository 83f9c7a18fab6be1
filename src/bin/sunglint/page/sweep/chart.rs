//! The chart of word lengths: a panel for each kind of number, a line for each method.

use kuva::plot::{LegendEntry, LegendShape};
use kuva::prelude::{Figure, Layout, LinePlot, LineStyle, MarkerShape, Plot, ScatterPlot, VolcanoLabelStyle};

use crate::chart;
use crate::key::{Key, in_order};
use crate::number;
use crate::panel::{self, INK, LINE, LINE_DASHES, PAPER, STEP};
use crate::sweep::{Family, SweepRow};

const PANEL: (f64, f64) = (400.0, 520.0);

const LEGEND: f64 = 150.0;

/// The panels: family, title, axis, and the least and greatest number of bits.
const PANELS: [(&str, &str, &str, (f64, f64)); 3] = [
    ("fixed", "Fixed point", "fraction bits", (7.0, 31.0)),
    ("float", "Floats", "digits of the significand", (7.0, 25.0)),
    ("flushing float", "Floats that flush subnormals", "digits of the significand", (7.0, 25.0)),
];

/// The exponent whose lines are of dashes.
const NARROW: Option<u32> = Some(5);

/// One per cent.
const PER_CENT: f64 = 1.0;

/// Chart of `rows`, which are all of one light and surface.
pub fn of_words(rows: &[&SweepRow], name: &str) -> String {
    let key = Key::new(rows.iter().map(|row| [&row.method, &row.method]));
    let range = range(rows);
    let last = PANELS.len() - 1;
    let mut figure = Figure::new(1, PANELS.len()).with_padding(12.0).with_row_height(0, PANEL.1);
    let (mut plots, mut layouts) = (Vec::new(), Vec::new());
    for (place, panel) in PANELS.into_iter().enumerate() {
        let (family, title, axis, bits) = panel;
        let rows: Vec<_> = rows.iter().copied().filter(|row| row.family == family).collect();
        let layout = layout(title, axis, bits, range, &rows);
        let width = PANEL.0 + if place == last { LEGEND } else { 0.0 };
        let layout = if place == last { with_legend(layout, &key, &rows) } else { layout };
        layouts.push(layout.with_width(width).with_height(PANEL.1));
        plots.push(drawn(&rows, &key, bits, range));
        figure = figure.with_col_width(place, width);
    }
    chart::svg(figure.with_plots(plots).with_layouts(layouts).render(), name)
}

/// The error that is shown, in per cent: of the edge, or of the arithmetic of a pixel.
fn shown(row: &SweepRow) -> f64 {
    row.edge_max.unwrap_or(100.0 * row.error_rms)
}

/// Decimal logarithms of the least and the greatest error, rounded outwards; at most a thousand per cent.
fn range(rows: &[&SweepRow]) -> (f64, f64) {
    let logarithms = rows.iter().map(|row| shown(row).log10()).filter(|log| log.is_finite());
    let (low, high) = logarithms.fold((0.0, 1.0), |(low, high): (f64, f64), log| (low.min(log), high.max(log)));
    (low.floor(), high.ceil().min(3.0))
}

/// Lines to compare with, then the methods.
fn drawn(rows: &[&SweepRow], key: &Key, bits: (f64, f64), range: (f64, f64)) -> Vec<Plot> {
    let mut plots = types(rows, range);
    plots.push(level(PER_CENT.log10(), bits, LINE));
    for family in Family::all(rows.iter().copied()) {
        let first = family.first();
        if first.alpha.is_some() && first.exponent != NARROW {
            let height = (100.0 * first.model_rms).log10();
            let seen = height > range.0 && height < range.1;
            plots.extend(seen.then(|| level(height, bits, key.colour(&first.method))));
        }
        plots.extend(method(&family, key, range));
    }
    plots
}

/// A line of dashes across a panel.
fn level(height: f64, bits: (f64, f64), colour: &str) -> Plot {
    let dashes = LineStyle::Custom(LINE_DASHES.to_owned());
    let line = LinePlot::new().with_data([(bits.0, height), (bits.1, height)]).with_color(colour);
    Plot::Line(line.with_line_style(dashes).with_stroke_width(1.2))
}

/// A method's line through the words of a family, and a mark for each of them.
fn method(family: &Family, key: &Key, range: (f64, f64)) -> Vec<Plot> {
    let colour = key.colour(&family.first().method);
    let rows: Vec<_> = family.rows.iter().copied().filter(|row| shown(row).is_finite()).collect();
    let place = |row: &SweepRow| (f64::from(row.bits), shown(row).log10().clamp(range.0, range.1));
    let line = LinePlot::new().with_data(rows.iter().map(|row| place(row))).with_color(colour).with_stroke_width(1.6);
    let narrow = family.first().exponent == NARROW;
    let line = if narrow { line.with_line_style(LineStyle::Custom("2 3".to_owned())) } else { line };
    let mut plots = vec![Plot::Line(line)];
    for row in rows {
        let size = if row.format.is_some() { 7.0 } else { 4.0 };
        let mark = |colour: &str, size: f64| {
            let mark =
                ScatterPlot::new().with_data([place(row)]).with_marker(key.shape(&row.method)).with_color(colour);
            Plot::Scatter(mark.with_size(size).with_tooltip_labels([tooltip(row)]).with_tooltips())
        };
        plots.push(mark(colour, size));
        plots.extend(row.failure.is_some().then(|| mark(PAPER, size - 2.0)));
    }
    plots
}

/// A line up to the name of each type, which stands above the panel.
fn types(rows: &[&SweepRow], range: (f64, f64)) -> Vec<Plot> {
    let mut named: Vec<_> = rows.iter().filter_map(|row| Some((row.format?, f64::from(row.bits)))).collect();
    named.sort_by(|a, b| a.1.total_cmp(&b.1));
    named.dedup();
    let of_type = |(name, bits): (&str, f64)| {
        let line =
            LinePlot::new().with_data([(bits, range.0), (bits, range.1)]).with_color(STEP).with_stroke_width(0.8);
        let text =
            ScatterPlot::new().with_data([(bits, range.1)]).with_color("none").with_size(0.0).with_labels([name]);
        [Plot::Line(line), Plot::Scatter(text.with_label_style(VolcanoLabelStyle::Exact))]
    };
    named.into_iter().flat_map(of_type).collect()
}

fn tooltip(row: &SweepRow) -> String {
    let format = row.format.map(|name| format!(" ({name})")).unwrap_or_default();
    let failure = row.failure.as_ref().map(|failure| format!(", {failure}")).unwrap_or_default();
    let what = if row.edge_max.is_some() { "of the radius at worst" } else { "root mean square" };
    format!("{} in {}{format}\n{} % {what}{failure}", row.method, row.word, number::scientific(shown(row)))
}

fn layout(title: &str, axis: &str, bits: (f64, f64), range: (f64, f64), rows: &[&SweepRow]) -> Layout {
    let edge = rows.first().is_none_or(|row| row.edge_max.is_some());
    let label = if edge { "worst error of the edge, % of the radius" } else { "arithmetic error of a pixel, rms, %" };
    let layout = Layout::new(bits, range)
        .with_title(title)
        .with_x_label(axis)
        .with_y_label(label)
        .with_x_axis_min(bits.0)
        .with_x_axis_max(bits.1)
        .with_x_tick_step(if bits.1 > 26.0 { 4.0 } else { 2.0 })
        .with_x_tick_format(panel::custom(|x| if x.fract().abs() < 1e-6 { format!("{x:.0}") } else { String::new() }))
        .with_y_axis_min(range.0)
        .with_y_axis_max(range.1)
        .with_y_tick_step(1.0)
        .with_y_tick_format(panel::powers_up_to(range.1));
    panel::dressed(layout)
}

/// The legend to the right of the last panel.
fn with_legend(layout: Layout, key: &Key, rows: &[&SweepRow]) -> Layout {
    let entry = |label: &str, color: &str, shape, dashes: Option<&str>| LegendEntry {
        label: label.to_owned(),
        color: color.to_owned(),
        shape,
        dasharray: dashes.map(str::to_owned),
    };
    let methods = in_order(rows.iter().map(|row| &row.method));
    let method = |name: &String| entry(name, key.colour(name), LegendShape::Marker(key.shape(name)), None);
    let mut signs = vec![
        entry("8 exponent bits", INK, LegendShape::Line, None),
        entry("5 exponent bits", INK, LegendShape::Line, Some("2 3")),
        entry("large: a type", INK, LegendShape::Marker(MarkerShape::Circle), None),
        entry("1 %", LINE, LegendShape::Line, Some(LINE_DASHES)),
    ];
    if rows.first().is_some_and(|row| row.alpha.is_some()) {
        signs.push(entry("model error", INK, LegendShape::Line, Some(LINE_DASHES)));
    }
    layout
        .with_legend_group("Method", methods.iter().map(method).collect())
        .with_legend_group("Signs", signs)
        .with_legend_width(LEGEND)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn types_are_named_and_what_is_no_number_is_left_out() {
        let mut rows = sample::sweep();
        rows[1].edge_max = Some(f64::NAN);
        let rows: Vec<_> = rows.iter().filter(|row| row.alpha.is_none() && row.family == "fixed").collect();
        let svg = of_words(&rows, "name");
        assert!(svg.contains(">I2F14<") && svg.contains("cap in Q14 in 16 bits (I2F14)"));
        assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("Q10 in"));
    }
}
