//! One number that says whether a machine, a compiler or a change alters a single bit of a result.
//!
//! Pseudo-random and hard inputs, made in integers, go through every function of a format, and the bits of all results
//! into a hash. `tests/digest.rs` asserts it in debug and release, `tests/firmware` on microcontrollers, Miri on a
//! big-endian and a 32-bit machine.

mod calls;
mod expected;
mod hash;
mod source;

use fixed::types::{I2F14, I2F30, I16F16};
use half::f16;
use micromath::F32;

use hash::Bits;
use source::{Digested, Source};

pub use hash::Digest;

/// Cases of each digest: together above a million results in fixed point.
pub const CASES: u32 = 3_000;

/// Cases for Miri, which takes a thousand times longer.
pub const FEW: u32 = 4;

/// One of the digests, by name.
#[derive(Clone, Copy, Debug)]
pub struct Digester {
    /// The format, or what else is digested.
    pub name: &'static str,
    /// Hash after [`CASES`] and after [`FEW`].
    pub expected: [u64; 2],
    digest: fn(u32) -> Digest,
}

impl Digester {
    /// The digest of the first `cases`.
    pub fn digest(&self, cases: u32) -> Digest {
        (self.digest)(cases)
    }
}

/// In integers alone at run time.
pub const FIXED_POINT: [Digester; 4] = [
    Digester { name: "I2F14", expected: expected::I2F14, digest: of_format::<I2F14> },
    Digester { name: "I2F30", expected: expected::I2F30, digest: of_format::<I2F30> },
    Digester { name: "I16F16", expected: expected::I16F16, digest: of_format::<I16F16> },
    Digester { name: "integers", expected: expected::INTEGERS, digest: of_integers },
];

/// By the machine's float instructions or the compiler's replacement of them: IEEE's arithmetic, but for which NaN.
pub const FLOATS: [Digester; 4] = [
    Digester { name: "f64", expected: expected::F64, digest: of_format::<f64> },
    Digester { name: "f32", expected: expected::F32, digest: of_format::<f32> },
    Digester { name: "micromath", expected: expected::MICROMATH, digest: of_format::<F32> },
    Digester { name: "f16", expected: expected::F16, digest: of_format::<f16> },
];

fn of_format<T: Digested>(cases: u32) -> Digest {
    let mut digest = Digest::EMPTY;
    let mut source = Source(1);
    for _ in 0..cases {
        calls::directions::<T>(&mut source, &mut digest);
        calls::diffuse::<T>(&mut source, &mut digest);
        calls::sampling::<T>(&mut source, &mut digest);
        calls::highlights::<T>(&mut source, &mut digest);
        calls::scene::<T>(&mut source, &mut digest);
        calls::radiometry::<T>(&mut source, &mut digest);
        calls::black_body::<T::Scalar>(&mut source, &mut digest);
        let quantity: T::Scalar = source.quantity();
        T::lane(quantity).add_to(&mut digest);
        T::narrow(quantity).add_to(&mut digest);
        T::level(quantity).add_to(&mut digest);
    }
    digest
}

/// What is of no one format: normalisation in integers, numbers of wide range, Planck's law; and whole pixels on bits.
fn of_integers(cases: u32) -> Digest {
    let mut digest = Digest::EMPTY;
    let mut source = Source(2);
    for _ in 0..cases {
        calls::normalization(&mut source, &mut digest);
        calls::scaled(&mut source, &mut digest);
        calls::pixel(&mut source, &mut digest);
    }
    digest
}
