//! Sampling: directions of the disc, the basis, the density, the hit test and soft shadows.

mod errors;
mod shadows;

use core::f64::consts::PI;

use super::figures::{self, Figures};
use super::{Broken, Case, inputs};
use crate::light::DistantLight;
use crate::oracle;
use crate::real::{Real, Scalar};
use crate::sampling::{Cone, basis, points, sin_cos};
use crate::sphere::DistantSphere;
use crate::trial::draw::Draw;
use crate::trial::format::{Format, Visitor};
use crate::trial::sampling::below_one;

pub use errors::BUDGETS;

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let sample = Sample::new(draw);
    let case = sample.case();
    figures::within(&case, &BUDGETS, sample.format.visit(errors::Errors(sample)))?;
    sample.format.visit(Laws(sample))?;
    sample.format.visit(shadows::Shadows { case, sample })
}

/// The errors of a case that are budgeted, for the search.
pub fn errors(draw: &mut Draw<'_>) -> (Format, Figures) {
    let sample = Sample::new(draw);
    (sample.format, sample.format.visit(errors::Errors(sample)))
}

/// A cone, points of the square and a direction beside the rim.
#[derive(Clone, Copy, Debug)]
struct Sample {
    format: Format,
    /// Whether vectors and points are any bits, so that answers only have to be finite.
    raw: bool,
    light: DistantLight,
    l: [f64; 3],
    point: [f64; 2],
    /// Another part of the versine.
    z: f64,
    direction: [f64; 3],
    first: u32,
    count: u32,
}

impl Sample {
    fn new(draw: &mut Draw<'_>) -> Self {
        let format = draw.format();
        let raw = draw.byte().is_multiple_of(8);
        let light = draw.light();
        if raw {
            let mut any = || draw.any(format);
            let (l, direction) = ([any(), any(), any()], [any(), any(), any()]);
            let (point, z) = ([any(), any()], any());
            return Self { format, raw, light, l, point, z, direction, first: draw.bits() as u32, count: 4 };
        }
        let l = draw.direction();
        let point = [part(draw), turn(draw)];
        let z = part(draw);
        let direction = draw.beside(l, light.angular_radius());
        let (first, count) = (draw.bits() as u32, u32::from(draw.byte() % 12));
        Self { format, raw, light, l, point, z, direction, first, count }
    }

    fn case(&self) -> Case {
        let mut inputs = inputs([self.l, self.direction, [self.light.sin(), self.light.angular_radius(), self.z]]);
        inputs[9] = self.point[0];
        Case { format: self.format, inputs }
    }

    fn cone<T: Real>(&self) -> Cone<T> {
        Cone::new(self.l.map(T::from_f64), &DistantSphere::of(&self.light))
    }
}

/// A part of the versine: anything, the ends, and beside them.
fn part(draw: &mut Draw<'_>) -> f64 {
    match draw.byte() % 8 {
        0 => draw.one_of([0.0, 1.0, 0.5, 1.0_f64.next_down()]),
        1 => draw.logarithmic(1e-12, 1.0),
        2 => 1.0 - draw.logarithmic(1e-9, 1.0),
        _ => draw.fraction(),
    }
}

/// A turn: anything, the octants where the series are folded, and beside those.
fn turn(draw: &mut Draw<'_>) -> f64 {
    let octant = f64::from(draw.byte() % 16) / 8.0;
    match octant {
        0.0..=1.0 => {
            let kind = draw.byte() % 4;
            let off = draw.logarithmic(1e-9, 1e-2);
            (octant + [0.0, off, -off, off * 1e-4][usize::from(kind)]).clamp(0.0, 1.0)
        }
        _ => draw.fraction(),
    }
}

/// What holds exactly, or follows from the budgets.
struct Laws(Sample);

impl Visitor for Laws {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self(sample) = self;
        let case = sample.case();
        let cone = sample.cone::<T>();
        let point = sample.point.map(T::from_f64);
        let direction = cone.direction(point);
        case.holds("directions are finite", finite(direction))?;
        case.holds("the basis is finite", basis(sample.l.map(T::from_f64)).into_iter().all(finite))?;
        case.holds("sines and cosines are finite", turned::<T>(point[1]).into_iter().all(f64::is_finite))?;
        let again = sample.cone::<T>().direction(point);
        case.holds("the same input has the same direction", direction == again)?;
        let beside = sample.direction.map(T::from_f64);
        case.holds("what is not finite is outside", finite(beside) || !cone.contains(beside))?;
        let (solid_angle, mean) = (cone.solid_angle().exact(), cone.mean_cosine().exact());
        case.holds("the solid angle is from 0 to the full sphere's", (0.0..=4.01 * PI).contains(&solid_angle))?;
        case.holds("the mean cosine is from 0 to 1", (0.0..=1.001).contains(&mean))?;
        for [x, y] in points::<T>(sample.first, sample.count) {
            let inside = |lane: T| (0.0..1.0).contains(&lane.to_f64());
            case.holds("points are in the square", inside(x) && inside(y))?;
        }
        if sample.raw { Ok(()) } else { unit::<T>(&sample, &case, &cone) }
    }
}

