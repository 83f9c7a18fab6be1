//! `reflect` and `cap` in I2F30.
#![no_std]
#![no_main]

use minimal::run;
use sunglint::fixed::types::I2F30;
use sunglint::raw::SUN_Q30;
use sunglint::{cap, reflect};

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    run(|n: [I2F30; 3], v, l| cap(l, reflect(n, v), &SUN_Q30))
}
