//! A whole lit pixel in Q14, in products of 32 bits.

mod short;
mod table;

use fixed::types::I2F14;

use self::short::{Long, Short, share};
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
    smith: Smith,
    lobe: Lobe,
    channels: [Colour; 3],
}

/// A roughness as Smith's roots need it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Smith {
    /// How far cosines are shifted up before they are squared: `2^octaves alpha` is above 1/2, but not above 1.
    octaves: u32,
    /// The square of that, Q16.
    square: u32,
}

/// A roughness and a disc in units of the highlight's width `b`, `b^2 = alpha^2 + w/2`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Lobe {
    /// `1 / b^2`.
    inverse: Short,
    /// `(alpha / b)^2`.
    rough: Short,
    /// `w / b^2`.
    disc: Short,
    /// `4 w (alpha / b^2)^2`.
    both: Short,
    /// `alpha^2 / (pi b^4 (1 - w/2))`.
    outside: Short,
    /// `1 / (4 pi w (1 - w/2))`.
    inside: Short,
}

/// What one channel needs.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Colour {
    /// Bits below Q16 that sums are formed with.
    guard: u32,
    /// Radiance of the surface facing the light, without its highlight, with those bits.
    matt: u32,
    illuminance: Short,
    /// Reflectance at normal incidence, Q31.
    f0: u32,
    /// What that leaves of 1, Q15.
    missing: u32,
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
        let [e, albedo, f0] = [illuminance.map(|bits| Scaled::from_unsigned(bits.into(), -16)), surface.albedo, surface.f0];
        let colour = |channel: usize| Colour::of(e[channel], albedo[channel], f0[channel]);
        Ok(Self {
            direction: each(direction, i32::from),
            light: *light,
            rim: if light.cos >= 0 { light.sin } else { i32::MAX },
            smith: Smith::of(surface.alpha),
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
        let toward_light = cosine(n_dot_l);
        let facing = if n_dot_l >= self.rim { toward_light } else { self.astride(n_dot_l) };
        if n_dot_l <= 0 || n_dot_v <= GRAZING {
            return Some((facing, Gloss::DARK));
        }
        let toward_viewer = cosine(n_dot_v);
        let sum = [l[0].wrapping_add(v[0]), l[1].wrapping_add(v[1]), l[2].wrapping_add(v[2])];
        let square = dot(sum, sum) as u32;
        let square = Long { mantissa: square | 1, exponent: 4 }.normalised();
        let root = square.root();
        let upright = toward_upright(n_dot_l, n_dot_v);
        let tilt = tilt(cross(n, sum));
        let shadow = self.smith.denominator(toward_light, toward_viewer);
        let level = self.lobe.level(square.short(), root, upright, tilt, toward_light, shadow);
        Some((facing, Gloss { level, fresnel: schlick(root) }))
    }

    /// The share of a disc that the surface cuts, or of one beyond half the sky.
    #[cold]
    #[inline(never)]
    fn astride(&self, n_dot_l: i32) -> Short {
        let share = Short::of(relative_illuminance::<I2F14>(n_dot_l, &self.light));
        if share.exponent > 0 { cosine(MOST) } else { share }
    }
}

/// `n.v` in Q28 up to which there is no highlight: `2^-14`.
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

/// The least cosine that is 1 in Q28, less one.
const MOST: i32 = (1 << 28) - 1;

/// A cosine in Q28.
#[inline(always)]
fn cosine(bits: i32) -> Short {
    Long { mantissa: bits.min(MOST) as u32, exponent: 4 }.normalised().short()
}

/// `n.l + n.v`.
#[inline(always)]
fn toward_upright(n_dot_l: i32, n_dot_v: i32) -> Short {
    Long { mantissa: n_dot_l.min(MOST).wrapping_add(n_dot_v.min(MOST)) as u32, exponent: 4 }.normalised().short()
}

/// The square of a vector in Q28, of which the greatest lane keeps 15 bits.
#[inline(always)]
fn tilt(lanes: [i32; 3]) -> Long {
    let [x, y, z] = each(lanes, |lane| (lane ^ (lane >> 31)) as u32);
    let (_, zeros) = short::normalised(x | y | z);
    let shift = 17_u32.saturating_sub(zeros);
    let half = (1_i32 << shift) >> 1;
    let lanes = each(lanes, |lane| lane.wrapping_add(half) >> shift);
    Long { mantissa: dot(lanes, lanes) as u32, exponent: ((shift << 1) as i32).wrapping_sub(24) }
}

/// `(1 - v.h)^5` in Q32, of `2 (v.h)`.
#[inline(always)]
fn schlick(twice: Short) -> u32 {
    let cosine = (twice.mantissa << 1) >> (2_i32.wrapping_sub(twice.exponent).clamp(0, 31) as u32);
    let rest = 65_536_u32.saturating_sub(cosine) & 0xffff;
    let square = rest.wrapping_mul(rest).wrapping_add(1 << 15) >> 16;
    share(square.wrapping_mul(square), rest)
}

impl Smith {
    fn of(alpha: Scaled) -> Self {
        let mut octaves = 0;
        let mut grown = alpha;
        while octaves < 28 && grown + grown <= Scaled::ONE {
            grown = grown + grown;
            octaves += 1;
        }
        Self { octaves, square: (grown * grown).to_unsigned(16) as u32 }
    }

