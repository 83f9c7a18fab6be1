//! The functions of [`raw`](crate::raw) for C and other languages: raw bits and plain structs by value, no allocation,
//! no `errno`, nothing that panics. The header is `src/capi/sunglint.h`, made of this module's documentation by
//! `tests/embedding/tests/header.rs`.
//!
//! Constructors return what they made beside a [`Status`]. Vectors are Q14 (16384 is 1) or Q30 (1073741824 is 1), of
//! length 1 give or take a rounding. Names and bits are those of `raw` and [`soft`](crate::soft): `tests/capi.rs` holds
//! them to it.

mod blackbody;
mod diffuse;
mod directions;
#[cfg(freestanding)]
mod freestanding;
mod opaque;
mod pixel;
mod radiometry;
mod sampling;
mod soft;
mod status;

pub use blackbody::*;
pub use diffuse::*;
pub use directions::*;
pub use opaque::*;
pub use pixel::*;
pub use radiometry::*;
pub use sampling::*;
pub use soft::*;
pub use status::*;

pub use crate::plain::*;
