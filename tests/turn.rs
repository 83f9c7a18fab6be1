//! Sine and cosine of a turn: every turn of the 16-bit formats, a million of the others.

mod exact;

use exact::{assert_tight, big, worse, worst};
use half::f16;
use sunglint::Real;
use sunglint::sampling::sin_cos;
use sunglint::trial::sampling::{TURN, turn_error};
use sunglint::trial::{Format, Visitor};

struct Turns;

impl Visitor for Turns {
    type Output = f64;

    fn visit<T: Real>(self) -> f64 {
        let evenly = (0..=1_000_000).map(|i| T::from_f64(f64::from(i) / 1e6));
        turn_error::<T>(evenly).max
    }
}

#[test]
fn keeps_its_budgets() {
    for format in Format::ALL {
        assert_tight(format.name(), format.visit(Turns), TURN[format as usize]);
    }
}

#[test]
fn keeps_its_budget_for_every_turn_of_16_bits() {
    let halves = (0..=f16::ONE.to_bits()).map(f16::from_bits);
    assert_tight("every f16", turn_error(halves).max, TURN[Format::F16 as usize]);
    let lanes = (0..=1 << 14).map(fixed::types::I2F14::from_bits);
    assert_tight("every I2F14", turn_error(lanes).max, TURN[Format::I2F14 as usize]);
}

/// The oracle of the others, and f64 itself, against 192 bits.
#[test]
fn f64_and_its_oracle_against_192_bits() {
    let error = |of: fn(f64) -> [f64; 2]| {
        worst((0..20_000).map(|i| {
            let turn = f64::from(i) / 20_000.0;
            let [sin, cos] = of(turn);
            let truth = [big(turn).sin_unit(1), big(turn).cos_unit(1)];
            let off = |value: f64, truth: &exact::Big| (big(value) - truth).to_f64().value().abs();
            worse(off(sin, &truth[0]), off(cos, &truth[1]))
        }))
    };
    assert_tight("oracle", error(sunglint::oracle::cone::turned), 1.7e-16);
    assert_tight("f64", error(sin_cos::<f64>), TURN[0]);
}

#[test]
fn whole_quarters_are_exact_and_what_is_outside_is_taken_for_the_end() {
    fn check<T: Real>() {
        let of = |turn: f64| sin_cos(T::of_lane(T::from_f64(turn))).map(|value| T::lane(value).to_f64());
        assert_eq!([0.0, 0.25, 0.5, 0.75, 1.0].map(of), [[0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [-1.0, 0.0], [0.0, 1.0]]);
        assert_eq!([-0.1, 1.1].map(of), [[0.0, 1.0]; 2]);
    }
    check::<f64>();
    check::<f32>();
    check::<micromath::F32>();
    check::<f16>();
    check::<fixed::types::I2F14>();
    check::<fixed::types::I2F30>();
    check::<fixed::types::I16F16>();
    assert_eq!([f32::NAN, -f32::NAN, f32::INFINITY].map(sin_cos), [[0.0, 1.0]; 3]);
}
