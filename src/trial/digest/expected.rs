//! The hashes after [`super::CASES`] and after [`super::FEW`].
//!
//! Where a change alters results on purpose, `cargo test --test digest` prints the lines that change.

pub(super) const I2F14: [u64; 2] = [0x7076f62c5db4232b, 0x137362f797fdeea2];
pub(super) const I2F30: [u64; 2] = [0xbd3ab37a5f8a0734, 0xb34e201a3c516de1];
pub(super) const I16F16: [u64; 2] = [0xa26a774ebb8402c1, 0x63a1decec9db5e33];
pub(super) const INTEGERS: [u64; 2] = [0x756c7b82739a0e2a, 0xa092b7743419f5df];
pub(super) const F64: [u64; 2] = [0xd32f2a2b3b4dd913, 0x44185187ebc04cec];
pub(super) const F32: [u64; 2] = [0x3fd7f62219862118, 0x16352e03970ccc43];
pub(super) const MICROMATH: [u64; 2] = [0xbfa246709d3cad31, 0x5e9df3d52356f977];
pub(super) const F16: [u64; 2] = [0x21426bc04199c77f, 0x0aeb2c0dcda9afd8];
