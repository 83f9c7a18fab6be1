//! What a panel shows, whatever it was that was measured.

use crate::axis::Axis;
use crate::frame::Frame;
use crate::result::Bound;

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
    /// The true answers as the formats hold them, at the cost of empty calls.
    pub anchors: Vec<Anchor>,
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
    /// What the bound of its error rests on; of a peer that is not known.
    pub bound: Option<Bound>,
    /// What it says when pointed at.
    pub tooltip: String,
}

/// The true answer rounded into a format, at the cost of an empty call.
#[derive(Clone, Debug)]
pub struct Anchor {
    /// What its colour stands for.
    pub format: String,
    /// What an empty call costs; on a core that is not known, and it stands at the left edge.
    pub cost: Option<f64>,
    /// How high it stands.
    pub error: f64,
    /// What it says when pointed at.
    pub tooltip: String,
}

/// What a line across a panel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// The part of an error that no precision removes.
    Model,
    /// A size to compare with: of the light, or of a step of a display.
    Size,
    /// What a standard of graphics asks for.
    Required,
}

/// A line across a panel.
#[derive(Clone, Debug)]
pub struct Line {
    /// How high it lies.
    pub error: f64,
    /// What is written at its right end.
    pub name: String,
    /// What it is.
    pub sort: Sort,
}
