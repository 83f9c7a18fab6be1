//! C's statuses by their numbers, which programs are compiled with: written out once more, so that they stay.

/// Made.
pub const OK: u32 = 0;
/// Radius over distance is out of range.
pub const RATIO: u32 = 1;
/// A direction is not of length 1.
pub const DIRECTION: u32 = 2;
/// A diffuse reflectance is out of range.
pub const ALBEDO: u32 = 3;
/// A roughness is out of range.
pub const ALPHA: u32 = 4;
/// A specular reflectance is out of range.
pub const F0: u32 = 5;
/// There is no area.
pub const AREA: u32 = 6;
/// There is no solid angle.
pub const SOLID_ANGLE: u32 = 7;
/// The answer is too great.
pub const OVERFLOW: u32 = 8;
