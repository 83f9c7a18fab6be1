//! `reflect` and `cap` in f64.
#![no_std]
#![no_main]

use minimal::run;
use sunglint::{DistantSphere, SUN, cap, reflect};

static SPHERE: DistantSphere<f64> = DistantSphere::<f64>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    run(|n: [f64; 3], v, l| cap(l, reflect(n, v), &SPHERE))
}
