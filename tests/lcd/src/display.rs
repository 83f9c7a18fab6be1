//! A display as small ST7735 panels have it, and the turns that are drawn on it.

use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU16};

/// Pixels of a side.
pub const SIDE: usize = 128;

/// All of its pixels in RAM.
pub type Frame = Framebuffer<Rgb565, RawU16, LittleEndian, SIDE, SIDE, { buffer_size::<Rgb565>(SIDE, SIDE) }>;

/// Quarters of a day, from an eighth of it on.
pub const TURNS: [u16; 4] = [8192, 24_576, 40_960, 57_344];
