//! Highlight: how bright is a glossy surface under a disc in the sky?
//!
//! The answer of every method is the radiance that leaves towards `v`, divided by the light's illuminance on a plane
//! that faces it: `D V F (n.l)` of the microfacet model with GGX, height-correlated Smith and Schlick, averaged over
//! the disc or as near to that as the method comes. `alpha` is the GGX width (perceptual roughness squared), `x`
//! radius over distance, `w` the versine.
//!
//! | type | what it does | model error at the Sun, 0 / 60 / 80 degrees off the normal |
//! |---|---|---|
//! | [`PointGgx::none`] | GGX at the disc's point that [`cap`](crate::cap) finds | 29 / 53 / 140 |
//! | [`PointGgx::karis`] | the same times `(alpha / (alpha + x/2))^2` | 0.30 / 1.0 / 4.8 |
//! | [`PointGgx::karis_third`] | the same with `x/3` | 1.3 / 3.5 / 12 |
//! | [`PointGgx::exact_rp`] | the same with the shape's own energy | 0.30 / 1.0 / 4.8 |
//! | [`DiscGgx::new`] | GGX averaged over the disc, taken to be a circle | 1e-5 / 0.40 / 0.97 |
//! | [`DiscGgx::directional`] | the same, the disc seen as an ellipse, nearly | 9e-6 / 0.071 / 0.37 |
//! | [`ConeGgx`] | GGX integrated over the cone of half vectors, exactly | 6e-6 / 2e-3 / 3e-4 |
//! | [`ShiftedConeGgx`] | the same, the rest of the model taken beside the mirror ray under large lights | 6e-6 / 9e-4 / 2e-4 |
//!
//! The model error is the difference from the BRDF integrated over the disc, integrated over all viewers, as a share of
//! the highlight: relative L1, the worst of `alpha` from 5e-4 to 1, and of 0 but for `none` (`tests/lobe.rs`).
//! Arithmetic errors of whole pixels in each format are the budgets of `trial::gloss`, asserted in `tests/gloss.rs`.
//!
//! A light beyond half the sky counts as half the sky, which gives a surface that faces it the same illuminance and
//! almost the same highlight: of a lobe that points away from the horizon neither sees the other half
//! (`tests/highlight_failures.rs`).
//!
//! `1 - (n.h)^2` is never formed by subtraction. Nothing overflows: a method works in units of its highlight's own
//! width, and the peak `1 / (pi alpha^2)`, which f16 cannot hold, is multiplied in a width at a time.
//!
//! In fixed point every factor here is a [`Scaled`](crate::real::Scaled): a 31-bit mantissa (Q31) with an exponent of
//! its own. Cosines come from Q28 or Q60 dot products, `1 - (n.h)^2` from a cross product that is exact.

mod cone;
mod disc;
mod energy;
mod microfacet;
mod point;

pub use cone::{ConeGgx, ShiftedConeGgx};
pub use disc::DiscGgx;
pub use energy::{exact_rp, karis};
#[cfg(feature = "fixed")]
pub use energy::{exact_rp_q30, karis_q30};
pub use microfacet::{schlick, smith};
pub use point::PointGgx;

use crate::product::saturated;
use crate::real::{HALF, INVERSE_PI, Real, Scalar, at_most, positive};
use crate::sphere::DistantSphere;

/// A method of shading a glossy surface of one roughness under one light, its constants computed.
pub trait Highlight<T: Real>: Copy {
    /// The highlight that a surface of normal `n` sends to `v` of a light whose centre is at `l`, all of unit length.
    ///
    /// Zero where the surface faces away from the viewer or from the light's centre ([`PointGgx`] and
    /// [`ShiftedConeGgx`]: from the direction of the disc that they shade with), and for NaN.
    ///
    /// ```
    /// use sunglint::highlight::{ConeGgx, Gloss, Highlight};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let sea = ConeGgx::new(&DistantSphere::<f32>::new(&SUN), 0.02);
    /// let (n, l) = ([0.0, 0.0, 1.0], [0.6, 0.0, 0.8]);
    /// // In the mirror's direction, from straight above, and from under the surface.
    /// let [glint, above, below] = [[-0.6, 0.0, 0.8], n, [-0.6, 0.0, -0.8]].map(|v| sea.shade(n, v, l));
    /// assert!(glint.level * glint.gain > 100.0 && above.level * above.gain < 0.01);
    /// assert_eq!(below, Gloss::DARK);
    /// ```
    fn shade(&self, n: [T; 3], v: [T; 3], l: [T; 3]) -> Gloss<T::Scalar>;
}

/// A highlight without its colour.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gloss<S> {
    /// `D V (n.l)` over `gain`, in 1/sr.
    pub level: S,
    /// One over the highlight's width, which is multiplied in last: `D V (n.l)` may overflow f16, and its share that
    /// has no width in it be subnormal.
    pub gain: S,
    /// Schlick's weight `(1 - v.h)^5`: of the reflectance that is missing at normal incidence, the share that is added.
    pub fresnel: S,
}

impl<S: Scalar> Gloss<S> {
    /// No highlight.
    pub const DARK: Self = Self { level: S::ZERO, gain: S::ONE, fresnel: S::ZERO };

    /// A level that may have left the range of f16, and the cosine that Schlick's weight is of.
    #[inline]
    pub(crate) fn of(level: S, gain: S, v_dot_h: S) -> Self {
        Self { level: saturated(level), gain, fresnel: schlick(v_dot_h) }
    }

    /// Radiance towards the viewer under a light of `illuminance`, in the unit of that per steradian, for a reflectance
    /// at normal incidence of `f0`, from 0 to 1.
    ///
    /// ```
    /// use sunglint::highlight::{ConeGgx, Highlight};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// // Chalk (alpha 1) seen from where the Sun is: of a light of illuminance pi its gloss shows a quarter of f0.
    /// let up = [0.0, 0.0, 1.0];
    /// let gloss = ConeGgx::new(&DistantSphere::<f64>::new(&SUN), 1.0).shade(up, up, up);
    /// assert!((gloss.radiance(core::f64::consts::PI, 0.04) - 0.01).abs() < 1e-6);
    /// // Twice the light is exactly twice the radiance.
    /// assert_eq!(gloss.radiance(2.0, 0.04), 2.0 * gloss.radiance(1.0, 0.04));
    /// ```
    #[inline]
    pub fn radiance(&self, illuminance: S, f0: S) -> S {
        let reflectance = f0 + (S::ONE - f0) * self.fresnel;
        self.level * (illuminance * reflectance) * self.gain
    }
}

/// Sine and versine of a light's angular radius; those of half the sky for all beyond, whose sine falls again.
#[inline]
pub(crate) fn extent<T: Real>(sphere: &DistantSphere<T>) -> [T::Scalar; 2] {
    if sphere.cos() < T::WIDE_ZERO { [T::Scalar::ONE; 2] } else { [sphere.sin(), sphere.versine()].map(T::scalar) }
}
