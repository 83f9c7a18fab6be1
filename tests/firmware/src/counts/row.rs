//! A line of what is counted.

use core::mem::transmute;

use cortex_m_semihosting::hprintln;
use sunglint::trial::chip::INPUTS;

use crate::counter::{Call, Counter};
use crate::stack;

/// What a line is of, by the names of `sunglint::trial::chip::Row`.
#[derive(Clone, Copy)]
pub struct Row {
    pub function: &'static str,
    pub format: &'static str,
    pub by: &'static str,
    pub case: &'static str,
}

impl Row {
    /// Counts `call` on each of the inputs and prints the line.
    pub fn count<I, O>(self, counter: &Counter, call: fn(&I) -> O, inputs: &[I; INPUTS]) {
        // `MaybeUninit<O>` is passed as `O` is.
        let call = unsafe { transmute::<fn(&I) -> O, Call<I, O>>(call) };
        let mut counts = inputs.each_ref().map(|input| counter.instructions(call, input));
        counts.sort_unstable();
        let (median, worst) = (counts[INPUTS / 2 - 1], counts[INPUTS - 1]);
        let stack = stack::depth(call, inputs);
        let Self { function, format, by, case } = self;
        hprintln!("{},{},{},{},{},{},{},{}", function, format, by, case, INPUTS, median, worst, stack);
    }
}
