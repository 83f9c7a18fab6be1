//! GGX at one point of the disc, with a factor that keeps the energy.

use super::microfacet::{flatness, upright, visibility};
use super::{Gloss, HALF, Highlight, INVERSE_PI, at_most, extent, positive};
use crate::real::{Constant, Real, Scalar};
use crate::specular::{cap, reflect};
use crate::sphere::DistantSphere;

/// GGX at the point of the disc that the mirror ray sees or comes nearest to, times an energy factor.
///
/// `D = k / (pi alpha^2 (z^2 + m / alpha^2)^2)`, `z = n.h`, `m = 1 - z^2`, `h` between `v` and the point that
/// [`cap`] finds. The factor `k` is part of the peak `k / (pi alpha^2) = 1 / (pi b^2)`:
///
/// | constructor | `b` |
/// |---|---|
/// | [`none`](Self::none) | `alpha` |
/// | [`karis`](Self::karis) | `alpha + x/2`, at most 1 |
/// | [`karis_third`](Self::karis_third) | `alpha + x/3`, at most 1 |
/// | [`exact_rp`](Self::exact_rp) | `sqrt(alpha^2 + (pi/4) alpha x + x^2 / 4)` |
///
/// For `alpha = 0` the highlight is a sharp image of the disc, of radiance 0 in [`none`](Self::none) (its peak is
/// infinite) and of the right one in the others.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PointGgx<T: Real> {
    sphere: DistantSphere<T>,
    alpha: T::Scalar,
    /// `sqrt(1 - alpha^2)`.
    flatness: T::Scalar,
    inverse_alpha: T::Scalar,
    gain: T::Scalar,
}

const THIRD: Constant = Constant::new(1.0 / 3.0);
const QUARTER_PI: Constant = Constant::new(core::f64::consts::FRAC_PI_4);

impl<T: Real> PointGgx<T> {
    /// No energy factor: too bright by the ratio of the disc's area to the highlight's.
    ///
    /// ```
    /// use sunglint::highlight::{Highlight, PointGgx};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let (sun, up) = (DistantSphere::<f32>::new(&SUN), [0.0, 0.0, 1.0]);
    /// // Anywhere on the Sun's disc it is the peak of GGX, 1 / (pi alpha^2), over 4: as if all of the Sun were there.
    /// let [centre, rim] = [up, [0.0046, 0.0, 0.999_989_4]].map(|l| PointGgx::none(&sun, 0.001).shade(up, up, l));
    /// assert!((centre.radiance(1.0, 1.0) / 79_577.0 - 1.0).abs() < 1e-4);
    /// assert!((rim.radiance(1.0, 1.0) / 79_577.0 - 1.0).abs() < 1e-4);
    /// ```
    pub fn none(sphere: &DistantSphere<T>, alpha: T::Scalar) -> Self {
        Self::of_width(sphere, alpha, alpha)
    }

    /// Karis's factor `(alpha / alpha')^2`, `alpha' = sat(alpha + x/2)` (course notes, 2013).
    ///
    /// ```
    /// use sunglint::highlight::{Highlight, PointGgx, karis};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let (sun, up) = (DistantSphere::<f64>::new(&SUN), [0.0, 0.0, 1.0]);
    /// let [plain, dimmed] = [PointGgx::none(&sun, 0.01), PointGgx::karis(&sun, 0.01)]
    ///     .map(|method| method.shade(up, up, up).radiance(1.0, 0.04));
    /// assert!((dimmed / plain / karis(0.01, SUN.sin())? - 1.0).abs() < 1e-12);
    /// # Ok::<(), sunglint::LightError>(())
    /// ```
    pub fn karis(sphere: &DistantSphere<T>, alpha: T::Scalar) -> Self {
        Self::widened(sphere, alpha, T::Scalar::constant(HALF))
    }

