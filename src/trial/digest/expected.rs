//! The hashes after [`super::CASES`] and after [`super::FEW`].
//!
//! Where a change alters results on purpose, `cargo test --test digest` prints the lines that change.

pub(super) const I2F14: [u64; 2] = [0x7076f62c5db4232b, 0xc7f2394c1ddfdc5c];
pub(super) const I2F30: [u64; 2] = [0xbd3ab37a5f8a0734, 0x43c2aeae81715508];
pub(super) const I16F16: [u64; 2] = [0xa26a774ebb8402c1, 0xb7dddb1a3092dbf9];
pub(super) const INTEGERS: [u64; 2] = [0x756c7b82739a0e2a, 0x193ba4b18e977311];
pub(super) const F64: [u64; 2] = [0xd32f2a2b3b4dd913, 0xb2fd092e168c3c23];
pub(super) const F32: [u64; 2] = [0x3fd7f62219862118, 0xead48c69fbaa7f67];
pub(super) const MICROMATH: [u64; 2] = [0xbfa246709d3cad31, 0x7982c0182bb9a889];
pub(super) const F16: [u64; 2] = [0x21426bc04199c77f, 0x251b7dc838ea0e65];
