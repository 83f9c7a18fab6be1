//! Light a surface by the Sun, or by any distant sphere, in the arithmetic that the machine has.
#![cfg_attr(not(test), no_std)]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod constant;
pub mod highlight;
pub mod light;
pub mod normalization;
#[cfg(feature = "oracle")]
pub mod oracle;
mod pair;
#[cfg(feature = "fixed")]
pub mod raw;
pub mod real;
#[cfg(feature = "fixed")]
mod root;
pub mod specular;
pub mod sphere;
#[cfg(feature = "oracle")]
pub mod trial;
mod vec3;

pub use light::{DistantLight, LightError, SUN};
pub use real::{Float, Real};
pub use specular::{cap, disc, epic, factored, normalize, reflect};
pub use sphere::{DistantSphere, UnfactoredSphere};
