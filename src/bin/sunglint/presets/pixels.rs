//! Glossy pixels under a light without size, in a float format and as they should be.

use sunglint::highlight::{Highlight, PointGgx};
use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::trial::gloss::Case;
use sunglint::{DistantLight, DistantSphere, Float, Real};

/// Normal, viewer and light in a format.
pub type Lanes<T> = [[T; 3]; 3];

/// How far the pixels of a form are from the truth.
#[derive(Clone, Copy, Debug, Default)]
pub struct Found {
    /// How many were tried.
    pub pixels: usize,
    /// Those off by more than a tenth, or no number.
    pub tenth: usize,
    /// Those off by a factor of two or more, or no number.
    pub twice: usize,
    /// Those that are black, infinite or no number.
    pub lost: usize,
}

/// A light without size, and a surface of the GGX width `alpha`.
fn case(alpha: f64) -> Case {
    let light = DistantLight::from_ratio(0.0).unwrap_or(sunglint::SUN);
    Case { name: "point", light, alpha }
}

/// Measures `form`, which makes `D V (n.l)` of normal, viewer, light and the GGX width, on `count` pixels of a
/// highlight of the width `alpha`: from a hundredth to ten widths off its middle. The truth is of the vectors as they
/// were rounded.
pub fn measure<T: Float>(alpha: f64, count: usize, form: impl Fn(Lanes<T>, T) -> f64) -> Found {
    let width = T::nearest(alpha);
    let glossy = Glossy { alpha: width.exact(), f0: 1.0, ratio: 0.0 };
    let mut found = Found::default();
    for Pixel { n, v, l } in case(alpha).pixels(1, count) {
        let lanes = [n, v, l].map(|vector| vector.map(T::nearest));
        let [n, v, l] = lanes.map(|vector| vector.map(T::exact));
        let ratio = form(lanes, width) / glossy.brdf(&Pixel { n, v, l });
        found.pixels += 1;
        found.tenth += usize::from(!(0.9..=1.1).contains(&ratio));
        found.twice += usize::from(!(ratio > 0.5 && ratio < 2.0));
        found.lost += usize::from(!(ratio > 0.0 && ratio < f64::INFINITY));
    }
    found
}

/// The half vector as shaders make it.
pub fn half<T: Float>(v: [T; 3], l: [T; 3]) -> [T; 3] {
    T::normalize([0, 1, 2].map(|i| v[i] + l[i]))
}

/// The same pixel by this crate.
pub fn by_this_crate<T: Float>([n, v, l]: Lanes<T>, alpha: T) -> f64 {
    let light = case(1.0).light;
    let gloss = PointGgx::none(&DistantSphere::<T>::of(&light), alpha).shade(n, v, l);
    // As the scene does: the wide part last.
    gloss.level.exact() * gloss.gain.exact()
}

/// `n.l` and `n.v`.
pub fn cosines<T: Float>([n, v, l]: Lanes<T>) -> [T; 2] {
    [l, v].map(|direction| <T as Real>::dot(n, direction))
}
