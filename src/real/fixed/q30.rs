//! I2F30 by hand: exact products of 32 bits summed in 64, and no shift of 64 bits by a number that varies.

use core::ops::Range;

use fixed::types::I2F30;

use super::{Lanes, dot};
use crate::multiply::{rounded_high, signed, square, wide};
use crate::root::reciprocal_root;
use crate::specular::nearest;
use crate::sphere::DistantSphere;
use crate::vec3::{each, zip};
use crate::zeros::even_zeros;

/// [`Real::normalize`](crate::real::Real::normalize) on bits; every lane within 0.9 of a step.
#[inline]
pub(super) fn normalize(v: Lanes) -> Lanes {
    match unit(sum_of_squares(v)) {
        // At half of its length the vector fills 32 bits with their sign.
        Some((mantissa, half)) => each(v, |lane| rounded_high(lane.wrapping_shl(half.wrapping_sub(1)), mantissa)),
        None => of_any_length(v),
    }
}

/// For lengths below 6.1e-5, or of 2 and more.
#[cold]
#[inline(never)]
fn of_any_length(v: Lanes) -> Lanes {
    super::normalize::<30>(v)
}

/// [`cap`](crate::specular::cap).
///
/// With `d` the difference of the two directions where they are within a right angle, else their sum, and `c = d.l`,
/// the tangent's square is `|d|^2 - c^2`, in which nothing cancels. Then `k = x / |s|` and the answer is a sum of two
/// vectors, `(1 - w - k cos) l + k r`, `cos` being `1 - c` or `c - 1`. What has no place in these words is left to the
/// formula: discs smaller than 8.7e-5 or larger than 0.69, and directions that are nearer to `-l` than the rim is to
/// `l`.
#[inline]
pub(super) fn cap(l: [I2F30; 3], r: [I2F30; 3], light: &DistantSphere<I2F30>) -> [I2F30; 3] {
    let (centre, mirror) = (each(l, I2F30::to_bits), each(r, I2F30::to_bits));
    let lanes = nearest_of_most(centre, mirror, light).unwrap_or_else(|| by_formula(l, r, light));
    each(lanes, I2F30::from_bits)
}

#[cold]
#[inline(never)]
fn by_formula(l: [I2F30; 3], r: [I2F30; 3], light: &DistantSphere<I2F30>) -> Lanes {
    each(nearest(l, r, light), I2F30::to_bits)
}

/// The upper words of the versines, in Q60, of discs that are drawn here: below, a rounding of Q31 is too much of them;
/// above, the rim is told by its cosine.
const VERSINES: Range<u32> = 1..0x480_0000;

#[inline(always)]
fn nearest_of_most(l: Lanes, r: Lanes, light: &DistantSphere<I2F30>) -> Option<Lanes> {
    let apart = zip(l, r, i32::wrapping_sub);
    let square = sum_of_squares(apart);
    // The tangent is no longer than what it is a part of.
    if words(square)[0] < words(light.sin_square as u64)[0] {
        return Some(r);
    }
    let [high, low] = words(light.versine as u64);
    if !VERSINES.contains(&high) {
        return None;
    }
    let versine = (high << 3) | (low >> 29);
    if square < 2 << 60 {
        rim::<true>(l, r, apart, square, versine, light)
    } else {
        let sum = zip(l, r, i32::wrapping_add);
        rim::<false>(l, r, sum, sum_of_squares(sum), versine, light)
    }
}

/// Twice in the code, `TOWARD` the light and away from it, since the signs of words that may be either cost a third
/// more.
#[inline(always)]
fn rim<const TOWARD: bool>(
    l: Lanes,
    r: Lanes,
    d: Lanes,
    square: u64,
    versine: u32,
    light: &DistantSphere<I2F30>,
) -> Option<Lanes> {
    let [high, low] = words(dot(d, l) as u64);
    // From 0 to 1, but where lengths are off by more than the directions are apart.
    if high & (1 << 28) != 0 {
        return None;
    }
    let along = (high << 4) | (low >> 28);
    let square = square.wrapping_sub(wide(along, along) >> 4);
    if square <= light.sin_square as u64 {
        return if TOWARD { Some(r) } else { None };
    }
    let (mantissa, half) = unit(square)?;
    let [high, low] = words(light.sin as u64);
    let sin = high.wrapping_shl(half.wrapping_add(2)) | low.wrapping_shr(30_u32.wrapping_sub(half));
    let [high, low] = words(wide(sin, mantissa));
    // Of Q31, and by a rounding it may be above 1; less 1 it has room for that in a signed word.
    let k = high.wrapping_add(low >> 31);
    let less = k ^ (1 << 31);
    let [k_along, _] = words(wide(k, along));
    let of_l = if TOWARD { k_along.wrapping_sub(less) } else { k.wrapping_sub(k_along) }.wrapping_sub(versine);
    let lanes = zip(l, r, |l, r| r.wrapping_add(sum_of_products(of_l as i32, l, less as i32, r)));
    // What is beside 1 of the factor of `l` has room, too.
    Some(if TOWARD { lanes } else { zip(lanes, l, i32::wrapping_add) })
}

/// `a x + b y` for factors in Q31, to nearest.
#[inline(always)]
fn sum_of_products(a: i32, x: i32, b: i32, y: i32) -> i32 {
    let [high, low] = words(signed(a, x).wrapping_add(signed(b, y)).wrapping_add(1 << 30) as u64);
    ((high << 1) as i32).wrapping_add((low >> 31) as i32)
}

/// `1 / sqrt(square)` as a Q31 mantissa in [1, 2) and the half exponent `h` from 1 to 15: `mantissa 2^(h - 63)` in
/// units of lanes; none where `square` is below `2^32`, or `2^62` and above.
#[inline(always)]
fn unit(square: u64) -> Option<(u32, u32)> {
    let [high, low] = words(square);
    let even = even_zeros(high);
    if even == 0 {
        return None;
    }
    let mantissa = reciprocal_root(high.wrapping_shl(even) | (low >> 1).wrapping_shr(31_u32.wrapping_sub(even)));
    Some((mantissa, even / 2))
}

#[inline(always)]
fn sum_of_squares(v: Lanes) -> u64 {
    let [x, y, z] = each(v, square);
    x.wrapping_add(y).wrapping_add(z)
}

#[inline(always)]
const fn words(bits: u64) -> [u32; 2] {
    [(bits >> 32) as u32, bits as u32]
}
