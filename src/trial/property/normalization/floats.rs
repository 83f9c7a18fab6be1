//! The quantities in a float format.

use core::f64::consts::PI;

use super::{Broken, Case, Judge, yes};
use crate::light::LightError;
use crate::normalization::{radiance, sun_radius_at};
use crate::real::Float;
use crate::trial::format::Format;
use crate::trial::quantity::Quantity;

/// Units in the last place that an answer may be off, f64 to f16. In f64 most of it is the truth's own rounding; below
/// the least normal number the others round twice.
const FAITHFUL: [f64; 4] = [9.0, 0.76, 0.76, 0.8];

/// The same of the Sun's radius.
const SUN_RADIUS: [f64; 4] = [1.2, 0.76, 0.76, 0.8];

/// The same of radiance, from [`LEAST`] on.
const RADIANCE: [f64; 4] = [4.0, 0.76, 0.76, 0.8];

/// What half the intensity may be off half the radiance: where one of them is subnormal.
const LINEAR: [f64; 4] = [0.0, 2.0, 2.0, 2.0];

/// Ratio and intensity below which the format has not all digits of the square or of the intensity's part in pi.
const LEAST: [[f64; 2]; 4] = [[1e-150, 1e-300], [1e-27, 0.0], [1e-27, 0.0], [1.0 / 2048.0, 0.001]];

pub(super) fn claims<T: Float>(case: &Case, judge: Judge<'_>) -> Result<(), Broken> {
    let [ratio, intensity] = [case.inputs[0], case.inputs[1]].map(T::nearest);
    for quantity in Quantity::ALL {
        quantity_claims(case, quantity, ratio, judge)?;
    }
    radiance_claims(case, ratio, intensity, judge)?;
    sun_radius_claims(case, intensity, judge)
}

fn in_unit(value: f64) -> bool {
    (0.0..=1.0).contains(&value)
}

/// Distance in units of the last place; an overflow counts as the first number that the format does not have.
fn off<T: Float>(case: &Case, answer: Result<T, LightError>, truth: f64) -> f64 {
    let format = case.format;
    match answer {
        Ok(answer) => (answer.exact() - truth).abs() / format.ulp(truth),
        Err(LightError::Overflow(name)) if name == T::FORMAT => {
            let over = T::MAX.exact() / format.ulp(T::MAX.exact()) + 1.0;
            (over - truth / format.ulp(T::MAX.exact())).max(0.0)
        }
        Err(_) => f64::NAN,
    }
}

fn quantity_claims<T: Float>(case: &Case, quantity: Quantity, ratio: T, judge: Judge<'_>) -> Result<(), Broken> {
    let answer = quantity.in_float(ratio);
    if !in_unit(ratio.exact()) {
        let refused = matches!(answer, Err(LightError::Ratio(value)) if value.to_bits() == ratio.exact().to_bits());
        return judge(case, ("a ratio out of 0 to 1 is refused", yes(refused), 0.0));
    }
    let faithful = FAITHFUL[case.format as usize];
    judge(case, (quantity.name(), off(case, answer, quantity.truth(ratio.exact())), faithful))?;
    // Zero is a point, whose sizeFactor is 1.
    let next = case.format.value(case.format.bits(ratio.exact()) + 1);
    if ratio.exact() > 0.0 && next <= 1.0 {
        let rising = !matches!(quantity, Quantity::InverseSizeFactor | Quantity::WhiteRadiance);
        let [now, then] = [ratio, T::nearest(next)].map(|ratio| quantity.in_float(ratio).unwrap_or(T::MAX));
        judge(case, ("has no step the other way", yes(if rising { now <= then } else { now >= then }), 0.0))?;
    }
    if quantity == Quantity::SizeFactor {
        product_claims(case, ratio, judge)?;
    }
    Ok(())
}

/// sizeFactor times its reciprocal, where neither is subnormal.
fn product_claims<T: Float>(case: &Case, ratio: T, judge: Judge<'_>) -> Result<(), Broken> {
    let answers = [Quantity::SizeFactor, Quantity::InverseSizeFactor].map(|quantity| quantity.in_float(ratio));
    let [Ok(factor), Ok(inverse)] = answers else { return Ok(()) };
    let normal = match case.format {
        Format::F64 => f64::MIN_POSITIVE,
        Format::F16 => 6.103_515_625e-5,
        _ => f32::MIN_POSITIVE.into(),
    };
    if factor.exact() < normal || inverse.exact() < normal {
        return Ok(());
    }
    let product = (factor.exact() * inverse.exact() - 1.0).abs() / case.format.step();
    judge(case, ("sizeFactor times its reciprocal is 1", product, if case.format == Format::F16 { 2.5 } else { 2.0 }))
}

fn radiance_claims<T: Float>(case: &Case, ratio: T, intensity: T, judge: Judge<'_>) -> Result<(), Broken> {
    let (x, i) = (ratio.exact(), intensity.exact());
    let answer = radiance(intensity, ratio);
    if !in_unit(x) {
        return judge(case, ("radiance refuses the ratio", yes(matches!(answer, Err(LightError::Ratio(_)))), 0.0));
    }
    if !(i >= 0.0 && i <= T::MAX.exact()) {
        let refused = matches!(answer, Err(LightError::Intensity(value)) if value.to_bits() == i.to_bits());
        return judge(case, ("radiance refuses the intensity", yes(refused), 0.0));
    }
    if x == 0.0 || i == 0.0 {
        return judge(case, ("a point's radiance is its intensity", yes(answer == Ok(intensity)), 0.0));
    }
    let [least_ratio, least] = LEAST[case.format as usize];
    if x < least_ratio || i < least {
        let number = answer.map_or_else(|error| error == LightError::Overflow(T::FORMAT), |answer| answer <= T::MAX);
        return judge(case, ("small radiance is a number", yes(number), 0.0));
    }
    judge(case, ("radiance", off(case, answer, i / (PI * x * x)), RADIANCE[case.format as usize]))?;
    let half = T::nearest(i / 2.0);
    if let (Ok(whole), Ok(part)) = (answer, radiance(half, ratio)) {
        let step = (whole.exact() - 2.0 * part.exact()).abs() / case.format.ulp(whole.exact());
        judge(
            case,
            ("radiance is linear", if half.exact() * 2.0 == i { step } else { 0.0 }, LINEAR[case.format as usize]),
        )?;
    }
    Ok(())
}

fn sun_radius_claims<T: Float>(case: &Case, distance: T, judge: Judge<'_>) -> Result<(), Broken> {
    let exact = distance.exact();
    let answer = sun_radius_at(distance);
    if !(exact > 0.0 && exact <= T::MAX.exact()) {
        return judge(case, ("no distance is refused", yes(matches!(answer, Err(LightError::Distance(_)))), 0.0));
    }
    let truth = exact * (6_957_000.0 / 1_495_978_707.0);
    judge(case, ("the Sun's radius", off(case, answer, truth), SUN_RADIUS[case.format as usize]))
}
