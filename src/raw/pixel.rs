//! A whole lit pixel in Q14, in products of 32 bits.

mod short;
mod table;

use fixed::types::I2F14;

use self::short::{Long, Short, distance, normalised, share};
use super::SphereQ14;
use super::scene::{SurfaceQ14, lamp_q14};
use crate::diffuse::relative_illuminance;
use crate::highlight::extent;
use crate::real::{HALF, INVERSE_PI, Scalar, Scaled, positive};
use crate::scene::{Channel, SceneError};
use crate::vec3::each;

/// One light on one material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelQ14 {
    direction: [i32; 3],
    light: SphereQ14,
    /// Least `n.l` in Q28 that leaves all of the disc above the surface; none for discs beyond half the sky.
    rim: i32,
    /// `alpha^2`: a mantissa, and how far its product with a Q16 number is to be shifted down to be Q30.
    alpha_square: u32,
    alpha_shift: u32,
    lobe: Lobe,
    channels: [Colour; 3],
}

/// A roughness and a disc in units of the highlight's width `b`, `b^2 = alpha^2 + w/2`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Lobe {
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

/// What one channel needs.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Colour {
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

impl PixelQ14 {
    /// The constants of a light in a unit `direction`, Q14, that gives a surface which faces it `illuminance`, Q16.
    ///
    /// # Errors
    /// [`SceneError::Direction`] where the length is not within a tenth of 1.
    pub fn new(
        direction: [i16; 3],
        light: &SphereQ14,
        surface: &SurfaceQ14,
        illuminance: [u32; 3],
    ) -> Result<Self, SceneError<Scaled>> {
        lamp_q14(direction, light, illuminance)?;
        let [e, albedo, f0] =
            [illuminance.map(|bits| Scaled::from_unsigned(bits.into(), -16)), surface.albedo, surface.f0];
        let colour = |channel: usize| Colour::of(e[channel], albedo[channel], f0[channel]);
        let alpha_square = Short::of(surface.alpha * surface.alpha);
        Ok(Self {
            direction: each(direction, i32::from),
            light: *light,
            rim: if light.cos >= 0 { light.sin } else { i32::MAX },
            alpha_square: alpha_square.mantissa,
            alpha_shift: distance(2, alpha_square.exponent),
            lobe: Lobe::of(light, surface.alpha),
            channels: [colour(0), colour(1), colour(2)],
        })
    }

    /// Radiance in one channel, Q16.
    pub fn shade_channel(&self, n: [i16; 3], v: [i16; 3], channel: Channel) -> u32 {
        let [red, green, blue] = &self.channels;
        let colour = match channel {
            Channel::Red => red,
            Channel::Green => green,
            Channel::Blue => blue,
        };
        match self.seen(n, v) {
            Some((facing, gloss)) => colour.radiance(facing, &gloss),
            None => 0,
        }
    }

    /// Radiance in red, green and blue, Q16.
    pub fn shade(&self, n: [i16; 3], v: [i16; 3]) -> [u32; 3] {
        match self.seen(n, v) {
            Some((facing, gloss)) => {
                let [red, green, blue] = &self.channels;
                [red, green, blue].map(|colour| colour.radiance(facing, &gloss))
            }
            None => [0; 3],
        }
    }

    /// The plane's share of the illuminance, and the highlight; nothing for a viewer below the surface.
    #[inline(always)]
    fn seen(&self, n: [i16; 3], v: [i16; 3]) -> Option<(Short, Gloss)> {
        let (n, v, l) = (each(n, i32::from), each(v, i32::from), self.direction);
        let (n_dot_l, n_dot_v) = (dot(n, l), dot(n, v));
        if n_dot_v <= 0 {
            return None;
        }
        if n_dot_l <= GRAZING || n_dot_v <= GRAZING {
            return Some((self.facing(n_dot_l), Gloss::DARK));
        }
        let sum = [l[0].wrapping_add(v[0]), l[1].wrapping_add(v[1]), l[2].wrapping_add(v[2])];
        let (square, tilt) = (dot(sum, sum) as u32, tilt(cross(n, sum)));
        let square = Long { mantissa: square, exponent: 4 }.normalised::<31>();
        let root = square.root();
        let upright = cosine(n_dot_l.wrapping_add(n_dot_v) >> 1);
        let (toward_light, toward_viewer) = (cosine(n_dot_l), cosine(n_dot_v));
        let shadow = self.shadow(toward_light, toward_viewer);
        let lean = Lean { square: square.short(), root, upright, tilt };
        let level = self.lobe.level(&lean, toward_light, shadow);
        let facing = if n_dot_l >= self.rim { toward_light } else { self.astride(n_dot_l) };
        Some((facing, Gloss { level, fresnel: schlick(root) }))
    }

