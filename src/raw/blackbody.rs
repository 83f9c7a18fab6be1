//! Black bodies on raw bits.

use crate::blackbody;
use crate::real::Scaled;
use crate::vec3::each;

/// [`relative_to_peak`](blackbody::relative_to_peak): a ratio of wavelengths in Q16 gives Q30. Within 4 LSB
/// (`tests/blackbody.rs`).
///
/// ```
/// use sunglint::raw::relative_to_peak_q16;
///
/// assert_eq!(relative_to_peak_q16(65_536), 1 << 30);
/// // At twice the peak's wavelength 0.405 of it is left.
/// assert_eq!((relative_to_peak_q16(2 * 65_536) + (1 << 19)) >> 20, 415); // of 1024
/// ```
pub fn relative_to_peak_q16(ratio: u32) -> i32 {
    q30(blackbody::relative_to_peak(q16(ratio)))
}

/// [`relative_to_peak_frequency`](blackbody::relative_to_peak_frequency): a ratio of frequencies in Q16 gives Q30.
/// Within 4 LSB (`tests/blackbody.rs`).
///
/// ```
/// use sunglint::raw::relative_to_peak_frequency_q16;
///
/// // At half the peak's frequency 0.637 of it.
/// let half = relative_to_peak_frequency_q16(32_768);
/// assert!((f64::from(half) / 2_f64.powi(30) - 0.6374).abs() < 1e-4);
/// assert_eq!(relative_to_peak_frequency_q16(0), 0);
/// ```
pub fn relative_to_peak_frequency_q16(ratio: u32) -> i32 {
    q30(blackbody::relative_to_peak_frequency(q16(ratio)))
}

/// [`tint`](blackbody::tint): kilokelvins and micrometres in Q16 give levels in Q30. Within 12 LSB
/// (`tests/blackbody.rs`), and the greatest is exactly 1.
///
/// ```
/// use sunglint::raw::tint_q16;
///
/// // 611, 549 and 464 nm, the primaries of a display.
/// let primaries = [40_042, 35_979, 30_409];
/// let [_, _, blue] = tint_q16(378_274, primaries); // the Sun's 5.772 kK
/// assert_eq!(blue, 1 << 30);
/// let [red, _, blue] = tint_q16(176_947, primaries); // a lamp's 2.7 kK
/// assert!(red == 1 << 30 && blue < 1 << 28);
/// ```
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
