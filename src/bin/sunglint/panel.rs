//! One panel of a chart: error against cost of every method and format under one light.
//!
//! A panel is built with its size, since the labels are placed by the pixel.

use std::sync::Arc;

use kuva::prelude::{AxisLine, Layout, LinePlot, Plot, ReferenceLine, ShadedRegion, Theme, TickFormat};

use crate::error_kind::ErrorKind;
use crate::frame::Frame;
use crate::key::Key;
use crate::labels::Mark;
use crate::lettering;
use crate::marks;
use crate::number;
use crate::result::Row;
use crate::sheet::Sheet;

/// Colour of text and axes.
pub const INK: &str = "#1b1b1b";
/// Colour of the background, and of the inside of the hollow marks of failures.
pub const PAPER: &str = "#ffffff";
/// Colour of the frontier.
pub const STEP: &str = "#7a7a7a";
const GRID: &str = "#e6e6e6";
/// Colour of the line at the angular radius.
pub const RADIUS: &str = "#a06a00";

/// Dashes of the line at the angular radius.
pub const RADIUS_DASHES: &str = "5 3";
const STRIP: &str = "#999999";

/// What is drawn on `layout`, from the back to the front.
pub fn plots(rows: &[&Row], kind: ErrorKind, key: &Key, layout: &Layout) -> Vec<Plot> {
    let frame = Frame::new(rows);
    let sheet = Sheet::new(&frame, layout);
    let places: Vec<_> = rows.iter().map(|row| place(row, kind, &frame)).collect();
    let pixels: Vec<_> = places.iter().map(|place| sheet.pixels(*place)).collect();
    let stairs = frontier(rows, kind, &frame);

    let mut plots = vec![Plot::Line(staircase(&stairs))];
    let sizes = marks::sizes(&pixels);
    for ((row, place), size) in rows.iter().zip(places).zip(sizes) {
        let marks = marks::of(row, kind, key, place, size);
        plots.extend(marks.into_iter().map(Plot::Scatter));
    }
    let named = |(row, at): (&&Row, (f64, f64))| Mark { at, name: marks::label(row, kind) };
    let named: Vec<_> = rows.iter().zip(pixels).map(named).collect();
    let mut taken = sheet.steps(&stairs);
    taken.push(sheet.line_label(&frame));
    plots.extend(lettering::plots(&named, &taken, &sheet));
    plots
}

/// Title, axes and lines of the panel.
pub fn layout(rows: &[&Row], kind: ErrorKind, (width, height): (f64, f64)) -> Layout {
    let frame = Frame::new(rows);
    scales(&frame)
        .with_width(width)
        .with_height(height)
        .with_title(format!("Worst {} error", kind.name()))
        .with_subtitle(kind.against())
        .with_x_label("time of a call, in calls of f32 factored")
        .with_y_label("error in radians")
        .with_y2_label("error in % of the light's angular radius")
        .with_shaded_region(ShadedRegion::horizontal(frame.y.1, frame.top()).with_color(STRIP))
        .with_reference_line(radius_line(&frame))
        .with_theme(theme())
        .with_axis_line(AxisLine::Box)
        .with_title_size(15)
        .with_subtitle_size(12)
        .with_label_size(12)
        .with_tick_size(11)
        .with_body_size(11)
        .with_legend_box(false)
}

/// The three axes: the right one is the left one in per cent of the angular radius.
fn scales(frame: &Frame) -> Layout {
    let in_percent = 2.0 - frame.radius;
    let (low, high) = (frame.y.0 + in_percent, frame.top() + in_percent);
    let powers = high - low;
    Layout::new(frame.x, (frame.y.0, frame.top()))
        .with_x_axis_min(frame.x.0)
        .with_x_axis_max(frame.x.1)
        .with_x_tick_step(tick_step(frame.x.1 - frame.x.0))
        .with_x_tick_format(custom(|x| number::power_of_two(x.round() as i32)))
        .with_y_axis_min(frame.y.0)
        .with_y_axis_max(frame.top())
        .with_y_tick_step(tick_step(powers))
        .with_y_tick_format(powers_up_to(frame.y.1))
        .with_y2_range(low, high)
        .with_y2_axis_min(low)
        .with_y2_axis_max(high)
        .with_y2_tick_format(powers_up_to(frame.y.1 + in_percent))
        .with_ticks((powers / tick_step(powers)).round() as usize)
}

/// A tick at each power, or at each second one where they would crowd.
fn tick_step(powers: f64) -> f64 {
    if powers > 10.0 { 2.0 } else { 1.0 }
}

/// Writes whole powers of ten, none of them in the strip above `highest`.
fn powers_up_to(highest: f64) -> TickFormat {
    custom(move |y| {
        let whole = (y - y.round()).abs() < 1e-6 && y < highest + 1e-6;
        if whole { number::power_of_ten(y.round() as i32) } else { String::new() }
    })
}

fn custom(write: impl Fn(f64) -> String + Send + Sync + 'static) -> TickFormat {
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

fn radius_line(frame: &Frame) -> ReferenceLine {
    ReferenceLine::horizontal(frame.radius).with_color(RADIUS).with_dasharray(RADIUS_DASHES)
}

/// Corners from the top edge over the rows on the frontier to the right edge.
fn frontier(rows: &[&Row], kind: ErrorKind, frame: &Frame) -> Vec<(f64, f64)> {
    let best = rows.iter().filter(|row| kind.on_frontier(row));
    let mut points: Vec<_> = best.map(|row| place(row, kind, frame)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    if let (Some(&first), Some(&last)) = (points.first(), points.last()) {
        points.insert(0, (first.0, frame.y.1));
        points.push((frame.x.1, last.1));
    }
    points
}

fn staircase(corners: &[(f64, f64)]) -> LinePlot {
    LinePlot::new().with_data(corners.iter().copied()).with_step().with_color(STEP).with_stroke_width(1.8)
}

fn place(row: &Row, kind: ErrorKind, frame: &Frame) -> (f64, f64) {
    (frame.across(row.cost), frame.up(kind.worst(row)))
}
