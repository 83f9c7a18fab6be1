//! The hashes after [`super::CASES`] and after [`super::FEW`].
//!
//! Where a change alters results on purpose, `cargo test --test digest` prints the lines that change.

pub(super) const I2F14: [u64; 2] = [0x1894a4e8cf1a61f1, 0x6ca9c9792b3b1087];
pub(super) const I2F30: [u64; 2] = [0x0d032338f04fa77b, 0x7e63b5d579da0cf3];
pub(super) const I16F16: [u64; 2] = [0xcb5df803de4d0675, 0xeaf3f463addc999f];
pub(super) const INTEGERS: [u64; 2] = [0xbc91ec5298e9e04f, 0xde287a7a603b2d7d];
pub(super) const F64: [u64; 2] = [0x79d458e53895ab98, 0x27d21706eac60956];
pub(super) const F32: [u64; 2] = [0x0f279b2d817fe48c, 0xb42d73c6fcdca258];
pub(super) const MICROMATH: [u64; 2] = [0x955dec44abeb6567, 0xfa9ff887434c2195];
pub(super) const F16: [u64; 2] = [0x7e434c8f8f51767b, 0x8eb201aa3b7b8494];
