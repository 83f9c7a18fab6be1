//! Draws to a panel that has its own memory, colour by colour, for ever: no buffer, and no panic, or it does not link.
#![no_std]
#![no_main]

use core::convert::Infallible;
use core::panic::PanicInfo;

use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use lcd::display::SIDE;
use lcd::{ball, planet};

/// Data register of the board's first SPI, which stands for the panel.
const DATA: *mut u32 = 0x4002_0008 as *mut u32;

#[entry]
fn main() -> ! {
    let mut turn = 0_u16;
    if let Some(lit) = planet::lit() {
        loop {
            let Ok(()) = ball::draw(&mut Panel, &lit, turn);
            turn = turn.wrapping_add(256);
        }
    }
    loop {
        core::hint::spin_loop();
    }
}

struct Panel;

impl OriginDimensions for Panel {
    fn size(&self) -> Size {
        Size::new_equal(SIDE as u32)
    }
}

impl DrawTarget for Panel {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().for_each(|Pixel(_, colour)| send(colour));
        Ok(())
    }

    /// A panel counts its pixels itself once it knows the area.
    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(&mut self, _: &Rectangle, colours: I) -> Result<(), Infallible> {
        colours.into_iter().for_each(send);
        Ok(())
    }
}

fn send(colour: Rgb565) {
    // A device's register; nothing else writes it.
    unsafe { DATA.write_volatile(colour.into_storage().into()) };
}

unsafe extern "C" {
    safe fn there_is_a_panic() -> !;
}

#[panic_handler]
fn panicked(_: &PanicInfo) -> ! {
    there_is_a_panic()
}
