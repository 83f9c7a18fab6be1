//! A lit pixel by `PixelQ14`.
#![no_std]
#![no_main]

use minimal::{SEA, end, run};
use sunglint::material::Surface;
use sunglint::raw::{PixelQ14, SUN_Q14};

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    match PixelQ14::new([9830, 0, 13107], &SUN_Q14, &Surface::of(&SEA), [205_887; 3]) {
        Ok(pixel) => run(|n, v, _| pixel.shade(n, v)),
        Err(_) => end(),
    }
}
