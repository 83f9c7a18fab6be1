//! A lit pixel again.

use std::any::Any;

use sunglint::fixed::types::{U16F16, U32F32};
use sunglint::highlight::Highlight;
use sunglint::oracle::angle_between;
use sunglint::oracle::highlight::Pixel;
use sunglint::oracle::quadrature::Quadrature;
use sunglint::scene::Channel;
use sunglint::trial::gloss::{self, ALBEDO, CASES, Case, F0};
use sunglint::trial::{Format, Make, Shading, ShadingVisitor, Visitor};
use sunglint::{Real, Scalar};

use crate::number::shortest;

use super::{in_radii, lanes, measures, used};

/// A method's input in a format in a case.
#[derive(Clone, Copy, Debug)]
pub struct LitPixel {
    /// The method.
    pub method: Shading,
    /// The format.
    pub format: Format,
    /// Light and roughness.
    pub case: Case,
    /// Normal.
    pub n: [f64; 3],
    /// To the viewer.
    pub v: [f64; 3],
    /// To the light.
    pub l: [f64; 3],
}

/// What came of it.
#[derive(Clone, Debug)]
pub struct Computed {
    /// The level that the format answers, with its raw bits; nothing where `l` is no direction.
    answer: Option<(f64, String)>,
    /// The exact value of the method's formula.
    truth: f64,
    /// The BRDF integrated over the disc.
    integral: f64,
    /// Relative arithmetic error; infinite where the answer is no number.
    pub error: f64,
}

/// The answer and its bits in the format, and the truths.
struct Answer<'a>(&'a LitPixel);

impl Visitor for Answer<'_> {
    type Output = (Option<(f64, String)>, [f64; 2]);

    fn visit<T: Real>(self) -> Self::Output {
        let LitPixel { method, case, n, v, l, .. } = self.0;
        let level = method.visit(Shade { case, pixel: [*n, *v, *l].map(|vector| vector.map(T::from_f64)) });
        let answer =
            level.map(|level| (T::of_level(level).exact(), raw(&level, T::of_level(level).exact(), self.0.format)));
        let pixel = Pixel { n: *n, v: *v, l: *l };
        (answer, gloss::truths::<T, 12>(*method, case, &pixel, &Quadrature::new()))
    }
}

/// Lights a pixel: normal, viewer and light.
struct Shade<'a, T> {
    case: &'a Case,
    pixel: [[T; 3]; 3],
}

impl<T: Real> ShadingVisitor<T> for Shade<'_, T> {
    type Output = Option<T::Level>;

    fn visit<H: Highlight<T> + 'static>(self, method: Make<T, H>) -> Option<T::Level> {
        let [n, v, l] = self.pixel;
        gloss::scene(self.case, l, method).map(|scene| scene.shade_channel(n, v, Channel::Green))
    }
}

/// The raw bits of a light level, whose `value` has no more digits than 31 bits give.
fn raw(level: &dyn Any, value: f64, format: Format) -> String {
    let narrow = level.downcast_ref::<U16F16>().map(|level| format!("{:08x} in U16F16", level.to_bits()));
    let wide = level.downcast_ref::<U32F32>().map(|level| format!("{:016x} in U32F32", level.to_bits()));
    narrow.or(wide).unwrap_or_else(|| crate::measure::bits(format, &[value]))
}

impl LitPixel {
    /// Answer, truths and the arithmetic error.
    pub fn computed(&self) -> Computed {
        let (answer, [truth, integral]) = self.format.visit(Answer(self));
        let error = (answer.as_ref().map_or(f64::NAN, |(value, _)| *value) / truth - 1.0).abs();
        Computed { answer, truth, integral, error: if error.is_nan() { f64::INFINITY } else { error } }
    }

    /// All there is to say.
    pub fn text(&self) -> String {
        let Self { method, format, case, n, v, l } = *self;
        let Computed { answer, truth, integral, error } = self.computed();
        let no_direction = || (f64::NAN, "l is no direction: its squared length is not 0.81 to 1.21".to_owned());
        let (value, bits) = answer.unwrap_or_else(no_direction);
        let mut table = lanes::table();
        lanes::add(&mut table, "n, normal", format, n);
        lanes::add(&mut table, "v, to the viewer", format, v);
        lanes::add(&mut table, "l, to the light", format, l);
        table.add_row(["answer", "", &bits, &lanes::exact(value)]);
        table.add_row(["truth of the same formula", "", "", &truth.to_string()]);
        table.add_row(["integral over the disc", "", "", &integral.to_string()]);
        let away = angle_between(mirror(n, v), l);
        let lines = [
            format!("{} in {}, {}: {}", method.name(), format.name(), case.name, measures(&case.light)),
            format!("albedo {ALBEDO}, reflectance {F0} at normal incidence, illuminance pi: white is 1\n"),
            format!("{}\n", table.trim_fmt()),
            format!("mirror ray to l   {} rad{}", shortest(away), in_radii(away, &case.light)),
            format!(
                "arithmetic error  {} of the pixel, {:.3} ULP",
                shortest(error),
                (value - truth).abs() / self.ulp(truth)
            ),
            format!("model error       {} of the pixel", shortest((truth / integral - 1.0).abs())),
            format!("total error       {} of the pixel", shortest((value / integral - 1.0).abs())),
            used(error, self.budget(), " of the pixel"),
        ];
        lines.join("\n")
    }

    /// The last place of a level about `value`.
    fn ulp(&self, value: f64) -> f64 {
        match self.format {
            Format::I2F14 | Format::I16F16 => (-16_f64).exp2(),
            Format::I2F30 => (-32_f64).exp2(),
            float => float.ulp(value),
        }
    }

    /// The arithmetic error that the tests of the library allow.
    fn budget(&self) -> Option<f64> {
        let place = CASES.iter().position(|known| known == &self.case)?;
        Some(gloss::MAXIMA[gloss::family(self.method)][place][self.format as usize])
    }
}

/// The mirror image of `v` about `n`.
fn mirror(n: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    let twice = 2.0 * (n[0] * v[0] + n[1] * v[1] + n[2] * v[2]);
    [0, 1, 2].map(|i| twice * n[i] - v[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_of_a_case_is_within_its_budget_and_shows_its_level() {
        let upright = [0.0, 0.0, 1.0];
        for format in Format::ALL {
            let pixel =
                LitPixel { method: Shading::ConeGgx, format, case: CASES[1], n: upright, v: upright, l: upright };
            let Computed { error, truth, integral, .. } = pixel.computed();
            assert!(error <= pixel.budget().expect("a budget"), "{}", format.name());
            assert!((truth / integral - 1.0).abs() < 1e-4, "{}", format.name());
            let text = pixel.text();
            let fixed = matches!(format, Format::I2F14 | Format::I2F30 | Format::I16F16);
            assert_eq!(text.contains(" in U"), fixed, "{text}");
        }
    }
}
