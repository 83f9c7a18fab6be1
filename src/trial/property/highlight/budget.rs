//! How far off a highlight may be, of any light, roughness, normal, viewer and light's direction.
//!
//! A method's answer is its formula's exact value at directions and lengths that lie at most [`reach`] beside the given
//! ones, but for a share of [`STEPS`] steps of the format (of the value, or of white where that is more) and for what
//! [`ROOT`] says. So nothing is added to what a few steps in the inputs' last places would do: where the formula is
//! steep (at the rim of a disc, on a polish, at grazing incidence), the answer is as good as the directions are.
//!
//! White, radiance over illuminance of `1/pi`, is what a matt white surface shows that faces the light.

use core::f64::consts::{FRAC_1_PI, PI};

use super::pixel::{cosine, mirrored};
use crate::oracle;
use crate::oracle::highlight::{Glossy, Pixel};
use crate::real::MOST_TILT;
use crate::trial::format::Format;
use crate::trial::gloss::family;
use crate::trial::shading::Shading;

/// What a step is of: half a unit of the last place of 1, in micromath what its root lacks.
pub fn step(format: Format) -> f64 {
    if format == Format::Micromath { 6e-6 } else { format.step() }
}

/// How far beside the given directions and lengths an answer may be at home, in radians and in lengths.
pub fn reach(format: Format) -> f64 {
    let steps = match format {
        Format::F64 | Format::F32 | Format::I2F14 | Format::I2F30 => 8.0,
        Format::Micromath => 2.0,
        Format::F16 => 16.0,
        Format::I16F16 => 4.0,
    };
    steps * step(format)
}

/// The least share of steps that says something: what rounding the answer itself may make.
pub const ROUNDING: f64 = 1.0;

/// What is allowed beside that, in steps, by [`family`] and format: 1.12 times what a search finds, or [`ROUNDING`]
/// where it finds less, for then the directions beside the given ones explain it all (`tests/highlight_budget.rs`).
pub const STEPS: [[f64; 7]; 6] = [
    [22.0, 13.0, 1.0, 4.6, 1.0, 4.2, 1.0],
    [30.0, 21.0, 1.3, 7.5, 1.0, 4.5, 1.0],
    [95.0, 17.0, 2.2, 9.3, 1.0, 6.3, 1.3],
    [30.0, 18.0, 2.2, 12.0, 1.0, 6.7, 2.8],
    [1.0, 14.0, 2.0, 85.0, 1.0, 1.0, 1.0],
    [1.0, 4.2, 1.0, 72.0, 1.0, 1.0, 1.0],
];

/// What the cone's root lacks, or the oracle's, which is of a cubic whose coefficients cancel: a share of the value, or
/// of the brightest that a normal shows between the same viewer and light. Steps without end find no other.
pub const ROOT: f64 = 7.8e-8;

/// How far the sum of viewer and light is above the surface at least, where the oracle can tell what a cone shows.
const LEAST_HALF: f64 = 1e-6;

/// A pixel as it was rounded, and the method that lights it.
#[derive(Clone, Copy, Debug)]
pub struct Lit {
    /// The format.
    pub format: Format,
    /// The method.
    pub method: Shading,
    /// The surface and the light's size.
    pub glossy: Glossy,
    /// The directions.
    pub pixel: Pixel,
}

/// The parts of what is allowed.
#[derive(Clone, Copy, Debug)]
pub struct Allowance {
    /// What directions beside the given ones make.
    pub change: f64,
    /// The value or white, whichever is more.
    pub unit: f64,
    /// What the root makes.
    pub root: f64,
}

impl Lit {
    /// The exact value.
    pub fn truth(&self) -> f64 {
        self.method.truth(&self.glossy, &self.pixel)
    }

