//! Normalisation: solid angle, sizeFactor, radiance, in floats and in integers; and the lights themselves, of any f64
//! bits.

mod floats;
mod integers;
mod lights;

use super::{Broken, Case};
use crate::trial::draw::Draw;
use crate::trial::format::Format;

/// What is claimed of a case: a property, the size that was found, and the size that is allowed.
pub type Claim = (&'static str, f64, f64);

/// Takes claims in, and may refuse one.
pub type Judge<'a> = &'a mut dyn FnMut(&Case, Claim) -> Result<(), Broken>;

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    claims(draw, &mut |case, (property, found, allowed)| case.at_most(property, found, allowed))
}

/// Reads a case and claims what should hold for it, one claim after the other; `tests/property_normalization.rs` asks
/// how near the claims come to what is allowed.
///
/// # Errors
/// The first of `judge`.
pub fn claims(draw: &mut Draw<'_>, judge: Judge<'_>) -> Result<(), Broken> {
    let format = draw.format();
    if draw.byte() & 3 == 0 {
        return lights::claims(draw, judge);
    }
    let [ratio, intensity] = [(); 2].map(|()| number(draw, format));
    let mut inputs = [0.0; 10];
    (inputs[0], inputs[1]) = (ratio, intensity);
    let case = Case { format, inputs };
    match format {
        Format::F64 => floats::claims::<f64>(&case, judge),
        Format::F32 => floats::claims::<f32>(&case, judge),
        Format::Micromath => floats::claims::<micromath::F32>(&case, judge),
        Format::F16 => floats::claims::<half::f16>(&case, judge),
        Format::I2F14 | Format::I2F30 | Format::I16F16 => integers::claims(&case, draw, judge),
    }
}

/// Any number of the format: by its bits, of any size about one, or next to one.
fn number(draw: &mut Draw<'_>, format: Format) -> f64 {
    let value = match draw.byte() & 3 {
        0 => return draw.any(format),
        1 => 1.0 - draw.logarithmic(1e-9, 0.5),
        2 => draw.logarithmic(1e-30, 1e6),
        _ => draw.logarithmic(1e-6, 1.0),
    };
    format.value(format.bits(value))
}

fn yes(so: bool) -> f64 {
    if so { 0.0 } else { 1.0 }
}