    /// `(n.l) L(n.v) + (n.v) L(n.l)`.
    #[inline(always)]
    fn denominator(&self, toward_light: Short, toward_viewer: Short) -> Short {
        let [light, viewer] = [self.root(toward_light), self.root(toward_viewer)];
        toward_light.product(viewer).plus(toward_viewer.product(light)).normalised().short()
    }

    /// `L(c) = sqrt(c^2 + alpha^2 (1 - c^2))`.
    #[inline(always)]
    fn root(&self, cosine: Short) -> Short {
        // As far as the cosine lies below 1, but no farther than alpha.
        let zeros = 0_i32.wrapping_sub(cosine.exponent).max(0) as u32;
        let shift = zeros.min(self.octaves);
        let shifted = cosine.mantissa >> zeros.wrapping_sub(shift).min(31);
        let square = shifted.wrapping_mul(shifted);
        // Q15.
        let rest = 32_768_u32.wrapping_sub((square >> 17) >> (shift << 1).min(31));
        let rough = rest.wrapping_mul(self.square) >> (self.octaves.wrapping_sub(shift) << 1).min(31);
        let mantissa = (square >> 2).wrapping_add(rough >> 1);
        Long { mantissa, exponent: 2_i32.wrapping_sub((shift << 1) as i32) }.root()
    }
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
            return Self { inverse: DARK, rough: DARK, disc: DARK, both: DARK, outside: DARK, inside: DARK };
        }
        let (inverse, rough) = (one / square, alpha * alpha / square);
        let disc = (half_disc + half_disc) / square;
        let four = Scaled::from_bits(4, 0);
        let facing = Scaled::constant(INVERSE_PI) / (one - versine * Scaled::constant(HALF));
        Self {
            inverse: Short::of(inverse),
            rough: Short::of(rough),
            disc: Short::of(disc),
            both: Short::of(four * rough * disc),
            outside: Short::of(rough * inverse * facing),
            inside: Short::of(facing / (four * (half_disc + half_disc))),
        }
    }

    #[inline(always)]
    fn level(&self, square: Short, root: Short, upright: Short, tilt: Long, toward_light: Short, shadow: Short) -> Short {
        let upright_square = upright.times(upright);
        let rough = upright_square.product(self.rough);
        let disc = root.product(self.disc);
        let exponent = tilt.exponent.wrapping_add(self.inverse.exponent);
        let tilt = Long { mantissa: share(tilt.mantissa, self.inverse.mantissa), exponent };
        // Two bits for sums of three.
        let exponent = tilt.exponent.max(rough.exponent).max(disc.exponent).wrapping_add(2);
        let p = tilt.at(exponent).wrapping_add(rough.at(exponent)).wrapping_sub(disc.at(exponent)) as i32;
        let size = Long { mantissa: p.unsigned_abs(), exponent }.normalised().short();
        let both = upright_square.times(root).product(self.both);
        let hypotenuse = size.product(size).plus(both).root();
        let sum = hypotenuse.plus(size);
        let over = toward_light.times(square);
        let under = shadow.times(hypotenuse);
        let (over, under) = if p < 0 {
            (over.times(root).times(self.inside).times(sum), under.times(upright_square))
        } else {
            (over.times(square).times(self.outside), under.times(sum))
        };
        over.times(under.reciprocal())
    }
}

impl Colour {
    fn of(illuminance: Scaled, albedo: Scaled, f0: Scaled) -> Self {
        let white = illuminance * Scaled::constant(INVERSE_PI);
        // Below 2^31, since illuminance is below 2^16.
        let guard = (white.to_unsigned(16) as u32).leading_zeros().saturating_sub(2).min(8);
        Self {
            guard,
            matt: (white * albedo).to_unsigned(16_u32.wrapping_add(guard)) as u32,
            illuminance: Short::of(illuminance),
            f0: f0.to_q31(),
            missing: (Scaled::ONE - f0).to_unsigned(15) as u32,
        }
    }

    /// In Q16; saturates.
    #[inline(always)]
    fn radiance(&self, facing: Short, gloss: &Gloss) -> u32 {
        let matt = share(self.matt, facing.mantissa) >> (0_i32.wrapping_sub(facing.exponent).clamp(0, 31) as u32);
        let reflectance = self.f0.wrapping_add(share(gloss.fresnel, self.missing));
        let bits = share(share(reflectance, self.illuminance.mantissa), gloss.level.mantissa);
        // Of bits in Q16.
        let exponent = self.illuminance.exponent.wrapping_add(gloss.level.exponent).wrapping_sub(15);
        let glossy = shifted(bits, exponent.wrapping_add(self.guard as i32));
        if glossy >> 31 == 0 {
            let half = 1_u32.wrapping_shl(self.guard) >> 1;
            return matt.wrapping_add(glossy).wrapping_add(half).wrapping_shr(self.guard);
        }
        bright(bits, exponent, matt.wrapping_shr(self.guard))
    }
}

/// `bits * 2^exponent`, cut; saturates.
#[inline(always)]
fn shifted(bits: u32, exponent: i32) -> u32 {
    if exponent <= 0 {
        return bits >> (0_i32.wrapping_sub(exponent).clamp(0, 31) as u32);
    }
    let up = exponent as u32;
    if up < 32 && (bits << up) >> up == bits {
        bits << up
    } else if bits == 0 {
        0
    } else {
        u32::MAX
    }
}

/// The sum without bits below Q16.
#[cold]
#[inline(never)]
fn bright(bits: u32, exponent: i32, matt: u32) -> u32 {
    shifted(bits, exponent).saturating_add(matt)
}
