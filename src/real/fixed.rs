//! Fixed point: lanes in 16 or 32 bits, scalars with twice the fraction bits, one rounding at the end.
//!
//! The kernels work on 32-bit lanes with `F` fraction bits. Scalars that multiply lanes are Q31 or Q32 in an
//! `i64`, whatever the format, since that is finer than the finest lane. All arithmetic that can leave its range
//! for vectors much longer than one wraps, so that such vectors give a wrong direction but never a panic.

mod q14;
mod q16;
mod q30;
mod short_root;

use fixed::types::{I2F14, I2F30, I16F16, U16F16, U32F32};

use super::{Halfway, Real, STEEP_COSINE, Scalar, Scaled, at_most, most_tilt, positive};
use crate::constant;
use crate::multiply::signed;
use crate::root::reciprocal_root;
use crate::sphere::DistantSphere;
use crate::vec3::{each, zip};

/// Raw bits of a vector.
pub(crate) type Lanes = [i32; 3];

/// A format whose raw bits fit in 32.
trait Lane: Copy {
    fn bits(self) -> i32;
    fn clamped(bits: i32) -> Self;
}

/// `acc / 2^shift`, to nearest, halves upwards.
#[inline]
const fn round_shift(acc: i64, shift: u32) -> i64 {
    (acc >> shift).wrapping_add((acc >> (shift - 1)) & 1)
}

/// The dot product in twice the fraction bits, exact.
#[inline]
pub(crate) fn dot(a: Lanes, b: Lanes) -> i64 {
    let [x, y, z] = zip(a, b, signed);
    x.wrapping_add(y).wrapping_add(z)
}

/// A wide scalar of `2 F` fraction bits in Q31.
#[inline]
const fn q31<const F: u32>(scalar: i64) -> i64 {
    if 2 * F > 31 { round_shift(scalar, 2 * F - 31) } else { scalar << (31 - 2 * F) }
}

/// `a x - b y` with `a`, `b` wide: products in Q(31 + F), rounded to QF once.
#[inline]
pub(crate) fn diff<const F: u32>(a: i64, x: Lanes, b: i64, y: Lanes) -> Lanes {
    let (a, b) = (q31::<F>(a), q31::<F>(b));
    zip(x, y, |x, y| saturate(round_shift(product(a, x).wrapping_sub(product(b, y)), 31)))
}

#[inline]
fn product(scalar: i64, lane: i32) -> i64 {
    scalar.wrapping_mul(i64::from(lane))
}

/// The nearest number of 32 bits.
#[inline]
pub(crate) fn saturate(lane: i64) -> i32 {
    lane.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
}

/// Shifts the largest lane into [1/2, 1) where it is smaller.
#[inline]
pub(crate) fn magnify<const F: u32>(v: Lanes) -> (Lanes, u32) {
    let size = v[0].unsigned_abs() | v[1].unsigned_abs() | v[2].unsigned_abs();
    let shift = (size | 1).leading_zeros().saturating_sub(32 - F);
    (each(v, |lane| lane << shift), shift)
}

/// `1 / sqrt(square)` as a Q31 mantissa in [1, 2) and the half exponent `h`: `mantissa 2^(h - 63)` in units of lanes.
#[inline]
fn unit(square: u64) -> (u64, u32) {
    let even = square.leading_zeros() & !1;
    (u64::from(reciprocal_root(((square << even) >> 32) as u32)), even / 2)
}

/// `l - versine l + s length / |s|`: the factor of `s` in Q32, sums in Q(32 + F), rounded to QF once.
#[inline]
pub(crate) fn rim<const F: u32>(l: Lanes, versine: i64, s: Lanes, square: u64, length: i64) -> Lanes {
    let (mantissa, half) = unit(square | 1);
    // A Q31 length times a Q31 mantissa, less the 63 - F bits that turn lanes into units, but for the bit that Q32
    // has more.
    let k = (q31::<F>(length) as u64).wrapping_mul(mantissa) >> (62 - F - half);
    let remain = (1_i64 << 32).wrapping_sub(q31::<F>(versine).wrapping_mul(2));
    zip(l, s, |l, s| saturate(round_shift(product(remain, l).wrapping_add(product(k as i64, s)), 32)))
}

/// `v` at unit length; zero where `v` is zero.
#[inline]
pub(crate) fn normalize<const F: u32>(v: Lanes) -> Lanes {
    let square = dot(v, v) as u64;
    if square == 0 {
        return [0; 3];
    }
    let (mantissa, half) = unit(square);
    each(v, |lane| saturate(round_shift(product(mantissa as i64, lane), 63 - F - half)))
}

