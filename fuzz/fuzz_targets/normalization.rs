//! Normalisation: solid angle, sizeFactor, radiance, in floats and in integers.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sunglint::trial::{Draw, property::normalization};

fuzz_target!(|bytes: &[u8]| {
    if let Err(broken) = normalization::hold(&mut Draw::new(bytes)) {
        panic!("{broken}");
    }
});
