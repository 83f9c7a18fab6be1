//! What every highlight shares: shadowing by Smith (height-correlated: E. Heitz, 2014), reflectance by Schlick (1994).

use super::HALF;
use crate::real::{Constant, Scalar};

/// `V (n.l)`: the height-correlated Smith visibility `1 / (2 ((n.l) L(n.v) + (n.v) L(n.l)))`, with `L(c) =
/// sqrt(alpha^2 + (1 - alpha^2) c^2)`, times the cosine of the light. Cosines and `alpha` are from 0 to 1.
///
/// The product stays below `1 / (2 alpha)`, where the visibility alone would reach `1 / (4 alpha^2)` and more than f16
/// holds. For `alpha = 0` it is `1 / (4 n.v)`. Zero where `n.l` is zero, negative or NaN, and where `n.v` is not above
/// `2^-14`, which is grazing to a 300th of a degree.
///
/// ```
/// use sunglint::highlight::smith;
///
/// // Nothing is in the shadow where light and viewer are upright, whatever the roughness.
/// assert_eq!(smith(1.0_f32, 1.0, 0.5), 0.25);
/// // 84 degrees off the normal chalk hides nine tenths of what a mirror, which has no shadows, shows: 1 / (4 n.v).
/// let [mirror, chalk] = [0.0, 1.0].map(|alpha| smith(0.1_f32, 0.1, alpha));
/// assert!((mirror - 2.5).abs() < 1e-6 && (chalk - 0.25).abs() < 1e-6);
/// assert_eq!(smith(-0.1_f32, 0.5, 0.3), 0.0);
/// ```
#[inline]
pub fn smith<S: Scalar>(n_dot_l: S, n_dot_v: S, alpha: S) -> S {
    visibility(n_dot_l, n_dot_v, alpha, flatness(alpha))
}

/// `sqrt(1 - alpha^2)`.
#[inline]
pub(super) fn flatness<S: Scalar>(alpha: S) -> S {
    smoothness(alpha).root()
}

/// `1 - alpha^2`.
#[inline]
pub(super) fn smoothness<S: Scalar>(alpha: S) -> S {
    (S::ONE - alpha) * (S::ONE + alpha)
}

/// [`smith`] of a roughness whose [`flatness`] is known.
#[inline]
pub(super) fn visibility<S: Scalar>(n_dot_l: S, n_dot_v: S, alpha: S, flatness: S) -> S {
    const GRAZING: Constant = Constant::new(1.0 / 16384.0);
    let lit = n_dot_l > S::ZERO && n_dot_v > S::constant(GRAZING);
    if !lit {
        return S::ZERO;
    }
    let [toward_light, toward_viewer] = [n_dot_l, n_dot_v].map(|cosine| S::hypotenuse(alpha, flatness * cosine));
    S::constant(HALF) / (toward_viewer + n_dot_v * (toward_light / n_dot_l))
}

/// `(1 - v.h)^5` of a cosine from 0 to 1, Schlick's weight of the reflectance that is missing at normal incidence; 0
/// for a cosine above 1, and for NaN.
///
/// ```
/// use sunglint::half::f16;
/// use sunglint::highlight::schlick;
///
/// assert_eq!([1.0, 0.5, 0.0].map(|v_dot_h| schlick(f16::from_f32(v_dot_h)).to_f32()), [0.0, 1.0 / 32.0, 1.0]);
/// // Glass from 60 degrees off its normal reflects 7 per cent.
/// let glass = |v_dot_h: f32| 0.04 + (1.0 - 0.04) * schlick(v_dot_h);
/// assert_eq!(glass(0.5), 0.07);
/// ```
#[inline]
pub fn schlick<S: Scalar>(v_dot_h: S) -> S {
    let rest = S::ONE - v_dot_h;
    let rest = if rest > S::ZERO { rest } else { S::ZERO };
    let square = rest * rest;
    square * square * rest
}

/// `(n.h)^2 = (n.l + n.v)^2 / (4 (v.h)^2)`, which no subtraction takes below zero; zero where `n.l + n.v` is not above
/// it.
#[inline]
pub(super) fn upright<S: Scalar>(n_dot_l: S, n_dot_v: S, v_dot_h_square: S) -> S {
    let half = (n_dot_l + n_dot_v) * S::constant(HALF);
    if half > S::ZERO { half / v_dot_h_square * half } else { S::ZERO }
}

/// `4 / pi`.
pub(super) const FOUR_OVER_PI: Constant = Constant::new(4.0 * core::f64::consts::FRAC_1_PI);
