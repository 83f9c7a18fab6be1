//! Radiometry and black bodies on raw bits against the exact quotients of integers.

use core::f64::consts::FRAC_1_PI;

use super::word;
use crate::blackbody;
use crate::radiometry::RadiometryError;
use crate::raw;
use crate::real::{Scalar, Scaled};
use crate::trial::draw::Draw;
use crate::trial::format::Format;
use crate::trial::property::{Broken, Case};

/// Reads a case and says what it breaks.
pub(super) fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let [a, b, c, d] = [(); 4].map(|()| word(draw));
    let cos = draw.bits() as i16;
    let numbers = [a.into(), b.into(), c.into(), d.into(), cos.into(), 0.0, 0.0, 0.0, 0.0, 0.0];
    let case = Case { format: Format::I2F14, inputs: numbers };
    radiometry(&case, [a, b, c].map(u128::from), cos)?;
    black_body(&case, [a, b, c, d])
}

/// Within half a unit and a share of the exact quotient, and the greatest number where that is above it.
fn near(case: &Case, what: &'static str, answer: u32, exact: f64, share: f64) -> Result<(), Broken> {
    let exact = exact.min(u32::MAX.into());
    // And f64's own rounding.
    case.at_most(what, (f64::from(answer) - exact).abs(), 0.5 + (share + 1e-15) * exact)
}

/// Zero for nothing.
fn quotient(part: u128, whole: u128) -> f64 {
    if whole == 0 { 0.0 } else { part as f64 / whole as f64 }
}

fn radiometry(case: &Case, [a, b, c]: [u128; 3], cos: i16) -> Result<(), Broken> {
    let above = u128::from(cos.max(0).unsigned_abs());
    let answer = raw::irradiance_q16(a as u32, cos, b as u32);
    near(case, "raw irradiance", answer, quotient((a * above) << 18, b * b), 2.1e-9)?;
    let answer = raw::diffuse_radiance_q16(cos, a as u32);
    near(case, "raw diffuse_radiance", answer, quotient(a * above, 1 << 14) * FRAC_1_PI, 1.3e-9)?;
    let exact = quotient(a << 32, b * c);
    match raw::area_radiance_q16(a as u32, b as u32, c as u32) {
        Ok(answer) => near(case, "raw area_radiance", answer, exact, 1.7e-9),
        Err(RadiometryError::Area(_)) => case.holds("an area is positive", b == 0),
        Err(RadiometryError::SolidAngle(_)) => case.holds("a solid angle is positive", b > 0 && c == 0),
        Err(RadiometryError::Overflow) => case.at_most("an overflow is one", 4_294_967_295.5 * (1.0 - 1.7e-9), exact),
        Err(_) => case.holds("any power will do", false),
    }
}

fn black_body(case: &Case, [a, b, c, d]: [u32; 4]) -> Result<(), Broken> {
    let q16 = |bits: u32| Scaled::from_unsigned(bits.into(), -16);
    let q30 = |level: Scaled| level.to_bits(30).clamp(0, 1 << 30) as i32;
    let [by_wavelength, by_frequency] = [raw::relative_to_peak_q16(a), raw::relative_to_peak_frequency_q16(a)];
    case.holds("raw relative_to_peak", by_wavelength == q30(blackbody::relative_to_peak(q16(a))))?;
    case.holds("raw relative_to_peak_frequency", by_frequency == q30(blackbody::relative_to_peak_frequency(q16(a))))?;
    let tint = raw::tint_q16(a, [b, c, d]);
    let levels = blackbody::tint(q16(a), [b, c, d].map(q16));
    case.holds("raw tint", tint == levels.map(q30))?;
    case.holds(
        "levels of a tint are from 0 to 1",
        levels.iter().all(|level| (Scaled::ZERO..=Scaled::ONE).contains(level)),
    )?;
    let lit = [a, b, c, d].into_iter().all(|bits| bits > 0);
    // As long as the quotients of the wavelengths are as documented, one of the three is the greatest.
    let wavelengths = [b, c, d].map(f64::from);
    let (least, most) = (wavelengths.into_iter().fold(f64::MAX, f64::min), wavelengths.into_iter().fold(0.0, f64::max));
    let greatest = tint.into_iter().fold(0, i32::max);
    let ends = !lit || most > 8.0 * least || greatest == 1 << 30;
    case.holds("the greatest level of a tint is 1", ends)?;
    case.holds("nothing has no tint", lit || tint == [0; 3])
}
