//! The points of the square: even from any first, below 1, and the published sequence.

use fixed::types::{I2F14, I2F30, I16F16};
use half::f16;
use micromath::F32;
use sunglint::Real;
use sunglint::sampling::points;

/// Of any run of 1024 points, each of 32 columns and rows has its share, give or take three; all are below 1.
#[test]
fn points_are_even_from_any_first() {
    fn check<T: Real>() {
        for first in [0, 1, 12_345, u32::MAX - 100] {
            let mut counts = [[0_i32; 32]; 2];
            for point in points::<T>(first, 1024) {
                for (side, lane) in point.into_iter().enumerate() {
                    let lane = lane.to_f64();
                    assert!((0.0..1.0).contains(&lane));
                    counts[side][(lane * 32.0) as usize] += 1;
                }
            }
            assert!(counts.as_flattened().iter().all(|count| (count - 32).abs() <= 3), "{} {counts:?}", T::NAME);
        }
        assert_eq!(points::<T>(7, 0).count(), 0);
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    check::<f16>();
    check::<I2F14>();
    check::<I2F30>();
    check::<I16F16>();
}

/// Against multiples of the plastic number in f64.
#[test]
fn points_are_the_published_sequence() {
    let plastic = 1.324_717_957_244_746_f64;
    for (index, point) in points::<f64>(0, 65_536).enumerate() {
        for (lane, step) in point.into_iter().zip([1.0 / plastic, 1.0 / (plastic * plastic)]) {
            let truth = (0.5 + index as f64 * step).fract();
            let apart = (lane - truth).abs();
            // A rounding of 2^-33 for each step.
            assert!(apart.min(1.0 - apart) < 65_536.0 / 2_f64.powi(32), "{index}: {lane} {truth}");
        }
    }
}

/// So that pixels which begin at multiples of the count share out one sequence.
#[test]
fn a_run_goes_on_where_the_last_one_ended() {
    for first in [0, 12_345, u32::MAX - 10] {
        let whole: Vec<_> = points::<f64>(first, 64).collect();
        let rest: Vec<_> = points::<f64>(first.wrapping_add(32), 32).collect();
        assert_eq!(whole[32..], rest);
    }
}
