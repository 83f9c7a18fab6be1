//! Structs as C has them.

use crate::raw;

/// A vector in Q14: 16384 is 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VectorQ14 {
    /// First lane.
    pub x: i16,
    /// Second lane.
    pub y: i16,
    /// Third lane.
    pub z: i16,
}

/// A vector in Q30: 1073741824 is 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VectorQ30 {
    /// First lane.
    pub x: i32,
    /// Second lane.
    pub y: i32,
    /// Third lane.
    pub z: i32,
}

/// A light's constants for Q14 vectors, each in Q28.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SphereQ14 {
    /// Sine of the angular radius, which is radius over distance.
    pub sin: i32,
    /// Its square.
    pub sin_square: i32,
    /// Least cosine of a direction inside the disc.
    pub cos: i32,
    /// `1 - cos`.
    pub versine: i32,
}

/// A light's constants for Q30 vectors, each in Q60.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SphereQ30 {
    /// Sine of the angular radius, which is radius over distance.
    pub sin: i64,
    /// Its square.
    pub sin_square: i64,
    /// Least cosine of a direction inside the disc.
    pub cos: i64,
    /// `1 - cos`.
    pub versine: i64,
}

impl From<[i16; 3]> for VectorQ14 {
    fn from([x, y, z]: [i16; 3]) -> Self {
        Self { x, y, z }
    }
}

impl From<VectorQ14> for [i16; 3] {
    fn from(v: VectorQ14) -> Self {
        [v.x, v.y, v.z]
    }
}

impl From<[i32; 3]> for VectorQ30 {
    fn from([x, y, z]: [i32; 3]) -> Self {
        Self { x, y, z }
    }
}

impl From<VectorQ30> for [i32; 3] {
    fn from(v: VectorQ30) -> Self {
        [v.x, v.y, v.z]
    }
}

impl From<raw::SphereQ14> for SphereQ14 {
    fn from(light: raw::SphereQ14) -> Self {
        Self { sin: light.sin, sin_square: light.sin_square, cos: light.cos, versine: light.versine }
    }
}

impl From<SphereQ14> for raw::SphereQ14 {
    fn from(light: SphereQ14) -> Self {
        Self { sin: light.sin, sin_square: light.sin_square, cos: light.cos, versine: light.versine }
    }
}

impl From<raw::SphereQ30> for SphereQ30 {
    fn from(light: raw::SphereQ30) -> Self {
        Self { sin: light.sin, sin_square: light.sin_square, cos: light.cos, versine: light.versine }
    }
}

impl From<SphereQ30> for raw::SphereQ30 {
    fn from(light: SphereQ30) -> Self {
        Self { sin: light.sin, sin_square: light.sin_square, cos: light.cos, versine: light.versine }
    }
}
