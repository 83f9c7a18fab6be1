//! The README's picture: the frames side by side, a pixel of theirs four of it.

use embedded_graphics::image::GetPixel;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use lcd::display::{SIDE, TURNS};

use crate::frames;

const SCALE: usize = 2;

/// As PNG.
pub fn encoded() -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, (SCALE * SIDE * TURNS.len()) as u32, (SCALE * SIDE) as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().expect("a size that PNG has");
    writer.write_image_data(&strip()).expect("so many bytes");
    writer.finish().expect("memory does not fail");
    file
}

/// Red, green and blue of a PNG's pixels.
pub fn decoded(file: &[u8]) -> Option<Vec<u8>> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().ok()?;
    let mut rgb = vec![0; reader.output_buffer_size()?];
    let read = reader.next_frame(&mut rgb).ok()?;
    (read.color_type == png::ColorType::Rgb).then_some(rgb)
}

/// Red, green and blue, line by line.
pub fn strip() -> Vec<u8> {
    let frames = frames::drawn();
    let (width, height) = (SCALE * SIDE * TURNS.len(), SCALE * SIDE);
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x / SCALE, y / SCALE)));
    let colours = places.map(|(x, y)| frames[x / SIDE].pixel(Point::new((x % SIDE) as i32, y as i32)).unwrap());
    colours.flat_map(|colour| Rgb888::from(colour).to_be_bytes()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const COMMITTED: &[u8] = include_bytes!("../../../ball.png");

    #[test]
    fn the_committed_picture_is_of_these_frames() {
        assert_eq!(decoded(COMMITTED), Some(strip()));
        assert!(COMMITTED.len() < 60_000);
    }

    #[test]
    fn what_is_written_is_what_is_read() {
        assert_eq!(decoded(&encoded()), Some(strip()));
    }
}
