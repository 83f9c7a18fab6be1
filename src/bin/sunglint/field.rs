//! What a panel shows, whatever it was that was measured.

use crate::axis::Axis;
use crate::frame::Frame;

/// A panel's content.
#[derive(Clone, Debug)]
pub struct Field {
    /// Above the panel.
    pub title: String,
    /// Below the title, smaller.
    pub subtitle: String,
    /// What is called.
    pub call: &'static str,
    /// What its cost is counted in.
    pub axis: Axis,
    /// What the axis of errors says.
    pub error_axis: String,
    /// What the axis on the right says, and the error that is its 100 per cent.
    pub per_cent: Option<(String, f64)>,
    /// The ranges of the axes.
    pub frame: Frame,
    /// What was measured.
    pub points: Vec<Point>,
    /// Errors to compare with.
    pub lines: Vec<Line>,
}

/// A measurement in a panel.
#[derive(Clone, Debug)]
pub struct Point {
    /// What its shape stands for.
    pub method: String,
    /// What its colour stands for.
    pub format: String,
    /// Whether it is somebody else’s, which has no colour.
    pub peer: bool,
    /// What a call costs.
    pub cost: f64,
    /// How high it stands.
    pub error: f64,
    /// Whether it is hollow and crossed out.
    pub fails: bool,
    /// Whether the stairs lead over it.
    pub on_frontier: bool,
    /// What is written beside it; may be empty.
    pub label: String,
    /// What it says when pointed at.
    pub tooltip: String,
}

/// A line across a panel.
#[derive(Clone, Debug)]
pub struct Line {
    /// How high it lies.
    pub error: f64,
    /// What is written at its right end; may be empty.
    pub name: String,
}
