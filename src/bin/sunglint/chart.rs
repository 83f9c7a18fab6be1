//! The charts as SVG text.

use kuva::plot::{LegendEntry, LegendShape};
use kuva::prelude::{Figure, Layout, MarkerShape, SvgBackend, render_multiple, render_twin_y};
use kuva::render::render::{Primitive, Scene};

use crate::axis::{Axis, Costs};
use crate::direction_panel;
use crate::error_kind::ErrorKind;
use crate::field::{Field, Sort};
use crate::key::Key;
use crate::lines;
use crate::mark_groups;
use crate::panel::{self, INK, PEER, STEP};
use crate::pixel_error::PixelError;
use crate::pixel_panel;
use crate::result::{Bound, PixelRow, Row, Study};
use crate::short_numbers;

/// Width of a legend, in pixels.
pub const LEGEND: f64 = 125.0;
const PANEL: (f64, f64) = (600.0, 640.0);
const BESIDE_LEGEND: (f64, f64) = (PANEL.0 + LEGEND, PANEL.1);
/// A panel that has a figure to itself.
pub const ALONE: (f64, f64) = (900.0, 620.0);

/// chart.svg: both errors of the first light side by side.
pub fn both_errors(study: &Study) -> String {
    let key = direction_key(study);
    let Some(first) = study.rows.first() else { return nothing() };
    let rows = under_light(study.all_directions(), &first.light);
    let [left, right] = ErrorKind::ALL.map(|kind| direction_panel::field(&rows, &study.anchors, kind, on_host(study)));
    let name = direction_title(&first.light, Axis::Host);
    let layouts = [panel::layout(&left, PANEL), with_legend(panel::layout(&right, BESIDE_LEGEND), &right, &key)];
    let scene = Figure::new(1, 2)
        .with_title(name.clone())
        .with_title_size(19)
        .with_padding(16.0)
        .with_twin_y_plots(0, panel::plots(&left, &key, &layouts[0]), Vec::new())
        .with_twin_y_plots(1, panel::plots(&right, &key, &layouts[1]), Vec::new())
        .with_layouts(layouts.into())
        .with_row_height(0, PANEL.1)
        .with_col_width(0, PANEL.0)
        .with_col_width(1, BESIDE_LEGEND.0)
        .render();
    svg(scene, &name)
}

/// pixels.svg: the total error of the first case's lit pixels.
pub fn first_pixels(study: &Study) -> String {
    let Some(first) = study.pixels.first() else { return nothing() };
    let error = PixelError::default();
    let mut field =
        pixel_panel::field(&of_case(study.all_pixels(), &first.case), &study.anchors, error, on_host(study));
    field.title = format!("{}: {}", first.case, field.title);
    one_panel(&field, &pixel_key(study), &pixel_title(&first.case, error, Axis::Host))
}

fn on_host(study: &Study) -> Costs<'_> {
    Costs { axis: Axis::Host, chip: &study.chip }
}

/// A chart of a study that has nothing to show.
pub fn nothing() -> String {
    svg(Scene::new(PANEL.0, PANEL.1), "No measurements")
}

/// One panel with its legend, under a name for screen readers.
pub fn one_panel(field: &Field, key: &Key, name: &str) -> String {
    let layout = with_legend(panel::layout(field, ALONE), field, key);
    svg(scene(field, key, layout), name)
}

/// A panel of the size `size` that explains itself.
pub fn small_panel(field: &Field, key: &Key, size: (f64, f64), name: &str) -> String {
    svg(scene(field, key, panel::layout(field, size)), name)
}

fn scene(field: &Field, key: &Key, layout: Layout) -> Scene {
    let plots = panel::plots(field, key, &layout);
    match field.per_cent {
        Some(_) => render_twin_y(plots, Vec::new(), layout),
        None => render_multiple(plots, layout),
    }
}

/// The rows of one light.
pub fn under_light<'a>(rows: impl IntoIterator<Item = &'a Row>, light: &str) -> Vec<&'a Row> {
    rows.into_iter().filter(|row| row.light == light).collect()
}

/// The rows of one case.
pub fn of_case<'a>(rows: impl IntoIterator<Item = &'a PixelRow>, case: &str) -> Vec<&'a PixelRow> {
    rows.into_iter().filter(|row| row.case == case).collect()
}

/// Shapes and colours of the directions.
pub fn direction_key(study: &Study) -> Key {
    Key::new(study.rows.iter().map(|row| [&row.method, &row.format]))
}

