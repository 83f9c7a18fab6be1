//! The ball: light for every pixel of a sphere, drawn on any display.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use sunglint::raw::{PixelQ14, normalize_q14, reciprocal_root_q16};

use crate::planet::{ground, wave};

/// The pixel at `x` and `y`, of which the ball fills -16384 to 16384, turned by an angle of this cosine and sine.
pub fn colour(lit: &[PixelQ14; 4], [x, y]: [i32; 2], [cos, sin]: [i32; 2]) -> Rgb565 {
    let square = ((1 << 28) - 1 - x * x - y * y) >> 12;
    if square <= 0 {
        return Rgb565::BLACK;
    }
    let z = ((square as u32 * reciprocal_root_q16(square as u32)) >> 18) as i32;
    let [east, north] = [(15 * x - 6 * y) >> 4, (6 * x + 15 * y) >> 4]; // the axis leans
    let place = [(east * cos + z * sin) >> 14, north, (z * cos - east * sin) >> 14];
    let [r, g, b] = lit[ground(place)].shade([x as i16, y as i16, z as i16], [0, 0, 16_384]);
    // The Sun is at (-2, 1, 2) / 3, as in planet.rs.
    let air = (((y - 2 * x + 2 * z + 4000).max(0) >> 8) * ((16_384 - z).pow(2) >> 14)) as u32;
    let [r, g, b] = [(r, air >> 7), (g, air >> 6), (b, air >> 5)].map(|(ground, air)| {
        let level = ground.min(1 << 22) + air;
        level * reciprocal_root_q16(level + (level >> 8).pow(2)) // sqrt(x / (1 + x)), in Q32
    });
    Rgb565::new((r >> 27) as u8, (g >> 26) as u8, (b >> 27) as u8)
}

/// Draws the ball in the middle of any display, pixel by pixel and without a buffer; a day is 65536 of `turn`.
pub fn draw<D: DrawTarget<Color = Rgb565>>(display: &mut D, lit: &[PixelQ14; 4], turn: u16) -> Result<(), D::Error> {
    let bounds = display.bounding_box();
    let size = bounds.size.width.min(bounds.size.height);
    let area = Rectangle::with_center(bounds.center(), Size::new_equal(size));
    let (step, middle) = (17_000 / size.max(1) as i32, Point::new_equal(size as i32 - 1));
    let [cos, sin] = [i32::from(turn) + 16_384, turn.into()].map(|turn| wave(turn) as i16);
    let [cos, _, sin] = normalize_q14([cos, 0, sin]).map(i32::from);
    let colours = area.points().map(|point| {
        let Point { x, y } = (point - area.top_left) * 2 - middle;
        colour(lit, [x * step, -y * step], [cos, sin])
    });
    display.fill_contiguous(&area, colours)
}
