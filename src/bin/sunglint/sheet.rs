//! The pixels of a panel: where its marks and lines end up, and back from there to the values.

use kuva::prelude::Layout;
use kuva::render::layout::ComputedLayout;

use crate::frame::Frame;
use crate::labels::Area;

/// The pixels of a panel and the values that they stand for.
pub struct Sheet {
    /// Where the marks stand, in pixels.
    pub area: Area,
    x: (f64, f64),
    y: (f64, f64),
}

impl Sheet {
    /// Pixels of `frame` as `layout` draws it.
    pub fn new(frame: &Frame, layout: &Layout) -> Self {
        let drawn = ComputedLayout::from_layout(layout);
        let (x, y) = ((frame.x.0, frame.right), (frame.y.0, frame.top));
        let area = Area { x: (drawn.map_x(x.0), drawn.map_x(x.1)), y: (drawn.map_y(y.1), drawn.map_y(y.0)) };
        Self { area, x, y }
    }

    /// Pixels of the values `x` and `y`.
    pub fn pixels(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let down = (self.area.y.1, self.area.y.0);
        (rescaled(x, self.x, self.area.x), rescaled(y, self.y, down))
    }

    /// Values at the pixels `x` and `y`.
    pub fn data(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let down = (self.area.y.1, self.area.y.0);
        (rescaled(x, self.area.x, self.x), rescaled(y, down, self.y))
    }

    /// The flats and the risers of the stairs through `points`.
    pub fn steps(&self, points: &[(f64, f64)]) -> Vec<Area> {
        let corner = |pair: &[(f64, f64)]| [pair[0], (pair[1].0, pair[0].1), pair[1]];
        let corners: Vec<_> = points.windows(2).flat_map(corner).collect();
        let edge = |pair: &[(f64, f64)]| Area::spanned(self.pixels(pair[0]), self.pixels(pair[1]));
        corners.windows(2).map(edge).collect()
    }
}

/// `value` of the range `from`, taken to the range `to`.
fn rescaled(value: f64, from: (f64, f64), to: (f64, f64)) -> f64 {
    to.0 + (value - from.0) / (from.1 - from.0) * (to.1 - to.0)
}
