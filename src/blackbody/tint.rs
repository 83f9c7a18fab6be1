//! The colour of a temperature at three wavelengths.

use crate::exponential::{complement, shrunk};
use crate::real::{Constant, Scalar, within_one};
use crate::vec3::each;

/// The second radiation constant `hc / k` in micrometres times kilokelvins.
const SECOND: Constant = Constant::new(14.387_768_775_039_338);

/// Spectral radiance by wavelength of a black body of `temperature` in *kilokelvins* at three `wavelengths` in
/// *micrometres*, over the greatest of the three: tints a light by its temperature, in every format.
///
/// The units are such that f16 and Q16.16 hold them. The law itself is never formed but its quotients alone, so that
/// embers of 0.8 kK, whose visible light is 1e-9 of their peak, have a colour in f16 too.
///
/// Wavelengths may differ by a factor of up to 8. Zeros where the temperature or a wavelength is zero, negative or not
/// finite. The greatest level is exactly 1.
///
/// Worst absolute error of a level, for 0.8 to 40 kK at wavelengths of 0.38 to 0.78 micrometres (searched for,
/// `tests/figures.rs`): f64 8.8e-15, f32 and micromath 1.3e-6, f16 9.5e-3, fixed point 9.9e-9.
///
/// ```
/// use sunglint::blackbody::tint;
///
/// // A lamp of 2700 K beside the Sun's 5772 K, at the primaries of a display.
/// let primaries = [0.611, 0.549, 0.464_f32];
/// let ([_, _, lamp], [_, _, sun]) = (tint(2.7, primaries), tint(5.772, primaries));
/// assert!(lamp < 0.25 && sun > 0.9);
/// ```
#[inline]
pub fn tint<S: Scalar>(temperature: S, wavelengths: [S; 3]) -> [S; 3] {
    let usable = |value: S| value > S::ZERO && value <= S::MAX;
    let [a, b, c] = wavelengths;
    if !(usable(temperature) && usable(a) && usable(b) && usable(c)) {
        return [S::ZERO; 3];
    }
    let longest = greatest(wavelengths);
    let exponent = |wavelength: S| S::constant(SECOND) / wavelength / temperature;
    let longest_rest = complement(exponent(longest));
    let levels = each(wavelengths, |wavelength| {
        if wavelength == longest {
            return S::ONE;
        }
        let exponent = exponent(wavelength);
        // The difference of two exponents, which would cancel where both are large.
        let lower = exponent * ((longest - wavelength) / longest);
        let ratio = longest / wavelength;
        let square = ratio * ratio;
        shrunk(square * square * ratio, lower) * (longest_rest / complement(exponent))
    });
    let greatest = greatest(levels);
    // Not every format divides a number by itself to the last place.
    each(levels, |level| if level == greatest { S::ONE } else { within_one(level / greatest) })
}

#[inline]
fn greatest<S: Scalar>([a, b, c]: [S; 3]) -> S {
    let larger = if a > b { a } else { b };
    if c > larger { c } else { larger }
}