/// Shapes and colours of the lit pixels.
pub fn pixel_key(study: &Study) -> Key {
    Key::new(study.pixels.iter().map(|row| [&row.method, &row.format]))
}

/// What the charts of a light show.
pub fn direction_title(light: &str, axis: Axis) -> String {
    format!("Specular light direction, {light}: error against {}", axis.against())
}

/// What the chart of a case shows.
pub fn pixel_title(case: &str, error: PixelError, axis: Axis) -> String {
    let PixelError { kind, mean } = error;
    format!("Lit pixel, {case}: {} of the {} against {}", mean.name(), kind.said(), axis.against())
}

/// The legend to the right of a panel: shapes, colours, and the rest.
fn with_legend(layout: Layout, field: &Field, key: &Key) -> Layout {
    let groups = legend(field, key);
    let add = |layout: Layout, (title, entries): (&str, Vec<LegendEntry>)| layout.with_legend_group(title, entries);
    groups.into_iter().fold(layout, add).with_legend_width(LEGEND)
}

/// The three parts of a legend, each under its title.
pub fn legend(field: &Field, key: &Key) -> [(&'static str, Vec<LegendEntry>); 3] {
    let entry = |label: &str, color: &str, shape| LegendEntry {
        label: label.to_owned(),
        color: color.to_owned(),
        shape,
        dasharray: None,
    };
    let method = |name: &String| entry(name, INK, LegendShape::Marker(key.shape(name)));
    let format = |name: &String| entry(name, key.colour(name), LegendShape::Marker(MarkerShape::Hexagon));
    let mut rest = vec![
        entry("frontier", STEP, LegendShape::Line),
        entry("hollow: fails", INK, LegendShape::Marker(MarkerShape::Cross)),
    ];
    if field.points.iter().any(|point| point.peer) {
        rest.push(entry("grey: a peer", PEER, LegendShape::Marker(MarkerShape::Hexagon)));
    }
    if !field.anchors.is_empty() {
        rest.push(entry("small: ideal", INK, LegendShape::CircleSize(3.5)));
    }
    rest.extend(line_entries(field));
    rest.extend(bound_entries(field).into_iter().map(|(name, shape)| entry(name, INK, shape)));
    [
        ("Shape: method", key.methods.iter().map(method).collect()),
        ("Colour: format", key.formats.iter().map(format).collect()),
        ("Signs", rest),
    ]
}

/// An entry for each sort of line that there is.
fn line_entries(field: &Field) -> impl Iterator<Item = LegendEntry> {
    let names = [(Sort::Model, "model error"), (Sort::Size, "size"), (Sort::Required, "standard")];
    let shown = names.into_iter().filter(|(sort, _)| field.lines.iter().any(|line| line.sort == *sort));
    shown.map(|(sort, name)| {
        let (colour, dashes) = lines::style(sort);
        let (label, color) = (name.to_owned(), colour.to_owned());
        LegendEntry { label, color, shape: LegendShape::Line, dasharray: Some(dashes.to_owned()) }
    })
}

/// How marks show what their bounds rest on, of those that there are.
fn bound_entries(field: &Field) -> Vec<(&'static str, LegendShape)> {
    let names = [
        (Bound::Exhaustive, ("rim: exhaustive", LegendShape::Circle)),
        (Bound::Searched, ("plain: searched", LegendShape::Circle)),
        (Bound::Sampled, ("dot: sampled", LegendShape::CircleSize(2.0))),
    ];
    let has = |bound: Bound| field.points.iter().any(|point| point.bound == Some(bound));
    names.into_iter().filter(|(bound, _)| has(*bound)).map(|(_, entry)| entry).collect()
}

/// Text of `scene` with a name for screen readers, able to grow and shrink.
pub fn svg(mut scene: Scene, name: &str) -> String {
    unclip(&mut scene);
    mark_groups::join(&mut scene);
    let (width, height) = (scene.width.ceil(), scene.height.ceil());
    let opening =
        format!("<svg role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {width} {height}\" ", crate::page::escape(name));
    short_numbers::rounded(&SvgBackend.render_scene(&scene).replacen("<svg ", &opening, 1))
}

/// Takes away the clipping, which cuts labels at the edges and whose identifiers count up over the
/// life of the process, so that equal charts would differ.
fn unclip(scene: &mut Scene) {
    let clips = |p: &Primitive| matches!(p, Primitive::ClipStart { .. } | Primitive::ClipEnd);
    scene.elements.retain(|primitive| !clips(primitive));
    scene.defs.clear();
}
