//! Black bodies: Planck's law in SI units, relative to its peak, and as a tint.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sunglint::trial::{Draw, property::blackbody};

fuzz_target!(|bytes: &[u8]| {
    if let Err(broken) = blackbody::hold(&mut Draw::new(bytes)) {
        panic!("{broken}");
    }
});
