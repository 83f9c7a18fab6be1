//! What lamps refuse: exactly what their documentation says, with the value that was refused.

use super::Lamp;
use super::formulas::{Held, finite, greatest};
use crate::radiometry::{
    RadiometryError, SphereLight, area_radiance, lambertian_radiance, non_directional_radiance, point_intensity,
    sphere_radiance,
};
use crate::real::{Real, Scalar};
use crate::trial::format::Visitor;
use crate::trial::property::{Broken, Case};
use crate::trial::radiometry::Formula;

pub struct Refusals(pub Lamp);

type Answer<S> = Result<S, RadiometryError<S>>;

type Refused<S> = Option<RadiometryError<S>>;

/// A lamp's formula, its answer, and why it should be refused.
type Asked<S> = (Formula, Answer<S>, Refused<S>);

impl Visitor for Refusals {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self(lamp) = self;
        let case = lamp.case();
        let Held { levels: [a, b, c, d], truth, .. } = Held::<T::Scalar>::new(&lamp);
        let power: Refused<T::Scalar> = (!finite(a)).then_some(RadiometryError::Power(a));
        let area = (!positive(b)).then_some(RadiometryError::Area(b));
        let solid_angle = (!positive(c)).then_some(RadiometryError::SolidAngle(c));
        let length = (!positive(b)).then_some(RadiometryError::Length(b));
        let asked: [Asked<T::Scalar>; 5] = [
            (Formula::AreaRadiance, area_radiance(a, b, c), power.or(area).or(solid_angle)),
            (Formula::LambertianRadiance, lambertian_radiance(a, b), power.or(area)),
            (Formula::LambertianRadiance, non_directional_radiance(a, b), power.or(area)),
            (Formula::SphereRadiance, sphere_radiance(a, b), power.or(length)),
            (Formula::PointIntensity, point_intensity(a), power),
        ];
        let most = greatest(lamp.format);
        for (index, (formula, answer, refused)) in asked.into_iter().enumerate() {
            // The third has another constant than the formula; raw bits may be beyond f64.
            let value = if formula == lamp.formula && index != 2 && !lamp.raw { Some(truth.value()) } else { None };
            refusal(&case, answer, refused, value, most)?;
        }
        sphere(&lamp, &case, [a, b, c], d)
    }
}

/// A refusal with its reason; else an overflow or an answer as the truth has it.
fn refusal<S: Scalar>(
    case: &Case,
    answer: Answer<S>,
    refused: Option<RadiometryError<S>>,
    truth: Option<f64>,
    most: f64,
) -> Result<(), Broken> {
    match (answer, refused) {
        (Err(error), Some(reason)) => case.holds("what is refused says why", same(error, reason)),
        (Ok(_), Some(_)) => case.holds("what cannot be is refused", false),
        (Ok(value), None) => {
            case.holds("lamps are finite and not negative", finite(value))?;
            case.at_most("what overflows is refused", truth.unwrap_or(0.0), 1.01 * most)
        }
        (Err(error), None) => {
            case.holds("only overflow is left", error == RadiometryError::Overflow)?;
            case.at_most("only what overflows is refused", -truth.unwrap_or(most), -0.99 * most)
        }
    }
}

/// A small sphere, from a position and from a direction.
fn sphere<S: Scalar>(lamp: &Lamp, case: &Case, position: [S; 3], radius: S) -> Result<(), Broken> {
    let colour = [S::nearest(lamp.albedo), S::ONE, S::ZERO];
    let point = SphereLight::of_point(position, [S::ZERO; 3], radius, colour);
    let direction = SphereLight::of_direction(position, S::ONE + S::ONE, radius, colour);
    for light in [point, direction, SphereLight::like_the_sun(position, S::ONE, colour)] {
        match light {
            Ok(light) => {
                case.holds(
                    "spheres have a distance and a radius",
                    positive(light.distance()) && positive(light.radius()),
                )?;
                case.holds("spheres are outside", light.radius() <= light.distance())?;
                let finite = light.radiance().map_or(true, |radiance| radiance.into_iter().all(finite));
                case.holds("radiance is finite and not negative", finite)?;
                let near = light.centre().into_iter().all(|lane| lane <= S::MAX && S::ZERO - lane <= S::MAX);
                case.holds("centres are finite", near)?;
            }
            Err(RadiometryError::Inside { radius, distance }) => case.holds("inside is inside", radius > distance)?,
            Err(RadiometryError::Length(length)) => {
                case.holds("lengths are refused if they are none", !positive(length))?
            }
            Err(RadiometryError::Colour(channel)) => {
                case.holds("colours are refused if they are none", !finite(channel))?
            }
            Err(_) => case.holds("spheres are refused for a reason", false)?,
        }
    }
    Ok(())
}

fn positive<S: Scalar>(value: S) -> bool {
    value > S::ZERO && value <= S::MAX
}

/// The same, NaN being the same as NaN.
fn same<S: Scalar>(a: RadiometryError<S>, b: RadiometryError<S>) -> bool {
    use RadiometryError::{Area, Length, Power, SolidAngle};
    match (a, b) {
        (Power(a), Power(b)) | (Area(a), Area(b)) | (SolidAngle(a), SolidAngle(b)) | (Length(a), Length(b)) => {
            a == b || (a.exact().is_nan() && b.exact().is_nan())
        }
        _ => a == b,
    }
}
