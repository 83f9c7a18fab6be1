//! GGX integrated over the disc exactly: the half vectors of a disc fill an elliptic cone.

use super::disc::Width;
use super::microfacet::{FOUR_OVER_PI, smoothness, upright};
use super::{Gloss, Highlight, at_most, positive};
use crate::real::{Constant, Halfway, Real, Scalar, TILT_LIMIT, most_tilt};
use crate::specular::{cap, reflect};
use crate::sphere::DistantSphere;
use crate::vec3::zip;

/// The share of the microfacets that mirror the disc to the viewer, exactly, times the rest of the model at the disc's
/// centre. **The default.**
///
/// `l'` is in the disc where `l.l' >= 1 - w`; with `l' = 2 (v.h) h - v` that is a quadratic form in `h`, whose axes are
/// `l + v`, `l - v` and `l x v` with eigenvalues `w`, `w - 2` and `-g`, `g = 2 (v.h)^2 - w`. Dividing slopes by
/// `alpha` turns GGX's microfacets into an even distribution by projected area, and the cone into another elliptic one,
/// whose projected solid angle is known in closed form from one root `y` of a cubic, which is that of
///
/// `y = (alpha^2 + k phi) / (1 - k (m - phi))`, `phi = m_d y / (y + A_d) + m_o y / (y + A_o)`, `k = 1 - alpha^2`,
/// `A_d = w / (2 - w)`, `A_o = w / g`,
///
/// where `m_d` and `m_o` are the squares of `n` along `l - v` and `l x v` and `m` is their sum. Then, with everything
/// positive and nothing subtracted,
///
/// `D = 4 alpha^2 (v.h) / (pi (2 - w) sqrt(1 - k (m - phi)) sqrt(((2 - w) y + w) (g y + w)) (alpha^2 + k y^2 (m_d (1
/// + A_d) / (y + A_d)^2 + m_o (1 + A_o) / (y + A_o)^2)))`,
///
/// which is GGX for `w = 0`, where `y = alpha^2 z^2 + m`. The root is found by three steps that put one pole in place
/// of the two, and by as many as change anything where the poles are four times apart (from about 60 degrees on). What
/// the root lacks is below 7.8e-8 of the highlight, as a search has found (`tests/highlight_budget.rs`).
///
/// For `alpha = 0` the highlight is the sharp, elliptic image of the disc. For `x = 0` it is GGX; for both it is zero.
/// Where the disc reaches to the viewer's opposite (`l.v <= w - 1`: for a ratio of 0.3 on from 81 degrees of incidence
/// and reflection, for half the sky from 45), `g` would not be positive, and half vectors lie at right angles to `v`,
/// which fit no cone. There `g` is kept at a 30 000th of `w` over `b^2 = alpha^2 + w/2`: all that is near the plane of
/// incidence counts, however far across.
///
/// Root mean square error of a whole pixel's arithmetic, relative, under the Sun (`trial::gloss`, `tests/gloss.rs`):
/// for `alpha = 0.001` f32 1.1e-5, f16 0.093, I2F14 2.2e-3, I2F30 2.7e-8; for 0.0625 f32 3.4e-7, f16 2.8e-3, I2F14
/// 1.7e-4, I2F30 2.8e-9.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ConeGgx<T: Real> {
    lobe: Lobe<T::Scalar>,
}

/// What of the cone hangs on the roughness and the light alone.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Lobe<S> {
    width: Width<S>,
    /// `b^2`.
    width_square: S,
    /// `alpha b`.
    rough_width: S,
    /// `2 - w`.
    along: S,
    /// The least `g`.
    least_across: S,
    /// `A_d / b^2`.
    opening: S,
    /// `1 + A_d`.
    widened: S,
    /// `k`.
    smooth: S,
}

