//! What C holds and passes but does not look into: the Rust types themselves, which the header declares as so many
//! words.
//!
//! Sound though C's fields are others: sizes and alignments are the same, asserted here for every target. Cones and
//! pixels are passed by pointer; as answers, by themselves or beside a status, they go into memory that the caller
//! provides, as every C ABI has it of structs of integers larger than 32 bytes (arm: 4, riscv32: 8, wasm32: more than
//! one number), whatever the integers.

use core::ffi::c_void;

use super::{VectorQ14, VectorQ30};
use crate::raw;

/// The directions to a light for Q14 vectors. Made by `sunglint_cone_q14` alone; its words are not to be changed. All
/// words zero has zero for its directions and contains every one.
pub type ConeQ14 = raw::ConeQ14;

/// The directions to a light for Q30 vectors. Made by `sunglint_cone_q30` alone; its words are not to be changed. All
/// words zero has zero for its directions and contains every one.
pub type ConeQ30 = raw::ConeQ30;

/// A material under one light, as `sunglint_pixel_q14` makes it. All words zero is black.
pub type PixelQ14 = raw::PixelQ14;

/// Asked whether the way from the surface into `direction` is free; `user` is what the caller gave. It has to
/// return, without an exception or a jump, and may call any function here, but not change the cone.
pub type SeesQ14 = Option<extern "C" fn(direction: VectorQ14, user: *mut c_void) -> bool>;

/// Asked whether the way from the surface into `direction` is free; `user` is what the caller gave. It has to
/// return, without an exception or a jump, and may call any function here, but not change the cone.
pub type SeesQ30 = Option<extern "C" fn(direction: VectorQ30, user: *mut c_void) -> bool>;

/// Whether a type is so many words of 32 bits.
const fn is_words<T>(words: usize) -> bool {
    size_of::<T>() == 4 * words && align_of::<T>() == align_of::<u32>()
}

const _: () = assert!(is_words::<ConeQ14>(19) && is_words::<ConeQ30>(24) && is_words::<PixelQ14>(41));
