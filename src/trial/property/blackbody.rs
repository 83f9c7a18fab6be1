//! Black bodies: Planck's law in SI units, relative to its peak, and as a tint.

mod errors;
mod si;

use super::figures::{self, Figures};
use super::{Broken, Case};
use crate::blackbody::tint;
use crate::oracle::planck::Law;
use crate::real::{Real, Scalar};
use crate::trial::blackbody::relative;
use crate::trial::draw::Draw;
use crate::trial::format::{Format, Visitor};

pub use errors::BUDGETS;

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let body = Body::new(draw);
    let case = body.case();
    figures::within(&case, &BUDGETS, body.format.visit(errors::Errors(body)))?;
    body.format.visit(Laws(body))?;
    si::hold(&body)
}

/// The errors of a case that are budgeted, for the search.
pub fn errors(draw: &mut Draw<'_>) -> (Format, Figures) {
    let body = Body::new(draw);
    (body.format, body.format.visit(errors::Errors(body)))
}

/// What is asked of the laws.
#[derive(Clone, Copy, Debug)]
struct Body {
    format: Format,
    /// Whether all numbers are any bits.
    raw: bool,
    /// Wavelengths or frequencies over the peak's.
    ratios: [f64; 2],
    /// In kilokelvins, two of them.
    temperatures: [f64; 2],
    /// In micrometres.
    wavelengths: [f64; 3],
    /// In kelvins, two of them.
    kelvins: [f64; 2],
    /// The exponent of Planck's law for the first of those; raw: a wavelength or frequency.
    exponent: f64,
}

impl Body {
    fn new(draw: &mut Draw<'_>) -> Self {
        let format = draw.format();
        let raw = draw.byte().is_multiple_of(8);
        if raw {
            let mut any = || draw.any(format);
            let (ratios, temperatures) = ([any(), any()], [any(), any()]);
            let (wavelengths, kelvins) = ([any(), any(), any()], [any(), any()]);
            return Self { format, raw, ratios, temperatures, wavelengths, kelvins, exponent: any() };
        }
        let ratios = [ratio(draw), ratio(draw)];
        let temperatures = [draw.logarithmic(0.8, 40.0), draw.logarithmic(0.8, 40.0)];
        let wavelengths = [(); 3].map(|()| draw.logarithmic(0.38, 0.78));
        let kelvins = [draw.logarithmic(1e-3, 1e9), draw.logarithmic(1e-3, 1e9)];
        let exponent = draw.logarithmic(1e-6, 700.0);
        Self { format, raw, ratios, temperatures, wavelengths, kelvins, exponent }
    }

    fn case(&self) -> Case {
        let Self { ratios: [a, b], temperatures: [c, d], wavelengths: [e, f, g], kelvins: [h, i], exponent, .. } =
            *self;
        Case { format: self.format, inputs: [a, b, c, d, e, f, g, h, i, exponent] }
    }
}

/// All that Q16 levels hold, what lies about the peak, and the peak and its neighbours.
fn ratio(draw: &mut Draw<'_>) -> f64 {
    match draw.byte() % 8 {
        0 | 1 => draw.logarithmic(1.0 / 65_536.0, 60_000.0),
        2 => draw.one_of([1.0, 0.5, 2.0, 10.0, 0.1, 3.0, 1.0_f64.next_up(), 1.0_f64.next_down()]),
        3 => 1.0 + draw.between(-1.0, 1.0) * draw.logarithmic(1e-9, 1e-1),
        _ => draw.logarithmic(0.1, 10.0),
    }
}

/// What follows from the budgets, and what is finite.
struct Laws(Body);

impl Visitor for Laws {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self(body) = self;
        let case = body.case();
        for law in Law::ALL {
            curve::<T::Scalar>(&body, &case, law)?;
        }
        let colours = body.temperatures.map(|temperature| {
            tint(T::Scalar::nearest(temperature), body.wavelengths.map(T::Scalar::nearest)).map(Scalar::exact)
        });
        for colour in colours {
            case.holds("tints are from 0 to 1", colour.into_iter().all(|level| (0.0..=1.0).contains(&level)))?;
        }
        if body.raw { Ok(()) } else { tints::<T::Scalar>(&body, &case, colours) }
    }
}

/// The law relative to its peak: finite, 1 at the peak, and falling to either side.
fn curve<S: Scalar>(body: &Body, case: &Case, law: Law) -> Result<(), Broken> {
    let budget = errors::absolute(body.format, law);
    let [a, b] = body.ratios.map(S::nearest);
    let levels = [a, b, S::ONE].map(|ratio| relative(law, ratio).exact());
    for level in levels {
        case.holds("levels over the peak's are finite and not negative", level.is_finite() && level >= 0.0)?;
        case.at_most("levels over the peak's are at most 1", level, 1.0 + budget)?;
    }
    case.at_most("the peak is 1", (levels[2] - 1.0).abs(), budget)?;
    let [a, b] = [a, b].map(Scalar::exact);
    case.holds("what is not positive has no level", (a > 0.0 || levels[0] == 0.0) && (b > 0.0 || levels[1] == 0.0))?;
    if a.is_nan() || b.is_nan() {
        return Ok(());
    }
    let farther = if a < b { levels[0] - levels[1] } else { levels[1] - levels[0] };
    if a.max(b) <= 1.0 {
        case.at_most("levels rise up to the peak", farther, 2.0 * budget)?;
    } else if a.min(b) >= 1.0 {
        case.at_most("levels fall from the peak", -farther, 2.0 * budget)?;
    }
    Ok(())
}

/// A tint has a level of 1, and turns from long waves to short ones as the temperature rises.
fn tints<S: Scalar>(body: &Body, case: &Case, colours: [[f64; 3]; 2]) -> Result<(), Broken> {
    let budget = errors::tint_budget(body.format);
    for colour in colours {
        let greatest = colour.into_iter().fold(0.0, f64::max);
        case.holds("the greatest level of a tint is 1", greatest == 1.0)?;
    }
    let wavelengths = body.wavelengths.map(|value| S::nearest(value).exact());
    let [cold, hot] = if body.temperatures[0] < body.temperatures[1] { colours } else { [colours[1], colours[0]] };
    for [i, j] in [[0, 1], [1, 2], [2, 0]] {
        // The quotient of the two rises; neither is divided by, for it may be zero.
        let rises = hot[i] * cold[j] - cold[i] * hot[j];
        let signed = if wavelengths[i] < wavelengths[j] { -rises } else { rises };
        let same = wavelengths[i] == wavelengths[j];
        let allowed = 4.0 * budget;
        case.at_most("short waves gain as the temperature rises", if same { rises.abs() } else { signed }, allowed)?;
    }
    Ok(())
}
