//! Planck's law relative to its peak, as a function of the wavelength or frequency relative to the peak's: numbers
//! about one, which every format holds.

use crate::exponential::{complement, shrunk};
use crate::real::{Constant, Scalar};

/// What tells the law by wavelength from that by frequency.
struct Law {
    /// The exponent `hc / (lambda k T)` at the peak: the root of `a = n (1 - exp(-a))`.
    peak: Constant,
    /// `1 - exp(-a)`.
    complement: Constant,
    /// Whether the power `n` is 5; else it is 3.
    fifth: bool,
}

const WAVELENGTH: Law =
    Law { peak: Constant::new(4.965_114_231_744_276), complement: Constant::new(0.993_022_846_348_855_3), fifth: true };

const FREQUENCY: Law = Law {
    peak: Constant::new(2.821_439_372_122_079),
    complement: Constant::new(0.940_479_790_707_359_6),
    fifth: false,
};

/// Spectral radiance by wavelength over that of the peak, at a wavelength of `ratio` times the peak's (`lambda T / b`,
/// for instance in micrometres times kilokelvins over 2.8978): `y^-5 expm1(a) / expm1(a / y)` with `a = 4.965114`, from
/// 0 to 1. The same curve for all temperatures.
///
/// Zero for `ratio` zero, negative or NaN. Worst relative error for ratios from 0.5 to 10, and worst absolute error
/// over all ratios that the format has (2^-16 to 60 000), as `tests/figures.rs` asserts them:
///
/// | | f64 | f32 | micromath | f16 | fixed point |
/// |---|---|---|---|---|---|
/// | relative | 2.1e-15 | 9.2e-7 | 9.2e-7 | 5.6e-3 | 7.8e-9 |
/// | absolute | 1.3e-15 | 3.7e-7 | 3.7e-7 | 2.0e-3 | 2.9e-9 |
///
/// In f16 answers below 6.1e-5, which are those for ratios below 0.224 and above 25.5, are subnormal, or
/// zero where hardware flushes those; the errors above hold there too (`tests/flush.rs`).
///
/// ```
/// use sunglint::blackbody::relative_to_peak;
/// use sunglint::half::f16;
///
/// let level = |ratio: f32| relative_to_peak(f16::from_f32(ratio)).to_f32();
/// // At the peak, at half of its wavelength, at twice, and what is no wavelength.
/// assert!((level(1.0) - 1.0).abs() < 2e-3 && (level(0.5) - 0.222).abs() < 2e-3 && (level(2.0) - 0.4046).abs() < 2e-3);
/// assert_eq!(level(-1.0), 0.0);
/// ```
#[inline]
pub fn relative_to_peak<S: Scalar>(ratio: S) -> S {
    // A negative quotient, and NaN, give zero as well.
    law(S::ONE / ratio, &WAVELENGTH)
}

/// Spectral radiance by frequency over that of the peak, at a frequency of `ratio` times the peak's (`nu / (b' T)`):
/// `z^3 expm1(a') / expm1(a' z)` with `a' = 2.821439`, from 0 to 1. The same curve for all temperatures.
///
/// Zero for `ratio` zero, negative or NaN. Worst relative error for ratios from 0.1 to 3, and worst absolute error over
/// all ratios that the format has, as `tests/figures.rs` asserts them:
///
/// | | f64 | f32 | micromath | f16 | fixed point |
/// |---|---|---|---|---|---|
/// | relative | 1.6e-15 | 7.4e-7 | 7.4e-7 | 4.7e-3 | 4.2e-9 |
/// | absolute | 8.8e-16 | 3.3e-7 | 3.3e-7 | 2.1e-3 | 2.5e-9 |
///
/// In f16 answers below 6.1e-5, which are those for ratios below 3.3e-3 and above 6.4, are subnormal or zero.
///
/// ```
/// use sunglint::blackbody::relative_to_peak_frequency;
///
/// assert!((relative_to_peak_frequency(1.0_f32) - 1.0).abs() < 3.3e-7);
/// // Low frequencies rise by the square: of a hundredth and two hundredths nearly to 4 times.
/// let [low, twice] = [0.01_f32, 0.02].map(relative_to_peak_frequency);
/// assert!((twice / low - 4.0).abs() < 0.06);
/// assert_eq!(relative_to_peak_frequency(0.0_f32), 0.0);
/// ```
#[inline]
pub fn relative_to_peak_frequency<S: Scalar>(ratio: S) -> S {
    law(ratio, &FREQUENCY)
}

/// `t^n (1 - exp(-a)) / (1 - exp(-a t)) exp(-a (t - 1))`.
#[inline]
fn law<S: Scalar>(t: S, law: &Law) -> S {
    // False for NaN.
    let positive = t > S::ZERO;
    if !positive {
        return S::ZERO;
    }
    let (peak, front) = (S::constant(law.peak), S::constant(law.complement));
    let square = |t: S| if law.fifth { t * t } else { S::ONE };
    let rest = complement(peak * t);
    // An exponent that is small about the peak, where the curve is high. Every product falls towards the answer.
    if t < S::ONE {
        let risen = t / shrunk(S::ONE, peak * (S::ONE - t));
        return risen * t * square(t) * (t / rest * front);
    }
    let power = square(t) * t * t * t;
    // A ratio whose power overflows has long since fallen to zero; so it has where the ratio itself is infinite.
    if power <= S::MAX { shrunk(power, peak * (t - S::ONE)) * (front / rest) } else { S::ZERO }
}
