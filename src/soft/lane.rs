//! Lanes from f32 to Q30 and back, by their bits.

use fixed::types::I2F30;

use crate::vec3::each;

/// Bit of the exponent that only 2 and more have, NaN included.
const TWO: u32 = 1 << 30;

const INFINITY: u32 = 0x7f80_0000;

/// f32's exponent of 1.
const ONE: u32 = 127;

/// Below this, where lanes may be subnormal, vectors are scaled by `2^64`.
const SMALL: u32 = 64 << 23;

/// f32's exponent of a number of 32 bits in Q30 whose first bit is set.
pub(super) const Q30: u32 = 128;

/// The lanes to nearest; none where one is NaN or 2 and more.
#[inline]
pub(super) fn lanes(v: [f32; 3]) -> Option<[I2F30; 3]> {
    let bits = each(v, f32::to_bits);
    let fits = (bits[0] | bits[1] | bits[2]) & TWO == 0;
    fits.then(|| each(bits, |lane| I2F30::from_bits(fixed(lane, ONE))))
}

/// The lanes times a power of two that puts the largest in [1/2, 1); none where they are all zero or one is not finite.
pub(super) fn scaled(bits: [u32; 3]) -> Option<[I2F30; 3]> {
    let most = largest(bits);
    if most == 0 || most >= INFINITY {
        return None;
    }
    let bits = if most < SMALL { each(bits, lifted) } else { bits };
    // Half of what is in [1, 2).
    let one = (largest(bits) >> 23).wrapping_add(1);
    Some(each(bits, |lane| I2F30::from_bits(fixed(lane, one))))
}

fn largest(bits: [u32; 3]) -> u32 {
    each(bits, |lane| lane << 1).into_iter().fold(0, u32::max) >> 1
}

/// Times `2^64`, so that it is zero or a normal number.
#[cold]
fn lifted(lane: u32) -> u32 {
    let size = lane << 1 >> 1;
    if size >> 23 > 0 {
        lane.wrapping_add(64 << 23)
    } else {
        // A multiple of 2^-149, of which the sign is restored.
        float(size as i32, Q30.wrapping_sub(149 - 64 - 30)) | (lane ^ size)
    }
}

/// The lane in Q30, where `one` is the exponent that counts as that of 1: to nearest, halves away from zero.
#[inline]
fn fixed(lane: u32, one: u32) -> i32 {
    let mantissa = (lane << 8) | (1 << 31);
    let places = one.wrapping_sub((lane >> 23) & 0xff);
    // The last bit of a mantissa that is not shifted is zero.
    let size = mantissa.checked_shr(places).unwrap_or(0).wrapping_add(1) >> 1;
    signed(size, lane)
}

#[inline]
const fn signed(size: u32, sign: u32) -> i32 {
    let all = sign as i32 >> 31;
    (size as i32 ^ all).wrapping_sub(all)
}

/// The nearest f32, halves away from zero; `top` is the exponent of a number whose first of 32 bits is set.
#[inline]
pub(super) fn float(lane: i32, top: u32) -> u32 {
    let size = lane.unsigned_abs();
    if size == 0 {
        return 0;
    }
    let free = size.leading_zeros();
    let mantissa = size << (free & 31);
    // The mantissa's first bit counts one up in the exponent.
    let exponent = top.wrapping_sub(free).wrapping_sub(1) << 23;
    let bits = exponent.wrapping_add(mantissa >> 8).wrapping_add((mantissa >> 7) & 1);
    bits | (lane as u32 & (1 << 31))
}
