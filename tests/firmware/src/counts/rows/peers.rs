//! The same jobs done by others, on the same inputs.

use peers::kernels::f32::{Libm, Micromath, Roots};
use peers::kernels::{CORDIC, FIXED, IDSP, LIBM, MICROMATH, cordic, f32, fixed, idsp};
use sunglint::Real;
use sunglint::fixed::types::{I2F14, I2F30, I3F29, I16F16, U16F16};
use sunglint::trial::chip::{Case, INPUTS, pairs};

use crate::counter::Counter;
use crate::inputs::{all, of_numbers, rounded};
use crate::row::Row;
use crate::rows::vectors::{couples, long, square};

pub fn count(counter: &Counter) {
    of_f32::<Libm>(LIBM, counter);
    of_f32::<Micromath>(MICROMATH, counter);
    of_fixed::<I2F14>(counter);
    of_fixed::<I2F30>(counter);
    of_fixed::<I16F16>(counter);
    let levels = of_numbers(|numbers| U16F16::from_num(square(numbers)));
    any("root", "U16F16", FIXED).count(counter, fixed::root, &levels);
    any("reciprocal root", "U16F16", FIXED).count(counter, fixed::reciprocal_root, &levels);
    let signed = of_numbers(|numbers| I16F16::from_num(square(numbers)));
    any("root", "I16F16", CORDIC).count(counter, cordic::root, &signed);
    let angles = of_numbers(|[part, ..]| I3F29::from_num(core::f64::consts::PI * (2.0 * part - 1.0)));
    any("sin_cos", "I3F29", CORDIC).count(counter, cordic::sin_cos, &angles);
    let turns = of_numbers(|[turn, ..]| (turn * 4_294_967_296.0) as u32 as i32);
    any("sin_cos", "Q31", IDSP).count(counter, idsp::sin_cos, &turns);
}

fn any(function: &'static str, format: &'static str, by: &'static str) -> Row {
    Row { function, format, by, case: "any" }
}

fn of_f32<R: Roots>(by: &'static str, counter: &Counter) {
    for case in Case::ALL {
        let rays = all(pairs(case).map(|pair| [rounded::<core::primitive::f32>(pair.l), rounded(pair.r)]));
        let row = |function| Row { function, format: "f32", by, case: case.name() };
        row("factored").count(counter, f32::factored::<R>, &rays);
        row("cap").count(counter, f32::cap::<R>, &rays);
    }
    any("normalize", "f32", by).count(counter, f32::normalize::<R>, &long());
    let squares: [_; INPUTS] = of_numbers(|numbers| square(numbers) as core::primitive::f32);
    any("root", "f32", by).count(counter, f32::root::<R>, &squares);
    any("reciprocal root", "f32", by).count(counter, f32::reciprocal_root::<R>, &squares);
}

fn of_fixed<T: Real + fixed::Number>(counter: &Counter) {
    any("dot", T::NAME, FIXED).count(counter, fixed::dot, &couples::<T>());
    any("normalize", T::NAME, FIXED).count(counter, fixed::normalize, &long::<T>());
}
