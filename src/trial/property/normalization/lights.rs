//! Lights of any f64 bits: what is refused, what the constants are, and that all constructors agree.

use core::f64::consts::PI;

use super::{Broken, Case, Judge, yes};
use crate::light::{DistantLight, LightError};
use crate::trial::draw::Draw;
use crate::trial::format::Format;

pub(super) fn claims(draw: &mut Draw<'_>, judge: Judge<'_>) -> Result<(), Broken> {
    let [value, other] = [(); 2].map(|()| number(draw));
    let mut inputs = [0.0; 10];
    (inputs[0], inputs[1]) = (value, other);
    let case = Case { format: Format::F64, inputs };
    constructor_claims(&case, value, other, judge)?;
    agreement_claims(&case, draw, judge)
}

fn number(draw: &mut Draw<'_>) -> f64 {
    match draw.byte() & 3 {
        0 => f64::from_bits(draw.bits()),
        1 => draw.logarithmic(1e-300, 1e300),
        2 => draw.between(0.0, 1.0),
        _ => draw.one_of([
            0.0,
            -0.0,
            1.0,
            1.0_f64.next_up(),
            PI,
            PI.next_up(),
            360.0,
            360.0_f64.next_up(),
            180.0,
            5e-324,
        ]),
    }
}

/// Each constructor takes what it documents, refuses all else by name, and holds the value.
fn constructor_claims(case: &Case, value: f64, other: f64, judge: Judge<'_>) -> Result<(), Broken> {
    let within = |most: f64| value >= 0.0 && value <= most;
    let same = |held: f64, value: f64| held.to_bits() == value.to_bits();
    let by_distance = DistantLight::from_radius_and_distance(value, other);
    let distant = other > 0.0 && other <= f64::MAX;
    let answers = [
        (DistantLight::from_ratio(value), within(1.0), "ratio"),
        (DistantLight::from_angular_radius(value), within(PI), "angular radius"),
        (DistantLight::from_angle(value), within(360.0), "angle"),
        (by_distance, distant && within(other), "radius and distance"),
    ];
    for (answer, taken, property) in answers {
        judge(case, (property, yes(answer.is_ok() == taken), 0.0))?;
        match answer {
            Ok(light) => constants_claims(case, &light, judge)?,
            Err(error) => judge(
                case,
                (
                    "an error holds the value",
                    yes(match error {
                        LightError::Ratio(held) | LightError::AngularRadius(held) | LightError::Angle(held) => {
                            same(held, value)
                        }
                        LightError::Radius { radius, distance } => {
                            distant && same(radius, value) && same(distance, other)
                        }
                        LightError::Distance(held) => !distant && same(held, other),
                        _ => false,
                    }),
                    0.0,
                ),
            )?,
        }
    }
    Ok(())
}

/// Ranges, Pythagoras, and the quantities of a light.
fn constants_claims(case: &Case, light: &DistantLight, judge: Judge<'_>) -> Result<(), Broken> {
    let (sin, cos, versine) = (light.sin(), light.cos(), light.versine());
    let ranges = (0.0..=1.0).contains(&sin) && (-1.0..=1.0).contains(&cos) && (0.0..=2.0).contains(&versine);
    judge(case, ("constants are in range", yes(ranges), 0.0))?;
    judge(case, ("sin^2 + cos^2 is 1", (sin * sin + cos * cos - 1.0).abs(), 6.0e-16))?;
    judge(case, ("versine is 1 - cos", (1.0 - cos - versine).abs(), 3.0e-16))?;
    let (solid, factor) = (light.solid_angle(), light.size_factor());
    let ranges = (0.0..=4.0 * PI).contains(&solid) && (0.0..=2.0 * PI).contains(&factor);
    judge(case, ("quantities are in range", yes(ranges), 0.0))?;
    match light.radiance(1.0) {
        Ok(radiance) => {
            judge(case, ("radiance times sizeFactor is the intensity", (radiance * factor - 1.0).abs(), 1.3e-16))
        }
        Err(error) => {
            judge(case, ("radiance overflows", yes(error == LightError::Overflow("f64") && factor < 1e-308), 0.0))
        }
    }
}

/// The same light by its ratio, by radius and distance, by the angle in radians and in degrees.
fn agreement_claims(case: &Case, draw: &mut Draw<'_>, judge: Judge<'_>) -> Result<(), Broken> {
    let angle = if draw.byte() & 1 == 0 { draw.logarithmic(1e-12, 360.0) } else { draw.between(0.0, 360.0) };
    let distance = draw.logarithmic(1e-100, 1e100);
    let mut case = *case;
    (case.inputs[2], case.inputs[3]) = (angle, distance);
    let theta = angle * (PI / 360.0);
    let by_angle = DistantLight::from_angle(angle);
    let (Ok(degrees), Ok(radians)) = (by_angle, DistantLight::from_angular_radius(theta.min(PI))) else {
        return judge(&case, ("angles are taken", 1.0, 0.0));
    };
    let constants = |light: &DistantLight| [light.sin(), light.cos(), light.versine()];
    let most = |a: &DistantLight, b: &DistantLight, small: f64| {
        let [p, q] = [a, b].map(constants);
        let [sin, cos, versine] = [0, 1, 2].map(|i| (p[i] - q[i]).abs());
        [sin / small, cos, versine / small].into_iter().fold(0.0, f64::max)
    };
    // The angle itself was rounded twice.
    judge(&case, ("degrees agree with radians", most(&degrees, &radians, theta), 5.0e-16))?;
    if angle > 180.0 {
        return Ok(());
    }
    let sin = degrees.sin();
    let spheres = [DistantLight::from_ratio(sin), DistantLight::from_radius_and_distance(sin * distance, distance)];
    for sphere in spheres {
        let Ok(sphere) = sphere else { return judge(&case, ("a sine is a ratio", 1.0, 0.0)) };
        judge(&case, ("a ratio is a sine", (sphere.sin() / sin - 1.0).abs(), 4.5e-16))?;
        // The cosine hangs on the sine by its tangent.
        let slack = sin / degrees.cos().max(1e-8);
        judge(&case, ("a sphere is a disc", most(&sphere, &degrees, 1.0) / (slack + 1.0), 6.0e-16))?;
    }
    Ok(())
}
