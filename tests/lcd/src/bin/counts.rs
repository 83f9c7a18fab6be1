//! Prints what the ball costs, a line of CSV for each way: pixels of the ball that were counted, their instructions in
//! the mean and at most, instructions of a frame, bytes of stack.
#![no_std]
#![no_main]

#[path = "../../../firmware/src/counts/counter.rs"]
mod counter;
#[path = "../../../firmware/src/counts/stack.rs"]
mod stack;

use core::cell::RefCell;
use core::mem::transmute;
use core::panic::PanicInfo;

use cortex_m::singleton;
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use embedded_graphics::pixelcolor::Rgb565;
use lcd::display::{Frame, SIDE, TURNS};
use lcd::float::{self, ByHand, ByScene, Lit};
use lcd::{ball, planet};
use sunglint::normalize;
use sunglint::raw::{PixelQ14, normalize_q14};

use counter::{Call, Counter};

#[entry]
fn main() -> ! {
    let counter = Counter::start(cortex_m::Peripherals::take().unwrap().SYST);
    let frame = RefCell::new(singleton!(: Frame = Frame::new()).unwrap());
    in_q14(&counter, &frame);
    in_f32::<ByScene>(&counter, &frame, "f32 Scene");
    in_f32::<ByHand>(&counter, &frame, "f32 by hand");
    end(true)
}

/// What a pixel is made of.
struct Pixel<'a, L, N> {
    lit: &'a [L; 4],
    place: [N; 2],
    turn: [N; 2],
}

/// What a frame is made of.
struct Drawing<'a, L> {
    lit: &'a [L; 4],
    frame: &'a RefCell<&'static mut Frame>,
}

fn in_q14(counter: &Counter, frame: &RefCell<&'static mut Frame>) {
    let lit = &planet::lit().unwrap();
    let [cos, _, sin] = normalize_q14(turned().map(|lane| lane as i16)).map(i32::from);
    let step = 17_000 / SIDE as i32;
    let pixels = places().map(|place| Pixel { lit, place: place.map(|at| at * step), turn: [cos, sin] });
    let colour = |pixel: &Pixel<PixelQ14, i32>| ball::colour(pixel.lit, pixel.place, pixel.turn);
    let draw = |all: &Drawing<PixelQ14>| ball::draw(*all.frame.borrow_mut(), all.lit, TURNS[0]).unwrap();
    print(counter, "I2F14 PixelQ14", pixels, colour, &Drawing { lit, frame }, draw);
}

fn in_f32<L: Lit>(counter: &Counter, frame: &RefCell<&'static mut Frame>, name: &str) {
    let lit = &float::lit::<L>().unwrap();
    let [cos, _, sin] = normalize(turned().map(|lane| lane as f32));
    let step = (17_000 / SIDE as i32) as f32 / 16_384.0;
    let pixels = places().map(|place| Pixel { lit, place: place.map(|at| at as f32 * step), turn: [cos, sin] });
    let colour = |pixel: &Pixel<L, f32>| float::colour(pixel.lit, pixel.place, pixel.turn);
    let draw = |all: &Drawing<L>| float::draw(*all.frame.borrow_mut(), all.lit, TURNS[0]).unwrap();
    print(counter, name, pixels, colour, &Drawing { lit, frame }, draw);
}

/// Cosine and sine of the turn, not of unit length.
fn turned() -> [i32; 3] {
    [planet::wave(i32::from(TURNS[0]) + 16_384), 0, planet::wave(TURNS[0].into())]
}

/// Every fourth pixel of every fourth line that is on the ball, in half pixels from the middle.
fn places() -> impl Iterator<Item = [i32; 2]> {
    let lines = || (1..2 * SIDE as i32).step_by(8).map(|at| at - SIDE as i32);
    let all = lines().flat_map(move |y| lines().map(move |x| [x, y]));
    // 16384 is the radius, of which a half pixel is 17000 over the side.
    all.filter(|[x, y]| (x * x + y * y) * (17_000 / SIDE as i32).pow(2) < 1 << 28)
}

fn print<P, D>(
    counter: &Counter,
    name: &str,
    pixels: impl Iterator<Item = P>,
    colour: fn(&P) -> Rgb565,
    drawing: &D,
    draw: fn(&D),
) {
    // `MaybeUninit<O>` is passed as `O` is.
    let colour = unsafe { transmute::<fn(&P) -> Rgb565, Call<P, Rgb565>>(colour) };
    let draw = unsafe { transmute::<fn(&D), Call<D, ()>>(draw) };
    let (mut count, mut sum, mut worst) = (0, 0, 0);
    for pixel in pixels {
        let instructions = counter.instructions(colour, &pixel);
        (count, sum, worst) = (count + 1, sum + instructions, worst.max(instructions));
    }
    let frame = counter.instructions(draw, drawing);
    let stack = stack::depth(draw, core::slice::from_ref(drawing));
    hprintln!("{},{},{},{},{},{}", name, count, sum / count, worst, frame, stack);
}

#[panic_handler]
fn panicked(info: &PanicInfo) -> ! {
    hprintln!("{}", info);
    end(false)
}

fn end(success: bool) -> ! {
    debug::exit(if success { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        core::hint::spin_loop();
    }
}
