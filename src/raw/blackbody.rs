//! Black bodies on raw bits.

use crate::blackbody;
use crate::real::Scaled;
use crate::vec3::each;

/// [`relative_to_peak`](blackbody::relative_to_peak): a ratio of wavelengths in Q16 gives Q30. Within 4 LSB.
pub fn relative_to_peak_q16(ratio: u32) -> i32 {
    q30(blackbody::relative_to_peak(q16(ratio)))
}

/// [`relative_to_peak_frequency`](blackbody::relative_to_peak_frequency): a ratio of frequencies in Q16 gives Q30.
/// Within 4 LSB.
pub fn relative_to_peak_frequency_q16(ratio: u32) -> i32 {
    q30(blackbody::relative_to_peak_frequency(q16(ratio)))
}

/// [`tint`](blackbody::tint): kilokelvins and micrometres in Q16 give levels in Q30. Within 12 LSB, and the greatest is
/// exactly 1.
pub fn tint_q16(temperature: u32, wavelengths: [u32; 3]) -> [i32; 3] {
    each(blackbody::tint(q16(temperature), each(wavelengths, q16)), q30)
}

fn q16(bits: u32) -> Scaled {
    Scaled::from_unsigned(bits.into(), -16)
}

/// A level relative to the peak is at most 1 and a rounding.
fn q30(level: Scaled) -> i32 {
    level.to_bits(30).clamp(0, 1 << 30) as i32
}
