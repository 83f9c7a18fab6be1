//! A lit pixel by `DiscGgx` in f32.
#![no_std]
#![no_main]

use minimal::shade;
use sunglint::{DistantSphere, SUN};

const TOWARDS_SUN: [f32; 3] = [0.6, 0.0, 0.8];

static SPHERE: DistantSphere<f32> = DistantSphere::<f32>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    shade(TOWARDS_SUN, &SPHERE, [core::f32::consts::PI; 3])
}
