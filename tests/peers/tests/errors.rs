//! The peers' errors as committed, and what is said of where they fail.

use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use fixed::types::{I2F14, I2F30, I16F16};
use peers::kernels::{cordic, fixed as operators};
use peers::throughput::normalize_lanes;
use peers::{contest, kernel_error};

const COMMITTED: &str = include_str!("../../../src/trial/chip/peers.csv");

#[test]
fn errors_are_as_committed() {
    let computed: Vec<_> = kernel_error::rows().iter().map(kernel_error::line).collect();
    assert_eq!(COMMITTED.lines().next(), Some(kernel_error::HEADER));
    assert_eq!(COMMITTED.lines().skip(1).collect::<Vec<_>>(), computed);
}

/// Within a quarter of each other's, so that neither side of a contest is cheap by being wrong.
#[test]
fn glam_is_as_exact_as_sunglint() {
    for contest in contest::ALL.map(|contest| contest()) {
        let [own, other] = (contest.errors)();
        let ratio = own / other;
        assert!(ratio > 0.75 && ratio < 1.25, "{} {}: {own} and {other}", contest.function, contest.peer);
    }
}

#[test]
fn roots_of_cordic_return_below_16384_and_not_there() {
    let returns = |square: I16F16| {
        let (sender, receiver) = mpsc::channel();
        // Where it hangs, the thread ends with the tests.
        thread::spawn(move || sender.send(cordic::root(&square)));
        receiver.recv_timeout(Duration::from_secs(2)).is_ok()
    };
    assert!(returns(I16F16::from_num(kernel_error::CORDIC_HANGS) - I16F16::DELTA));
    assert!(!returns(I16F16::from_num(kernel_error::CORDIC_HANGS)));
}

#[test]
fn fixed_wraps_where_the_square_leaves_the_format() {
    let [x, ..] = operators::normalize(&[I2F30::from_num(1.4), I2F30::ZERO, I2F30::ZERO]);
    assert!((x.to_num::<f64>() - 1.0).abs() < 1e-8);
    let wrapped =
        std::panic::catch_unwind(|| operators::normalize(&[I2F30::from_num(1.2), I2F30::from_num(1.2), I2F30::ZERO]));
    let right = |[x, ..]: [I2F30; 3]| (x.to_num::<f64>() - 0.5_f64.sqrt()).abs() < 0.01;
    assert!(!wrapped.is_ok_and(right));
}

/// Nearest but for a hundredth of a step: what a loop by hand for vectors gains is not bought with error.
#[test]
fn lanes_are_rounded_to_nearest() {
    let lanes = |factor: i32| (1..4000).map(move |i: i32| ((i * factor) % 17_000) as i16).collect::<Vec<_>>();
    let [x, y, z] = [lanes(7), lanes(-1301), lanes(4391)];
    let [mut a, mut b, mut c] = [x.clone(), y.clone(), z.clone()];
    normalize_lanes([&x, &y, &z], [&mut a, &mut b, &mut c]);
    let mut worst: f64 = 0.0;
    for i in 0..x.len() {
        let [p, q, r] = [x[i], y[i], z[i]].map(f64::from);
        let scale = f64::from(I2F14::ONE.to_bits()) / (p * p + q * q + r * r).sqrt();
        for (got, exact) in [(a[i], p), (b[i], q), (c[i], r)] {
            worst = worst.max((f64::from(got) - scale * exact).abs());
        }
    }
    assert!(worst < 0.51 && worst > 0.49, "{worst}");
}
