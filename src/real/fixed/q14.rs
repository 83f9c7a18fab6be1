//! I2F14 by hand: 16-bit lanes, whose products and sums of squares 32-bit registers hold.
//!
//! [`cap`] is the formula of [`nearest`](crate::specular::nearest) rearranged. The tangent `s` is `r - q l`, where `q`
//! is `l.r / l.l`, so that the point on the rim, `l - w l + s x / |s|`, is a sum of `r` and `l` themselves: no lane of
//! the tangent is ever formed, and its rounding is spared. `|s|^2` is `|e|^2 - (e.l)^2` with `e = r - l`, or `r + l`
//! behind the light, all from three dot products and without cancellation. Lengths may be a rounding off 1, which
//! counts in neither: twice that, times the square of `e.l`, is below what `|s|^2` is rounded to for small discs, and
//! large ones are told by their cosine. Within half a step of `-l` the answer is `l`.

use fixed::types::I2F14;

use super::short_root::{NO_COUNT, reciprocal_root};
use super::{Lane, Lanes};
use crate::multiply::wide;
use crate::real::Real;
use crate::sphere::DistantSphere;
use crate::vec3::{each, zip};

type Vector = [I2F14; 3];

/// 1 in Q28.
const ONE: i32 = I2F14::WIDE_ONE;

/// The square in Q30 up to which a tangent behind the light counts as short, 222 steps of Q14: there its length needs
/// more digits than its square has. A zero `r` counts as one, too.
const SHORT: i32 = 3 << 16;

/// The square in Q44 of half a step, below which a tangent has no direction.
const SHORTEST: u32 = 1 << 14;

/// `l.(l - r)` in Q28 from which `r` is beside no small disc: well below that of a zero `r`.
const LEVEL: i32 = ONE - (ONE >> 8);

/// The cosine in Q28 above which a disc is small: its sine is below 1/8.
const SMALL: i32 = ONE - (ONE >> 7);

/// [`Real::normalize`](crate::real::Real::normalize) on bits: each lane within 0.78 of the last place
/// (`tests/exhaustive`, `tests/q14.rs`).
#[inline]
pub(super) fn normalize(v: Lanes) -> Lanes {
    let square = dot(v, v) as u32;
    if NO_COUNT && square == 0 {
        return [0; 3];
    }
    let (half, root) = reciprocal_root(square);
    // Half of the last place; of the longest, whose root is not shifted, less the least, lest a lane overflow: at most
    // 2^31 / 2^half.
    let (shift, rounding) = (17_u32.wrapping_sub(half), 0xffff_u32.wrapping_add(half).wrapping_shr(half));
    each(v, |lane| lane.wrapping_mul(root as i32).wrapping_add(rounding as i32).wrapping_shr(shift) as i16 as i32)
}

/// Products of two vectors.
struct Dots {
    /// `l.r` in Q28.
    along: i32,
    /// `l.l` in Q28.
    length: i32,
    /// `|s|^2` in Q30.
    square: i32,
}

/// [`cap`](crate::specular::cap).
#[inline]
pub(super) fn cap(l: Vector, r: Vector, light: &DistantSphere<I2F14>) -> Vector {
    each(nearest(each(l, Lane::bits), each(r, Lane::bits), light), |lane| I2F14::from_bits(lane as i16))
}

/// Whether `r` is inside a small disc takes two products less by `l - r`.
#[inline(always)]
fn nearest(l: Lanes, r: Lanes, light: &DistantSphere<I2F14>) -> Lanes {
    let e = zip(l, r, i32::wrapping_sub);
    let part = dot(l, e);
    let square = square(dot(e, e), part);
    let [_, ahead] = I2F14::STEEP;
    if part < LEVEL {
        if square <= light.sin_square << 2 {
            if light.cos >= ahead {
                return r;
            }
        } else if light.cos > SMALL && !NO_COUNT {
            // What `outside` does, where there are registers enough to do it here.
            let length = dot(l, l);
            let dots = Dots { along: length.wrapping_sub(part), length, square };
            if dots.along > 0 {
                return rim(&l, &r, light, dots.projection(), reciprocal_root(square as u32), 19);
            }
        }
    }
    let (xy, z) = outside(&[l, r], light);
    [xy, xy >> 16, z]
}

/// `|s|^2` in Q30 from `|e|^2` and `e.l` in Q28.
#[inline(always)]
fn square(apart: i32, part: i32) -> i32 {
    let sunk = part.wrapping_add(1 << 12) >> 13;
    (apart << 2).wrapping_sub(sunk.wrapping_mul(sunk))
}

impl Dots {
    #[inline(always)]
    fn of(l: Lanes, r: Lanes) -> Self {
        let (along, length) = (dot(l, r), dot(l, l));
        // As if `r` were ahead.
        let part = length.wrapping_sub(along.wrapping_abs());
        let apart = dot(r, r).wrapping_sub(length).wrapping_add(part.wrapping_mul(2));
        Self { along, length, square: square(apart, part) }
    }

    #[inline]
    fn is_within(&self, light: &DistantSphere<I2F14>) -> bool {
        self.square <= light.sin_square << 2
    }

