//! Directions: the four methods, `reflect` and `normalize`.

use super::{Broken, Case, inputs};
use crate::light::DistantLight;
use crate::oracle;
use crate::real::Real;
use crate::specular::cap;
use crate::sphere::DistantSphere;
use crate::trial::draw::Draw;
use crate::trial::format::Visitor;

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let format = draw.format();
    let light = draw.light();
    let l = draw.direction();
    let r = draw.beside(l, light.angular_radius());
    let case = Case { format, inputs: inputs([l, r, [light.sin(), light.angular_radius(), 0.0]]) };
    format.visit(Directions { case, light, l, r })
}

struct Directions {
    case: Case,
    light: DistantLight,
    l: [f64; 3],
    r: [f64; 3],
}

impl Visitor for Directions {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self { case, light, l, r } = self;
        let sphere = DistantSphere::<T>::of(&light);
        let (l, r) = (l.map(T::from_f64), r.map(T::from_f64));
        let answer = cap(l, r, &sphere).map(T::to_f64);
        case.holds("cap is finite", answer.into_iter().all(f64::is_finite))?;
        let off = oracle::angle_between(l.map(T::to_f64), answer) - light.angular_radius();
        case.at_most("cap stays in the disc", off, 0.01)
    }
}
