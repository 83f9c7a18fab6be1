//! What others make of the jobs that sunglint does.
//!
//! Development only: their versions are pinned here, and none of them is a dependency of the crate.

#![cfg_attr(not(feature = "host"), no_std)]

#[cfg(feature = "host")]
pub mod callgrind;
// The study's own clock, so that costs mean the same here and there.
#[cfg(feature = "host")]
#[allow(dead_code)]
#[path = "../../../src/bin/sunglint/clock.rs"]
pub mod clock;
#[cfg(feature = "host")]
pub mod contest;
#[cfg(feature = "host")]
pub mod glam_f32;
#[cfg(feature = "host")]
pub mod kernel_error;
pub mod kernels;
#[cfg(feature = "host")]
pub mod throughput;
#[cfg(feature = "host")]
pub mod vector_error;