    /// The share of the illuminance that a plane gets.
    #[inline(always)]
    fn facing(&self, n_dot_l: i32) -> Short {
        if n_dot_l >= self.rim { cosine(n_dot_l) } else { self.astride(n_dot_l) }
    }

    /// `(n.l) L(n.v) + (n.v) L(n.l)`, Smith's.
    #[inline(always)]
    fn shadow(&self, toward_light: Short, toward_viewer: Short) -> Short {
        let [light, viewer] = [self.smith(toward_light), self.smith(toward_viewer)];
        toward_light.product(viewer).plus(toward_viewer.product(light)).normalised::<3>().short()
    }

    /// `L(c) = sqrt(c^2 + alpha^2 (1 - c^2))`.
    #[inline(always)]
    fn smith(&self, cosine: Short) -> Short {
        // Q30; a cosine's exponent is from -13 to 1.
        let lower = 2_i32.wrapping_sub(cosine.exponent.wrapping_mul(2)) as u32 & 31;
        let square = cosine.mantissa.wrapping_mul(cosine.mantissa) >> lower;
        let rest = 65_536_i32.wrapping_sub((square >> 14) as i32).max(0) as u32;
        let rough = rest.wrapping_mul(self.alpha_square).wrapping_shr(self.alpha_shift);
        Long { mantissa: square.wrapping_add(rough), exponent: 2 }.normalised::<31>().root()
    }

    /// The share of a disc that the surface cuts, or of one beyond half the sky.
    #[cold]
    #[inline(never)]
    fn astride(&self, n_dot_l: i32) -> Short {
        let share = Short::of(relative_illuminance::<I2F14>(n_dot_l, &self.light));
        if share.exponent > 0 { Short { mantissa: 0xffff, exponent: 0 } } else { share }
    }
}

/// `n.l` and `n.v` in Q28 up to which there is no highlight: `2^-14`.
const GRAZING: i32 = 1 << 14;

/// A highlight without its colour.
#[derive(Clone, Copy)]
struct Gloss {
    /// `D V (n.l)`.
    level: Short,
    /// Schlick's weight, Q32.
    fresnel: u32,
}

impl Gloss {
    const DARK: Self = Self { level: Short { mantissa: 0, exponent: 0 }, fresnel: 0 };
}

#[inline(always)]
fn dot(a: [i32; 3], b: [i32; 3]) -> i32 {
    let [x, y, z] = [a[0].wrapping_mul(b[0]), a[1].wrapping_mul(b[1]), a[2].wrapping_mul(b[2])];
    x.wrapping_add(y).wrapping_add(z)
}

#[inline(always)]
fn cross(a: [i32; 3], b: [i32; 3]) -> [i32; 3] {
    let minor = |p: i32, q: i32, r: i32, s: i32| p.wrapping_mul(q).wrapping_sub(r.wrapping_mul(s));
    [minor(a[1], b[2], a[2], b[1]), minor(a[2], b[0], a[0], b[2]), minor(a[0], b[1], a[1], b[0])]
}

/// A cosine in Q28; its bits are all there from `2^-14` on.
#[inline(always)]
fn cosine(bits: i32) -> Short {
    Long { mantissa: (bits << 2) as u32, exponent: 2 }.normalised::<15>().short()
}

