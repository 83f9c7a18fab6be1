//! The errors of black bodies, and their budgets.

use super::{Body, si};
use crate::blackbody::tint;
use crate::oracle::planck::Law;
use crate::real::{Real, Scalar};
use crate::trial::blackbody::{SPAN, error_at};
use crate::trial::format::{Format, Visitor};
use crate::trial::found::worse;
use crate::trial::property::figures::{Figures, NONE, Row};

const ABSOLUTE: usize = 2;
const TINT: usize = 4;
const SPECTRAL: usize = 5;
const TOTAL: usize = 7;

/// Budgets of relative and absolute errors of the forms relative to the peak, of tints, and of the laws in SI units
/// (relative, of the spectral ones over one more than the exponent), which f16 does not have.
pub const BUDGETS: [Row; TOTAL + 1] = [
    ("wavelength over the peak's, relative", [2.1e-15, 9.2e-7, 9.2e-7, 5.6e-3, 7.8e-9, 7.8e-9, 7.8e-9]),
    ("frequency over the peak's, relative", [1.6e-15, 7.4e-7, 7.4e-7, 4.7e-3, 4.2e-9, 4.2e-9, 4.2e-9]),
    ("wavelength over the peak's, absolute", [1.3e-15, 3.7e-7, 3.7e-7, 2e-3, 2.9e-9, 2.9e-9, 2.9e-9]),
    ("frequency over the peak's, absolute", [8.8e-16, 3.3e-7, 3.3e-7, 2.1e-3, 2.5e-9, 2.5e-9, 2.5e-9]),
    ("tint", [8.8e-15, 1.3e-6, 1.3e-6, 9.5e-3, 9.9e-9, 9.9e-9, 9.9e-9]),
    ("Planck's law by wavelength", [1.7e-15, 8.6e-7, 8.6e-7, 0.0, 7.3e-9, 7.3e-9, 7.3e-9]),
    ("Planck's law by frequency", [1.2e-15, 5e-7, 5e-7, 0.0, 4.5e-9, 4.5e-9, 4.5e-9]),
    ("Wien's and Stefan and Boltzmann's laws", [7.5e-16, 2.7e-7, 2.7e-7, 0.0, 2.2e-9, 2.2e-9, 2.2e-9]),
];

/// The budget of the absolute error of a law over its peak.
pub fn absolute(format: Format, law: Law) -> f64 {
    BUDGETS[ABSOLUTE + law as usize].1[format as usize]
}

/// The budget of a level of a tint.
pub fn tint_budget(format: Format) -> f64 {
    BUDGETS[TINT].1[format as usize]
}

/// The budget of a law in SI units, over one more than the exponent.
pub fn spectral(format: Format, law: Law) -> f64 {
    BUDGETS[SPECTRAL + law as usize].1[format as usize]
}

/// The budget of the laws without a spectrum.
pub fn total(format: Format) -> f64 {
    BUDGETS[TOTAL].1[format as usize]
}

pub struct Errors(pub Body);

impl Visitor for Errors {
    type Output = Figures;

    fn visit<T: Real>(self) -> Figures {
        let Self(body) = self;
        if body.raw {
            return NONE;
        }
        let [[relative, absolute], [by_frequency, absolute_by_frequency]] =
            Law::ALL.map(|law| over_peak::<T::Scalar>(&body, law));
        let [wavelength, frequency] = Law::ALL.map(|law| si::spectral_error(&body, law));
        [
            relative.map(|error| (0, error)),
            by_frequency.map(|error| (1, error)),
            absolute.map(|error| (ABSOLUTE, error)),
            absolute_by_frequency.map(|error| (ABSOLUTE + 1, error)),
            Some((TINT, tint_error::<T::Scalar>(&body))),
            wavelength.map(|error| (SPECTRAL, error)),
            frequency.map(|error| (SPECTRAL + 1, error)),
            si::total_error(&body).map(|error| (TOTAL, error)),
        ]
    }
}

/// Relative error within the span that it is budgeted for, and absolute error.
fn over_peak<S: Scalar>(body: &Body, law: Law) -> [Option<f64>; 2] {
    let ratio = S::nearest(body.ratios[0]);
    let [error, truth] = error_at(law, ratio);
    let error = libm::fabs(error);
    let [least, most] = SPAN[law as usize];
    let within = (least..=most).contains(&ratio.exact());
    [within.then_some(error / truth), Some(error)]
}

/// The greatest error of a level.
fn tint_error<S: Scalar>(body: &Body) -> f64 {
    let temperature = S::nearest(body.temperatures[0]);
    let wavelengths = body.wavelengths.map(S::nearest);
    let kelvins = 1000.0 * temperature.exact();
    let truth = wavelengths.map(|wavelength| Law::Wavelength.radiance(1e-6 * wavelength.exact(), kelvins));
    let greatest = truth.into_iter().fold(0.0, f64::max);
    let levels = tint(temperature, wavelengths).map(Scalar::exact);
    levels.iter().zip(truth).map(|(level, truth)| (level - truth / greatest).abs()).fold(0.0, worse)
}
