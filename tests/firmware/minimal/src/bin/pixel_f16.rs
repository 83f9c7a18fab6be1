//! A lit pixel by `DiscGgx` in f16.
#![no_std]
#![no_main]

use minimal::shade;
use sunglint::half::f16;
use sunglint::{DistantSphere, SUN};

const TOWARDS_SUN: [f16; 3] = [f16::from_f32_const(0.6), f16::ZERO, f16::from_f32_const(0.8)];

static SPHERE: DistantSphere<f16> = DistantSphere::<f16>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    shade(TOWARDS_SUN, &SPHERE, [f16::PI; 3])
}
