//! Black bodies: every kernel in every format against the truth in f64, with its error budgets.
//!
//! Each budget is 1.12 times the worst of 100 000 random inputs from each of three seeds (f16's relative forms: of all
//! inputs), rounded up to two digits; an ignored test of `tests/blackbody.rs` prints them again. In f64 the oracle's
//! own rounding counts too.

use oorandom::Rand64;

use super::found::{Found, worst};
use crate::blackbody::{
    WideRange, radiance_per_frequency, radiance_per_wavelength, relative_to_peak, relative_to_peak_frequency, tint,
};
use crate::oracle::planck::Law;
use crate::real::{Real, Scalar};

/// Budgets for f64, f32, micromath, f16, I2F14, I2F30 and I16F16.
type Maxima = [f64; 7];

/// The relative error of the form relative to the peak, over [`SPAN`].
pub const RELATIVE: [Maxima; 2] = [
    [1.8e-15, 8.9e-7, 8.9e-7, 5.6e-3, 7.2e-9, 7.8e-9, 7.2e-9],
    [1.5e-15, 7.2e-7, 7.2e-7, 4.7e-3, 4.4e-9, 4.2e-9, 4.4e-9],
];

/// Its absolute error, over all positive numbers of the format.
pub const ABSOLUTE: [Maxima; 2] = [
    [8.8e-16, 3.5e-7, 3.5e-7, 2.0e-3, 3.0e-9, 3.0e-9, 3.0e-9],
    [7.5e-16, 2.9e-7, 2.9e-7, 2.1e-3, 2.0e-9, 1.9e-9, 2.0e-9],
];

/// The absolute error of a level of [`tint`].
pub const TINT: Maxima = [6.5e-15, 1.2e-6, 1.2e-6, 8.5e-3, 7.8e-9, 7.6e-9, 7.8e-9];

/// The error of the laws in SI units, relative and over one more than the exponent: f64, f32, micromath and `Scaled`.
pub const SPECTRAL: [[f64; 4]; 2] = [[1.6e-15, 7.3e-7, 7.3e-7, 6.1e-9], [1.2e-15, 5.5e-7, 5.5e-7, 4.4e-9]];

/// Ratios to the peak between which the relative error is budgeted.
pub const SPAN: [[f64; 2]; 2] = [[0.5, 10.0], [0.1, 3.0]];

/// The law relative to its peak, in the scalars of a format.
pub fn relative<S: Scalar>(law: Law, ratio: S) -> S {
    match law {
        Law::Wavelength => relative_to_peak(ratio),
        Law::Frequency => relative_to_peak_frequency(ratio),
    }
}

/// The difference from the truth at a ratio, and the truth there.
pub fn error_at<S: Scalar>(law: Law, ratio: S) -> [f64; 2] {
    let truth = law.relative(ratio.exact());
    [relative(law, ratio).exact() - truth, truth]
}

/// Relative error over [`SPAN`]; ratios as the light levels of the format hold them.
pub fn relative_error<T: Real>(law: Law, seed: u64, count: usize) -> Found {
    let [least, most] = SPAN[law as usize];
    found(seed, count, [[least, most]], |found, [ratio]| {
        let ratio = held::<T>(ratio);
        let [error, truth] = error_at(law, ratio);
        found.add_signed(error / truth, [ratio.exact(), 0.0, 0.0, 0.0, 0.0, 0.0]);
    })
}

/// Absolute error over ratios from 2^-16 to 60 000; as the light levels of the format hold them.
pub fn absolute_error<T: Real>(law: Law, seed: u64, count: usize) -> Found {
    found(seed, count, [[1.0 / 65_536.0, 60_000.0]], |found, [ratio]| {
        let ratio = held::<T>(ratio);
        let [error, _] = error_at(law, ratio);
        found.add_signed(error, [ratio.exact(), 0.0, 0.0, 0.0, 0.0, 0.0]);
    })
}

/// Absolute error of the levels of [`tint`], for 0.8 to 40 kK and wavelengths of 0.38 to 0.78 micrometres.
pub fn tint_error<T: Real>(seed: u64, count: usize) -> Found {
    found(seed, count, [[0.8, 40.0], [0.38, 0.78], [0.38, 0.78], [0.38, 0.78]], |found, input| {
        let [temperature, wavelengths @ ..] = input.map(held::<T>);
        let kelvins = 1000.0 * temperature.exact();
        let truth = wavelengths.map(|wavelength| Law::Wavelength.radiance(1e-6 * wavelength.exact(), kelvins));
        let greatest = truth.into_iter().fold(0.0, f64::max);
        let levels = tint(temperature, wavelengths).map(Scalar::exact);
        let error = worst(levels.iter().zip(truth).map(|(level, truth)| (level - truth / greatest).abs()));
        let [a, b, c] = wavelengths.map(Scalar::exact);
        found.add(error, [temperature.exact(), a, b, c, 0.0, 0.0]);
    })
}

/// The law in SI units.
pub fn spectral<S: WideRange>(law: Law, at: S, temperature: S) -> S {
    match law {
        Law::Wavelength => radiance_per_wavelength(at, temperature),
        Law::Frequency => radiance_per_frequency(at, temperature),
    }
}

/// Wavelengths in metres and frequencies in hertz at which the laws in SI units are judged.
pub const DOMAIN: [[f64; 2]; 2] = [[1e-8, 100.0], [3e6, 3e16]];

/// Relative error of the law in SI units over one more than the exponent, from 10 to 1e6 K, where the answer is a
/// normal number of f32.
pub fn spectral_error<S: WideRange>(law: Law, seed: u64, count: usize) -> Found {
    found(seed, count, [DOMAIN[law as usize], [10.0, 1e6]], |found, input| {
        let [at, temperature] = input.map(S::nearest);
        let truth = law.radiance(at.exact(), temperature.exact());
        let normal = truth >= f64::from(f32::MIN_POSITIVE) && truth <= f64::from(f32::MAX);
        let error = (spectral(law, at, temperature).exact() - truth) / truth;
        let bound = 1.0 + law.exponent(at.exact(), temperature.exact());
        let error = if normal { error / bound } else { 0.0 };
        found.add_signed(error, [at.exact(), temperature.exact(), 0.0, 0.0, 0.0, 0.0]);
    })
}

/// The number as the format's light levels hold it.
fn held<T: Real>(value: f64) -> T::Scalar {
    T::of_level(T::level(T::Scalar::nearest(value)))
}

/// The errors that `add` adds at `count` random inputs, the logarithm of each spread evenly between two ends.
fn found<const N: usize>(seed: u64, count: usize, ends: [[f64; 2]; N], add: impl Fn(&mut Found, [f64; N])) -> Found {
    let mut source = Rand64::new(u128::from(seed));
    let mut found = Found::new();
    for _ in 0..count {
        add(&mut found, ends.map(|[least, most]| least * libm::pow(most / least, source.rand_float())));
    }
    found
}