    /// The same with `x/3`, as later engines have it.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::highlight::{Highlight, PointGgx};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let (sun, alpha) = (DistantSphere::<f16>::new(&SUN), f16::from_f32(0.01));
    /// let up = [f16::ZERO, f16::ZERO, f16::ONE];
    /// let [half, third] =
    ///     [PointGgx::karis(&sun, alpha), PointGgx::karis_third(&sun, alpha)].map(|method| method.shade(up, up, up));
    /// // A narrower highlight in f16, whose gain is one over its width: 1 / 0.01155 against 1 / 0.01233.
    /// assert!((third.gain.to_f32() - 86.58).abs() < 0.1 && (half.gain.to_f32() - 81.13).abs() < 0.1);
    /// ```
    pub fn karis_third(sphere: &DistantSphere<T>, alpha: T::Scalar) -> Self {
        Self::widened(sphere, alpha, T::Scalar::constant(THIRD))
    }

    /// The factor that makes the energy right at normal incidence for small angles: `1 / (1 + (pi/2) t + t^2)` with
    /// `t = x / (2 alpha)`.
    ///
    /// ```
    /// use sunglint::highlight::{Highlight, PointGgx};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let (sun, up) = (DistantSphere::<f64>::new(&SUN), [0.0, 0.0, 1.0]);
    /// // A mirror shows the Sun as bright as it is, illuminance over pi x^2.
    /// let mirrored = PointGgx::exact_rp(&sun, 0.0).shade(up, up, up).radiance(1.0, 1.0);
    /// assert!((mirrored * core::f64::consts::PI * SUN.sin() * SUN.sin() - 1.0).abs() < 1e-12);
    /// ```
    pub fn exact_rp(sphere: &DistantSphere<T>, alpha: T::Scalar) -> Self {
        let [sin, _] = extent(sphere);
        let half = sin * T::Scalar::constant(HALF);
        // b^2 = alpha^2 + (pi/2) alpha (x/2) + (x/2)^2, whose terms would be subnormal in f16.
        let (great, small) = if alpha > half { (alpha, half) } else { (half, alpha) };
        let ratio = if great > T::Scalar::ZERO { small / great } else { T::Scalar::ZERO };
        let (one, twice_quarter) = (T::Scalar::ONE, T::Scalar::constant(QUARTER_PI) + T::Scalar::constant(QUARTER_PI));
        Self::of_width(sphere, alpha, great * (one + ratio * (twice_quarter + ratio)).root())
    }

    fn widened(sphere: &DistantSphere<T>, alpha: T::Scalar, share: T::Scalar) -> Self {
        let [sin, _] = extent(sphere);
        let width = alpha + sin * share;
        Self::of_width(sphere, alpha, at_most(width, T::Scalar::ONE))
    }

    fn of_width(sphere: &DistantSphere<T>, alpha: T::Scalar, width: T::Scalar) -> Self {
        let (zero, one, most) = (T::Scalar::ZERO, T::Scalar::ONE, T::Scalar::MAX);
        let inverse = |value: T::Scalar| if value > zero { at_most(one / value, most) } else { zero };
        Self { sphere: *sphere, alpha, flatness: flatness(alpha), inverse_alpha: inverse(alpha), gain: inverse(width) }
    }
}

impl<T: Real> Highlight<T> for PointGgx<T> {
    #[inline]
    fn shade(&self, n: [T; 3], v: [T; 3], l: [T; 3]) -> Gloss<T::Scalar> {
        let r = reflect(n, v);
        let point = cap(l, r, &self.sphere);
        let [n_dot_l, n_dot_v] = [point, v].map(|direction| T::scalar(T::dot(n, direction)));
        let visibility = visibility(n_dot_l, n_dot_v, self.alpha, self.flatness);
        if !positive(visibility) {
            return Gloss::DARK;
        }
        let halfway = T::halfway(n, point, v, self.inverse_alpha, false);
        let shape = if self.alpha > T::Scalar::ZERO {
            let rest = upright(n_dot_l, n_dot_v, halfway.v_dot_h_square) + halfway.tilt;
            self.gain / rest / rest
        } else if point == r {
            self.gain
        } else {
            T::Scalar::ZERO
        };
        let level = visibility * shape * T::Scalar::constant(INVERSE_PI);
        Gloss::of(level, self.gain, halfway.v_dot_h_square.root())
    }
}
