//! A lit pixel by `DiscGgx` in f64.
#![no_std]
#![no_main]

use minimal::shade;
use sunglint::{DistantSphere, SUN};

const TOWARDS_SUN: [f64; 3] = [0.6, 0.0, 0.8];

static SPHERE: DistantSphere<f64> = DistantSphere::<f64>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    shade(TOWARDS_SUN, &SPHERE, [core::f64::consts::PI; 3])
}
