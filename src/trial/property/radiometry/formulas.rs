//! The formulas over all that a format holds: their errors, and what follows from their form.

use super::Lamp;
use super::scale::Truth;
use crate::radiometry::{Patch, beam_power, flux, irradiance, point_intensity, projected_area, radiosity};
use crate::real::{Real, Scalar};
use crate::trial::format::{Format, Visitor};
use crate::trial::property::figures::Row;
use crate::trial::property::{Broken, Case};
use crate::trial::radiometry::Formula;

/// Budgets of the relative error of each of [`Formula::ALL`]; answers below the least normal number count as that one.
pub const BUDGETS: [Row; Formula::ALL.len()] = [
    ("area_radiance", [3.3e-16, 1.8e-7, 1.8e-7, 1.5e-3, 1.7e-9, 1.7e-9, 1.7e-9]),
    ("lambertian_radiance", [3.7e-16, 2e-7, 2e-7, 1.7e-3, 1.5e-9, 1.5e-9, 1.5e-9]),
    ("sphere_radiance", [4.9e-16, 2.3e-7, 2.3e-7, 2.3e-3, 1.9e-9, 1.9e-9, 1.9e-9]),
    ("point_intensity", [1.7e-16, 9.8e-8, 9.8e-8, 8.7e-4, 6e-10, 6e-10, 6e-10]),
    ("irradiance", [4.8e-16, 2.4e-7, 2.4e-7, 2.1e-3, 2.1e-9, 2.1e-9, 2.1e-9]),
    ("patch_solid_angle", [4.8e-16, 2.4e-7, 2.4e-7, 2.1e-3, 2.1e-9, 2.1e-9, 2.1e-9]),
    ("diffuse_radiance", [2.6e-16, 1.7e-7, 1.7e-7, 1.4e-3, 9.9e-10, 9.9e-10, 9.9e-10]),
    ("flux", [5.8e-16, 2.9e-7, 3e-7, 2.6e-3, 2.8e-9, 2.8e-9, 2.8e-9]),
    ("SphereLight", [1.1e-15, 4.8e-7, 1.1e-5, 4.1e-3, 4.1e-9, 4.1e-9, 4.1e-9]),
];

fn budget(formula: Formula, format: Format) -> f64 {
    BUDGETS[formula as usize].1[format as usize]
}

/// The least and the greatest number that count as answers. Fixed point's numbers reach beyond f64's, in which they
/// are judged.
pub fn ends(format: Format) -> [f64; 2] {
    match format {
        Format::F32 | Format::Micromath => [f32::MIN_POSITIVE.into(), f32::MAX.into()],
        Format::F16 => [1.0 / 16_384.0, 65_504.0],
        _ => [1e-290, 1e300],
    }
}

/// The greatest number of a format; none where it is beyond f64's.
pub fn greatest(format: Format) -> f64 {
    match format {
        Format::F64 => f64::MAX,
        Format::I2F14 | Format::I2F30 | Format::I16F16 => f64::INFINITY,
        format => ends(format)[1],
    }
}

/// A case as the format's numbers hold it, and its truth.
pub struct Held<S> {
    pub levels: [S; 4],
    pub cosines: [S; 2],
    pub truth: Truth,
}

impl<S: Scalar> Held<S> {
    pub fn new(lamp: &Lamp) -> Self {
        let (levels, cosines) = (lamp.levels.map(S::nearest), lamp.cosines.map(S::nearest));
        // What faces away counts as not there.
        let truth = Truth::of(lamp.formula, levels.map(S::exact), cosines.map(|cosine| cosine.exact().max(0.0)));
        Self { levels, cosines, truth }
    }
}

/// The error of the formula, where its numbers are allowed and its answer is within the format.
pub struct Errors(pub Lamp);

