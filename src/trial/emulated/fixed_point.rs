//! Fixed point of any number of fraction bits, in as many bits as two more.

use fixed::types::U32F32;

use crate::constant;
use crate::real::fixed::{Lanes, diff, dot, halfway, magnify, normalize, rim, saturate};
use crate::real::{Halfway, Real, STEEP_COSINE, Scaled};
use crate::vec3::each;

/// A number of two integer bits, the sign one of them, and `FRACTION` fraction bits (6 to 30): what I2F14 and I2F30 are
/// of 14 and 30.
///
/// The arithmetic is the formulas' that all fixed-point formats share: products and their sums are exact in a wide
/// accumulator, lanes are rounded once, halves upwards. What I2F14 and I2F30 do by hand in `cap` and `normalize` is not
/// for other words; `tests/emulated.rs` compares the rest bit for bit.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct FixedPoint<const FRACTION: u32>(i32);

/// The nearest number of `bits` bits, the sign included.
#[inline]
const fn clamped(value: i64, bits: u32) -> i64 {
    let most = i64::MAX >> (64 - bits);
    if value > most {
        most
    } else if value < -most - 1 {
        -most - 1
    } else {
        value
    }
}

impl<const FRACTION: u32> FixedPoint<FRACTION> {
    /// Bits of an accumulator: 32 beside I2F14, 64 beside I2F30.
    const WIDE_BITS: u32 = 2 * FRACTION + 4;

    /// Fraction bits of a light level: those of U16F16 beside I2F14, of U32F32 beside I2F30.
    const LEVEL_FRACTION: u32 = if FRACTION > 16 { 32 } else { 16 };

    /// The nearest number; every number is made here, so that no lane has more bits than the word.
    #[inline]
    const fn lane_of(bits: i32) -> Self {
        const { assert!(FRACTION >= 6 && FRACTION <= 30) }
        Self(clamped(bits as i64, FRACTION + 2) as i32)
    }

    /// What an accumulator keeps of a sum: the low bits.
    #[inline]
    const fn wrapped(wide: i64) -> i64 {
        let spare = const { 64 - Self::WIDE_BITS };
        (wide << spare) >> spare
    }

    /// The bits of an accumulator without their sign.
    #[inline]
    const fn unsigned(wide: i64) -> u64 {
        (wide as u64) & const { u64::MAX >> (64 - Self::WIDE_BITS) }
    }

    /// The nearest accumulator to a constant.
    const fn constant(value: f64) -> i64 {
        clamped(constant::to_fixed(value, 2 * FRACTION), Self::WIDE_BITS)
    }

    #[inline]
    fn bits(v: [Self; 3]) -> Lanes {
        each(v, |lane| lane.0)
    }

    #[inline]
    fn lanes(bits: Lanes) -> [Self; 3] {
        each(bits, Self::lane_of)
    }
}

impl<const FRACTION: u32> Real for FixedPoint<FRACTION> {
    type Wide = i64;

    type Scalar = Scaled;

    type Level = U32F32;

    const NAME: &'static str = "emulated fixed point";

    const ZERO: Self = Self(0);

    const WIDE_ZERO: i64 = 0;

    const WIDE_ONE: i64 = 1 << (2 * FRACTION);

    const WIDE_MAX: i64 = i64::MAX >> (64 - Self::WIDE_BITS);

    const STEEP: [i64; 2] = [Self::constant(-STEEP_COSINE), Self::constant(STEEP_COSINE)];

    fn from_f64(value: f64) -> Self {
        Self::lane_of(saturate(constant::to_fixed(value, FRACTION)))
    }

    fn to_f64(self) -> f64 {
        f64::from(self.0) / f64::from(1_u32 << FRACTION)
    }

    fn wide(value: f64) -> i64 {
        Self::constant(value)
    }

    #[inline]
    fn add(a: Self, b: Self) -> Self {
        Self::lane_of(a.0.saturating_add(b.0))
    }

    #[inline]
    fn sub(a: Self, b: Self) -> Self {
        Self::lane_of(a.0.saturating_sub(b.0))
    }

    #[inline]
    fn scalar(wide: i64) -> Scaled {
        Scaled::from_bits(wide, -2 * FRACTION as i32)
    }

    #[inline]
    fn narrow(scalar: Scaled) -> i64 {
        clamped(scalar.to_bits(2 * FRACTION), Self::WIDE_BITS)
    }

    #[inline]
    fn of_lane(lane: Self) -> Scaled {
        Scaled::from_i32(lane.0, -(FRACTION as i32))
    }

    #[inline]
    fn lane(scalar: Scaled) -> Self {
        Self::lane_of(scalar.to_i32(FRACTION))
    }

    #[inline]
    fn level(scalar: Scaled) -> U32F32 {
        let bits = scalar.to_unsigned(Self::LEVEL_FRACTION);
        let most = u64::MAX >> (64 - 2 * Self::LEVEL_FRACTION);
        U32F32::from_bits(bits.min(most) << (32 - Self::LEVEL_FRACTION))
    }

    #[inline]
    fn of_level(level: U32F32) -> Scaled {
        Scaled::from_unsigned(level.to_bits(), -32)
    }

    #[inline]
    fn dot(a: [Self; 3], b: [Self; 3]) -> i64 {
        Self::wrapped(dot(Self::bits(a), Self::bits(b)))
    }

    #[inline]
    fn twice(a: i64) -> i64 {
        Self::wrapped(a.wrapping_mul(2))
    }

    #[inline]
    fn diff(a: i64, x: [Self; 3], b: i64, y: [Self; 3]) -> [Self; 3] {
        Self::lanes(diff::<FRACTION>(a, Self::bits(x), b, Self::bits(y)))
    }

    #[inline]
    fn magnify(v: [Self; 3]) -> ([Self; 3], u32) {
        let (v, exponent) = magnify::<FRACTION>(Self::bits(v));
        (Self::lanes(v), exponent)
    }

    #[inline]
    fn square(v: [Self; 3]) -> i64 {
        Self::dot(v, v)
    }

    fn square_of(length: f64) -> i64 {
        Self::constant(length * length)
    }

    #[inline]
    fn within(square: i64, exponent: u32, limit: i64) -> bool {
        Self::unsigned(square).checked_shr(exponent << 1).unwrap_or(0) <= Self::unsigned(limit)
    }

    #[inline]
    fn rim(l: [Self; 3], versine: i64, s: [Self; 3], square: i64, length: i64) -> [Self; 3] {
        Self::lanes(rim::<FRACTION>(Self::bits(l), versine, Self::bits(s), Self::unsigned(square), length))
    }

    #[inline]
    fn normalize(v: [Self; 3]) -> [Self; 3] {
        Self::lanes(normalize::<FRACTION>(Self::bits(v)))
    }

    #[inline]
    fn halfway(n: [Self; 3], l: [Self; 3], v: [Self; 3], gain: Scaled, in_plane: bool) -> Halfway<Scaled> {
        halfway::<FRACTION>(Self::bits(n), Self::bits(l), Self::bits(v), gain, in_plane)
    }
}