/// Squared sine and cosines of the half vector from integers alone: cross and dot products are exact.
#[inline]
pub(crate) fn halfway<const F: u32>(n: Lanes, l: Lanes, v: Lanes, gain: Scaled, in_plane: bool) -> Halfway<Scaled> {
    let (exponent, twice) = const { (-(F as i32), -2 * F as i32) };
    let sum = zip(l, v, |l, v| i64::from(l) + i64::from(v));
    let square = sum_of_squares(each(sum, |lane| Scaled::from_bits(lane, exponent)));
    let quarter = Scaled::from_bits(1, -2);
    let v_dot_h_square = square * quarter;
    if !positive(v_dot_h_square) {
        return Halfway { v_dot_h_square: Scaled::ZERO, tilt: Scaled::ZERO, in_plane: Scaled::ZERO };
    }
    let gain_square = gain * gain;
    let scaled = |bits| Scaled::from_bits(bits, twice);
    let limit = most_tilt();
    // Products of 32 bits, a machine's own, are fewer than those with a sum, which may have 33.
    let turned = zip(cross(n, l), cross(n, v), i64::wrapping_add);
    let tilt = at_most(sum_of_squares(each(turned, scaled)) / square * gain_square, limit);
    if !in_plane {
        return Halfway { v_dot_h_square, tilt, in_plane: Scaled::ZERO };
    }
    let lacking = zip(l, v, |l, v| i64::from(l) - i64::from(v));
    let across = sum_of_squares(each(lacking, |lane| Scaled::from_bits(lane, exponent)));
    let in_plane = if across > Scaled::ZERO {
        let along = scaled(dot(n, l).wrapping_sub(dot(n, v)));
        at_most(along * along / across * gain_square, tilt)
    } else {
        tilt * Scaled::from_bits(1, -1)
    };
    Halfway { v_dot_h_square, tilt, in_plane }
}

#[inline]
fn sum_of_squares([x, y, z]: [Scaled; 3]) -> Scaled {
    x * x + y * y + z * z
}

#[inline]
fn cross(a: Lanes, b: Lanes) -> [i64; 3] {
    let minor = |p, q, r, s| signed(p, q).wrapping_sub(signed(r, s));
    [minor(a[1], b[2], a[2], b[1]), minor(a[2], b[0], a[0], b[2]), minor(a[0], b[1], a[1], b[0])]
}

/// A wide constant in `fraction` fraction bits.
pub(crate) const fn wide_i64<const FRACTION: u32>(value: f64) -> i64 {
    constant::to_fixed(value, FRACTION)
}

/// A wide constant in 32 bits.
pub(crate) const fn wide_i32<const FRACTION: u32>(value: f64) -> i32 {
    let bits = constant::to_fixed(value, FRACTION);
    if bits > i32::MAX as i64 {
        i32::MAX
    } else if bits < i32::MIN as i64 {
        i32::MIN
    } else {
        bits as i32
    }
}

