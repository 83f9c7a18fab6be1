//! `reflect` and `cap` in I2F14.
#![no_std]
#![no_main]

use minimal::run;
use sunglint::fixed::types::I2F14;
use sunglint::raw::SUN_Q14;
use sunglint::{cap, reflect};

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    run(|n: [I2F14; 3], v, l| cap(l, reflect(n, v), &SUN_Q14))
}
