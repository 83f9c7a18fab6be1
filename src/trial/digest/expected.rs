//! The hashes after [`super::CASES`] and after [`super::FEW`].
//!
//! Where a change alters results on purpose, `cargo test --test digest` prints the lines that change.

pub(super) const I2F14: [u64; 2] = [0x56cfc504d1d1a792, 0x6ca9c9792b3b1087];
pub(super) const I2F30: [u64; 2] = [0xba852b818141e5d0, 0x7e63b5d579da0cf3];
pub(super) const I16F16: [u64; 2] = [0x64e97966014a9eb8, 0xeaf3f463addc999f];
pub(super) const INTEGERS: [u64; 2] = [0xbc91ec5298e9e04f, 0xde287a7a603b2d7d];
pub(super) const F64: [u64; 2] = [0xa3e15c48be1479a4, 0x27d21706eac60956];
pub(super) const F32: [u64; 2] = [0x3d1310390eb48ba2, 0xb42d73c6fcdca258];
pub(super) const MICROMATH: [u64; 2] = [0x26fe7bed7c07ebb1, 0xfa9ff887434c2195];
pub(super) const F16: [u64; 2] = [0x0ad81212b9823415, 0x8eb201aa3b7b8494];
