//! How bright the gloss is, and the whole pixel.

use sunglint::Real;
use sunglint::highlight::{Gloss, Highlight};
use sunglint::scene::{Channel, Scene};

/// Normal, viewer and light, and a method's constants.
pub struct Glossy<T, H> {
    pub n: [T; 3],
    pub v: [T; 3],
    pub l: [T; 3],
    pub highlight: H,
}

/// Normal and viewer under one light.
pub struct Lit<T: Real, H> {
    pub n: [T; 3],
    pub v: [T; 3],
    pub scene: Scene<T, 1, H>,
}

pub fn shade<T: Real, H: Highlight<T>>(glossy: &Glossy<T, H>) -> Gloss<T::Scalar> {
    glossy.highlight.shade(glossy.n, glossy.v, glossy.l)
}

pub fn pixel<T: Real, H: Highlight<T>>(lit: &Lit<T, H>) -> T::Level {
    lit.scene.shade_channel(lit.n, lit.v, Channel::Red)
}
