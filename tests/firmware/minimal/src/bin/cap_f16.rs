//! `reflect` and `cap` in f16.
#![no_std]
#![no_main]

use minimal::run;
use sunglint::half::f16;
use sunglint::{DistantSphere, SUN, cap, reflect};

static SPHERE: DistantSphere<f16> = DistantSphere::<f16>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    run(|n: [f16; 3], v, l| cap(l, reflect(n, v), &SPHERE))
}