/// The laws of directions that are of unit length.
fn unit<T: Real>(sample: &Sample, case: &Case, cone: &Cone<T>) -> Result<(), Broken> {
    let l = sample.l.map(T::from_f64);
    let [z, turn] = sample.point.map(T::from_f64);
    let direction = cone.direction([z, turn]);
    case.holds("samples are inside", cone.contains(direction) && cone.contains(l))?;
    case.holds("no part of the versine is l itself", cone.direction([T::ZERO, turn]) == l)?;
    case.holds("the basis is right-handed", handed(basis(l), l) > 0.99)?;
    let budget = errors::direction_budget(sample.format, &sample.light);
    let angle = |a: [T; 3]| oracle::angle_between(l.map(T::to_f64), a.map(T::to_f64));
    let other = T::from_f64(sample.z);
    let (near, far) = if other < z { (other, z) } else { (z, other) };
    let falls = angle(cone.direction([near, turn])) - angle(cone.direction([far, turn]));
    case.at_most("the angle does not fall as the part rises", falls, 2.0 * budget)?;
    opposite(sample, case, cone)?;
    around(sample, case, cone)
}

/// Half a turn on is the mirror image, and the sine and the cosine of it are the negatives to the last bit.
fn opposite<T: Real>(sample: &Sample, case: &Case, cone: &Cone<T>) -> Result<(), Broken> {
    let z = T::from_f64(sample.point[0]);
    // Made from the second half, whose step is the coarser, so that both are exact.
    let late = T::from_f64(0.5 + sample.point[1] / 2.0);
    let early = T::from_f64(late.to_f64() - 0.5);
    let [a, b] = [turned::<T>(early), turned::<T>(late)];
    let full = late.to_f64() >= 1.0;
    case.holds("half a turn on is the negative", full || (a[0] == -b[0] && a[1] == -b[1]))?;
    let l = sample.l.map(T::from_f64).map(T::to_f64);
    let [a, b] = [early, late].map(|turn| cone.direction([z, turn]).map(T::to_f64));
    let square = dot(l, l);
    let mirrored = [0, 1, 2].map(|i| 2.0 * dot(a, l) / square * l[i] - a[i]);
    let off = oracle::angle_between(b, mirrored);
    // Both have their error, and the vectors of f64 that of the mirror image here.
    let budget = errors::direction_budget(sample.format, &sample.light);
    case.at_most("half a turn on is the mirror image", off, 2.0 * budget + 1e-15)
}

/// A step on, and from the last turn to the first, the direction goes no further than it should.
fn around<T: Real>(sample: &Sample, case: &Case, cone: &Cone<T>) -> Result<(), Broken> {
    let [z, turn] = sample.point.map(T::from_f64);
    let last = below_one::<T>();
    let next = T::from_f64((turn.to_f64() + 2.0 * sample.format.step()).min(1.0));
    let budget = errors::direction_budget(sample.format, &sample.light);
    for [from, to, step] in [[turn.to_f64(), next.to_f64(), next.to_f64() - turn.to_f64()], [last, 0.0, 1.0 - last]] {
        let [a, b] = [from, to].map(|turn| cone.direction([z, T::from_f64(turn)]).map(T::to_f64));
        let apart = oracle::angle_between(a, b) - 2.0 * PI * step;
        case.at_most("turns are continuous", apart, 2.0 * budget)?;
    }
    Ok(())
}

fn turned<T: Real>(turn: T) -> [f64; 2] {
    sin_cos(T::of_lane(turn)).map(Scalar::exact)
}

fn finite<T: Real>(v: [T; 3]) -> bool {
    v.into_iter().all(|lane| lane.to_f64().is_finite())
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Volume of the frame: 1 if it is right-handed.
fn handed<T: Real>([t, b]: [[T; 3]; 2], l: [T; 3]) -> f64 {
    let [t, b, l] = [t, b, l].map(|v| v.map(T::to_f64));
    dot([t[1] * b[2] - t[2] * b[1], t[2] * b[0] - t[0] * b[2], t[0] * b[1] - t[1] * b[0]], l)
}