impl Visitor for Errors {
    type Output = Option<(usize, f64)>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self(lamp) = self;
        let Held { levels, cosines, truth } = Held::<T::Scalar>::new(&lamp);
        let [least, most] = ends(lamp.format);
        let allowed = levels.into_iter().all(|level| level > T::Scalar::ZERO);
        // A sphere is not larger than its distance, which has to be a normal number: a subnormal one has lost digits.
        let distance = libm::hypot(libm::hypot(lamp.levels[0], lamp.levels[1]), lamp.levels[2]);
        let outside =
            lamp.formula != Formula::SmallSphere || (truth.value() > 1.01 && (least..0.99 * most).contains(&distance));
        let within = truth.value() <= most * (1.0 - 0.01);
        if lamp.raw || !allowed || !outside || !within {
            return None;
        }
        let answer = lamp.formula.compute(levels, cosines).exact();
        Some((lamp.formula as usize, truth.error(answer, least)))
    }
}

/// What follows from the formulas' form.
pub struct Laws(pub Lamp);

impl Visitor for Laws {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self(lamp) = self;
        let case = lamp.case();
        let Held { levels, cosines, truth } = Held::<T::Scalar>::new(&lamp);
        let answer = lamp.formula.compute(levels, cosines);
        case.holds("answers are finite and not negative", finite(answer))?;
        let ([a, b, c, d], [cos, other]) = (levels, cosines);
        for product in [projected_area(a, cos), beam_power(a, b), radiosity(cos, a)] {
            case.holds("products are finite and not negative", finite(product))?;
        }
        if lamp.raw {
            return Ok(());
        }
        let [least, most] = ends(lamp.format);
        let overflows = matches!(lamp.formula, Formula::Irradiance | Formula::PatchSolidAngle | Formula::Flux);
        let distant = if lamp.formula == Formula::Flux { d } else { b } > T::Scalar::ZERO;
        let top = greatest(lamp.format);
        if overflows && distant && truth.value() > top * 1.01 {
            case.at_most("what overflows is the greatest number", top - answer.exact(), 0.01 * top)?;
        }
        doubled(&case, [a, b, cos], [least, most])?;
        let [sender, receiver] = [Patch { area: b, cos }, Patch { area: c, cos: other }];
        let ways = [flux(a, sender, receiver, d), flux(a, receiver, sender, d)].map(T::Scalar::exact);
        let apart = (ways[0] - ways[1]).abs() / ways[0].max(least);
        let allowed = 2.0 * budget(Formula::Flux, lamp.format);
        let read = ways.into_iter().all(|way| way <= most);
        case.at_most("flux is the same both ways", if read { apart } else { 0.0 }, allowed)?;
        let near = irradiance(a, cos, b).exact();
        let far = irradiance(a, cos, b + b).exact();
        let apart = (far * 4.0 - near).abs() / near.max(4.0 * least);
        let read = near < 0.99 * most && (b + b).exact() <= most;
        let allowed = 2.0 * budget(Formula::Irradiance, lamp.format);
        case.at_most("twice as far is a quarter", if read { apart } else { 0.0 }, allowed)
    }
}

/// Twice the light is exactly twice the answer of the formulas that are one product or quotient.
fn doubled<S: Scalar>(case: &Case, [a, b, cos]: [S; 3], [least, most]: [f64; 2]) -> Result<(), Broken> {
    let twice = a + a;
    let intensity = |power: S| point_intensity(power).unwrap_or(S::ZERO);
    for [once, doubled] in [
        [projected_area(a, cos), projected_area(twice, cos)],
        [beam_power(a, b), beam_power(twice, b)],
        [radiosity(cos, a), radiosity(cos, twice)],
        [intensity(a), intensity(twice)],
    ] {
        let [once, doubled] = [once, doubled].map(S::exact);
        let within = once > least && 2.0 * once <= most && twice.exact() <= most;
        case.holds("twice the light is twice the answer", !within || doubled == 2.0 * once)?;
    }
    Ok(())
}

pub fn finite<S: Scalar>(value: S) -> bool {
    value >= S::ZERO && value <= S::MAX
}
