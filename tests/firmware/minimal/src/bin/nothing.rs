//! Reads directions and gives one back: what the others have beside this crate.
#![no_std]
#![no_main]

use minimal::run;

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    run(|_: [i16; 3], _, l| l)
}
