//! Counts functions of known length and depth, and stops the firmware where a count is off by one.

use core::arch::global_asm;
use core::mem::{MaybeUninit, transmute};

use crate::counter::{Call, Counter};
use crate::stack;

global_asm!(
    ".macro nops name, count",
    ".global \\name",
    ".type \\name, %function",
    ".thumb_func",
    "\\name:",
    ".rept \\count",
    "nop",
    ".endr",
    "bx lr",
    ".endm",
    "nops nops_0, 0",
    "nops nops_1, 1",
    "nops nops_2, 2",
    "nops nops_38, 38",
    "nops nops_39, 39",
    "nops nops_40, 40",
    "nops nops_1000, 1000",
    ".global loops",
    ".type loops, %function",
    ".thumb_func",
    "loops:",
    "ldr r0, [r0]",
    "2:",
    "subs r0, #1",
    "bne 2b",
    "bx lr",
    ".global pushes",
    ".type pushes, %function",
    ".thumb_func",
    "pushes:",
    "push {{r0-r7, lr}}",
    "pop {{r0-r7, pc}}",
);

unsafe extern "C" {
    fn nops_0(input: &u32) -> u32;
    fn nops_1(input: &u32) -> u32;
    fn nops_2(input: &u32) -> u32;
    fn nops_38(input: &u32) -> u32;
    fn nops_39(input: &u32) -> u32;
    fn nops_40(input: &u32) -> u32;
    fn nops_1000(input: &u32) -> u32;
    fn loops(input: &u32) -> u32;
    fn pushes(input: &u32) -> u32;
}

/// A C function of one pointer, which Rust calls as its own.
type Known = unsafe extern "C" fn(&u32) -> u32;

const LENGTHS: [(Known, u32); 7] =
    [(nops_0, 0), (nops_1, 1), (nops_2, 2), (nops_38, 38), (nops_39, 39), (nops_40, 40), (nops_1000, 1000)];

/// Fails by a panic.
pub fn run(counter: &Counter) {
    for (known, length) in LENGTHS {
        assert_eq!(counter.instructions(rust(known), &0), length + 2, "instructions of so many nops");
    }
    for length in (1..100).chain([10_000, 1_000_000]) {
        let found = counter.instructions(rust(loops), &length);
        assert_eq!(found, 2 * length + 3, "instructions of so many loops");
    }
    assert_eq!(stack::depth(rust(pushes), &[0]), 36, "bytes of nine registers");
    assert_eq!(stack::depth(rust(nops_1), &[0]), 0, "bytes of stack of none");
}

fn rust(known: Known) -> Call<u32, u32> {
    // One pointer in, one integer out: both conventions have them in r0.
    unsafe { transmute::<Known, fn(&u32) -> MaybeUninit<u32>>(known) }
}
