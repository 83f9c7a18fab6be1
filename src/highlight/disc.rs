//! GGX averaged over the disc, in closed form where the disc is seen as a circle.

use super::microfacet::{flatness, upright, visibility};
use super::{Gloss, HALF, Highlight, INVERSE_PI, at_most, extent, positive};
use crate::real::{Halfway, Real, Scalar};
use crate::sphere::DistantSphere;

/// GGX averaged over the disc: `D = 2 alpha^2 / (pi R (R + p))`, `p = alpha^2 z^2 + m - T`, `R = sqrt(p^2 + 4 alpha^2
/// z^2 T)`, with `z = n.h`, `m = 1 - z^2`, `T = w / (2 (v.h))`; for `p < 0` the equal `(R - p) / (2 pi T z^2 R)`.
///
/// GGX's slopes are the stereographic projection of an even distribution over the sphere, and the projection of a
/// circle is a circle. The disc's image in the half vectors is one at normal incidence; off it, an ellipse with the
/// same area, which [`directional`](Self::directional) makes up for in part and [`ConeGgx`](super::ConeGgx) fully.
///
/// For `alpha = 0` the answer is a sharp image of that circle; for `x = 0` it is GGX; for both it is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiscGgx<T: Real> {
    width: Width<T::Scalar>,
    /// `w / (2 b^2)`.
    half_disc: T::Scalar,
    /// `1 - w/2`.
    facing: T::Scalar,
    directional: bool,
}

/// A roughness and a disc in units of the highlight's width `b`, `b^2 = alpha^2 + w/2`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Width<S> {
    pub(super) alpha: S,
    /// `sqrt(1 - alpha^2)`.
    pub(super) flatness: S,
    /// `(alpha / b)^2`.
    pub(super) alpha_square: S,
    /// The versine, which f16 holds as a subnormal number if at all.
    pub(super) versine: S,
    /// `w / b^2`.
    pub(super) disc: S,
    /// `b`.
    pub(super) width: S,
    /// `1 / b`; 0 for a mirror under a point.
    pub(super) inverse: S,
}

impl<S: Scalar> Width<S> {
    pub(super) fn of<T: Real<Scalar = S>>(sphere: &DistantSphere<T>, alpha: S) -> Self {
        let [sin, versine] = extent(sphere);
        // sqrt(w / 2) is x / sqrt(2 (1 + cos)): neither is subnormal in f16.
        let cosine = S::ONE - versine;
        let half = sin / (S::ONE + S::ONE + cosine + cosine).root();
        let width = S::hypotenuse(alpha, half);
        let flatness = flatness(alpha);
        if !positive(width) {
            return Self { alpha, flatness, alpha_square: S::ZERO, versine, disc: S::ZERO, width, inverse: S::ZERO };
        }
        let (rough, flat) = (alpha / width, half / width);
        let disc = flat * flat;
        Self {
            alpha,
            flatness,
            alpha_square: rough * rough,
            versine,
            disc: disc + disc,
            width,
            inverse: at_most(S::ONE / width, S::MAX),
        }
    }

    /// [`smith`](super::smith) of this roughness.
    #[inline]
    pub(super) fn visibility(&self, n_dot_l: S, n_dot_v: S) -> S {
        visibility(n_dot_l, n_dot_v, self.alpha, self.flatness)
    }
}

impl<T: Real> DiscGgx<T> {
    /// The disc's image in the half vectors taken to be a circle: one root.
    ///
    /// ```
    /// use sunglint::highlight::{ConeGgx, DiscGgx, Highlight};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let (sun, up) = (DistantSphere::<f64>::new(&SUN), [0.0, 0.0, 1.0]);
    /// let [disc, cone] = [DiscGgx::new(&sun, 0.01).shade(up, up, up), ConeGgx::new(&sun, 0.01).shade(up, up, up)]
    ///     .map(|gloss| gloss.radiance(1.0, 0.04));
    /// // Seen from above the image is a circle, and the closed form exact.
    /// assert!((disc / cone - 1.0).abs() < 1e-4);
    /// ```
    pub fn new(sphere: &DistantSphere<T>, alpha: T::Scalar) -> Self {
        Self::of_width(Width::of(sphere, alpha), false)
    }

