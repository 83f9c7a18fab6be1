//! The highlight methods as a list.

use crate::highlight::{ConeGgx, DiscGgx, Gloss, Highlight, PointGgx, ShiftedConeGgx};
use crate::oracle::highlight::{Glossy, Pixel};
use crate::real::{Real, Scalar};
use crate::sphere::DistantSphere;

/// One of the highlight methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// [`PointGgx::none`].
    None,
    /// [`PointGgx::karis`].
    Karis,
    /// [`PointGgx::karis_third`].
    KarisThird,
    /// [`PointGgx::exact_rp`].
    ExactRp,
    /// [`DiscGgx::new`].
    DiscGgx,
    /// [`DiscGgx::directional`].
    Directional,
    /// [`ConeGgx`].
    ConeGgx,
    /// [`ShiftedConeGgx`].
    Shifted,
}

/// Makes a method's constants for a roughness under a light.
pub type Make<T, H> = fn(&DistantSphere<T>, <T as Real>::Scalar) -> H;

/// What is to be done with a method, once that is a type.
pub trait ShadingVisitor<T: Real> {
    /// What comes of it.
    type Output;
    /// Does it with the function that makes the method's constants.
    fn visit<H: Highlight<T> + 'static>(self, method: Make<T, H>) -> Self::Output;
}

impl Shading {
    /// All methods, in the order of tables.
    pub const ALL: [Self; 8] = [
        Self::None,
        Self::Karis,
        Self::KarisThird,
        Self::ExactRp,
        Self::DiscGgx,
        Self::Directional,
        Self::ConeGgx,
        Self::Shifted,
    ];

    /// The method of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    /// Name, as tables and charts print it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Karis => "karis",
            Self::KarisThird => "karis/3",
            Self::ExactRp => "exact_rp",
            Self::DiscGgx => "disc_ggx",
            Self::Directional => "disc_ggx dir",
            Self::ConeGgx => "cone_ggx",
            Self::Shifted => "cone_ggx shifted",
        }
    }

    /// Calls `visitor` with the method.
    pub fn visit<T: Real, V: ShadingVisitor<T>>(self, visitor: V) -> V::Output {
        match self {
            Self::None => visitor.visit(PointGgx::none),
            Self::Karis => visitor.visit(PointGgx::karis),
            Self::KarisThird => visitor.visit(PointGgx::karis_third),
            Self::ExactRp => visitor.visit(PointGgx::exact_rp),
            Self::DiscGgx => visitor.visit(DiscGgx::new),
            Self::Directional => visitor.visit(DiscGgx::directional),
            Self::ConeGgx => visitor.visit(ConeGgx::new),
            Self::Shifted => visitor.visit(ShiftedConeGgx::new),
        }
    }

    /// The exact value of the method's own formula: radiance over illuminance.
    pub fn truth(self, glossy: &Glossy, pixel: &Pixel) -> f64 {
        self.truth_beside(glossy, &pixel.unit(), [0.0; 3])
    }

    /// The same for vectors that are of length 1 or nearly so, whatever that makes of the formula, and with the point
    /// of the disc that the method finds, if it does, moved by `offset`.
    pub fn truth_beside(self, glossy: &Glossy, pixel: &Pixel, offset: [f64; 3]) -> f64 {
        let Glossy { alpha, ratio, .. } = *glossy;
        match self {
            Self::None => glossy.at_nearest_point(pixel, alpha, offset),
            Self::Karis => glossy.at_nearest_point(pixel, (alpha + ratio / 2.0).min(1.0), offset),
            Self::KarisThird => glossy.at_nearest_point(pixel, (alpha + ratio / 3.0).min(1.0), offset),
            Self::ExactRp => {
                let square = alpha * alpha + core::f64::consts::FRAC_PI_4 * alpha * ratio + ratio * ratio / 4.0;
                glossy.at_nearest_point(pixel, libm::sqrt(square), offset)
            }
            Self::DiscGgx => glossy.over_circle(pixel, false),
            Self::Directional => glossy.over_circle(pixel, true),
            Self::ConeGgx => glossy.over_cone(pixel),
            Self::Shifted => glossy.over_cone_shifted(pixel, offset),
        }
    }

    /// The highlight that the method makes in the format `T` of a pixel, normal, viewer and light: radiance over
    /// illuminance, for a reflectance of `f0` at normal incidence.
    pub fn radiance<T: Real>(self, glossy: &Glossy, sphere: &DistantSphere<T>, pixel: [[T; 3]; 3]) -> f64 {
        let gloss = self.shade(sphere, T::Scalar::nearest(glossy.alpha), pixel);
        gloss.radiance(T::Scalar::ONE, T::Scalar::nearest(glossy.f0)).exact()
    }

    /// The highlight of one pixel: normal, viewer and light.
    pub fn shade<T: Real>(self, sphere: &DistantSphere<T>, alpha: T::Scalar, pixel: [[T; 3]; 3]) -> Gloss<T::Scalar> {
        self.visit(Once { sphere, alpha, pixel })
    }
}

/// Shades one pixel.
struct Once<'a, T: Real> {
    sphere: &'a DistantSphere<T>,
    alpha: T::Scalar,
    pixel: [[T; 3]; 3],
}

impl<T: Real> ShadingVisitor<T> for Once<'_, T> {
    type Output = Gloss<T::Scalar>;

    fn visit<H: Highlight<T> + 'static>(self, method: Make<T, H>) -> Gloss<T::Scalar> {
        let [n, v, l] = self.pixel;
        method(self.sphere, self.alpha).shade(n, v, l)
    }
}
