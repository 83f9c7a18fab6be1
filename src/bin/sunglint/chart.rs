//! The charts as SVG text.

use kuva::plot::{LegendEntry, LegendShape};
use kuva::prelude::{Figure, Layout, MarkerShape, SvgBackend, render_twin_y};
use kuva::render::render::{Primitive, Scene};

use crate::error_kind::ErrorKind;
use crate::key::Key;
use crate::panel::{self, INK, RADIUS, RADIUS_DASHES, STEP};
use crate::result::{Row, Study};

const LEGEND: f64 = 125.0;
const PANEL: (f64, f64) = (600.0, 640.0);
const BESIDE_LEGEND: (f64, f64) = (PANEL.0 + LEGEND, PANEL.1);
const ALONE: (f64, f64) = (900.0, 620.0);

/// chart.svg: both errors of the first light side by side.
pub fn both_errors(study: &Study) -> String {
    let key = Key::new(&study.rows);
    let Some(first) = study.rows.first() else {
        return svg(Scene::new(PANEL.0, PANEL.1), "No measurements");
    };
    let rows = under_light(&study.rows, &first.light);
    let left = panel::layout(&rows, ErrorKind::Arithmetic, PANEL);
    let right = with_legend(panel::layout(&rows, ErrorKind::Total, BESIDE_LEGEND), &key);
    let name = title(&first.light);
    let scene = Figure::new(1, 2)
        .with_title(name.clone())
        .with_title_size(19)
        .with_padding(16.0)
        .with_twin_y_plots(0, panel::plots(&rows, ErrorKind::Arithmetic, &key, &left), Vec::new())
        .with_twin_y_plots(1, panel::plots(&rows, ErrorKind::Total, &key, &right), Vec::new())
        .with_layouts(vec![left, right])
        .with_row_height(0, PANEL.1)
        .with_col_width(0, PANEL.0)
        .with_col_width(1, BESIDE_LEGEND.0)
        .render();
    svg(scene, &name)
}

/// One error of one light, for the page.
pub fn one_error(rows: &[&Row], kind: ErrorKind, key: &Key) -> String {
    let light = rows.first().map_or("", |row| row.light.as_str());
    let layout = with_legend(panel::layout(rows, kind, ALONE), key);
    let scene = render_twin_y(panel::plots(rows, kind, key, &layout), Vec::new(), layout);
    svg(scene, &format!("{}: {} error", title(light), kind.name()))
}

/// The rows of one light.
pub fn under_light<'a>(rows: &'a [Row], light: &str) -> Vec<&'a Row> {
    rows.iter().filter(|row| row.light == light).collect()
}

fn title(light: &str) -> String {
    format!("Specular light direction, {light}: error against cost")
}

/// The legend to the right of a panel: shapes, colours, and the rest.
fn with_legend(layout: Layout, key: &Key) -> Layout {
    let entry = |label: &str, color: &str, shape| LegendEntry {
        label: label.to_owned(),
        color: color.to_owned(),
        shape,
        dasharray: None,
    };
    let method = |name: &String| entry(name, INK, LegendShape::Marker(key.shape(name)));
    let format = |name: &String| entry(name, key.colour(name), LegendShape::Marker(MarkerShape::Hexagon));
    let rest = vec![
        entry("frontier", STEP, LegendShape::Line),
        entry("hollow: fails", INK, LegendShape::Marker(MarkerShape::Cross)),
        LegendEntry {
            dasharray: Some(RADIUS_DASHES.to_owned()),
            ..entry("100 % of radius", RADIUS, LegendShape::Line)
        },
    ];
    layout
        .with_legend_group("Shape: method", key.methods.iter().map(method).collect())
        .with_legend_group("Colour: format", key.formats.iter().map(format).collect())
        .with_legend_group("Signs", rest)
        .with_legend_width(LEGEND)
}

/// Text of `scene` with a name for screen readers, able to grow and shrink.
fn svg(mut scene: Scene, name: &str) -> String {
    unclip(&mut scene);
    let (width, height) = (scene.width.ceil(), scene.height.ceil());
    let opening =
        format!("<svg role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {width} {height}\" ", crate::page::escape(name));
    SvgBackend.render_scene(&scene).replacen("<svg ", &opening, 1)
}

/// Takes away the clipping, which cuts labels at the edges and whose identifiers count up over the
/// life of the process, so that equal charts would differ.
fn unclip(scene: &mut Scene) {
    let clips = |p: &Primitive| matches!(p, Primitive::ClipStart { .. } | Primitive::ClipEnd);
    scene.elements.retain(|primitive| !clips(primitive));
    scene.defs.clear();
}
