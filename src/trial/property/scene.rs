//! Scenes: materials, lamps and whole pixels, three channels at a time.

mod bits;
mod whole;

use super::{Broken, Case, Inputs, inputs};
use crate::material::{LEAST_ALPHA, Material, MaterialError, Surface};
use crate::real::{Constant, Float, Real, Scalar};
use crate::scene::{Lamp, SceneError};
use crate::sphere::DistantSphere;
use crate::trial::draw::Draw;
use crate::trial::format::{Format, Visitor};

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let format = draw.format();
    match draw.byte() % 8 {
        0 => format.visit(Materials { format, numbers: numbers(draw, format) }),
        1 => lamps(draw, format),
        2 => bits::hold(draw),
        _ => whole::hold(draw, format),
    }
}

/// Albedo, reflectance and roughness: allowed ones mostly, or any that the format has.
fn numbers(draw: &mut Draw<'_>, format: Format) -> [f64; 7] {
    let mut numbers = [(); 7].map(|()| match draw.byte() % 8 {
        0 => draw.any(format),
        1 => draw.one_of([0.0, 1.0, 1.0_f64.next_up(), -f64::MIN_POSITIVE, 2.0, -1.0]),
        _ => draw.fraction(),
    });
    if draw.byte().is_multiple_of(2) {
        numbers[6] = draw.one_of([0.0, LEAST_ALPHA, LEAST_ALPHA.next_down(), 1e-4, 1.0]);
    }
    numbers
}

/// Checks that a material is taken or refused as documented, and is the same from constants and at run time.
struct Materials {
    format: Format,
    numbers: [f64; 7],
}

/// The first number that is out of its range, by kind and value: albedo, reflectance, roughness.
fn refused(order: [usize; 7], numbers: [f64; 7], least: f64) -> Option<(usize, f64)> {
    let fits = |index: usize| {
        let value = numbers[index];
        let within = (0.0..=1.0).contains(&value);
        if index == 6 { value == 0.0 || within && value >= least } else { within }
    };
    order.into_iter().find(|&index| !fits(index)).map(|index| (index / 3, numbers[index]))
}

fn reason<S: Scalar>(error: MaterialError<S>) -> (usize, f64) {
    match error {
        MaterialError::Albedo(value) => (0, value.exact()),
        MaterialError::F0(value) => (1, value.exact()),
        MaterialError::Alpha(value) => (2, value.exact()),
    }
}

/// Equal, NaN to itself too.
fn same(found: Option<(usize, f64)>, expected: Option<(usize, f64)>) -> bool {
    match (found, expected) {
        (Some((kind, value)), Some((other, number))) => {
            kind == other && (value == number || value.is_nan() && number.is_nan())
        }
        (found, expected) => found.is_none() && expected.is_none(),
    }
}

impl Visitor for Materials {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self { format, numbers } = self;
        let mut inputs = Inputs::default();
        inputs[..7].copy_from_slice(&numbers);
        let case = Case { format, inputs };
        let [a, b, c, d, e, f, alpha] = numbers;
        let material = Material::new([a, b, c], alpha, [d, e, f]);
        let by_channel = [0, 3, 1, 4, 2, 5, 6];
        let expected = refused(by_channel, numbers, LEAST_ALPHA);
        case.holds("a material is refused for its number", same(material.err().map(reason), expected))?;
        let [a, b, c, d, e, f, alpha] = numbers.map(T::Scalar::nearest);
        let surface = Surface::<T>::new([a, b, c], alpha, [d, e, f]);
        let rounded = [a, b, c, d, e, f, alpha].map(Scalar::exact);
        let least = T::Scalar::constant(Constant::new(LEAST_ALPHA)).exact();
        let expected = refused([0, 1, 2, 3, 4, 5, 6], rounded, least);
        case.holds("a surface is refused for its number", same(surface.err().map(reason), expected))?;
        let Ok(material) = material else { return Ok(()) };
        case.holds("a material's surface is that of its numbers", surface == Ok(Surface::of(&material)))
    }
}

