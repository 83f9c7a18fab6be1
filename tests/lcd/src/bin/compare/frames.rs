//! The frames as the host draws them, and what differs.

use lcd::display::{Frame, SIDE, TURNS};
use lcd::{ball, planet};

/// All frames, as the firmware writes them.
pub fn host() -> Vec<u8> {
    drawn().iter().flat_map(|frame| *frame.data()).collect()
}

/// One frame for each turn.
pub fn drawn() -> [Frame; TURNS.len()] {
    let lit = planet::lit().expect("materials and the Sun are in range");
    TURNS.map(|turn| {
        let mut frame = Frame::new();
        let Ok(()) = ball::draw(&mut frame, &lit, turn);
        frame
    })
}

/// Where and how often two files of frames differ, if they do.
pub fn difference(found: &[u8], expected: &[u8]) -> Option<String> {
    if found.len() != expected.len() {
        return Some(format!("{} bytes of frames in place of {}", found.len(), expected.len()));
    }
    let pixels = found.chunks(2).zip(expected.chunks(2)).enumerate();
    let differ: Vec<usize> = pixels.filter(|(_, (a, b))| a != b).map(|(index, _)| index).collect();
    let first = *differ.first()?;
    let (frame, x, y) = (first / (SIDE * SIDE), first % SIDE, first / SIDE % SIDE);
    Some(format!("{} pixels differ, the first in frame {frame} at {x}, {y}", differ.len()))
}

#[cfg(test)]
mod tests {
    use core::convert::Infallible;

    use embedded_graphics::image::GetPixel;
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::Rgb565;
    use embedded_graphics::prelude::*;
    use lcd::float::{self, ByHand, ByScene, Lit};

    use super::*;

    #[test]
    fn one_bit_of_one_pixel_is_told() {
        let expected = host();
        assert_eq!(difference(&expected, &expected), None);
        let mut planted = expected.clone();
        planted[2 * (SIDE * SIDE + 70 * SIDE + 50)] ^= 1;
        assert_eq!(difference(&planted, &expected).unwrap(), "1 pixels differ, the first in frame 1 at 50, 70");
        assert!(difference(&expected[2..], &expected).is_some());
    }

    /// Overflow would panic here.
    #[test]
    fn any_turn_can_be_drawn() {
        let lit = planet::lit().unwrap();
        let mut frame = Frame::new();
        for turn in (0..=u16::MAX).step_by(771) {
            let Ok(()) = ball::draw(&mut frame, &lit, turn);
        }
    }

    /// Nor here: of an odd size the middle pixel faces the viewer.
    #[test]
    fn any_size_can_be_drawn() {
        let lit = planet::lit().unwrap();
        let sides = (0..150).map(|side| Size::new(side, side + side % 3));
        for size in sides.chain([(160, 128), (135, 240), (480, 320), (20_000, 1)].map(|(x, y)| Size::new(x, y))) {
            let Ok(()) = ball::draw(&mut Nowhere(size), &lit, 8192);
        }
    }

    /// A display of any size.
    struct Nowhere(Size);

    impl OriginDimensions for Nowhere {
        fn size(&self) -> Size {
            self.0
        }
    }

    impl DrawTarget for Nowhere {
        type Color = Rgb565;
        type Error = Infallible;

        fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
            let drawn = pixels.into_iter().count();
            assert_eq!(drawn, self.0.width.min(self.0.height).pow(2) as usize);
            Ok(())
        }
    }

    #[test]
    fn the_middle_of_a_display_that_is_no_square_is_drawn_on() {
        let mut display = MockDisplay::<Rgb565>::new();
        let wide = embedded_graphics::primitives::Rectangle::new(Point::new(3, 5), Size::new(40, 20));
        ball::draw(&mut display.cropped(&wide), &planet::lit().unwrap(), 0).unwrap();
        let area = display.affected_area();
        assert_eq!((area.top_left, area.size), (Point::new(13, 5), Size::new(20, 20)));
    }

    #[test]
    fn there_are_sea_wood_sand_ice_night_and_a_glint() {
        for frame in drawn() {
            let colours: Vec<Rgb565> = frame.bounding_box().points().filter_map(|point| frame.pixel(point)).collect();
            let count = |is: fn(&Rgb565) -> bool| colours.iter().filter(|colour| is(colour)).count();
            assert!(count(|c| c.b() > c.g() / 2 && c.b() > c.r() + 4) > 2000, "sea");
            assert!(count(|c| c.g() / 2 > c.r() && c.g() / 2 > c.b() + 1) > 300, "wood");
            assert!(count(|c| c.r() > c.b() + 3) > 300, "sand");
            assert!(count(|c| c.r() > 20 && c.b() > 20) > 50, "ice or glint");
            assert!(count(|c| *c == Rgb565::BLACK) > 4000, "night and space");
        }
    }

    /// The balls that are counted are the same ball.
    #[test]
    fn f32_draws_the_same_within_a_step() {
        like_in_integers::<ByScene>();
        like_in_integers::<ByHand>();
    }

    fn like_in_integers<L: Lit>() {
        let lit = float::lit::<L>().unwrap();
        let mut differ = 0;
        for (expected, turn) in drawn().iter().zip(TURNS) {
            let mut frame = Frame::new();
            let Ok(()) = float::draw(&mut frame, &lit, turn);
            let apart = |point: &Point| {
                let [a, b] = [&frame, expected].map(|frame| frame.pixel(*point).unwrap());
                let steps = [a.r().abs_diff(b.r()), a.g().abs_diff(b.g()), a.b().abs_diff(b.b())];
                steps.into_iter().max() > Some(1)
            };
            differ += frame.bounding_box().points().filter(apart).count();
        }
        // Where sea and land meet, and at the ball's edge, a last place decides.
        assert!(differ < 4 * SIDE * SIDE / 1000, "{differ} pixels");
    }
}