    /// With `T` in `p` alone widened along the ellipse's long axis: `T_p = (w/2) (m + alpha^2 z^2) / (m_d + m_o (v.h)^2
    /// + alpha^2 z^2 (v.h))`, `m_d` being the part of `m` in the plane of `l` and `v`, and `m_o` the rest.
    ///
    /// ```
    /// use sunglint::highlight::{ConeGgx, DiscGgx, Highlight};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// // 60 degrees off the normal, a mirror ray a quarter of a degree beside the Sun's centre.
    /// let (n, l, v) = ([0.0, 0.0, 1.0], [0.866_025_4, 0.0, 0.5], [-0.868_199, 0.0, 0.496_217]);
    /// let sun = DistantSphere::<f32>::new(&SUN);
    /// let exact = ConeGgx::new(&sun, 0.001).shade(n, v, l).radiance(1.0, 0.04);
    /// let off = |disc: DiscGgx<f32>| (disc.shade(n, v, l).radiance(1.0, 0.04) / exact - 1.0).abs();
    /// assert!(off(DiscGgx::directional(&sun, 0.001)) < off(DiscGgx::new(&sun, 0.001)));
    /// ```
    pub fn directional(sphere: &DistantSphere<T>, alpha: T::Scalar) -> Self {
        Self::of_width(Width::of(sphere, alpha), true)
    }

    fn of_width(width: Width<T::Scalar>, directional: bool) -> Self {
        let half = T::Scalar::constant(HALF);
        Self { width, half_disc: width.disc * half, facing: T::Scalar::ONE - width.versine * half, directional }
    }

    /// `pi b D`.
    #[inline]
    fn shape(&self, halfway: &Halfway<T::Scalar>, v_dot_h: T::Scalar, cosine_square: T::Scalar) -> T::Scalar {
        let zero = T::Scalar::ZERO;
        let Width { alpha_square: a, inverse, .. } = self.width;
        let m = halfway.tilt;
        let rough = a * cosine_square;
        let circle = self.half_disc / v_dot_h;
        let along = if self.directional {
            let across = (m - halfway.in_plane) * halfway.v_dot_h_square;
            let spread = halfway.in_plane + across + rough * v_dot_h;
            if spread > zero { self.half_disc * (m + rough) / spread } else { circle }
        } else {
            circle
        };
        let p = rough + m - along;
        let root = (rough * circle).root();
        let size = T::Scalar::hypotenuse(if p < zero { zero - p } else { p }, root + root);
        if !positive(size) {
            return zero;
        }
        if p < zero {
            let spread = circle * cosine_square;
            if positive(spread) { inverse * ((size - p) / size) / (spread + spread) } else { zero }
        } else {
            inverse * (a + a) / size / (size + p)
        }
    }
}

impl<T: Real> Highlight<T> for DiscGgx<T> {
    #[inline]
    fn shade(&self, n: [T; 3], v: [T; 3], l: [T; 3]) -> Gloss<T::Scalar> {
        let [n_dot_l, n_dot_v] = [l, v].map(|direction| T::scalar(T::dot(n, direction)));
        let visibility = self.width.visibility(n_dot_l, n_dot_v);
        if !positive(visibility) {
            return Gloss::DARK;
        }
        let halfway = T::halfway(n, l, v, self.width.inverse, self.directional);
        let v_dot_h = halfway.v_dot_h_square.root();
        let shape = self.shape(&halfway, v_dot_h, upright(n_dot_l, n_dot_v, halfway.v_dot_h_square));
        // The mean over the disc is per solid angle, illuminance per projected one: pi x^2 = 2 pi w (1 - w/2).
        let level = visibility * shape * T::Scalar::constant(INVERSE_PI) / self.facing;
        Gloss::of(level, self.width.inverse, v_dot_h)
    }
}
