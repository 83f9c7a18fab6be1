//! The functions of [`raw`](crate::raw) for C and other languages: raw bits and plain structs by value, no allocation, no
//! `errno`, nothing that panics. The header is `src/capi/sunglint.h`, made of this module's documentation.
//!
//! Constructors return what they made beside a [`Status`]. Vectors are Q14 (16384 is 1) or Q30 (1073741824 is 1).

mod directions;
#[cfg(freestanding)]
mod freestanding;
mod plain;
mod status;

pub use directions::*;
pub use plain::{SphereQ14, SphereQ30, VectorQ14, VectorQ30};
pub use status::{SphereQ14Made, SphereQ30Made, Status};