    /// Whether the formula says anything: not where the viewer, within four times the [`reach`], is not above the
    /// surface or is opposite to the light, nor where all of a disc's rim is as near to the mirror ray, nor of a cone
    /// whose half vector is about in the surface.
    ///
    /// The viewer is 2^-14 above it at least, since below that every highlight is zero.
    pub fn is_defined(&self) -> bool {
        let reach = reach(self.format);
        let Pixel { n, v, l } = self.pixel.unit();
        let above = cosine(n, v) > (4.0 * reach).max(1.0 / 16384.0 + reach);
        let apart = PI - oracle::angle_between(v, l) > 2.0 * reach;
        // The oracle's own cubic has no digits left beyond.
        let half_above = cosine(n, [0, 1, 2].map(|i| l[i] + v[i])) > LEAST_HALF;
        let one_rim = PI - oracle::angle_between(mirrored(n, v), l) > reach;
        above && apart && one_rim && (family(self.method) < 4 || half_above)
    }

    /// What the error may be made of.
    pub fn allowance(&self, truth: f64) -> Allowance {
        let reach = reach(self.format);
        let Self { method, glossy, .. } = self;
        let pixel = self.pixel.unit();
        let off = |value: f64| (value - truth).abs();
        let beside = pixel.beside(reach).map(|pixel| off(method.truth_beside(glossy, &pixel, [0.0; 3])));
        let moved = self.offsets(&pixel, reach).map(|offset| off(method.truth_beside(glossy, &pixel, offset)));
        let as_given = off(method.truth_beside(glossy, &self.pixel, [0.0; 3]));
        let change = beside.into_iter().chain(moved).fold(as_given, f64::max);
        // Where a rim is crossed and the viewer is near the surface, both count.
        let change = change * (1.0 + 2.0 * reach / cosine(pixel.n, pixel.v));
        let root = if family(*method) >= 4 { ROOT * self.brightest(&pixel).max(truth) } else { 0.0 };
        Allowance { change, unit: (truth + change).max(FRAC_1_PI), root: root + self.beyond(&pixel) }
    }

    /// The method's point of the disc moved to either side of every axis, towards the mirror ray, and so that the half
    /// vector comes nearer to the normal, where between the former a narrow highlight has its peak.
    fn offsets(&self, pixel: &Pixel, reach: f64) -> [[f64; 3]; 8] {
        let mut offsets = [[0.0; 3]; 8];
        if matches!(self.method, Shading::DiscGgx | Shading::Directional | Shading::ConeGgx) {
            return offsets;
        }
        for (i, offset) in offsets.iter_mut().enumerate().take(6) {
            offset[i % 3] = if i % 2 == 0 { reach } else { -reach };
        }
        offsets[7] = pixel.off_the_normal(self.glossy.ratio, reach);
        offsets[6] = pixel.off_the_mirror(self.glossy.ratio, reach);
        offsets
    }

    /// With the normal at the half vector.
    fn brightest(&self, &Pixel { v, l, .. }: &Pixel) -> f64 {
        let n = [0, 1, 2].map(|i| l[i] + v[i]);
        self.method.truth(&self.glossy, &Pixel { n, v, l })
    }

    /// f16 has no room for tilts beyond 173 widths of a highlight, which is its billionth there.
    fn beyond(&self, &Pixel { n, v, l }: &Pixel) -> f64 {
        if self.format != Format::F16 {
            return 0.0;
        }
        let Glossy { alpha, ratio, .. } = self.glossy;
        let at_a_point = family(self.method) < 2;
        let theta = oracle::angular_radius(ratio);
        let l = if at_a_point { oracle::nearest_in_disc(l, mirrored(n, v), theta) } else { l };
        let square = alpha * alpha + if at_a_point { 0.0 } else { oracle::closed::versine(ratio) / 2.0 };
        let lean = oracle::angle_between(n, [0, 1, 2].map(|i| l[i] + v[i]));
        let (sine, cosine_of_lean) = (libm::sin(lean), libm::cos(lean).abs());
        let far = sine * sine > 0.95 * MOST_TILT * square;
        if far { 1.3e-9 / (4.0 * PI * square * cosine(n, v) * cosine_of_lean) } else { 0.0 }
    }

    /// The greatest error that is allowed.
    pub fn allowed(&self, truth: f64) -> f64 {
        let Allowance { change, unit, root } = self.allowance(truth);
        change + root + STEPS[family(self.method)][self.format as usize] * step(self.format) * unit
    }
}
