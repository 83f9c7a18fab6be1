//! Highlights: every method's whole pixel.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sunglint::trial::{Draw, property::highlight};

fuzz_target!(|bytes: &[u8]| {
    if let Err(broken) = highlight::hold(&mut Draw::new(bytes)) {
        panic!("{broken}");
    }
});