/// [`ConeGgx`] for lights of any size: shadowing, reflectance and the cosine are taken not at the disc's centre but
/// between that and the point nearest to the mirror ray, the nearer to it the smaller the roughness is beside the
/// disc. At the Sun the centre is good enough.
///
/// That direction `m` is a little shorter than 1. `(v.h)^2 = (1 + m.v) / 2` is taken as `(|m + v|^2 + 1 - |m|^2) / 4`,
/// the latter from how far apart the two are that `m` lies between, so that nothing cancels where the viewer is about
/// opposite. Zero where `n.l + n.v` is not above it, which under almost half the sky is an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ShiftedConeGgx<T: Real> {
    cone: ConeGgx<T>,
    sphere: DistantSphere<T>,
    /// `w / (w + alpha^2)` and what it lacks of 1.
    shares: [T::Wide; 2],
    /// The product of the two shares.
    spread: T::Scalar,
}

const QUARTER: Constant = Constant::new(0.25);

/// The share of the microfacets, as far as the disc's centre tells.
struct Shape<S> {
    /// `pi b D / (4 v.h)`.
    value: S,
    /// `(n.h)^2`.
    cosine_square: S,
    v_dot_h_square: S,
}

/// The cone of half vectors and the surface's place in it, in units of the highlight's width.
struct Cone<'a, S> {
    lobe: &'a Lobe<S>,
    /// `g`.
    across: S,
    /// `m_d` and `m_o` over `b^2`.
    tilt: [S; 2],
    /// `A_d` and `A_o` over `b^2`.
    opening: [S; 2],
    /// `1 - k m`, which is `z^2 + alpha^2 m`.
    rest: S,
}

/// From this quotient of the poles on, which is at about 60 degrees of incidence, three steps are too few.
const APART: Constant = Constant::new(4.0);

/// How many more they are there at most; mostly five.
const MORE_STEPS: u32 = 24;

impl<S: Scalar> Lobe<S> {
    fn of(width: Width<S>) -> Self {
        let along = S::ONE + S::ONE - width.versine;
        let (opening, width_square) = (width.disc / along, width.width * width.width);
        Self {
            width,
            width_square,
            rough_width: width.alpha * width.width,
            along,
            // No opening is greater than a tilt may be in f16.
            least_across: width.disc / S::constant(TILT_LIMIT),
            opening,
            widened: S::ONE + opening * width_square,
            smooth: smoothness(width.alpha),
        }
    }
}

impl<'a, S: Scalar> Cone<'a, S> {
    #[inline]
    fn of(lobe: &'a Lobe<S>, halfway: &Halfway<S>, cosine_square: S) -> Self {
        let across = halfway.v_dot_h_square + halfway.v_dot_h_square - lobe.width.versine;
        let across = if across > lobe.least_across { across } else { lobe.least_across };
        Self {
            lobe,
            across,
            tilt: [halfway.in_plane, halfway.tilt - halfway.in_plane],
            opening: [lobe.opening, at_most(lobe.width.disc / across, S::constant(TILT_LIMIT))],
            rest: cosine_square + halfway.tilt * lobe.rough_width * lobe.rough_width,
        }
    }

    /// `y / b^2`.
    #[inline]
    fn root(&self) -> S {
        let [along, across] = self.tilt;
        let tilt = along + across;
        if !positive(tilt) {
            return self.lobe.width.alpha_square;
        }
        let [first, second] = self.opening;
        // Between the two: the root of the product of their arithmetic and harmonic means.
        let pole = (first * ((along * first + across * second) / (along * second + across * first)) * second).root();
        // Where f16 has no digits left for a small disc the quotient may be anything.
        let pole = at_most(pole, second);
        // Each step doubles the digits that are right.
        let near = self.step(self.one_pole(tilt, pole));
        let root = self.step(self.step(near));
        // Poles that are far apart, as at grazing incidence, leave the first guess with hardly any.
        if second > first * S::constant(APART) { self.until_it_stays(root) } else { root }
    }

    /// Steps until one changes nothing or comes back to the root before, or there have been [`MORE_STEPS`].
    #[inline]
    fn until_it_stays(&self, mut root: S) -> S {
        let mut previous = root;
        for _ in 0..MORE_STEPS {
            let next = self.step(root);
            if next == root || next == previous {
                break;
            }
            (previous, root) = (root, next);
        }
        root
    }

