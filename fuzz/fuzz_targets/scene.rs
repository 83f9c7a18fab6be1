//! Scenes: materials, lamps and whole pixels, three channels at a time.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sunglint::trial::{Draw, property::scene};

fuzz_target!(|bytes: &[u8]| {
    if let Err(broken) = scene::hold(&mut Draw::new(bytes)) {
        panic!("{broken}");
    }
});
