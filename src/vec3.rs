//! Three lanes, written out: an index in a closure would bring a bounds check, and `array::map` a loop, into small
//! firmware.

/// `f` of each lane.
#[inline(always)]
pub(crate) fn each<A: Copy, B>(v: [A; 3], f: impl Fn(A) -> B) -> [B; 3] {
    [f(v[0]), f(v[1]), f(v[2])]
}

/// `f` of the lanes of two vectors.
#[inline(always)]
pub(crate) fn zip<A: Copy, B: Copy, C>(a: [A; 3], b: [B; 3], f: impl Fn(A, B) -> C) -> [C; 3] {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}
