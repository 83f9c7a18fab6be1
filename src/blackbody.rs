//! Black bodies: what a light of a given temperature radiates.
//!
//! Two families. The laws in SI units need an exponent range ([`WideRange`]) that f16 does not have: its least number
//! is a tenth of a visible wavelength in metres, and the Sun's spectral radiance is `2.6e13`. The forms relative to the
//! spectrum's peak ([`relative_to_peak`], [`relative_to_peak_frequency`], [`tint`]) work in every format, fixed point
//! included ([`Scaled`](crate::real::Scaled), integers alone).
//!
//! | quantity | formula | function |
//! |---|---|---|
//! | spectral radiance by wavelength, W/(m^2 sr m) | `2 h c^2 / lambda^5 / (exp(hc / (lambda k T)) - 1)` | [`radiance_per_wavelength`] |
//! | spectral radiance by frequency, W/(m^2 sr Hz) | `2 h nu^3 / c^2 / (exp(h nu / (k T)) - 1)` | [`radiance_per_frequency`] |
//! | wavelength of the peak, m | `b / T` (Wien) | [`peak_wavelength`] |
//! | frequency of the peak, Hz | `b' T` | [`peak_frequency`] |
//! | radiant exitance, W/m^2 | `sigma T^4` (Stefan, Boltzmann) | [`radiant_exitance`] |
//! | radiance, W/(m^2 sr) | `sigma T^4 / pi` | [`total_radiance`] |
//! | over the peak's, by wavelength | `y^-5 expm1(a) / expm1(a / y)` | [`relative_to_peak`] |
//! | over the peak's, by frequency | `z^3 expm1(a') / expm1(a' z)` | [`relative_to_peak_frequency`] |
//! | levels at three wavelengths | the first, over their greatest | [`tint`] |
//!
//! No exponential is ever large: the laws are computed as `exp(-x) / (1 - exp(-x))`, which falls to zero for large
//! exponents and loses nothing for small ones. Temperatures, wavelengths and frequencies that are zero, negative or NaN
//! give zero. Truth of all bounds: 192 bits in `tests/blackbody.rs`, budgets in `trial::blackbody`.
//!
//! Wien's, and Stefan and Boltzmann's laws: relative error at most 7.5e-16 in f64, 2.7e-7 in f32 and micromath, 2.2e-9
//! in [`Scaled`](crate::real::Scaled), for 1e-3 to 1e9 K and normal answers (searched for, `tests/figures.rs`).
//!
//! Sources: Planck 1901; the SI of 2019, whose `h`, `c` and `k` are exact; CODATA for the constants derived from them.

mod relative;
mod tint;

pub use relative::{relative_to_peak, relative_to_peak_frequency};
pub use tint::tint;

use crate::exponential::{complement, shrunk};
use crate::product::{quotient, saturated};
use crate::real::{Constant, Scalar};

/// Planck's constant in J s, exact.
pub const PLANCK: f64 = 6.626_070_15e-34;

/// The speed of light in vacuum in m/s, exact.
pub const SPEED_OF_LIGHT: f64 = 299_792_458.0;

/// Boltzmann's constant in J/K, exact.
pub const BOLTZMANN: f64 = 1.380_649e-23;

/// The second radiation constant `hc / k` in m K.
pub const SECOND_RADIATION: f64 = 1.438_776_877_503_933_8e-2;

/// Stefan and Boltzmann's constant `2 pi^5 k^4 / (15 h^3 c^2)` in W/(m^2 K^4).
pub const STEFAN_BOLTZMANN: f64 = 5.670_374_419_184_429_5e-8;

/// Wien's displacement constant for wavelengths in m K: `hc / (k a)`.
pub const WIEN_WAVELENGTH: f64 = 2.897_771_955_185_172_7e-3;

/// Wien's displacement constant for frequencies in Hz/K: `k a' / h`.
pub const WIEN_FREQUENCY: f64 = 5.878_925_757_646_825e10;

/// The Sun's effective temperature in kelvins (IAU 2015 resolution B3).
pub const SUN_TEMPERATURE: f64 = 5772.0;

/// Numbers whose range holds the quantities of light in SI units, from Planck's law at X-rays to that at radio waves:
/// all but f16.
///
/// ```compile_fail
/// sunglint::blackbody::peak_wavelength(sunglint::half::f16::from_f32(5772.0));
/// ```
pub trait WideRange: Scalar {}

