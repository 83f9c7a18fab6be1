//! `reflect` and `cap` in micromath.
#![no_std]
#![no_main]

use minimal::run;
use sunglint::micromath::F32;
use sunglint::{DistantSphere, SUN, cap, reflect};

static SPHERE: DistantSphere<F32> = DistantSphere::<F32>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    run(|n: [F32; 3], v, l| cap(l, reflect(n, v), &SPHERE))
}
