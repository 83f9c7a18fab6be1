//! How deep the stack goes: what is free of it is painted, and what has lost its paint was used.

use core::hint::black_box;
use core::ptr::with_exposed_provenance_mut;

use cortex_m::register::msp;

use crate::counter::{Call, nothing};

/// More than any function takes.
const PAINTED: usize = 16 * 1024;

/// No address, small number or float of a direction.
const PAINT: u32 = 0xa5c3_5ac3;

/// Bytes of stack at the deepest that `call` goes on any of the inputs.
pub fn depth<I, O>(call: Call<I, O>, inputs: &[I]) -> u32 {
    let [own, empty] = [call, nothing()].map(|call| used(call, inputs));
    assert!(own < PAINTED, "more stack than is painted");
    (own - empty) as u32
}

#[inline(never)]
fn used<I, O>(call: Call<I, O>, inputs: &[I]) -> usize {
    let call = black_box(call);
    // Everything of this function lies above.
    let top = msp::read() as usize;
    let free = (top - PAINTED..top).step_by(4);
    for address in free.clone() {
        // The stack has 4 MB, and nothing interrupts.
        unsafe { with_exposed_provenance_mut::<u32>(address).write_volatile(PAINT) };
    }
    for input in inputs {
        black_box(call(black_box(input)));
    }
    let painted = free.take_while(|&address| {
        // As above.
        unsafe { with_exposed_provenance_mut::<u32>(address).read_volatile() == PAINT }
    });
    PAINTED - 4 * painted.count()
}
