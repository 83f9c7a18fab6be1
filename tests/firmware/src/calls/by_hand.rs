//! What has a function of its own beside the formulas: f32 in integers, a root of raw bits, a pixel in Q14.

use sunglint::raw::{self, PixelQ14, SphereQ30};
use sunglint::scene::Channel;
use sunglint::soft;

/// To the light and along the mirror ray in f32.
pub struct SoftRay {
    pub l: [f32; 3],
    pub r: [f32; 3],
    pub sphere: SphereQ30,
}

/// Normal and viewer.
pub struct Seen {
    pub n: [i16; 3],
    pub v: [i16; 3],
    pub pixel: PixelQ14,
}

pub fn soft_cap(ray: &SoftRay) -> [f32; 3] {
    soft::cap(ray.l, ray.r, &ray.sphere)
}

pub fn soft_reflect([n, v]: &[[f32; 3]; 2]) -> [f32; 3] {
    soft::reflect(*n, *v)
}

pub fn soft_normalize(v: &[f32; 3]) -> [f32; 3] {
    soft::normalize(*v)
}

pub fn soft_root(square: &f32) -> f32 {
    soft::root(*square)
}

pub fn soft_reciprocal_root(square: &f32) -> f32 {
    soft::reciprocal_root(*square)
}

pub fn reciprocal_root_q16(square: &u32) -> u32 {
    raw::reciprocal_root_q16(*square)
}

pub fn pixel_q14(seen: &Seen) -> u32 {
    seen.pixel.shade_channel(seen.n, seen.v, Channel::Red)
}
