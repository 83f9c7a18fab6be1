//! From the arrays that functions take, and back.

use super::{ColourQ16, ColourQ30, SoftShadow, SphereQ14, SphereQ30, VectorF32, VectorQ14, VectorQ30};
use crate::raw;

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

impl From<[f32; 3]> for VectorF32 {
    fn from([x, y, z]: [f32; 3]) -> Self {
        Self { x, y, z }
    }
}

impl From<VectorF32> for [f32; 3] {
    fn from(v: VectorF32) -> Self {
        [v.x, v.y, v.z]
    }
}

impl From<[u32; 3]> for ColourQ16 {
    fn from([red, green, blue]: [u32; 3]) -> Self {
        Self { red, green, blue }
    }
}

impl From<ColourQ16> for [u32; 3] {
    fn from(colour: ColourQ16) -> Self {
        [colour.red, colour.green, colour.blue]
    }
}

impl From<[i32; 3]> for ColourQ30 {
    fn from([red, green, blue]: [i32; 3]) -> Self {
        Self { red, green, blue }
    }
}

impl From<ColourQ30> for [i32; 3] {
    fn from(colour: ColourQ30) -> Self {
        [colour.red, colour.green, colour.blue]
    }
}

impl From<[i32; 2]> for SoftShadow {
    fn from([visible, mean_cosine]: [i32; 2]) -> Self {
        Self { visible, mean_cosine }
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
