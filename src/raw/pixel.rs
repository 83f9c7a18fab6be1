//! A whole lit pixel in Q14, in products of 32 bits: beside the generic formula of [`shade_channel_q14`] a kernel of
//! its own, for chips on which that one's 64-bit products and divisions take too long.
//!
//! Numbers are [`Short`]: 16-bit mantissas with an exponent, so that a product is one instruction on the smallest core.
//! The fractions of Smith's shadowing and of GGX over the disc are put under one, for which there is one reciprocal;
//! of roots there are four. Everything is multiplied by `|l + v|^2`, so that neither `h` nor `1 / (v.h)` is needed:
//! with `A = n.l + n.v`, `P = alpha^2 A^2 + |n x (l + v)|^2 - w |l + v|` and `H^2 = P^2 + 4 alpha^2 A^2 w |l + v|`,
//!
//! `D = 2 alpha^2 |l + v|^4 / (pi H (H + P))`, and for `P < 0` the equal `(H - P) |l + v|^3 / (2 pi w A^2 H)`.
//!
//! [`shade_channel_q14`]: super::shade_channel_q14

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

/// One light on one material, its constants computed: the fast way to a whole pixel where products have 32 bits.
///
/// A pixel is Lambert's law by [`relative_illuminance`] and the highlight of
/// [`DiscGgx::new`](crate::highlight::DiscGgx::new) with Smith's shadowing and Schlick's reflectance, as
/// [`shade_channel_q14`](super::shade_channel_q14) makes it of a scene with that light alone and that method. For more
/// lights add up their pixels, saturating.
///
/// Directions are Q14 and of length 1 but for their rounding; up to 1.16 nothing overflows, and longer ones give some
/// colour, never a panic. Illuminance and radiance are unsigned Q16, and what is too great is `2^32 - 1`. Any light,
/// any `alpha` of a [`SurfaceQ14`].
///
/// Black where the surface faces away from the viewer. No highlight where `n.v` or `n.l` is at most `2^-14`, which is
/// a 300th of a degree and less than what the vectors' rounding moves them by; none for a mirror under a point.
///
/// # Error
/// By itself, against the exact value of the formula at the same vectors (`tests/pixel_q14.rs`, a million random
/// pixels): 6e-5 of the diffuse part, 6e-4 of the highlight (root mean square 4e-5) times the formula's condition,
/// which is 2 away from the disc's image and grows at the rim of a sharp one and within a tenth of a degree of the
/// horizon, 2e-5 of what the highlight would be with a reflectance of 1, and 0.6 of the last place. The vectors'
/// rounding costs more: in the study's cases the root mean square is 3.9e-5 to 3.9e-3, at most 1.2 times that of the
/// generic pixel.
///
/// # Cost
/// Instructions for one channel, as QEMU counts them (`src/trial/chip/counts.csv`): 764 on Cortex-M0+, 388 on M3 and
/// M4F, where the generic pixel takes 5800 and 2500; a highlight of thousands of times its light up to 50 more; each
/// further channel some 50 (27). Where the surface cuts the disc, the generic [`relative_illuminance`] adds up to 4700
/// (2700).
///
/// ```
/// use sunglint::material::{Material, Surface};
/// use sunglint::raw::{PixelQ14, SUN_Q14};
/// use sunglint::scene::Channel;
///
/// const ROAD: Material = match Material::new([0.2; 3], 0.0625, [0.04; 3]) {
///     Ok(road) => road,
///     Err(_) => panic!("reflectances and alpha are from 0 to 1"),
/// };
///
/// // The Sun at 37 degrees from straight up, pi bright in Q16; the viewer where its mirror image is.
/// let pixel = PixelQ14::new([9830, 0, 13107], &SUN_Q14, &Surface::of(&ROAD), [205_887; 3])?;
/// let [matt, glint] = [[0, 0, 16384], [-9830, 0, 13107]].map(|v| pixel.shade_channel([0, 0, 16384], v, Channel::Red));
/// // 0.16, and some 2.6 with the glint.
/// assert!((10_000..12_000).contains(&matt) && glint > 10 * matt);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
    /// Black under all lights: all bits are zero.
    pub const BLACK: Self = Self {
        direction: [0; 3],
        light: SphereQ14 { sin: 0, sin_square: 0, cos: 0, versine: 0 },
        rim: 0,
        alpha_square: 0,
        alpha_shift: 0,
        lobe: Lobe::DARK,
        channels: [Colour::BLACK; 3],
    };

    /// The constants of a light whose centre is in the unit `direction`, Q14, and that gives a surface which faces it
    /// `illuminance` in red, green and blue, Q16. In [`Scaled`] numbers, once a light.
    ///
    /// ```
    /// use sunglint::raw::{PixelQ14, SUN_Q14, surface_q14};
    /// use sunglint::scene::SceneError;
    ///
    /// let grey = surface_q14([1 << 29; 3], 1 << 28, [1 << 25; 3]).unwrap();
    /// assert!(PixelQ14::new([0, 0, 16_384], &SUN_Q14, &grey, [205_887; 3]).is_ok());
    /// assert!(matches!(PixelQ14::new([0, 0, 0], &SUN_Q14, &grey, [205_887; 3]), Err(SceneError::Direction(_))));
    /// ```
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
        let [e, f, g] = each(illuminance, |bits| Scaled::from_unsigned(bits.into(), -16));
        let ([red, green, blue], [r, s, t]) = (surface.albedo, surface.f0);
        let alpha_square = Short::of(surface.alpha * surface.alpha);
        Ok(Self {
            direction: each(direction, i32::from),
            light: *light,
            rim: if light.cos >= 0 { light.sin } else { i32::MAX },
            alpha_square: alpha_square.mantissa,
            alpha_shift: distance(2, alpha_square.exponent),
            lobe: Lobe::of(light, surface.alpha),
            channels: [Colour::of(e, red, r), Colour::of(f, green, s), Colour::of(g, blue, t)],
        })
    }

    /// Radiance in one channel, Q16, that a surface of the unit normal `n` sends towards the unit direction `v`, both
    /// Q14. Error and cost are the type's.
    ///
    /// ```
    /// use sunglint::raw::{PixelQ14, SUN_Q14, surface_q14};
    /// use sunglint::scene::Channel;
    ///
    /// // Matt white under illuminance pi is white, 65 536, but for 6e-5; from below it is black.
    /// let white = surface_q14([1 << 30; 3], 1 << 30, [0; 3]).unwrap();
    /// let pixel = PixelQ14::new([0, 0, 16_384], &SUN_Q14, &white, [205_887; 3]).unwrap();
    /// let seen = |v| pixel.shade_channel([0, 0, 16_384], v, Channel::Green);
    /// assert!(seen([0, 0, 16_384]).abs_diff(65_536) <= 5);
    /// assert_eq!(seen([9830, 0, -13_107]), 0);
    /// ```
    #[inline]
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

    /// [`shade_channel`](Self::shade_channel) of red, green and blue.
    ///
    /// ```
    /// use sunglint::raw::{PixelQ14, SUN_Q14, surface_q14};
    ///
    /// // Matt, and red alone reflects all of the light.
    /// let red = surface_q14([1 << 30, 1 << 28, 0], 1 << 30, [0; 3]).unwrap();
    /// let pixel = PixelQ14::new([0, 0, 16_384], &SUN_Q14, &red, [205_887; 3]).unwrap();
    /// let [r, g, b] = pixel.shade([0, 0, 16_384], [9830, 0, 13_107]);
    /// assert!(r.abs_diff(4 * g) <= 8 && b == 0);
    /// ```
    pub fn shade(&self, n: [i16; 3], v: [i16; 3]) -> [u32; 3] {
        match self.seen(n, v) {
            Some((facing, gloss)) => {
                let [red, green, blue] = &self.channels;
                each([red, green, blue], |colour| colour.radiance(facing, &gloss))
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
