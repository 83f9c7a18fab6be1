//! Radiometry: power, intensity, irradiance, radiance, and the diffuse part down to sunset.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sunglint::trial::{Draw, property::radiometry};

fuzz_target!(|bytes: &[u8]| {
    if let Err(broken) = radiometry::hold(&mut Draw::new(bytes)) {
        panic!("{broken}");
    }
});
