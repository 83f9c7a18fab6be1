//! The peers' functions for microcontrollers: plain ones, of an input that lies in memory, so that the firmware counts
//! them as it counts sunglint's.

pub mod cordic;
pub mod f32;
pub mod fixed;
pub mod idsp;

/// The authors, as rows have them: names and versions.
pub const LIBM: &str = "libm 0.2.16";
/// micromath's approximations.
pub const MICROMATH: &str = "micromath 2.1.0";
/// The operators and the root of the crate `fixed`.
pub const FIXED: &str = "fixed 1.31.0";
/// CORDIC over `fixed`.
pub const CORDIC: &str = "cordic 0.1.5";
/// Signal processing in integers.
pub const IDSP: &str = "idsp 0.23.1";
