//! The laws in SI units, in the formats whose range holds them: all but f16.

use super::{Body, errors};
use crate::blackbody::{
    STEFAN_BOLTZMANN, WIEN_FREQUENCY, WIEN_WAVELENGTH, WideRange, peak_frequency, peak_wavelength, radiant_exitance,
    total_radiance,
};
use crate::oracle::planck::Law;
use crate::real::Scaled;
use crate::trial::blackbody::spectral;
use crate::trial::format::Format;
use crate::trial::found::worse;
use crate::trial::property::{Broken, Case};

/// What is to be done in a number of wide range.
trait Wide {
    type Output;
    fn with<S: WideRange>(self) -> Self::Output;
}

/// In the numbers of a format; none of f16.
fn visit<W: Wide>(format: Format, wide: W) -> Option<W::Output> {
    match format {
        Format::F64 => Some(wide.with::<f64>()),
        Format::F32 => Some(wide.with::<f32>()),
        Format::Micromath => Some(wide.with::<micromath::F32>()),
        Format::F16 => None,
        Format::I2F14 | Format::I2F30 | Format::I16F16 => Some(wide.with::<Scaled>()),
    }
}

/// Claims what holds of the laws.
pub fn hold(body: &Body) -> Result<(), Broken> {
    visit(body.format, Laws { body, case: body.case() }).unwrap_or(Ok(()))
}

/// Relative error over one more than the exponent, where numbers and answer are normal.
pub fn spectral_error(body: &Body, law: Law) -> Option<f64> {
    visit(body.format, Spectral { body, law }).flatten()
}

/// The worst relative error of the laws without a spectrum, where all of them are normal numbers.
pub fn total_error(body: &Body) -> Option<f64> {
    visit(body.format, Totals(body)).flatten()
}

/// The greatest and least normal numbers that are judged.
fn ends(format: Format) -> [f64; 2] {
    match format {
        Format::F32 | Format::Micromath => [f32::MIN_POSITIVE.into(), f32::MAX.into()],
        _ => [1e-290, 1e300],
    }
}

fn normal(format: Format, value: f64) -> bool {
    let [least, most] = ends(format);
    // The greatest numbers may round up and be the greatest.
    value >= least && value <= most * (1.0 - 1e-6)
}

/// The wavelength in metres or the frequency in hertz at which the exponent is the case's.
fn place<S: WideRange>(body: &Body, law: Law) -> S {
    let at = match law {
        Law::Wavelength => crate::blackbody::SECOND_RADIATION / (body.exponent * body.kelvins[0]),
        Law::Frequency => body.exponent * body.kelvins[0] / 4.799_243_073_366_221e-11,
    };
    S::nearest(if body.raw { body.exponent } else { at })
}

struct Spectral<'a> {
    body: &'a Body,
    law: Law,
}

impl Wide for Spectral<'_> {
    type Output = Option<f64>;

    fn with<S: WideRange>(self) -> Option<f64> {
        let Self { body, law } = self;
        let (at, temperature) = (place::<S>(body, law), S::nearest(body.kelvins[0]));
        let truth = law.radiance(at.exact(), temperature.exact());
        let error = (spectral(law, at, temperature).exact() - truth).abs() / truth;
        normal(body.format, truth).then(|| error / (1.0 + law.exponent(at.exact(), temperature.exact())))
    }
}

struct Totals<'a>(&'a Body);

fn totals<S: WideRange>(temperature: S) -> [f64; 4] {
    [
        radiant_exitance(temperature),
        total_radiance(temperature),
        peak_wavelength(temperature),
        peak_frequency(temperature),
    ]
    .map(S::exact)
}

impl Wide for Totals<'_> {
    type Output = Option<f64>;

    fn with<S: WideRange>(self) -> Option<f64> {
        let temperature = S::nearest(self.0.kelvins[0]);
        let kelvins = temperature.exact();
        let fourth = STEFAN_BOLTZMANN * kelvins * kelvins * kelvins * kelvins;
        let truths = [fourth, fourth / core::f64::consts::PI, WIEN_WAVELENGTH / kelvins, WIEN_FREQUENCY * kelvins];
        let found = totals(temperature).into_iter().zip(truths).map(|(found, truth)| (found / truth - 1.0).abs());
        truths.into_iter().all(|truth| normal(self.0.format, truth)).then(|| found.fold(0.0, worse))
    }
}

struct Laws<'a> {
    body: &'a Body,
    case: Case,
}

impl Wide for Laws<'_> {
    type Output = Result<(), Broken>;

    fn with<S: WideRange>(self) -> Self::Output {
        let Self { body, case } = self;
        let temperatures = body.kelvins.map(S::nearest);
        for law in Law::ALL {
            let at = place::<S>(body, law);
            let levels = temperatures.map(|temperature| spectral(law, at, temperature));
            for level in levels {
                case.holds("radiance is finite and not negative", level >= S::ZERO && level <= S::MAX)?;
            }
            rises(body, &case, law, at, temperatures)?;
        }
        for temperature in temperatures {
            let all = [radiant_exitance, total_radiance, peak_wavelength, peak_frequency].map(|law| law(temperature));
            let finite = all.into_iter().all(|value| value >= S::ZERO && value <= S::MAX);
            case.holds("totals and peaks are finite and not negative", finite)?;
            let dark = temperature > S::ZERO || all == [S::ZERO; 4];
            case.holds("what is not warm is dark", dark)?;
        }
        if body.raw { Ok(()) } else { powers(body, &case, temperatures[0]) }
    }
}

/// A warmer body is brighter at every wavelength.
fn rises<S: WideRange>(body: &Body, case: &Case, law: Law, at: S, [a, b]: [S; 2]) -> Result<(), Broken> {
    if body.raw {
        return Ok(());
    }
    let (cold, hot) = if a < b { (a, b) } else { (b, a) };
    let [dark, bright] = [cold, hot].map(|temperature| spectral(law, at, temperature).exact());
    let part = |temperature: S| 1.0 + law.exponent(at.exact(), temperature.exact());
    let allowed = errors::spectral(body.format, law) * (part(cold) + part(hot));
    let fell = if normal(body.format, dark) { 1.0 - bright / dark } else { 0.0 };
    case.at_most("warmer is brighter at every wavelength", fell, allowed)
}

/// Twice the temperature: exactly 16 times the power, half the wavelength and twice the frequency of the peak.
fn powers<S: WideRange>(body: &Body, case: &Case, temperature: S) -> Result<(), Broken> {
    let [once, twice] = [temperature, temperature + temperature].map(totals);
    let within = once.into_iter().chain(twice).all(|value| normal(body.format, value));
    // Fixed point divides by way of a root, which is another one for an odd exponent.
    let float = matches!(body.format, Format::F64 | Format::F32 | Format::Micromath);
    let halved = if float { 0.0 } else { 2.0 * errors::total(body.format) };
    for (i, [factor, allowed]) in [[16.0, 0.0], [16.0, 0.0], [0.5, halved], [2.0, 0.0]].into_iter().enumerate() {
        let apart = if within { (twice[i] / factor / once[i] - 1.0).abs() } else { 0.0 };
        case.at_most("twice the temperature is 16 times the power, half the wavelength", apart, allowed)?;
    }
    let apart = (once[1] * core::f64::consts::PI / once[0] - 1.0).abs();
    let allowed = 2.0 * errors::total(body.format);
    case.at_most("radiance times pi is exitance", if within { apart } else { 0.0 }, allowed)
}
