//! Black bodies.

use super::{ColourQ16, ColourQ30};
use crate::raw;

/// Planck's law by wavelength over its peak, `y^-5 expm1(a) / expm1(a / y)` with `a = 4.965114`: of a wavelength `ratio`
/// times the peak's, in Q16 (the peak is at 2.8978 micrometres times kilokelvins); the answer in Q30, from 0 to 1.
///
/// Within 4 units of the last place. Zero for a ratio of 0.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_relative_to_peak_q16(ratio: u32) -> i32 {
    raw::relative_to_peak_q16(ratio)
}

/// Planck's law by frequency over its peak, `z^3 expm1(a) / expm1(a z)` with `a = 2.821439`: of a frequency `ratio`
/// times the peak's, in Q16 (the peak is at 58.789 THz per kilokelvin); the answer in Q30, from 0 to 1.
///
/// Within 4 units of the last place. Zero for a ratio of 0.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_relative_to_peak_frequency_q16(ratio: u32) -> i32 {
    raw::relative_to_peak_frequency_q16(ratio)
}

/// The colour of a black body: Planck's law by wavelength at three wavelengths, over the greatest of the three, which
/// is exactly 1. `temperature` in kilokelvins and `wavelengths` in micrometres, in Q16, those within a factor of 8 of
/// each other; the answer in Q30.
///
/// Within 12 units of the last place, for 0.8 to 40 kK at 0.38 to 0.78 micrometres. Zeros where the temperature or a
/// wavelength is 0.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_tint_q16(temperature: u32, wavelengths: ColourQ16) -> ColourQ30 {
    raw::tint_q16(temperature, wavelengths.into()).into()
}
