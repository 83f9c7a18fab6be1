//! A hash over results' bits, the same on every machine.

use fixed::types::{I2F14, I2F30, I16F16, U16F16, U16F48, U32F32, U52F12};
use half::f16;
use micromath::F32;

use crate::real::Scaled;

/// A multiplicative hash, and how many results it is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest {
    /// The hash.
    pub hash: u64,
    /// How many results, each a lane, a scalar or a level.
    pub results: u32,
}

impl Digest {
    /// Of nothing.
    pub(super) const EMPTY: Self = Self { hash: 0xcbf2_9ce4_8422_2325, results: 0 };

    /// Takes in a result.
    pub(super) fn add(&mut self, bits: u64) {
        // The low bits of short numbers are zero: rotated, all bits count.
        self.hash = (self.hash.rotate_left(23) ^ bits).wrapping_mul(0x0100_0000_01b3);
        self.results = self.results.wrapping_add(1);
    }
}

/// What can be hashed.
pub trait Bits {
    /// Takes the bits in.
    fn add_to(self, digest: &mut Digest);
}

// A macro, since each type has its own `to_bits`.
macro_rules! bits {
    ($($type:ty: $value:ident => $bits:expr;)*) => {
        $(impl Bits for $type {
            fn add_to(self, digest: &mut Digest) {
                let $value = self;
                digest.add($bits);
            }
        })*
    };
}

bits! {
    bool: value => value.into();
    i32: value => value as u64;
    i64: value => value as u64;
    u64: value => value;
    I2F14: value => value.to_bits() as u64;
    I2F30: value => value.to_bits() as u64;
    I16F16: value => value.to_bits() as u64;
    U16F16: value => value.to_bits().into();
    U32F32: value => value.to_bits();
    U16F48: value => value.to_bits();
    U52F12: value => value.to_bits();
    // Which NaN it is, machines do not agree upon.
    f64: value => if value.is_nan() { u64::MAX } else { value.to_bits() };
    f32: value => if value.is_nan() { u64::MAX } else { value.to_bits().into() };
    F32: value => if value.0.is_nan() { u64::MAX } else { value.0.to_bits().into() };
    f16: value => if value.is_nan() { u64::MAX } else { value.to_bits().into() };
}

impl Bits for Scaled {
    fn add_to(self, digest: &mut Digest) {
        let (mantissa, exponent) = self.parts();
        digest.add((u64::from(mantissa as u32) << 32) | u64::from(exponent as u32));
    }
}

impl<B: Bits, const N: usize> Bits for [B; N] {
    fn add_to(self, digest: &mut Digest) {
        self.into_iter().for_each(|bits| bits.add_to(digest));
    }
}

/// An error is a result too; which one it is, its tests say.
impl<B: Bits, E> Bits for Result<B, E> {
    fn add_to(self, digest: &mut Digest) {
        digest.add(self.is_ok().into());
        if let Ok(bits) = self {
            bits.add_to(digest);
        }
    }
}