// A macro, since the blanket implementation for floats leaves no room for a second generic one: the compiler cannot
// rule out that somebody makes `FixedI32<TheirFraction>` a `Float`.
macro_rules! fixed_point {
    ($format:ty, $name:literal, $lane:ty, $wide:ty, $unsigned:ty, $level:ty, $fraction:literal, $constant:path, $by_hand:ident) => {
        impl Lane for $format {
            #[inline]
            fn bits(self) -> i32 {
                i32::from(self.to_bits())
            }

            #[inline]
            fn clamped(bits: i32) -> Self {
                Self::from_bits(bits.clamp(<$lane>::MIN.into(), <$lane>::MAX.into()) as $lane)
            }
        }

        impl Real for $format {
            type Wide = $wide;

            type Scalar = Scaled;

            type Level = $level;

            const NAME: &'static str = $name;

            const ZERO: Self = <$format>::ZERO;

            const WIDE_ZERO: $wide = 0;

            const WIDE_ONE: $wide = 1 << (2 * $fraction);

            const WIDE_MAX: $wide = <$wide>::MAX;

            const STEEP: [$wide; 2] = [$constant(-STEEP_COSINE), $constant(STEEP_COSINE)];

            fn from_f64(value: f64) -> Self {
                Self::clamped(saturate(constant::to_fixed(value, $fraction)))
            }

            fn to_f64(self) -> f64 {
                f64::from(self.to_bits()) / f64::from(1_u32 << $fraction)
            }

            fn wide(value: f64) -> $wide {
                $constant(value)
            }

            #[inline]
            fn add(a: Self, b: Self) -> Self {
                a.saturating_add(b)
            }

            #[inline]
            fn sub(a: Self, b: Self) -> Self {
                a.saturating_sub(b)
            }

            #[inline]
            fn scalar(wide: $wide) -> Scaled {
                Scaled::from_bits(wide.into(), -2 * $fraction)
            }

            #[inline]
            fn narrow(scalar: Scaled) -> $wide {
                scalar.to_bits(2 * $fraction).clamp(<$wide>::MIN.into(), <$wide>::MAX.into()) as $wide
            }

            #[inline]
            fn of_lane(lane: Self) -> Scaled {
                Scaled::from_i32(lane.to_bits().into(), -$fraction)
            }

            #[inline]
            fn lane(scalar: Scaled) -> Self {
                Self::clamped(scalar.to_i32($fraction))
            }

            #[inline]
            fn level(scalar: Scaled) -> $level {
                let bits = scalar.to_unsigned(<$level>::FRAC_NBITS);
                <$level>::from_bits(bits.try_into().unwrap_or(<$level>::MAX.to_bits()))
            }

            #[inline]
            fn of_level(level: $level) -> Scaled {
                Scaled::from_unsigned(level.to_bits().into(), -(<$level>::FRAC_NBITS as i32))
            }

            #[inline]
            fn dot(a: [Self; 3], b: [Self; 3]) -> $wide {
                dot(each(a, Lane::bits), each(b, Lane::bits)) as $wide
            }

            #[inline]
            fn twice(a: $wide) -> $wide {
                a.wrapping_mul(2)
            }

            #[inline]
            fn diff(a: $wide, x: [Self; 3], b: $wide, y: [Self; 3]) -> [Self; 3] {
                each(diff::<$fraction>(a.into(), each(x, Lane::bits), b.into(), each(y, Lane::bits)), Lane::clamped)
            }

            #[inline]
            fn magnify(v: [Self; 3]) -> ([Self; 3], u32) {
                let (v, exponent) = magnify::<$fraction>(each(v, Lane::bits));
                (each(v, Lane::clamped), exponent)
            }

            #[inline]
            fn square(v: [Self; 3]) -> $wide {
                Self::dot(v, v)
            }

            fn square_of(length: f64) -> $wide {
                $constant(length * length)
            }

            #[inline]
            fn within(square: $wide, exponent: u32, limit: $wide) -> bool {
                (square as $unsigned).checked_shr(exponent << 1).unwrap_or(0) <= limit as $unsigned
            }

            #[inline]
            fn rim(l: [Self; 3], versine: $wide, s: [Self; 3], square: $wide, length: $wide) -> [Self; 3] {
                let square = u64::from(square as $unsigned);
                let (l, s) = (each(l, Lane::bits), each(s, Lane::bits));
                each(rim::<$fraction>(l, versine.into(), s, square, length.into()), Lane::clamped)
            }

            #[inline]
            fn normalize(v: [Self; 3]) -> [Self; 3] {
                each($by_hand::normalize(each(v, Lane::bits)), Lane::clamped)
            }

            #[inline]
            fn cap(l: [Self; 3], r: [Self; 3], light: &DistantSphere<Self>) -> [Self; 3] {
                $by_hand::cap(l, r, light)
            }

            #[inline]
            fn halfway(n: [Self; 3], l: [Self; 3], v: [Self; 3], gain: Scaled, in_plane: bool) -> Halfway<Scaled> {
                let [n, l, v] = [each(n, Lane::bits), each(l, Lane::bits), each(v, Lane::bits)];
                halfway::<$fraction>(n, l, v, gain, in_plane)
            }
        }

        const _: () = {
            /// Compiles only where the format holds 1.
            const ONE: $format = <$format>::ONE;
            assert!(ONE.to_bits() == 1 << $fraction);
        };
    };
}

fixed_point!(I2F14, "I2F14", i16, i32, u32, U16F16, 14, wide_i32::<28>, q14);
fixed_point!(I2F30, "I2F30", i32, i64, u64, U32F32, 30, wide_i64::<60>, q30);
fixed_point!(I16F16, "I16F16", i32, i64, u64, U16F16, 16, wide_i64::<32>, q16);