    /// A better root from `y`: one pole with the value and the slope that the two have there. It lies between them.
    #[inline]
    fn step(&self, y: S) -> S {
        let [first, second] = self.opening.map(|opening| S::ONE / (y + opening));
        let [along, across] = [self.tilt[0] * first, self.tilt[1] * second];
        let [near, far] = [along * first, across * second];
        let weight = near + far;
        if !positive(weight) {
            return y;
        }
        let pole = (near * self.opening[0] + far * self.opening[1]) / weight;
        self.one_pole((along + across) * (y + pole), pole)
    }

    /// The root where `phi` is `height y / (y + pole)`.
    #[inline]
    fn one_pole(&self, height: S, pole: S) -> S {
        let zero = S::ZERO;
        let Width { alpha_square: a, width, .. } = self.lobe.width;
        let height = self.lobe.smooth * height;
        // height is in units of b^2.
        let lead = self.rest + height * width * width;
        let linear = self.rest * pole - a - height;
        let quarter = (lead * (a * pole)).root();
        let size = S::hypotenuse(if linear < zero { zero - linear } else { linear }, quarter + quarter);
        if linear < zero {
            // Farther out than a tilt may be, where nothing of the highlight is left.
            at_most((size - linear) / (lead + lead), most_tilt())
        } else if size > zero {
            let twice = a * pole;
            (twice + twice) / (size + linear)
        } else {
            zero
        }
    }

    /// `pi b D / (4 v.h)`.
    #[inline]
    fn shape(&self) -> S {
        let Lobe { width, width_square, along, smooth, .. } = *self.lobe;
        let a = width.alpha_square;
        if !positive(a) {
            return self.mirrored();
        }
        let y = self.root();
        let sums = self.opening.map(|opening| y + opening);
        let [first, second] = sums.map(|sum| S::ONE / sum);
        let [near, far] = [self.tilt[0] * first, self.tilt[1] * second];
        let density = self.rest + smooth * ((near + far) * y * width_square);
        let widened = [self.lobe.widened, S::ONE + self.opening[1] * width_square];
        let widen = |share: S, inverse: S, widened: S| share * (y * (y * inverse)) * widened;
        let spread = a + smooth * (widen(near, first, widened[0]) + widen(far, second, widened[1]));
        let roots = (along * y + width.disc).root() * (self.across * y + width.disc).root() * density.root();
        width.inverse * a / spread / (roots * along)
    }

    /// The same for `alpha = 0`: whether `n` is in the cone of half vectors.
    #[inline]
    fn mirrored(&self) -> S {
        let Lobe { width, along: factor, .. } = *self.lobe;
        let [along, across] = self.tilt;
        let inside = factor * along + self.across * across <= self.rest * width.disc;
        if inside && positive(width.disc) { width.inverse / (factor * width.disc * self.rest.root()) } else { S::ZERO }
    }
}

impl<T: Real> ConeGgx<T> {
    /// A roughness `alpha` from 0 to 1 under a light. Once per light and material; in fixed point integers alone.
    ///
    /// ```
    /// use sunglint::fixed::types::I2F14;
    /// use sunglint::highlight::{ConeGgx, Highlight};
    /// use sunglint::real::{Scalar, Scaled};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// // A mirror shows the Sun as bright as it is: its illuminance over pi x^2, 14 718 of it per steradian.
    /// let mirror = ConeGgx::new(&DistantSphere::<I2F14>::new(&SUN), Scaled::ZERO);
    /// let up = [I2F14::ZERO, I2F14::ZERO, I2F14::ONE];
    /// let sun = mirror.shade(up, up, up).radiance(Scaled::ONE, Scaled::ONE).exact();
    /// assert!((sun / 14_718.3 - 1.0).abs() < 2e-4);
    /// ```
    pub fn new(sphere: &DistantSphere<T>, alpha: T::Scalar) -> Self {
        Self { lobe: Lobe::of(Width::of(sphere, alpha)) }
    }

    /// `n_dot_l` and `n_dot_v` are those of the directions.
    #[inline]
    fn shape(&self, [n, v, l]: [[T; 3]; 3], n_dot_l: T::Scalar, n_dot_v: T::Scalar) -> Shape<T::Scalar> {
        let halfway = T::halfway(n, l, v, self.lobe.width.inverse, true);
        let cosine_square = upright(n_dot_l, n_dot_v, halfway.v_dot_h_square);
        let value = Cone::of(&self.lobe, &halfway, cosine_square).shape();
        Shape { value, cosine_square, v_dot_h_square: halfway.v_dot_h_square }
    }
}

