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

/// What is to be done with a method, once that is a type.
pub trait ShadingVisitor<T: Real> {
    /// What comes of it.
    type Output;
    /// Does it with a highlight whose constants are computed.
    fn visit(self, highlight: impl Highlight<T> + 'static) -> Self::Output;
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

    /// Calls `visitor` with the method's constants for a roughness under a light.
    pub fn visit<T: Real, V: ShadingVisitor<T>>(
        self,
        sphere: &DistantSphere<T>,
        alpha: T::Scalar,
        visitor: V,
    ) -> V::Output {
        match self {
            Self::None => visitor.visit(PointGgx::none(sphere, alpha)),
            Self::Karis => visitor.visit(PointGgx::karis(sphere, alpha)),
            Self::KarisThird => visitor.visit(PointGgx::karis_third(sphere, alpha)),
            Self::ExactRp => visitor.visit(PointGgx::exact_rp(sphere, alpha)),
            Self::DiscGgx => visitor.visit(DiscGgx::new(sphere, alpha)),
            Self::Directional => visitor.visit(DiscGgx::directional(sphere, alpha)),
            Self::ConeGgx => visitor.visit(ConeGgx::new(sphere, alpha)),
            Self::Shifted => visitor.visit(ShiftedConeGgx::new(sphere, alpha)),
        }
    }

    /// The exact value of the method's own formula: radiance over illuminance.
    pub fn truth(self, glossy: &Glossy, pixel: &Pixel) -> f64 {
        let Glossy { alpha, ratio, .. } = *glossy;
        match self {
            Self::None => glossy.at_nearest_point(pixel, alpha),
            Self::Karis => glossy.at_nearest_point(pixel, (alpha + ratio / 2.0).min(1.0)),
            Self::KarisThird => glossy.at_nearest_point(pixel, (alpha + ratio / 3.0).min(1.0)),
            Self::ExactRp => {
                let square = alpha * alpha + core::f64::consts::FRAC_PI_4 * alpha * ratio + ratio * ratio / 4.0;
                glossy.at_nearest_point(pixel, libm::sqrt(square))
            }
            Self::DiscGgx => glossy.over_circle(pixel, false),
            Self::Directional => glossy.over_circle(pixel, true),
            Self::ConeGgx => glossy.over_cone(pixel),
            Self::Shifted => glossy.over_cone_shifted(pixel),
        }
    }

    /// The highlight that the method makes in the format `T` of a pixel, a light and a surface that are rounded into it:
    /// radiance over illuminance, for a reflectance of `f0` at normal incidence.
    pub fn radiance<T: Real>(self, glossy: &Glossy, sphere: &DistantSphere<T>, pixel: [[T; 3]; 3]) -> f64 {
        let [n, v, l] = pixel;
        let f0 = T::Scalar::nearest(glossy.f0);
        let gloss: Gloss<T::Scalar> = self.visit(sphere, T::Scalar::nearest(glossy.alpha), Once { n, v, l });
        gloss.radiance(T::Scalar::ONE, f0).exact()
    }
}

/// Shades one pixel.
struct Once<T> {
    n: [T; 3],
    v: [T; 3],
    l: [T; 3],
}

impl<T: Real> ShadingVisitor<T> for Once<T> {
    type Output = Gloss<T::Scalar>;

    fn visit(self, highlight: impl Highlight<T>) -> Gloss<T::Scalar> {
        highlight.shade(self.n, self.v, self.l)
    }
}
