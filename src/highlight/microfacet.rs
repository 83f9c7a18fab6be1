//! What every highlight shares: shadowing by Smith, reflectance by Schlick.

use super::{HALF, hypotenuse};
use crate::real::{Constant, Scalar};

/// `V (n.l)`: the height-correlated Smith visibility `1 / (2 ((n.l) L(n.v) + (n.v) L(n.l)))`, with `L(c) =
/// sqrt(alpha^2 + (1 - alpha^2) c^2)`, times the cosine of the light.
///
/// The product stays below `1 / (2 alpha)`, where the visibility alone would reach `1 / (4 alpha^2)` and more than f16
/// holds. For `alpha = 0` it is `1 / (4 n.v)`. Zero where either cosine is zero, negative or NaN.
#[inline]
pub fn smith<S: Scalar>(n_dot_l: S, n_dot_v: S, alpha: S) -> S {
    let lit = n_dot_l > S::ZERO && n_dot_v > S::ZERO;
    if !lit {
        return S::ZERO;
    }
    let smooth = ((S::ONE - alpha) * (S::ONE + alpha)).root();
    let [toward_light, toward_viewer] = [n_dot_l, n_dot_v].map(|cosine| hypotenuse(alpha, smooth * cosine));
    S::constant(HALF) / (toward_viewer + n_dot_v * (toward_light / n_dot_l))
}

/// `(1 - v.h)^5`, Schlick's weight of the reflectance that is missing at normal incidence; 0 for a cosine above 1.
#[inline]
pub fn schlick<S: Scalar>(v_dot_h: S) -> S {
    let rest = S::ONE - v_dot_h;
    let rest = if rest > S::ZERO { rest } else { S::ZERO };
    let square = rest * rest;
    square * square * rest
}

/// `4 / pi`.
pub(super) const FOUR_OVER_PI: Constant = Constant::new(4.0 * core::f64::consts::FRAC_1_PI);
