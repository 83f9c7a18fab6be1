//! `reflect` and `cap` in f32 by integers.
#![no_std]
#![no_main]

use minimal::run;
use sunglint::raw::SUN_Q30;
use sunglint::soft::{cap, reflect};

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    run(|n: [f32; 3], v, l| cap(l, reflect(n, v), &SUN_Q30))
}
