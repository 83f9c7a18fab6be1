//! One panel of a chart: error against cost.
//!
//! A panel is built with its size, since the labels are placed by the pixel.

use std::sync::Arc;

use kuva::prelude::{AxisLine, Layout, LinePlot, Plot, ShadedRegion, Theme, TickFormat};

use crate::axis::Axis;
use crate::field::{Anchor, Field, Point};
use crate::frame::Frame;
use crate::key::Key;
use crate::labels::Mark;
use crate::lettering;
use crate::lines;
use crate::marks;
use crate::number;
use crate::sheet::Sheet;
use crate::ticks;

/// Colour of text and axes.
pub const INK: &str = "#1b1b1b";
/// Colour of the background, and of the inside of the hollow marks of failures.
pub const PAPER: &str = "#ffffff";
/// Colour of the frontier.
pub const STEP: &str = "#7a7a7a";
/// Colour of the marks of peers.
pub const PEER: &str = "#9a9a9a";
/// Colour of the lines at the ticks.
pub const GRID: &str = "#e6e6e6";
/// Colour of the rim of a mark whose bound is exhaustive.
pub const RIM: &str = "#1c1c1c";
/// Colour of the lines of model errors.
pub const LINE: &str = "#a06a00";
/// Colour of the lines of sizes.
pub const SIZE: &str = "#8a3c00";
/// Colour of the lines of what standards ask for.
pub const REQUIRED: &str = "#6a4fb0";
/// Dashes of the lines of model errors.
pub const LINE_DASHES: &str = "5 3";

const STRIP: &str = "#999999";

/// What is drawn on `layout`, from the back to the front.
pub fn plots(field: &Field, key: &Key, layout: &Layout) -> Vec<Plot> {
    let frame = &field.frame;
    let sheet = Sheet::new(frame, layout);
    let places: Vec<_> = field.points.iter().map(|point| place(point, frame)).collect();
    let pixels: Vec<_> = places.iter().map(|place| sheet.pixels(*place)).collect();
    let stairs = frontier(field);

    let mut plots = if field.axis == Axis::Host { Vec::new() } else { ticks::plots(field, &sheet) };
    plots.extend(lines::plots(field).chain([Plot::Line(staircase(&stairs))]));
    let anchors: Vec<_> = field.anchors.iter().map(|anchor| anchored(anchor, frame)).collect();
    for (anchor, &place) in field.anchors.iter().zip(&anchors) {
        plots.extend(marks::of_anchor(anchor, key, place).map(Plot::Scatter));
    }
    let sizes = marks::sizes(&pixels);
    for ((point, place), &size) in field.points.iter().zip(places).zip(&sizes) {
        let marks = marks::of(point, key, place, size);
        plots.extend(marks.into_iter().map(Plot::Scatter));
    }
    let named = |((point, at), reach): ((&Point, (f64, f64)), f64)| Mark { at, reach, name: point.label.clone() };
    let unnamed = |&place: &(f64, f64)| Mark { at: sheet.pixels(place), reach: marks::ANCHOR, name: String::new() };
    let named = field.points.iter().zip(pixels).zip(sizes).map(named);
    let named: Vec<_> = named.chain(anchors.iter().map(unnamed)).collect();
    let taken = [sheet.steps(&stairs), lines::areas(field, &sheet)].concat();
    plots.extend(lettering::plots(&named, &taken, &sheet));
    plots.extend(lines::names(field, &sheet));
    plots
}

/// Title, axes and lines of the panel.
pub fn layout(field: &Field, (width, height): (f64, f64)) -> Layout {
    let frame = &field.frame;
    let layout = scales(field)
        .with_width(width)
        .with_height(height)
        .with_title(field.title.clone())
        .with_subtitle(field.subtitle.clone())
        .with_x_label(field.axis.label(field.call))
        .with_y_label(field.error_axis.clone())
        .with_shaded_region(ShadedRegion::horizontal(frame.y.1, frame.top).with_color(STRIP));
    let layout = dressed(layout);
    match &field.per_cent {
        Some((label, _)) => layout.with_y2_label(label.clone()),
        None => layout,
    }
}