    /// Whether `r` is inside a disc whose cosine is below the first of [`Real::STEEP`].
    #[inline]
    fn is_inside_large(&self, light: &DistantSphere<I2F14>) -> bool {
        let [behind, _] = I2F14::STEEP;
        if light.cos >= behind {
            return self.along >= light.cos;
        }
        // The full sphere's cosine is given as -2.
        self.along >= 0 || !self.is_within(light) || light.cos >> 28 < -1
    }

    /// `l.r / l.l` in Q30, for an `l` about as long as 1; up to lengths of 1.16 no product overflows.
    #[inline]
    fn projection(&self) -> i32 {
        self.over_length(self.along)
    }

    /// The same behind the light: the part of `r + l`, less 1, so that beside `-l`, where `k` is great, no more than a
    /// part of what a length lacks counts.
    #[inline]
    fn projection_behind(&self) -> i32 {
        self.over_length(self.along.wrapping_add(self.length)).wrapping_sub(ONE << 2)
    }

    /// A part of `l` in Q28, over `l.l`, in Q30.
    #[inline]
    fn over_length(&self, part: i32) -> i32 {
        let lacking = ONE.wrapping_sub(self.length) >> 8;
        (part << 2).wrapping_add((part >> 16).wrapping_mul(lacking) >> 2)
    }

    /// The same where `r` is beside `-l`, to the last bit: the part of `r + l`, which is small, less 1.
    #[inline]
    fn fine_projection(&self) -> i32 {
        let part = self.along.wrapping_add(self.length);
        // What rounding leaves a length to lack; where it is more, some other such number, which has room as well.
        let lacking = i32::from(ONE.wrapping_sub(self.length) as i16);
        (part << 2).wrapping_add((part >> 12).wrapping_mul(lacking) >> 14).wrapping_sub(ONE << 2)
    }

    /// `|s|^2` in Q44 of a tangent that is [`SHORT`]: `|l x r|^2 = l.l r.r - (l.r)^2`, exact in Q56, over `l.l`.
    #[inline]
    fn fine_square(&self, across: i32) -> u32 {
        let part = self.along.unsigned_abs();
        let square = product(self.length as u32, across as u32).wrapping_sub(product(part, part)) >> 12;
        // Of vectors that are too long it may be a little more.
        let square = square.min(u32::MAX.into()) as u32;
        let lacking = ((square >> 16) as i32).wrapping_mul(ONE.wrapping_sub(self.length) >> 12);
        square.wrapping_add(lacking as u32)
    }
}

/// [`cap`] but for what is inside a small disc, in a function of its own lest that pays for registers. Lanes are packed
/// for the same reason: they return in registers, of 16 bits each what counts.
#[inline(never)]
fn outside([l, r]: &[Lanes; 2], light: &DistantSphere<I2F14>) -> (i32, i32) {
    let dots = Dots::of(*l, *r);
    let [_, ahead] = I2F14::STEEP;
    if light.cos < ahead && dots.is_inside_large(light) {
        return packed(*r);
    }
    let q = if dots.along > 0 { dots.projection() } else { dots.projection_behind() };
    let (mut square, mut quadruplings, mut q) = (dots.square as u32, 0, q);
    if dots.along <= 0 && dots.square < SHORT {
        let across = dot(*r, *r);
        if across == 0 {
            return (0, 0);
        }
        (square, quadruplings, q) = (dots.fine_square(across), 7, dots.fine_projection());
        if square < SHORTEST {
            return packed(*l);
        }
    }
    let (half, root) = reciprocal_root(square.max(1));
    // A ratio under 1/8.
    let n = if light.cos > SMALL { 19 } else { 16 };
    packed(rim(l, r, light, q, (half.wrapping_add(quadruplings), root), n))
}

/// `l + k r + (-w - k q) l` with `k = x / |s|`. What the small discs add to `l` is in Q33 a number of 32 bits, though
/// its parts are not; what the large ones do is so in Q30.
#[inline(always)]
fn rim(l: &Lanes, r: &Lanes, light: &DistantSphere<I2F14>, q: i32, (half, root): (u32, u32), n: u32) -> Lanes {
    // 2^16 is one too many.
    let x = light.sin.wrapping_shr(28 - n).wrapping_sub(light.sin >> 28) as u32;
    let k = x.wrapping_mul(root).wrapping_shr(16_u32.wrapping_sub(half));
    // k (q + 2), lest it be negative.
    let kq = (product(k, (q as u32).wrapping_add(1 << 31)) >> 30) as u32;
    let versine = light.versine.wrapping_shr(28 - n) as u32;
    let d = k.wrapping_mul(2).wrapping_sub(kq).wrapping_sub(versine) as i32;
    let lane = |l: i32, r: i32| {
        let shift = (k as i32).wrapping_mul(r).wrapping_add((1 << n) >> 1).wrapping_add(d.wrapping_mul(l));
        l.wrapping_add(shift.wrapping_shr(n))
    };
    zip(*l, *r, lane)
}

#[inline(always)]
fn dot(a: Lanes, b: Lanes) -> i32 {
    let product = |lane: usize| a[lane].wrapping_mul(b[lane]);
    product(0).wrapping_add(product(1)).wrapping_add(product(2))
}

/// [`wide`]; where that takes four products, one copy of them has to do.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
fn product(a: u32, b: u32) -> u64 {
    wide(a, b)
}

#[inline(always)]
fn packed([x, y, z]: Lanes) -> (i32, i32) {
    ((x & 0xffff) | (y << 16), z)
}
