//! Highlights: every method, in every format, of any light, roughness and directions.

pub mod budget;
pub mod pixel;
mod relation;

use budget::Lit;

use super::{Broken, Case, inputs};
use crate::light::DistantLight;
use crate::oracle::highlight::{Glossy, Pixel};
use crate::real::{Real, Scalar};
use crate::sphere::DistantSphere;
use crate::trial::draw::Draw;
use crate::trial::format::{Format, Visitor};
use crate::trial::gloss::F0;
use crate::trial::shading::Shading;

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let format = draw.format();
    let method = draw.one_of(Shading::ALL);
    match draw.byte() % 4 {
        0 => total(draw, format, method),
        1 => relation::hold(draw, format, method),
        _ => {
            let (surface, pixel) = surface_and_pixel(draw);
            format.visit(Exact { method, surface, pixel }).within()
        }
    }
}

/// A light and a surface before they are rounded.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// Up to half the sky.
    pub light: DistantLight,
    /// From 0 to 1.
    pub alpha: f64,
    /// Reflectance at normal incidence.
    pub f0: f64,
}

/// What the budgets are for, off bytes.
pub fn surface_and_pixel(draw: &mut Draw<'_>) -> (Surface, Pixel) {
    let light = draw.sphere();
    let alpha = pixel::alpha(draw);
    let f0 = draw.one_of([F0, 1.0]);
    (Surface { light, alpha, f0 }, pixel::pixel(draw, &light, alpha))
}

/// A pixel as a method makes it in a format, beside the formula's exact value.
#[derive(Clone, Copy, Debug)]
pub struct Shaded {
    /// What was lit.
    pub lit: Lit,
    /// Radiance over illuminance; infinite where f16 has no such number.
    pub found: f64,
    /// Likewise.
    pub truth: f64,
}

impl Shaded {
    /// The error; what is above the format's greatest number counts as that.
    pub fn error(&self) -> f64 {
        let most = if self.lit.format == Format::F16 { 65504.0 } else { f64::MAX };
        let error = (self.found.min(most) - self.truth.min(most)).abs();
        // A minimum drops the NaN.
        if self.found.is_nan() { f64::NAN } else { error }
    }

    fn case(&self) -> Case {
        let Lit { format, glossy, pixel: Pixel { n, v, l }, .. } = self.lit;
        let mut inputs = inputs([n, v, l]);
        inputs[9] = glossy.alpha;
        Case { format, inputs }
    }

    fn within(&self) -> Result<(), Broken> {
        // Most pixels are within a step of white, for which nothing else has to be computed.
        let error = self.error();
        if error <= budget::step(self.lit.format) * core::f64::consts::FRAC_1_PI || !self.lit.is_defined() {
            return Ok(());
        }
        self.case().at_most(self.lit.method.name(), error, self.lit.allowed(self.truth))
    }
}

/// Shades a pixel by both.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// The method.
    pub method: Shading,
    /// The light and the surface.
    pub surface: Surface,
    /// The directions.
    pub pixel: Pixel,
}

impl Visitor for Exact {
    type Output = Shaded;

    fn visit<T: Real>(self) -> Shaded {
        let Self { method, surface: Surface { light, alpha, f0 }, pixel: Pixel { n, v, l } } = self;
        let rounded = |value: f64| T::Scalar::nearest(value).exact();
        let sphere = DistantSphere::of(&light);
        // As the format holds it: I2F14 in steps of 2^-28, a 270th of a ratio of a millionth. That of a wide disc
        // hardly says how wide it is; the cosine does.
        let ratio = if light.sin() < 0.5 { T::scalar(sphere.sin()).exact() } else { light.sin() };
        let glossy = Glossy { alpha: rounded(alpha), f0: rounded(f0), ratio };
        let lanes = [n, v, l].map(|vector| vector.map(T::from_f64));
        let [n, v, l] = lanes.map(|vector| vector.map(T::to_f64));
        let lit = Lit { format: format_of::<T>(), method, glossy, pixel: Pixel { n, v, l } };
        let found = method.radiance::<T>(&glossy, &sphere, lanes);
        Shaded { lit, found, truth: lit.truth() }
    }
}

fn format_of<T: Real>() -> Format {
    Format::named(T::NAME).unwrap_or(Format::F64)
}

/// Any light, any roughness from 0 to 1, and vectors of any bits or of any direction: numbers all the same, and none
/// where there is nothing to see.
fn total(draw: &mut Draw<'_>, format: Format, method: Shading) -> Result<(), Broken> {
    let light = draw.light();
    let alpha = match draw.byte() % 4 {
        0 => draw.any(format).clamp(0.0, 1.0),
        1 => draw.logarithmic(1e-9, 1.0),
        _ => pixel::alpha(draw),
    };
    // A comparison would let NaN through.
    let alpha = if alpha.is_nan() { 0.0 } else { alpha };
    let vectors = if draw.byte().is_multiple_of(2) {
        [(); 3].map(|()| [(); 3].map(|()| draw.any(format)))
    } else {
        let Pixel { n, v, l } = pixel::pixel(draw, &light, alpha);
        [n, v, l]
    };
    format.visit(Total { format, method, light, alpha, vectors })
}

struct Total {
    format: Format,
    method: Shading,
    light: DistantLight,
    alpha: f64,
    vectors: [[f64; 3]; 3],
}

impl Visitor for Total {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self { format, method, light, alpha, vectors } = self;
        let pixel = vectors.map(|vector| vector.map(T::from_f64));
        let mut numbers = inputs(vectors);
        numbers[9] = alpha;
        let case = Case { format, inputs: numbers };
        let sphere = DistantSphere::<T>::of(&light);
        let gloss = method.shade(&sphere, T::Scalar::nearest(alpha), pixel);
        let parts = [gloss.level, gloss.gain, gloss.fresnel].map(Scalar::exact);
        case.holds("a highlight is finite", parts.into_iter().all(f64::is_finite))?;
        case.holds("a highlight is not negative", parts.into_iter().all(|part| part >= 0.0))?;
        case.at_most("Schlick's weight", parts[2], 1.0)?;
        let radiance = T::of_level(T::level(gloss.radiance(T::Scalar::ONE, T::Scalar::ONE))).exact();
        case.holds("its level is finite", radiance >= 0.0 && radiance.is_finite())?;
        let [n, v, l] = pixel;
        let positive = |scalar: T::Wide| scalar > T::WIDE_ZERO;
        let at_the_centre = matches!(method, Shading::DiscGgx | Shading::Directional | Shading::ConeGgx);
        if !positive(T::dot(n, v)) || at_the_centre && !positive(T::dot(n, l)) {
            case.at_most("a highlight below the surface", parts[0], 0.0)?;
        }
        Ok(())
    }
}
