//! The light quantities over every ratio that f32 and I2F30 have from 1e-6 to 1, against the closed forms in f64.
//!
//! Four minutes on two cores: `cargo test --release --test exhaustive -- --ignored --nocapture`.

use std::thread;

use fixed::types::I2F30;
use sunglint::trial::Format;
use sunglint::trial::quantity::Quantity;

/// The worst error over `bits`, on all cores, and where it is.
fn worst(bits: std::ops::RangeInclusive<u32>, error: impl Fn(u32) -> f64 + Sync) -> (f64, u32) {
    let cores = thread::available_parallelism().map_or(1, |cores| cores.get() as u32);
    let part = |core: u32| {
        bits.clone().skip(core as usize).step_by(cores as usize).fold((0.0, 0), |worst: (f64, u32), bits| {
            let error = error(bits);
            // A NaN is the worst of all.
            if error <= worst.0 { worst } else { (error, bits) }
        })
    };
    let parts: Vec<_> = thread::scope(|scope| {
        let part = &part;
        let threads: Vec<_> = (0..cores).map(|core| scope.spawn(move || part(core))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    parts.into_iter().fold((0.0, 0), |a, b| if b.0 <= a.0 { a } else { b })
}

fn check(name: &str, unit: &str, (error, bits): (f64, u32), bound: f64) {
    println!("{name}: worst {error} {unit} at bits {bits:#010x}");
    assert!(error <= bound && error >= bound / 4.0, "{name}: {error} at {bits:#010x}");
}

#[test]
#[ignore = "167 million ratios a quantity"]
fn every_f32() {
    let range = 1e-6_f32.to_bits()..=1.0_f32.to_bits();
    for quantity in Quantity::ALL {
        let error = |bits| {
            let ratio = f32::from_bits(bits);
            let truth = quantity.truth(ratio.into());
            quantity.in_float(ratio).map_or(f64::NAN, |value| (f64::from(value) - truth).abs() / Format::F32.ulp(truth))
        };
        check(quantity.name(), "ULP in f32", worst(range.clone(), error), 0.51);
    }
}

#[test]
#[ignore = "1074 million ratios a quantity"]
fn every_q30() {
    for quantity in Quantity::ALL {
        let error = |bits: u32| {
            let ratio = I2F30::from_bits(bits as i32);
            let truth = quantity.truth(ratio.to_num());
            quantity.in_fixed(ratio).map_or(f64::NAN, |answer| (answer.value - truth).abs() / answer.lsb)
        };
        // Of which the truth's own rounding takes up to 0.75: against 192 bits, tests/normalization.rs finds 0.5.
        check(quantity.name(), "LSB in 64 bits", worst(1074..=1 << 30, error), 1.25);
    }
}
