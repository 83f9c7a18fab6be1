//! The charts of presets: a measure against an input, a line for each form.

use kuva::plot::{LegendEntry, LegendShape};
use kuva::prelude::{Layout, LinePlot, Plot, ScatterPlot, render_multiple};

use super::{Axes, PresetRow, shown};
use crate::chart::{self, ALONE};
use crate::key::{Key, in_order};
use crate::{number, panel};

const LEGEND: f64 = 245.0;

/// The tick about which the others lie.
const MIDDLE: f64 = 0.1;

/// Chart of those of `rows` that stand on its axis.
pub fn against(rows: &[PresetRow], axes: &Axes) -> String {
    let rows: Vec<_> = rows.iter().filter(|row| row.input.is_some() && row.value.is_finite()).collect();
    let forms = in_order(rows.iter().map(|row| &row.form));
    let key = Key::new(rows.iter().map(|row| [&row.form, &row.form]));
    let plots = forms.iter().flat_map(|form| {
        let points: Vec<_> = rows.iter().copied().filter(|row| row.form == *form).collect();
        line(&points, form, &key, axes)
    });
    let name = format!("{}: {} against {}", axes.title, axes.measure, axes.input);
    chart::svg(render_multiple(plots.collect(), layout(&rows, &forms, &key, axes)), &name)
}

fn across(row: &PresetRow, axes: &Axes) -> f64 {
    (row.input.unwrap_or(MIDDLE) / MIDDLE).log(axes.base)
}

fn place(row: &PresetRow, axes: &Axes) -> (f64, f64) {
    (across(row, axes), row.value.max(axes.lowest).log10())
}

fn line(points: &[&PresetRow], form: &str, key: &Key, axes: &Axes) -> [Plot; 2] {
    let places = points.iter().map(|row| place(row, axes));
    let tooltip = |row: &&PresetRow| {
        let input = row.input.map_or_else(String::new, |input| input.to_string());
        format!("{form}\n{} {input}\n{} {}", axes.input, axes.measure, shown(row.value))
    };
    let line = LinePlot::new().with_data(places.clone()).with_color(key.colour(form)).with_stroke_width(1.6);
    let marks = ScatterPlot::new()
        .with_data(places)
        .with_marker(key.shape(form))
        .with_color(key.colour(form))
        .with_size(5.0)
        .with_tooltip_labels(points.iter().map(tooltip))
        .with_tooltips();
    [Plot::Line(line), Plot::Scatter(marks)]
}

fn layout(rows: &[&PresetRow], forms: &[String], key: &Key, axes: &Axes) -> Layout {
    let inputs = rows.iter().map(|row| across(row, axes));
    let left = inputs.clone().fold(f64::INFINITY, f64::min) - 0.2;
    let right = inputs.fold(f64::NEG_INFINITY, f64::max) + 0.2;
    let lowest = axes.lowest.log10();
    let highest = rows.iter().map(|row| place(row, axes).1).fold(lowest + 1.0, f64::max).ceil();
    let base = axes.base;
    let entry = |form: &String| LegendEntry {
        label: form.clone(),
        color: key.colour(form).to_owned(),
        shape: LegendShape::Marker(key.shape(form)),
        dasharray: None,
    };
    let layout = Layout::new((left, right), (lowest, highest))
        .with_width(ALONE.0)
        .with_height(ALONE.1 - 200.0)
        .with_title(axes.title)
        .with_x_label(axes.input)
        .with_y_label(axes.measure)
        .with_x_axis_min(left)
        .with_x_axis_max(right)
        .with_x_tick_step(1.0)
        .with_x_tick_format(panel::custom(move |x| number::two_digits(MIDDLE * base.powf(x)).to_string()))
        .with_y_axis_min(lowest)
        .with_y_axis_max(highest)
        .with_y_tick_step(1.0)
        .with_y_tick_format(panel::powers_up_to(highest))
        .with_legend_group("Form", forms.iter().map(entry).collect())
        .with_legend_width(LEGEND);
    panel::dressed(layout)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_and_infinity_have_no_place_outside() {
        let axes = Axes { title: "Title", input: "roughness", measure: "off", base: 2.0, lowest: 0.01 };
        let points = [(0.1, 0.0), (0.2, 10.0), (0.4, f64::INFINITY)];
        let rows = points.map(|(input, value)| PresetRow::point("a < b", "off", input, value));
        assert_eq!(place(&rows[0], &axes), (0.0, -2.0));
        assert_eq!(place(&rows[1], &axes), (1.0, 1.0));
        let svg = against(&rows, &axes);
        assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("a < b"));
        assert!(svg.contains("a &lt; b") && svg.contains("roughness 0.2"));
    }
}
