//! `reflect` and `cap` in f32.
#![no_std]
#![no_main]

use minimal::run;
use sunglint::{DistantSphere, SUN, cap, reflect};

static SPHERE: DistantSphere<f32> = DistantSphere::<f32>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    run(|n: [f32; 3], v, l| cap(l, reflect(n, v), &SPHERE))
}
