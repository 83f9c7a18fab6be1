//! The chart of whole highlights: relative L1 against roughness, a line for each method.

use kuva::plot::{LegendEntry, LegendShape};
use kuva::prelude::{Layout, LinePlot, Plot, ScatterPlot, render_multiple};

use crate::chart::{self, ALONE};
use crate::key::{Key, in_order};
use crate::mark_groups;
use crate::number;
use crate::panel;
use crate::result::LobeRow;

/// Decimal logarithm of the error under which nothing is shown: the integrals are not much better.
const LOWEST: f64 = -6.0;

/// Where a mirror stands on the axis of widths, beside the least width that there is.
const MIRROR: f64 = -4.0;

const LEGEND: f64 = 140.0;

/// Chart of `rows`, which are all of one light and incidence.
pub fn l1(rows: &[&LobeRow], name: &str) -> String {
    let methods = in_order(rows.iter().map(|row| &row.method));
    let key = Key::new(rows.iter().map(|row| [&row.method, &row.method]));
    let plots = methods.iter().flat_map(|method| {
        let points: Vec<_> =
            rows.iter().filter(|row| row.method == *method).map(|row| (place(row), tooltip(row))).collect();
        line(&points, method, &key)
    });
    chart::svg(render_multiple(plots.collect(), layout(rows, &methods, &key)), name)
}

fn place(row: &LobeRow) -> (f64, f64) {
    let across = if row.alpha > 0.0 { row.alpha.log10() } else { MIRROR };
    (across, row.relative_l1.log10().max(LOWEST))
}

/// A line through all widths but the mirror's, which stands apart, and the marks of all.
fn line(points: &[((f64, f64), String)], method: &str, key: &Key) -> Vec<Plot> {
    let places = points.iter().map(|(place, _)| *place);
    let line = LinePlot::new()
        .with_data(places.clone().filter(|place| place.0 > MIRROR))
        .with_color(key.colour(method))
        .with_stroke_width(1.6);
    let marks = ScatterPlot::new()
        .with_data(places)
        .with_marker(key.shape(method))
        .with_color(key.colour(method))
        .with_size(5.0)
        .with_tooltip_labels(points.iter().map(|(_, tooltip)| mark_groups::title(method, tooltip)))
        .with_tooltips();
    vec![Plot::Line(line), Plot::Scatter(marks)]
}

fn tooltip(row: &LobeRow) -> String {
    format!(
        "{}, alpha {}\nrelative L1 {}, energy {}, peak {}",
        row.method,
        row.alpha,
        number::scientific(row.relative_l1),
        number::scientific(row.energy),
        number::scientific(row.peak)
    )
}

fn layout(rows: &[&LobeRow], methods: &[String], key: &Key) -> Layout {
    let highest = rows.iter().map(|row| row.relative_l1.log10()).fold(0.0, f64::max).ceil();
    let entry = |method: &String| LegendEntry {
        label: method.clone(),
        color: key.colour(method).to_owned(),
        shape: LegendShape::Marker(key.shape(method)),
        dasharray: None,
    };
    let widths =
        panel::custom(|x| if x < MIRROR + 0.5 { "0".to_owned() } else { number::power_of_ten(x.round() as i32) });
    let layout = Layout::new((MIRROR - 0.3, 0.2), (LOWEST, highest))
        .with_width(ALONE.0)
        .with_height(ALONE.1 - 120.0)
        .with_title("Difference of the whole highlight from the integral over the disc")
        .with_subtitle("relative L1 over all viewers")
        .with_x_label("alpha, the GGX width")
        .with_y_label("relative L1")
        .with_x_axis_min(MIRROR - 0.3)
        .with_x_axis_max(0.2)
        .with_x_tick_step(1.0)
        .with_x_tick_format(widths)
        .with_y_axis_min(LOWEST)
        .with_y_axis_max(highest)
        .with_y_tick_step(1.0)
        .with_y_tick_format(panel::powers_up_to(highest))
        .with_legend_group("Method", methods.iter().map(entry).collect())
        .with_legend_width(LEGEND);
    panel::dressed(layout)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn a_mirror_and_an_exact_method_have_a_place() {
        let exact = LobeRow { relative_l1: 0.0, ..sample::lobe("cone_ggx", 0.0) };
        assert_eq!(place(&exact), (MIRROR, LOWEST));
        let svg = l1(&[&exact, &sample::lobe("karis", 0.25)], "name");
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
        assert!(svg.contains("karis, alpha 0.25") && svg.contains("cone_ggx, alpha 0"));
    }
}