impl<T: Real> Highlight<T> for ConeGgx<T> {
    #[inline]
    fn shade(&self, n: [T; 3], v: [T; 3], l: [T; 3]) -> Gloss<T::Scalar> {
        let [n_dot_l, n_dot_v] = [l, v].map(|direction| T::scalar(T::dot(n, direction)));
        let visibility = self.lobe.width.visibility(n_dot_l, n_dot_v);
        if !positive(visibility) {
            return Gloss::DARK;
        }
        let shape = self.shape([n, v, l], n_dot_l, n_dot_v);
        let v_dot_h = shape.v_dot_h_square.root();
        let level = visibility * v_dot_h * shape.value * T::Scalar::constant(FOUR_OVER_PI);
        Gloss::of(level, self.lobe.width.inverse, v_dot_h)
    }
}

impl<T: Real> ShiftedConeGgx<T> {
    /// A roughness `alpha` from 0 to 1 under a light. Once per light and material.
    ///
    /// ```
    /// use sunglint::highlight::{ConeGgx, Gloss, Highlight, ShiftedConeGgx};
    /// use sunglint::{DistantLight, DistantSphere};
    ///
    /// // The centre of a great lamp has just set; a polish still mirrors what of it is up.
    /// let lamp = DistantSphere::<f32>::of(&DistantLight::from_ratio(0.3)?);
    /// let (n, v, l) = ([0.0, 0.0, 1.0], [-0.98, 0.0, 0.199], [0.9998, 0.0, -0.02]);
    /// assert_eq!(ConeGgx::new(&lamp, 0.05).shade(n, v, l), Gloss::DARK);
    /// assert!(ShiftedConeGgx::new(&lamp, 0.05).shade(n, v, l).level > 0.0);
    /// # Ok::<(), sunglint::LightError>(())
    /// ```
    pub fn new(sphere: &DistantSphere<T>, alpha: T::Scalar) -> Self {
        let cone = ConeGgx::new(sphere, alpha);
        let Width { disc, alpha_square: rough, .. } = cone.lobe.width;
        let sum = disc + rough;
        let near = if sum > T::Scalar::ZERO { disc / sum } else { T::Scalar::ZERO };
        let far = T::Scalar::ONE - near;
        let shares = [T::narrow(near), T::narrow(near - T::Scalar::ONE)];
        Self { cone, sphere: *sphere, shares, spread: near * far }
    }
}

impl<T: Real> Highlight<T> for ShiftedConeGgx<T> {
    #[inline]
    fn shade(&self, n: [T; 3], v: [T; 3], l: [T; 3]) -> Gloss<T::Scalar> {
        let cosine = |a, b| T::scalar(T::dot(a, b));
        let [near, less_far] = self.shares;
        let nearest = cap(l, reflect(n, v), &self.sphere);
        let middle = T::diff(near, nearest, less_far, l);
        let [n_dot_m, n_dot_v] = [cosine(n, middle), cosine(n, v)];
        let visibility = self.cone.lobe.width.visibility(n_dot_m, n_dot_v);
        // The half vector of the middle: (v.h)^2, and 2 (v.h)^2 / (n.m + n.v), which is (v.h) / (n.h). (v.h)^2 = (1 +
        // m.v) / 2, where nothing cancels: the middle is short by what the two that it is between are apart.
        let (sum, apart) = (zip(middle, v, T::add), zip(nearest, l, T::sub));
        let square = cosine(sum, sum) + cosine(apart, apart) * self.spread;
        let v_dot_h_square = square * T::Scalar::constant(QUARTER);
        if !(positive(visibility) && positive(v_dot_h_square)) {
            return Gloss::DARK;
        }
        let shape = self.cone.shape([n, v, l], cosine(n, l), n_dot_v);
        let slant = (v_dot_h_square + v_dot_h_square) / (n_dot_m + n_dot_v);
        let level = shape.value * shape.cosine_square.root() * visibility * slant * T::Scalar::constant(FOUR_OVER_PI);
        Gloss::of(level, self.cone.lobe.width.inverse, v_dot_h_square.root())
    }
}
