//! Directions: finite, within budget, symmetric, continuous across the rim.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sunglint::trial::{Draw, property::directions};

fuzz_target!(|bytes: &[u8]| {
    if let Err(broken) = directions::hold(&mut Draw::new(bytes)) {
        panic!("{broken}");
    }
});
