//! Roots of f32 in integers, correctly rounded, for chips without an FPU or whose root instruction Rust does not reach.

use super::{seed, times_seed, whole_reciprocal_root};
use crate::multiply::NARROW;

const NAN: u32 = 0x7fc0_0000;
const INFINITY: u32 = 0x7f80_0000;

/// The least normal number.
const NORMAL: u32 = 1 << 23;

/// A positive number `y 4^half`.
#[derive(Clone, Copy)]
struct Quarters {
    /// `y` in Q32, in [1/4, 1): 24 or 25 bits and zeros.
    mantissa: u32,
    /// Up by 63, hence positive: the exponent that f32 has, halved, upwards.
    half: u32,
}

/// The nearest square root of the number of these bits.
#[inline]
pub(crate) fn root(bits: u32) -> u32 {
    // Normal and positive.
    if bits.wrapping_sub(NORMAL) < INFINITY - NORMAL { root_of(quarters(bits), 0) } else { special_root(bits) }
}

#[cold]
fn special_root(bits: u32) -> u32 {
    match bits {
        0 | INFINITY | 0x8000_0000 => bits,
        1..NORMAL => root_of(quarters_of_subnormal(bits), 12),
        _ => NAN,
    }
}

/// The nearest `1 / sqrt` of the number of these bits.
#[inline]
pub(crate) fn reciprocal_root(bits: u32) -> u32 {
    if bits.wrapping_sub(NORMAL) < INFINITY - NORMAL {
        reciprocal_root_of(quarters(bits), 0)
    } else {
        special_reciprocal_root(bits)
    }
}

#[cold]
fn special_reciprocal_root(bits: u32) -> u32 {
    match bits {
        0 | 0x8000_0000 => bits | INFINITY,
        INFINITY => 0,
        1..NORMAL => reciprocal_root_of(quarters_of_subnormal(bits), 12),
        _ => NAN,
    }
}

#[inline]
const fn quarters(bits: u32) -> Quarters {
    // An odd exponent is that of an even power of two, f32's being up by 127.
    let odd = (bits >> 23) & 1;
    Quarters { mantissa: ((bits << 8) | (1 << 31)) >> odd, half: ((bits >> 23) + 1) >> 1 }
}

/// Of the number times `2^24`.
const fn quarters_of_subnormal(bits: u32) -> Quarters {
    let free = bits.leading_zeros();
    // bits 2^(24 - 149), the first bit worth 2^(31 - free).
    let exponent = 127 + 31 - free + 24 - 149;
    quarters((exponent << 23).wrapping_add((bits << free >> 8) & (NORMAL - 1)))
}

/// The root, over `2^lift`.
#[inline]
fn root_of(y: Quarters, lift: u32) -> u32 {
    let m = y.mantissa;
    let seed = seed(m);
    // Q31, and up to a unit too small.
    let near = times_seed::<NARROW>(m, seed);
    // 1 - y seed^2 in Q30, under 2^-11.
    let residual = (1_i32 << 30).wrapping_sub(times_seed::<NARROW>(near, seed) as i32);
    let step = ((near >> 16) as i32).wrapping_mul(residual >> 3) >> 12;
    // Of 24 bits, the nearest one or that below it: the step leaves a root that is too small, by up to 0.7 of them, and
    // what cutting adds to it is less than what is subtracted here from a half.
    let below = near.wrapping_add(step as u32).wrapping_add(54) >> 7;
    // Whether root^2 > (below + 1/2)^2, by the low bits of the difference, which is small.
    let above = (m << 16).wrapping_sub(below.wrapping_mul(below)) as i32 > below as i32;
    (y.half.wrapping_add(62 - lift) << 23).wrapping_add(below).wrapping_add(u32::from(above))
}

/// The reciprocal root, times `2^lift`.
#[inline]
fn reciprocal_root_of(y: Quarters, lift: u32) -> u32 {
    // Q30, of which seven bits are more than f32 has, within one.
    let root = whole_reciprocal_root(y.mantissa);
    let nearest =
        if root.wrapping_sub(63) & 127 > 2 { root.wrapping_add(64) >> 7 } else { decided(y.mantissa, root >> 7) };
    (189_u32.wrapping_sub(y.half).wrapping_add(lift) << 23).wrapping_add(nearest)
}

/// `below` or the next, whichever is nearer to the root.
#[cold]
fn decided(m: u32, below: u32) -> u32 {
    let middle = u64::from(below.wrapping_mul(2).wrapping_add(1));
    // y middle^2 against 1, which is 2^80 here: by the low bits of the difference, which is small.
    let difference = u64::from(m).wrapping_mul(middle.wrapping_mul(middle)) as i64;
    below.wrapping_add(u32::from(difference < 0))
}
