//! Construction from raw bits: every function of sunglint::raw and of the formats on any bits at all.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sunglint::trial::{Draw, property::raw};

fuzz_target!(|bytes: &[u8]| {
    if let Err(broken) = raw::hold(&mut Draw::new(bytes)) {
        panic!("{broken}");
    }
});
