//! The rows, by group. To add one, count it here and export it from `bytes.rs`.

mod by_hand;
mod directions;
mod highlights;
mod peers;
mod sampling;
mod vectors;

use sunglint::Real;
use sunglint::trial::{Format, Visitor};

use crate::counter::Counter;

/// Counts and prints all of them.
pub fn count(counter: &Counter) {
    for format in Format::ALL {
        format.visit(InFormat { counter });
    }
    vectors::of_floats(counter);
    vectors::of_mantissas(counter);
    directions::by_formula(counter);
    by_hand::count(counter);
    peers::count(counter);
}

struct InFormat<'a> {
    counter: &'a Counter,
}

impl Visitor for InFormat<'_> {
    type Output = ();

    fn visit<T: Real>(self) {
        directions::count::<T>(self.counter);
        vectors::count::<T>(self.counter);
        sampling::count::<T>(self.counter);
        highlights::count::<T>(self.counter);
    }
}
