//! Vectors of the crate `mint`, by which mathematics crates exchange theirs.

use mint::{IntoMint, Vector3};

use super::{VectorF32, VectorQ14, VectorQ30};

impl From<Vector3<i16>> for VectorQ14 {
    fn from(v: Vector3<i16>) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl From<VectorQ14> for Vector3<i16> {
    fn from(v: VectorQ14) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl IntoMint for VectorQ14 {
    type MintType = Vector3<i16>;
}

impl From<Vector3<i32>> for VectorQ30 {
    fn from(v: Vector3<i32>) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl From<VectorQ30> for Vector3<i32> {
    fn from(v: VectorQ30) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl IntoMint for VectorQ30 {
    type MintType = Vector3<i32>;
}

impl From<Vector3<f32>> for VectorF32 {
    fn from(v: Vector3<f32>) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl From<VectorF32> for Vector3<f32> {
    fn from(v: VectorF32) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl IntoMint for VectorF32 {
    type MintType = Vector3<f32>;
}
