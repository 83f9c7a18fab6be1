//! Inputs in a format, rounded outside of what is counted.

use core::array::from_fn;

use sunglint::Real;
use sunglint::trial::chip::{self, INPUTS};

/// One of each of the numbers.
pub fn of_numbers<I>(make: impl FnMut([f64; 3]) -> I) -> [I; INPUTS] {
    all(chip::numbers().map(make))
}

/// All that an iterator of so many gives.
pub fn all<I>(mut inputs: impl Iterator<Item = I>) -> [I; INPUTS] {
    from_fn(|_| inputs.next().unwrap())
}

/// A vector in the format.
pub fn rounded<T: Real>(v: [f64; 3]) -> [T; 3] {
    v.map(T::from_f64)
}
