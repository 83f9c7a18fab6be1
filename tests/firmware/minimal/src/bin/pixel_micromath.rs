//! A lit pixel by `DiscGgx` in micromath.
#![no_std]
#![no_main]

use minimal::shade;
use sunglint::micromath::F32;
use sunglint::{DistantSphere, SUN};

const TOWARDS_SUN: [F32; 3] = [F32(0.6), F32(0.0), F32(0.8)];

static SPHERE: DistantSphere<F32> = DistantSphere::<F32>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    shade(TOWARDS_SUN, &SPHERE, [F32(core::f32::consts::PI); 3])
}
