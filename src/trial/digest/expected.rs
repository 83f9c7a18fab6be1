//! The hashes after [`super::CASES`] and after [`super::FEW`].
//!
//! Where a change alters results on purpose, `cargo test --test digest` prints the lines that change.

pub(super) const I2F14: [u64; 2] = [0xeb13a8f46ae7e685, 0x8a7a8c98a50407ba];
pub(super) const I2F30: [u64; 2] = [0x482255e4a7f12a45, 0xb18b8f2d5140fbe5];
pub(super) const I16F16: [u64; 2] = [0xddbb48c33f384793, 0xeaf3f463addc999f];
pub(super) const INTEGERS: [u64; 2] = [0xe20a7c3f1c4f14ac, 0x1a02198814880fe0];
pub(super) const F64: [u64; 2] = [0x79d458e53895ab98, 0x27d21706eac60956];
pub(super) const F32: [u64; 2] = [0x0f279b2d817fe48c, 0xb42d73c6fcdca258];
pub(super) const MICROMATH: [u64; 2] = [0xf47ce5297bed882d, 0xfa9ff887434c2195];
pub(super) const F16: [u64; 2] = [0x8ce6e569589bae23, 0x8eb201aa3b7b8494];
