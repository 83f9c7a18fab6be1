//! Directions: the four methods, `reflect` and `normalize`.

mod accuracy;
mod any_bits;
mod neighbours;
mod symmetry;

use core::f64::consts::FRAC_PI_2;

use super::{Broken, Case, inputs};
use crate::light::DistantLight;
use crate::oracle;
use crate::real::Real;
use crate::trial::aim::{Aim, Candidate, DISCS, LENGTHS, Lit, SPHERES};
use crate::trial::budget;
use crate::trial::draw::Draw;
use crate::trial::format::Visitor;
use crate::trial::input::Pair;
use crate::trial::method::Method;

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let format = draw.format();
    let light = draw.light();
    let l = draw.direction();
    let theta = light.angular_radius();
    let r = draw.beside(l, theta);
    let other = draw.beside(l, theta);
    let choice = draw.byte();
    let [span] = LENGTHS[format as usize];
    let length = draw.logarithmic(span.from, span.to);
    let raw = [(); 6].map(|()| draw.any(format));
    let case = Case { format, inputs: inputs([l, r, [light.sin(), theta, 0.0]]) };
    format.visit(Directions { case, light, l, r, other, choice, length, raw })
}

struct Directions {
    case: Case,
    light: DistantLight,
    l: [f64; 3],
    r: [f64; 3],
    /// A second mirror direction.
    other: [f64; 3],
    /// Which lanes are negated, exchanged and moved.
    choice: u8,
    /// Of the vector that is normalised.
    length: f64,
    raw: [f64; 6],
}

impl Visitor for Directions {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let [l, r, other] = [self.l, self.r, self.other].map(|v| v.map(|lane| T::from_f64(lane).to_f64()));
        let case = Case { inputs: inputs([l, r, [self.light.sin(), self.light.angular_radius(), 0.0]]), ..self.case };
        let given = Given { case, lit: Lit::<T>::of(self.light), pair: Pair { l, r } };
        accuracy::hold(&given)?;
        accuracy::normalized(&given, self.length)?;
        neighbours::hold(&given, other, self.choice)?;
        symmetry::hold(&given, self.choice)?;
        any_bits::hold(&given, self.raw)
    }
}

/// A case in the format `T`.
#[derive(Clone, Copy)]
struct Given<T: Real> {
    case: Case,
    lit: Lit<T>,
    /// As rounded into the format.
    pair: Pair,
}

impl<T: Real> Given<T> {
    fn theta(&self) -> f64 {
        self.lit.light.angular_radius()
    }

    /// The same with another mirror direction.
    fn with(&self, r: [f64; 3]) -> Self {
        Self { pair: Pair { r, ..self.pair }, ..*self }
    }

    fn answer(&self, method: Method) -> [f64; 3] {
        let (l, r) = (self.pair.l.map(T::from_f64), self.pair.r.map(T::from_f64));
        method.direction(l, r, &self.lit.constants).map(T::to_f64)
    }

    /// Between the light's centre and a direction.
    fn turn(&self, direction: [f64; 3]) -> f64 {
        oracle::angle_between(self.pair.l, direction)
    }

    fn budget(&self, method: Method) -> Option<f64> {
        budget::of_any_light(method, self.case.format, self.theta())
    }

    /// The greatest difference of two answers to one question.
    fn twice(&self, method: Method) -> f64 {
        2.0 * self.budget(method).unwrap_or(f64::INFINITY)
    }

    fn defined(&self, method: Method) -> bool {
        method.is_defined(self.pair.l, self.pair.r, &self.lit.light, self.case.format.step())
    }

    fn error(&self, aim: Aim, size: f64) -> Option<f64> {
        aim.error(self.case.format, &self.lit, &Candidate { size, pair: self.pair })
    }

    /// The methods that are meant for the light, of which `epic` is `factored` where the distance is 1.
    fn methods(&self) -> &'static [Method] {
        if self.theta() <= DISCS[SPHERES - 1].to {
            &[Method::Factored, Method::Disc, Method::Cap]
        } else {
            &[Method::Disc, Method::Cap]
        }
    }

    fn is_sphere(&self) -> bool {
        self.theta() <= FRAC_PI_2
    }
}
