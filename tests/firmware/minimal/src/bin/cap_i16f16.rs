//! `reflect` and `cap` in I16F16.
#![no_std]
#![no_main]

use minimal::run;
use sunglint::fixed::types::I16F16;
use sunglint::{DistantSphere, SUN, cap, reflect};

static SPHERE: DistantSphere<I16F16> = DistantSphere::<I16F16>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    run(|n: [I16F16; 3], v, l| cap(l, reflect(n, v), &SPHERE))
}
