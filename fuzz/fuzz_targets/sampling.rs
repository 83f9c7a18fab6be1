//! Sampling: directions of the disc, the basis, the density, the hit test and soft shadows.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sunglint::trial::{Draw, property::sampling};

fuzz_target!(|bytes: &[u8]| {
    if let Err(broken) = sampling::hold(&mut Draw::new(bytes)) {
        panic!("{broken}");
    }
});