/// Lamps in any direction, of any length and of any level.
fn lamps(draw: &mut Draw<'_>, format: Format) -> Result<(), Broken> {
    let length = match draw.byte() % 4 {
        0 => 1.0,
        1 => draw.between(0.85, 1.15),
        _ => draw.between(0.0, 2.0),
    };
    let direction = match draw.byte() % 4 {
        0 => [(); 3].map(|()| draw.any(format)),
        _ => draw.direction().map(|lane| lane * length),
    };
    let levels =
        [(); 3].map(|()| if draw.byte().is_multiple_of(2) { draw.any(format) } else { draw.logarithmic(1e-3, 1e4) });
    let light = draw.light();
    match format {
        Format::F64 => lamp_of_floats::<f64>(format, &light, direction, levels),
        Format::F32 => lamp_of_floats::<f32>(format, &light, direction, levels),
        Format::Micromath => lamp_of_floats::<micromath::F32>(format, &light, direction, levels),
        Format::F16 => lamp_of_floats::<half::f16>(format, &light, direction, levels),
        Format::I2F14 | Format::I2F30 | Format::I16F16 => format.visit(FixedLamp { format, light, direction, levels }),
    }
}

/// Refused for its direction first, then for its first bad level.
fn lamp_of_floats<T: Float>(
    format: Format,
    light: &crate::DistantLight,
    direction: [f64; 3],
    levels: [f64; 3],
) -> Result<(), Broken> {
    let case = Case { format, inputs: inputs([direction, levels]) };
    let levels = levels.map(T::nearest);
    let answer = Lamp::<T>::new(direction.map(T::nearest), DistantSphere::of(light), levels);
    let bad = levels.into_iter().find(|level| !(level.exact() >= 0.0 && level.exact().is_finite()));
    direction_is_judged(&case, direction.map(|lane| T::nearest(lane).exact()), &answer)?;
    match answer {
        Ok(_) => case.holds("a lamp's levels are positive and finite", bad.is_none()),
        Err(SceneError::Illuminance(level)) => {
            let same = bad.is_some_and(|bad| bad == level || bad.exact().is_nan() && level.exact().is_nan());
            case.holds("a lamp is refused for its level", same)
        }
        Err(_) => Ok(()),
    }
}

struct FixedLamp {
    format: Format,
    light: crate::DistantLight,
    direction: [f64; 3],
    levels: [f64; 3],
}

impl Visitor for FixedLamp {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self { format, light, direction, levels } = self;
        let case = Case { format, inputs: inputs([direction, levels]) };
        let lanes = direction.map(T::from_f64);
        let levels = levels.map(|level| T::level(T::Scalar::nearest(level)));
        let answer = Lamp::new(lanes, DistantSphere::of(&light), levels);
        direction_is_judged(&case, lanes.map(T::to_f64), &answer)
    }
}

/// A direction is refused where its squared length is out of 0.81 to 1.21, and for nothing else.
fn direction_is_judged<T: Real>(
    case: &Case,
    direction: [f64; 3],
    answer: &Result<Lamp<T>, SceneError<T::Scalar>>,
) -> Result<(), Broken> {
    let square: f64 = direction.into_iter().map(|lane| lane * lane).sum();
    let refused = matches!(answer, Err(SceneError::Direction(_)));
    // Where the format rounds the square, either is right.
    let slack = 4.0 * case.format.step();
    let fits = square > 0.81 + slack && square < 1.21 - slack;
    let unfit = !(square >= 0.81 - slack && square <= 1.21 + slack);
    case.holds("a direction of length 1 is taken", !(fits && refused))?;
    case.holds("a direction of another length is refused", !unfit || refused)?;
    match answer {
        // Fixed point wraps from 8 on.
        Err(SceneError::Direction(held)) if square < 4.0 => {
            case.at_most("a refused length", (held.exact() - square).abs(), slack * square + slack)
        }
        _ => Ok(()),
    }
}
