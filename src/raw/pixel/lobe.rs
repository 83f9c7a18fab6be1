//! GGX averaged over the disc, with Smith's shadowing put under the same fraction.

use super::super::SphereQ14;
use super::short::{Long, Short, distance, share};
use crate::highlight::extent;
use crate::real::{HALF, INVERSE_PI, Scalar, Scaled, positive};

/// A roughness and a disc in units of the highlight's width `b`, `b^2 = alpha^2 + w/2`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Lobe {
    /// `1 / b^2`.
    inverse: Short,
    /// `(2 alpha / b)^2`.
    rough: Short,
    /// `w / b^2`.
    disc: Short,
    /// `alpha^2 / (2 pi b^4 (1 - w/2))`.
    outside: Short,
    /// `1 / (8 pi w (1 - w/2))`.
    inside: Short,
}

/// How the normal leans from the half vector.
pub(super) struct Lean {
    /// `|l + v|^2`.
    pub(super) square: Short,
    /// `|l + v|`.
    pub(super) root: Short,
    /// `(n.l + n.v) / 2`.
    pub(super) upright: Short,
    /// `|n x (l + v)|^2`.
    pub(super) tilt: Long,
}

/// A [`Long`] with a sign.
struct Signed {
    mantissa: i32,
    exponent: i32,
}

impl Lobe {
    /// No highlight.
    pub(super) const DARK: Self = {
        const ZERO: Short = Short { mantissa: 0, exponent: 0 };
        Self { inverse: ZERO, rough: ZERO, disc: ZERO, outside: ZERO, inside: ZERO }
    };

    pub(super) fn of(light: &SphereQ14, alpha: Scaled) -> Self {
        let [sin, versine] = extent(light);
        let one = Scaled::ONE;
        let cosine = one - versine;
        let half_disc = sin * sin / (one + one + cosine + cosine);
        let square = alpha * alpha + half_disc;
        if !positive(square) {
            return Self::DARK;
        }
        let (inverse, rough) = (one / square, alpha * alpha / square);
        let disc = (half_disc + half_disc) / square;
        let (half, four) = (Scaled::constant(HALF), Scaled::from_bits(4, 0));
        let facing = Scaled::constant(INVERSE_PI) / (one - versine * half);
        Self {
            inverse: Short::of(inverse),
            rough: Short::of(four * rough),
            disc: Short::of(disc),
            outside: Short::of(rough * inverse * facing * half),
            inside: Short::of(facing / (four * four * half_disc)),
        }
    }

    /// `D V (n.l)`, of Smith's `(n.l) L(n.v) + (n.v) L(n.l)`; all of [`Lean`] in units of `b`.
    #[inline(always)]
    pub(super) fn level(&self, lean: &Lean, toward_light: Short, shadow: Short) -> Short {
        let upright_square = lean.upright.product(lean.upright).short();
        let (rough, disc) = (upright_square.product(self.rough), lean.root.product(self.disc));
        let p = self.difference(rough, disc, &lean.tilt);
        let size = Long { mantissa: p.mantissa.unsigned_abs(), exponent: p.exponent }.normalised::<31>().short();
        // 4 alpha^2 A^2 w |l + v| / b^4; where it counts, P is no greater.
        let product = rough.short().product(disc.short());
        let both = Long { exponent: product.exponent.wrapping_add(2), ..product };
        let hypotenuse = size.product(size).plus(both).normalised::<7>().root();
        // Half of H + |P|.
        let sum = hypotenuse.mean(size);
        let (over, under) = (toward_light.times(lean.square), shadow.times(hypotenuse));
        let (over, under) = if p.mantissa < 0 {
            let over = over.product(lean.root).normalised::<3>().short();
            (over.times(self.inside).times(sum), under.product(upright_square))
        } else {
            let over = over.product(lean.square).normalised::<3>().short();
            (over.times(self.outside), under.product(sum))
        };
        over.times(under.normalised::<3>().short().reciprocal())
    }

    /// `P / b^2`. Its terms may cancel, near the rim of a sharp image, hence keep up to 32 bits.
    #[inline(always)]
    fn difference(&self, rough: Long, disc: Long, tilt: &Long) -> Signed {
        let mantissa = share(tilt.mantissa, self.inverse.mantissa) >> 1;
        // Q27, or as much coarser as a great tilt needs.
        let fixed = |long: Long| (long.mantissa >> distance(5, long.exponent)) as i32;
        let beside = fixed(rough).wrapping_sub(fixed(disc));
        let up = tilt.exponent.wrapping_add(self.inverse.exponent).wrapping_sub(4);
        if up < 0 {
            let mantissa = (mantissa >> distance(0, up)) as i32;
            return Signed { mantissa: mantissa.wrapping_add(beside), exponent: 5 };
        }
        let mantissa = (mantissa as i32).wrapping_add(beside >> distance(up, 0));
        Signed { mantissa, exponent: up.wrapping_add(5) }
    }
}