/// The square of a vector in Q28, of which the greatest lane keeps 15 bits.
#[inline(always)]
fn tilt(lanes: [i32; 3]) -> Long {
    let [x, y, z] = each(lanes, |lane| (lane ^ (lane >> 31)) as u32);
    let (_, zeros) = normalised::<31>(x | y | z);
    let shift = 17_i32.wrapping_sub(zeros as i32).max(0) as u32;
    let half = (1_i32 << shift) >> 1;
    let lanes = each(lanes, |lane| lane.wrapping_add(half) >> shift);
    Long { mantissa: dot(lanes, lanes) as u32, exponent: ((shift << 1) as i32).wrapping_sub(24) }
}

/// `(1 - v.h)^5` in Q32, of `2 (v.h)`.
#[inline(always)]
fn schlick(twice: Short) -> u32 {
    let cosine = (twice.mantissa << 1) >> (2_i32.wrapping_sub(twice.exponent) as u32 & 31);
    let rest = 65_536_i32.wrapping_sub(cosine as i32).max(0) as u32;
    let square = rest.wrapping_mul(rest).wrapping_add(1 << 15) >> 16;
    (square.wrapping_mul(square).wrapping_add(1 << 15) >> 16).wrapping_mul(rest)
}

impl Lobe {
    fn of(light: &SphereQ14, alpha: Scaled) -> Self {
        const DARK: Short = Short { mantissa: 0, exponent: 0 };
        let [sin, versine] = extent(light);
        let one = Scaled::ONE;
        let cosine = one - versine;
        let half_disc = sin * sin / (one + one + cosine + cosine);
        let square = alpha * alpha + half_disc;
        if !positive(square) {
            return Self { inverse: DARK, rough: DARK, disc: DARK, outside: DARK, inside: DARK };
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

    /// `D V (n.l)`.
    #[inline(always)]
    fn level(&self, lean: &Lean, toward_light: Short, shadow: Short) -> Short {
        let upright_square = lean.upright.product(lean.upright).short();
        let (rough, disc) = (upright_square.product(self.rough), lean.root.product(self.disc));
        let p = self.difference(rough, disc, &lean.tilt);
        let size = Long { mantissa: p.mantissa.unsigned_abs(), exponent: p.exponent }.normalised::<31>().short();
        let product = rough.short().product(disc.short());
        let both = Long { exponent: product.exponent.wrapping_add(2), ..product };
        let hypotenuse = size.product(size).plus(both).normalised::<7>().root();
        // Half of it.
        let sum = hypotenuse.mean(size);
        let (over, under) = (toward_light.times(lean.square), shadow.times(hypotenuse));
        let (over, under) = if p.mantissa < 0 {
            (over.times(lean.root).times(self.inside).times(sum), under.product(upright_square))
        } else {
            (over.times(lean.square).times(self.outside), under.product(sum))
        };
        over.times(under.normalised::<3>().short().reciprocal())
    }

    /// `p`.
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

/// How the normal leans from the half vector.
struct Lean {
    /// `|l + v|^2`.
    square: Short,
    /// `|l + v|`.
    root: Short,
    /// `(n.l + n.v) / 2`.
    upright: Short,
    /// `|n x (l + v)|^2`.
    tilt: Long,
}

/// A [`Long`] with a sign.
struct Signed {
    mantissa: i32,
    exponent: i32,
}

impl Colour {
    fn of(illuminance: Scaled, albedo: Scaled, f0: Scaled) -> Self {
        let white = illuminance * Scaled::constant(INVERSE_PI);
        let [e, white, matt] = [illuminance, white, white * albedo].map(Short::of);
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
    fn radiance(&self, facing: Short, gloss: &Gloss) -> u32 {
        let matt = self.matt.wrapping_mul(facing.mantissa) >> distance(self.matt_shift, facing.exponent);
        let reflected = self.mirrored.wrapping_add(share(gloss.fresnel, self.missing) >> 1);
        let bits = share(reflected, gloss.level.mantissa);
        let exponent = self.exponent.wrapping_add(gloss.level.exponent);
        if exponent > 0 {
            return bright(bits, exponent.wrapping_sub(self.guard as i32), matt.wrapping_shr(self.guard));
        }
        let glossy = bits >> distance(0, exponent);
        matt.wrapping_add(glossy).wrapping_add(self.half).wrapping_shr(self.guard)
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
