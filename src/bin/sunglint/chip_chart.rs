//! chips.svg: the direction methods under the Sun on three microcontrollers, one below the other.

use kuva::prelude::{Figure, Layout};

use crate::axis::{Axis, Costs};
use crate::chart::{self, LEGEND, direction_key, legend, under_light};
use crate::direction_panel;
use crate::error_kind::ErrorKind;
use crate::field::Field;
use crate::panel;
use crate::result::{Row, Study};

/// Width and height of a panel with its part of the legend.
const PANEL: (f64, f64) = (920.0, 430.0);

/// The total error of the first light against the instructions on each core, with a part of the legend beside each.
pub fn of_cores(study: &Study) -> String {
    let key = direction_key(study);
    let Some(first) = study.rows.first() else { return chart::nothing() };
    let fields = fields(study, &under_light(study.all_directions(), &first.light));
    let layout = |place: usize| {
        let (title, entries) = legend(&fields[place], &key)[place].clone();
        panel::layout(&fields[place], PANEL).with_legend_group(title, entries).with_legend_width(LEGEND)
    };
    let layouts: Vec<Layout> = (0..fields.len()).map(layout).collect();
    let name = format!("Specular light direction, {}: worst total error against instructions", first.light);
    let mut figure = Figure::new(fields.len(), 1).with_title(name.clone()).with_title_size(17).with_padding(14.0);
    for (place, field) in fields.iter().enumerate() {
        let plots = panel::plots(field, &key, &layouts[place]);
        figure = figure.with_twin_y_plots(place, plots, Vec::new()).with_row_height(place, PANEL.1);
    }
    chart::svg(figure.with_layouts(layouts).with_col_width(0, PANEL.0).render(), &name)
}

/// A panel for each core. All have the same axes, so that the eye can go down from core to core.
fn fields(study: &Study, rows: &[&Row]) -> [Field; 3] {
    let [_, cores @ ..] = Axis::ALL;
    let fields = cores.map(|axis| {
        let field = direction_panel::field(rows, &study.anchors, ErrorKind::Total, Costs { axis, chip: &study.chip });
        Field { title: format!("Cortex-{}", axis.name()), ..field }
    });
    let low = fields.iter().map(|field| field.frame.x.0).fold(f64::INFINITY, f64::min);
    let high = fields.iter().map(|field| field.frame.x.1).fold(f64::NEG_INFINITY, f64::max);
    fields.map(|field| Field { frame: field.frame.with_costs((low, high)), ..field })
}
