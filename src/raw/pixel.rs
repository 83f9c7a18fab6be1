//! A whole lit pixel in Q14, in products of 32 bits.

mod colour;
mod lobe;
mod short;
mod table;

use fixed::types::I2F14;

use self::colour::{Colour, Gloss, schlick};
use self::lobe::{Lean, Lobe};
use self::short::{Long, Short, distance, normalised};
use super::SphereQ14;
use super::scene::{SurfaceQ14, lamp_q14};
use crate::diffuse::relative_illuminance;
use crate::real::Scaled;
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
