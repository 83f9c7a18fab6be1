//! The hashes after [`super::CASES`] and after [`super::FEW`].
//!
//! Where a change alters results on purpose, `cargo test --test digest` prints the lines to put here.

pub(super) const I2F14: [u64; 2] = [0xc5834f240ceceaf1, 0x33be619405bfaffd];
pub(super) const I2F30: [u64; 2] = [0x0776d6626f4b78dd, 0xcbfe28f86b093fdb];
pub(super) const I16F16: [u64; 2] = [0x1bae2f16eb05e821, 0xbea2aff61b05e01c];
pub(super) const INTEGERS: [u64; 2] = [0x756c7b82739a0e2a, 0xa092b7743419f5df];
pub(super) const F64: [u64; 2] = [0x31248c42af25107b, 0x6a41deebb197a502];
pub(super) const F32: [u64; 2] = [0xf7bd77ed4252a9a4, 0xe90f683e1d2eb923];
pub(super) const MICROMATH: [u64; 2] = [0x1475c11755bc81db, 0x210af1ac41306758];
pub(super) const F16: [u64; 2] = [0x5ecb45666153ca09, 0xc072ab9d94882d24];