impl WideRange for f64 {}
impl WideRange for f32 {}
#[cfg(feature = "micromath")]
impl WideRange for micromath::F32 {}
#[cfg(feature = "fixed")]
impl WideRange for crate::real::Scaled {}

/// Planck's law by wavelength: spectral radiance in W/(m^2 sr m) at `wavelength` in metres and `temperature` in
/// kelvins.
///
/// Relative error at most `b (1 + x)`, `x = hc / (lambda k T)` being the exponent, with `b` 1.7e-15 in f64, 8.6e-7 in
/// f32 and micromath, 7.3e-9 in [`Scaled`](crate::real::Scaled): for wavelengths from 1e-8 to 100 m at 10 to 1e6 K
/// (`tests/blackbody.rs`), and exponents from 1e-6 to 700 at 1e-3 to 1e9 K (searched for, `tests/figures.rs`), where the
/// answer is a normal number. Saturates at the greatest finite number.
///
/// ```
/// use sunglint::blackbody::{SUN_TEMPERATURE, peak_wavelength, radiance_per_wavelength};
///
/// let green = radiance_per_wavelength(peak_wavelength(SUN_TEMPERATURE), SUN_TEMPERATURE);
/// assert!((green * 1e-9 / 26_237.0 - 1.0).abs() < 1e-4); // 26.2 kW/(m^2 sr) in each nanometre
/// ```
#[inline]
pub fn radiance_per_wavelength<S: WideRange>(wavelength: S, temperature: S) -> S {
    const SECOND: Constant = Constant::new(SECOND_RADIATION);
    // The wavelength in 2^-20 m, which is about a micrometre, so that its powers stay in f32's range.
    const MICRO: Constant = Constant::new(1.0 / 1_048_576.0);
    // 2 h c^2 2^100
    const FIRST: Constant = Constant::new(150_982_633_885_691.03);
    if !(wavelength > S::ZERO && temperature > S::ZERO) {
        return S::ZERO;
    }
    let exponent = quotient([S::constant(SECOND)], [wavelength, temperature]);
    spectral(S::constant(FIRST), S::constant(MICRO) / wavelength, [true, true], exponent)
}

/// Planck's law by frequency: spectral radiance in W/(m^2 sr Hz) at `frequency` in hertz and `temperature` in
/// kelvins.
///
/// Relative error at most `b (1 + x)`, `x = h nu / (k T)` being the exponent, with `b` 1.2e-15 in f64, 5.5e-7 in f32
/// and micromath, 4.5e-9 in [`Scaled`](crate::real::Scaled): for frequencies from 3e6 to 3e16 Hz at 10 to 1e6 K
/// (`tests/blackbody.rs`), and exponents from 1e-6 to 700 at 1e-3 to 1e9 K (searched for, `tests/figures.rs`), where the
/// answer is a normal number. Saturates at the greatest finite number.
///
/// ```
/// use sunglint::blackbody::{BOLTZMANN, SPEED_OF_LIGHT, radiance_per_frequency};
///
/// // Radio waves, 1 GHz at 300 K: 2 nu^2 k T / c^2, as Rayleigh and Jeans have it.
/// let (frequency, temperature) = (1e9, 300.0);
/// let classical = 2.0 * frequency * frequency * BOLTZMANN * temperature / (SPEED_OF_LIGHT * SPEED_OF_LIGHT);
/// assert!((radiance_per_frequency(frequency, temperature) / classical - 1.0).abs() < 1e-4);
/// assert_eq!(radiance_per_frequency(frequency, -1.0), 0.0);
/// ```
#[inline]
pub fn radiance_per_frequency<S: WideRange>(frequency: S, temperature: S) -> S {
    // h / k
    const HERTZ: Constant = Constant::new(4.799_243_073_366_221e-11);
    // The frequency in 2^49 Hz, about that of green light.
    const GREEN: Constant = Constant::new(1.0 / (1_u64 << 49) as f64);
    // 2 h / c^2 2^147
    const FIRST: Constant = Constant::new(2.630_594_948_723_137_8e-6);
    if !(frequency > S::ZERO && temperature > S::ZERO) {
        return S::ZERO;
    }
    let exponent = quotient([S::constant(HERTZ), frequency], [temperature]);
    spectral(S::constant(FIRST), S::constant(GREEN) * frequency, [true, false], exponent)
}