/// What all charts have in common: colours, frame and letters.
pub fn dressed(layout: Layout) -> Layout {
    layout
        .with_theme(theme())
        .with_axis_line(AxisLine::Box)
        .with_title_size(15)
        .with_subtitle_size(12)
        .with_label_size(12)
        .with_tick_size(11)
        .with_body_size(11)
        .with_legend_box(false)
}

/// The axes: the right one, if there is one, is the left one in per cent of some error.
fn scales(field: &Field) -> Layout {
    let frame = &field.frame;
    let powers = frame.top - frame.y.0;
    let layout = Layout::new((frame.x.0, frame.right), (frame.y.0, frame.top))
        .with_x_axis_min(frame.x.0)
        .with_x_axis_max(frame.right)
        .with_x_tick_step(tick_step(frame.x.1 - frame.x.0))
        .with_x_tick_format(costs_up_to(frame.x.1, field.axis))
        .with_y_axis_min(frame.y.0)
        .with_y_axis_max(frame.top)
        .with_y_tick_step(tick_step(powers))
        .with_y_tick_format(powers_up_to(frame.y.1))
        .with_ticks((powers / tick_step(powers)).round() as usize);
    let Some((_, whole)) = field.per_cent else { return layout };
    let in_percent = 2.0 - whole.log10();
    let (low, high) = (frame.y.0 + in_percent, frame.top + in_percent);
    layout
        .with_y2_range(low, high)
        .with_y2_axis_min(low)
        .with_y2_axis_max(high)
        .with_y2_tick_format(powers_up_to(frame.y.1 + in_percent))
}

/// A tick at each power, or at each second one where they would crowd.
fn tick_step(powers: f64) -> f64 {
    if powers > 10.0 { 2.0 } else { 1.0 }
}

/// Writes powers of two, none of them in the lane right of `highest`; for instructions nothing, as [`ticks`] does.
fn costs_up_to(highest: f64, axis: Axis) -> TickFormat {
    let writes = move |x: f64| axis == Axis::Host && x < highest + 1e-6;
    custom(move |x| if writes(x) { number::power_of_two(x.round() as i32) } else { String::new() })
}

/// Writes whole powers of ten, none of them in the strip above `highest`.
pub fn powers_up_to(highest: f64) -> TickFormat {
    custom(move |y| {
        let whole = (y - y.round()).abs() < 1e-6 && y < highest + 1e-6;
        if whole { number::power_of_ten(y.round() as i32) } else { String::new() }
    })
}

/// Ticks as `write` writes them.
pub fn custom(write: impl Fn(f64) -> String + Send + Sync + 'static) -> TickFormat {
    TickFormat::Custom(Arc::new(write))
}

fn theme() -> Theme {
    Theme {
        background: PAPER.to_owned(),
        text_color: INK.to_owned(),
        axis_color: INK.to_owned(),
        tick_color: INK.to_owned(),
        grid_color: GRID.to_owned(),
        legend_bg: PAPER.to_owned(),
        ..Theme::light()
    }
}

/// Corners from the top edge over the points on the frontier to the right edge.
fn frontier(field: &Field) -> Vec<(f64, f64)> {
    let frame = &field.frame;
    let best = field.points.iter().filter(|point| point.on_frontier);
    let mut corners: Vec<_> = best.map(|point| place(point, frame)).collect();
    corners.sort_by(|a, b| a.0.total_cmp(&b.0));
    if let (Some(&first), Some(&last)) = (corners.first(), corners.last()) {
        corners.insert(0, (first.0, frame.y.1));
        corners.push((frame.x.1, last.1));
    }
    corners
}

fn staircase(corners: &[(f64, f64)]) -> LinePlot {
    LinePlot::new().with_data(corners.iter().copied()).with_step().with_color(STEP).with_stroke_width(1.8)
}

/// Where an anchor stands: at its cost, or at the left edge.
fn anchored(anchor: &Anchor, frame: &Frame) -> (f64, f64) {
    (anchor.cost.map_or(frame.x.0, |cost| frame.across(cost)), frame.up(anchor.error))
}

fn place(point: &Point, frame: &Frame) -> (f64, f64) {
    (frame.across(point.cost), frame.up(point.error))
}
