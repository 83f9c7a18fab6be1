//! What C holds and passes but does not look into: the Rust types themselves, which the header declares as so many words.
//!
//! Sound though C's fields are others: sizes and alignments are the same, asserted here for every target; the structs are
//! passed by pointer and returned by value, for which every C ABI uses memory that the caller provides once a struct is
//! larger than 16 bytes (x86-64, AArch64; 8 on arm and riscv32, one scalar on wasm32) whatever its fields.

use core::ffi::c_void;

use super::{VectorQ14, VectorQ30};
use crate::raw;

/// The directions to a light for Q14 vectors, as `sunglint_cone_q14` makes them; of no use to any other function if its
/// words are others.
pub type ConeQ14 = raw::ConeQ14;

/// The directions to a light for Q30 vectors, as `sunglint_cone_q30` makes them; of no use to any other function if its
/// words are others.
pub type ConeQ30 = raw::ConeQ30;

/// A material under one light, as `sunglint_pixel_q14` makes it. All words zero is black.
pub type PixelQ14 = raw::PixelQ14;

/// Asked whether the way from the surface into `direction` is free; `user` is what the caller gave.
pub type SeesQ14 = Option<extern "C" fn(direction: VectorQ14, user: *mut c_void) -> bool>;

/// Asked whether the way from the surface into `direction` is free; `user` is what the caller gave.
pub type SeesQ30 = Option<extern "C" fn(direction: VectorQ30, user: *mut c_void) -> bool>;

/// Whether a type is so many words of 32 bits.
const fn is_words<T>(words: usize) -> bool {
    size_of::<T>() == 4 * words && align_of::<T>() == align_of::<u32>()
}

const _: () = assert!(is_words::<ConeQ14>(19) && is_words::<ConeQ30>(24) && is_words::<PixelQ14>(41));