/// `front base^5 / (exp(x) - 1)`; of the power 5 the first two or none.
#[inline]
fn spectral<S: Scalar>(front: S, base: S, squares: [bool; 2], exponent: S) -> S {
    let half = exponent * S::constant(Constant::new(0.5));
    let part = |square: bool| shrunk(if square { base * base } else { S::ONE }, half);
    let [first, second] = squares.map(part);
    saturated(quotient([front, first, second, base], [complement(exponent)]))
}

/// Wien's law: the wavelength in metres at which the spectral radiance by wavelength peaks; zero for temperatures that
/// are not positive.
///
/// ```
/// use sunglint::blackbody::peak_wavelength;
///
/// // The Sun's is green, 502 nm; a body's of 37 degrees Celsius is 9.3 micrometres.
/// assert!((peak_wavelength(5772.0_f32) * 1e9 - 502.04).abs() < 0.01);
/// assert!((peak_wavelength(310.15_f32) * 1e6 - 9.343).abs() < 0.001);
/// assert_eq!(peak_wavelength(0.0_f32), 0.0);
/// ```
#[inline]
pub fn peak_wavelength<S: WideRange>(temperature: S) -> S {
    const WIEN: Constant = Constant::new(WIEN_WAVELENGTH);
    if temperature > S::ZERO { saturated(S::constant(WIEN) / temperature) } else { S::ZERO }
}

/// Wien's law by frequency: the frequency in hertz at which the spectral radiance by frequency peaks, which is another
/// colour than [`peak_wavelength`]; zero for temperatures that are not positive.
///
/// ```
/// use sunglint::blackbody::{SPEED_OF_LIGHT, SUN_TEMPERATURE, peak_frequency};
///
/// // 339 THz, which is an infrared of 883 nm.
/// let frequency = peak_frequency(SUN_TEMPERATURE);
/// assert!((frequency / 339.33e12 - 1.0).abs() < 1e-4);
/// assert!((SPEED_OF_LIGHT / frequency * 1e9 - 883.5).abs() < 0.1);
/// ```
#[inline]
pub fn peak_frequency<S: WideRange>(temperature: S) -> S {
    const WIEN: Constant = Constant::new(WIEN_FREQUENCY);
    saturated(S::constant(WIEN) * temperature)
}

/// Stefan and Boltzmann's law: the power that a square metre radiates into its half of the sky, `sigma T^4` in
/// W/m^2.
///
/// ```
/// use sunglint::SUN;
/// use sunglint::blackbody::{SUN_TEMPERATURE, radiant_exitance};
///
/// // The solar constant from the Sun's temperature and size alone.
/// assert!((radiant_exitance(SUN_TEMPERATURE) * SUN.sin() * SUN.sin() - 1361.0).abs() < 0.5);
/// ```
#[inline]
pub fn radiant_exitance<S: WideRange>(temperature: S) -> S {
    const SIGMA: Constant = Constant::new(STEFAN_BOLTZMANN);
    fourth_power(S::constant(SIGMA), temperature)
}

/// Radiance over all wavelengths in W/(m^2 sr): `sigma T^4 / pi`.
///
/// ```
/// use sunglint::blackbody::total_radiance;
/// use sunglint::real::{Scalar, Scaled};
///
/// // The Sun's 20 MW/(m^2 sr), in integers; twice the temperature is 16 times that, exactly.
/// let [sun, twice] = [5772, 11_544].map(|kelvins| total_radiance(Scaled::from_bits(kelvins, 0)).exact());
/// assert!((sun / 2.0034e7 - 1.0).abs() < 1e-4);
/// assert_eq!(twice, 16.0 * sun);
/// ```
#[inline]
pub fn total_radiance<S: WideRange>(temperature: S) -> S {
    const SIGMA_OVER_PI: Constant = Constant::new(1.804_936_235_990_074e-8);
    fourth_power(S::constant(SIGMA_OVER_PI), temperature)
}

#[inline]
fn fourth_power<S: Scalar>(front: S, base: S) -> S {
    if base > S::ZERO { saturated(quotient([front, base, base, base, base], [])) } else { S::ZERO }
}
