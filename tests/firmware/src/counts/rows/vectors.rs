//! Vectors and roots.

use sunglint::half::f16;
use sunglint::micromath::F32;
use sunglint::trial::chip::{Case, INPUTS, pairs};
use sunglint::{Float, Real, Scalar};

use crate::calls::vectors;
use crate::counter::Counter;
use crate::inputs::{all, of_numbers, rounded};
use crate::row::Row;

pub fn count<T: Real>(counter: &Counter) {
    let row = |function| Row { function, format: T::NAME, by: "sunglint", case: "any" };
    row("dot").count(counter, vectors::dot, &couples::<T>());
    row("reflect").count(counter, vectors::reflect, &couples::<T>());
    row("normalize").count(counter, vectors::normalize, &long::<T>());
    row("root").count(counter, vectors::root, &squares::<T::Scalar>());
}

/// Two unit vectors each.
pub fn couples<T: Real>() -> [[[T; 3]; 2]; INPUTS] {
    all(pairs(Case::Outside).map(|pair| [rounded::<T>(pair.l), rounded(pair.r)]))
}

/// Vectors of lengths from 1/10 to 1.1.
pub fn long<T: Real>() -> [[T; 3]; INPUTS] {
    let mut lengths = of_numbers(|[length, ..]| 0.1 + length).into_iter();
    let long = |v: [f64; 3], length: f64| v.map(|lane| lane * length);
    all(pairs(Case::Outside).map(|pair| rounded::<T>(long(pair.r, lengths.next().unwrap_or(1.0)))))
}

/// What floats have as a function of their own.
pub fn of_floats(counter: &Counter) {
    of_float::<f64>(counter);
    of_float::<f32>(counter);
    of_float::<F32>(counter);
    of_float::<f16>(counter);
}

fn of_float<T: Float>(counter: &Counter) {
    let row = Row { function: "reciprocal root", format: T::FORMAT, by: "sunglint", case: "any" };
    row.count(counter, vectors::reciprocal_root, &squares::<T>());
}

/// The root beneath fixed point, of mantissas from `2^30`.
pub fn of_mantissas(counter: &Counter) {
    let row = Row { function: "reciprocal root", format: "Q31", by: "sunglint", case: "any" };
    let mantissa = |[part, ..]: [f64; 3]| (1 << 30) + (part * f64::from(3_u32 << 30)) as u32;
    row.count(counter, vectors::mantissa_reciprocal_root, &of_numbers(mantissa));
}

fn squares<S: Scalar>() -> [S; INPUTS] {
    of_numbers(|numbers| S::nearest(square(numbers)))
}

/// A number from 1/1000 to 1000, each power of ten as often.
pub fn square([digits, exponent, _]: [f64; 3]) -> f64 {
    let tens = [1e-3, 1e-2, 1e-1, 1.0, 10.0, 100.0][(6.0 * exponent) as usize];
    tens * (1.0 + 9.0 * digits)
}
