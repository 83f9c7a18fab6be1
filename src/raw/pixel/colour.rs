//! What a channel makes of the two shares of light: the matt part, and the highlight by Schlick's reflectance.

use super::short::{Short, distance, share};
use crate::real::{INVERSE_PI, Scalar, Scaled};
use crate::vec3::each;

/// What one channel needs.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Colour {
    /// Bits below Q16 that sums are formed with.
    guard: u32,
    /// Half of Q16's last place.
    half: u32,
    /// Radiance of the surface facing the light, without its highlight: a mantissa, and how far its product with that
    /// of a cosine is to be shifted down.
    matt: u32,
    matt_shift: i32,
    /// Illuminance times the reflectance at normal incidence, a mantissa of 31 bits.
    mirrored: u32,
    /// Illuminance times what that reflectance lacks, of 16 bits.
    missing: u32,
    /// The exponent of both for sums.
    exponent: i32,
}

/// A highlight without its colour.
#[derive(Clone, Copy)]
pub(super) struct Gloss {
    /// `D V (n.l)`.
    pub(super) level: Short,
    /// Schlick's weight, Q32.
    pub(super) fresnel: u32,
}

impl Gloss {
    /// None.
    pub(super) const DARK: Self = Self { level: Short { mantissa: 0, exponent: 0 }, fresnel: 0 };
}

impl Colour {
    /// Of a light that is out.
    pub(super) const BLACK: Self =
        Self { guard: 0, half: 0, matt: 0, matt_shift: 0, mirrored: 0, missing: 0, exponent: 0 };

    pub(super) fn of(illuminance: Scaled, albedo: Scaled, f0: Scaled) -> Self {
        let white = illuminance * Scaled::constant(INVERSE_PI);
        let [e, white, matt] = each([illuminance, white, white * albedo], Short::of);
        // Sums stay below 2^32: a highlight's are below 2^31.
        let guard = 14_i32.wrapping_sub(white.exponent).clamp(0, 6);
        Self {
            guard: guard as u32,
            half: 1_u32.wrapping_shl(guard as u32) >> 1,
            matt: matt.mantissa,
            matt_shift: 16_i32.wrapping_sub(guard).wrapping_sub(matt.exponent),
            mirrored: share(f0.to_q31(), e.mantissa),
            missing: ((Scaled::ONE - f0).to_q31() >> 15).wrapping_mul(e.mantissa) >> 16,
            exponent: e.exponent.wrapping_sub(15).wrapping_add(guard),
        }
    }

    /// In Q16; saturates.
    #[inline(always)]
    pub(super) fn radiance(&self, facing: Short, gloss: &Gloss) -> u32 {
        let matt = self.matt.wrapping_mul(facing.mantissa) >> distance(self.matt_shift, facing.exponent);
        let reflected = self.mirrored.wrapping_add(share(gloss.fresnel, self.missing) >> 1);
        let bits = share(reflected, gloss.level.mantissa);
        let exponent = self.exponent.wrapping_add(gloss.level.exponent);
        let matt = matt.wrapping_add(self.half);
        if exponent > 0 {
            return bright(bits, exponent.wrapping_sub(self.guard as i32), matt.wrapping_shr(self.guard));
        }
        matt.wrapping_add(bits >> distance(0, exponent)).wrapping_shr(self.guard)
    }
}

/// A bright highlight and the rest, `bits * 2^exponent + matt`; saturates.
#[cold]
#[inline(never)]
fn bright(bits: u32, exponent: i32, matt: u32) -> u32 {
    let room = bits.leading_zeros() as i32;
    let glossy = match exponent {
        ..=0 => bits >> distance(0, exponent),
        up if up <= room => bits.wrapping_shl(up as u32),
        _ if bits == 0 => 0,
        _ => u32::MAX,
    };
    glossy.saturating_add(matt)
}

/// `(1 - v.h)^5` in Q32, of `2 (v.h)`.
#[inline(always)]
pub(super) fn schlick(twice: Short) -> u32 {
    let cosine = (twice.mantissa << 1) >> (2_i32.wrapping_sub(twice.exponent) as u32 & 31);
    let rest = 65_536_i32.wrapping_sub(cosine as i32).max(0) as u32;
    let square = rest.wrapping_mul(rest) >> 16;
    (square.wrapping_mul(square).wrapping_add(1 << 15) >> 16).wrapping_mul(rest)
}
