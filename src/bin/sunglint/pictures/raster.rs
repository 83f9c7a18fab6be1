//! A picture as its pixels, with letters on it, and its PNG file.

use std::collections::BTreeSet;

use font8x8::legacy::BASIC_LEGACY;
use png::{BitDepth, ColorType, DeflateCompression, Encoder, Filter};

use super::colour::{Colour, PAPER};

/// Width of a letter, and its height, in pixels.
pub const LETTER: u32 = 8;

/// Pixels in rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// Width and height.
    pub size: [u32; 2],
    pixels: Vec<Colour>,
}

impl Raster {
    /// Nothing but paper.
    pub fn blank(size: [u32; 2]) -> Self {
        Self { size, pixels: vec![PAPER; size[0] as usize * size[1] as usize] }
    }

    /// The pixels of a square in rows from the top.
    pub fn square(side: u32, pixels: Vec<Colour>) -> Self {
        Self { size: [side; 2], pixels }
    }

    /// Whether all pixels but paper pass.
    #[cfg(test)]
    pub fn all(&self, test: impl Fn(Colour) -> bool) -> bool {
        self.pixels.iter().all(|&colour| colour == PAPER || test(colour))
    }

    /// Colours a pixel; nothing beyond the edge.
    fn set(&mut self, x: u32, y: u32, colour: Colour) {
        if x < self.size[0] && y < self.size[1] {
            self.pixels[y as usize * self.size[0] as usize + x as usize] = colour;
        }
    }

    /// Fills a rectangle.
    pub fn fill(&mut self, [x, y]: [u32; 2], [width, height]: [u32; 2], colour: Colour) {
        for row in y..y + height {
            (x..x + width).for_each(|column| self.set(column, row, colour));
        }
    }

    /// Lays another picture on this one.
    pub fn lay(&mut self, [x, y]: [u32; 2], other: &Self) {
        for (row, line) in (y..).zip(other.pixels.chunks(other.size[0].max(1) as usize)) {
            (x..).zip(line).for_each(|(column, &colour)| self.set(column, row, colour));
        }
    }

    /// Writes ASCII, each letter `LETTER` wide; other characters are left out.
    pub fn write(&mut self, [x, y]: [u32; 2], text: &str, colour: Colour) {
        let letters = text.chars().filter_map(|letter| BASIC_LEGACY.get(letter as usize));
        for (left, rows) in (x..).step_by(LETTER as usize).zip(letters) {
            for (row, bits) in (y..).zip(rows) {
                let lit = (0..LETTER).filter(|column| bits >> column & 1 == 1);
                lit.for_each(|column| self.set(left + column, row, colour));
            }
        }
    }

    /// The PNG file, with a palette where 256 colours are enough.
    pub fn png(&self) -> Vec<u8> {
        let colours: BTreeSet<_> = self.pixels.iter().copied().collect();
        let palette: Vec<_> = colours.into_iter().collect();
        let indexed = palette.len() <= 256;
        let data: Vec<u8> = if indexed {
            // Every colour is in the palette, which is sorted.
            self.pixels.iter().map(|colour| palette.binary_search(colour).unwrap_or(0) as u8).collect()
        } else {
            self.pixels.concat()
        };
        let mut file = Vec::new();
        let mut encoder = Encoder::new(&mut file, self.size[0], self.size[1]);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_color(if indexed { ColorType::Indexed } else { ColorType::Rgb });
        if indexed {
            encoder.set_palette(palette.concat());
        }
        encoder.set_deflate_compression(DeflateCompression::Level(9));
        // Noise and flat colours gain nothing by differences.
        encoder.set_filter(Filter::NoFilter);
        encoder
            .write_header()
            .and_then(|mut writer| writer.write_image_data(&data))
            .expect("writing to memory does not fail, and the data are as long as the size says");
        file
    }
}

/// Size and pixels of a PNG file.
#[cfg(test)]
pub fn decoded(file: &[u8]) -> (png::OutputInfo, Vec<u8>) {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("a PNG");
    let mut data = vec![0; reader.output_buffer_size().expect("it fits")];
    let info = reader.next_frame(&mut data).expect("a picture");
    (info, data)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::colour::INK;

    #[test]
    fn a_png_has_the_pixels_with_few_colours_and_with_many() {
        let few = Raster::square(2, vec![[1, 2, 3], [4, 5, 6], [1, 2, 3], [255, 0, 255]]);
        let many = Raster::square(20, (0..400).map(|index| [(index / 2) as u8, index as u8, 7]).collect());
        for raster in [few, many] {
            let (info, data) = decoded(&raster.png());
            assert_eq!([info.width, info.height], raster.size);
            assert_eq!(data, raster.pixels.concat());
        }
    }

    #[test]
    fn letters_are_drawn_and_cut_at_the_edge() {
        let mut raster = Raster::blank([12, 8]);
        raster.write([0, 0], "II", INK);
        let inked = raster.pixels.iter().filter(|&&colour| colour == INK).count();
        assert!((20..60).contains(&inked), "{inked}");
        raster.write([11, 7], "\u{3b1}M", INK);
    }
}
