//! What stands fast of each method, without any measurement: its formula, ranges, use and limits.

mod blocks;
mod directions;
mod highlights;

use super::subject::Subject;

/// The fixed text of a page. All of it is HTML.
#[derive(Clone, Copy, Debug)]
pub struct About {
    /// In a line.
    pub what: &'static str,
    /// Lines of the formula.
    pub formula: &'static [&'static str],
    /// What goes in, with units and ranges.
    pub takes: &'static str,
    /// When to take it.
    pub good_for: &'static str,
    /// Name of the public function.
    pub function: &'static str,
    /// A known limit in a sentence; may be empty.
    pub limit: &'static str,
}

impl Subject {
    /// Its fixed text.
    pub fn about(self) -> About {
        match self {
            Self::Direction(method) => directions::about(method),
            Self::Soft => directions::SOFT,
            Self::Highlight(shading) => highlights::about(shading),
            Self::PixelQ14 => highlights::PIXEL_Q14,
            Self::Block(kernel) => blocks::about(kernel),
        }
    }
}
