//! Each function on bits gives the bits of the function on the types.

use core::fmt::Debug;

use super::layer::Raw;
use super::{lanes, word};
use crate::diffuse::{lambert, lambert_disc, relative_illuminance};
use crate::real::Scalar;
use crate::sampling::{Cone, basis, points};
use crate::shadow::soft_shadow;
use crate::specular::{cap, disc, factored, normalize, reflect};
use crate::sphere::DistantSphere;
use crate::trial::draw::Draw;
use crate::trial::property::{Broken, Case, inputs};

/// Reads a case and says what it breaks.
pub(super) fn hold<T: Raw>(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let light = DistantSphere::<T>::of(&draw.light());
    let [a, b] = [(); 2].map(|()| lanes(draw, T::FORMAT).map(T::from_f64));
    let case = Case { format: T::FORMAT, inputs: inputs([a.map(T::to_f64), b.map(T::to_f64)]) };
    directions(&case, &light, a, b)?;
    diffuse(&case, draw, &light, a, b)?;
    sampling(&case, draw, &light, a, b)
}

fn same<A: PartialEq + Debug>(case: &Case, function: &'static str, on_bits: A, on_types: A) -> Result<(), Broken> {
    case.holds(function, on_bits == on_types)
}

fn directions<T: Raw>(case: &Case, light: &DistantSphere<T>, a: [T; 3], b: [T; 3]) -> Result<(), Broken> {
    let (layer, p, q) = (T::LAYER, a.map(T::bits), b.map(T::bits));
    same(case, "raw cap", (layer.cap)(p, q, light), cap(a, b, light).map(T::bits))?;
    same(case, "raw factored", (layer.factored)(p, q, light), factored(a, b, light).map(T::bits))?;
    same(case, "raw disc", (layer.disc)(p, q, light), disc(a, b, light).map(T::bits))?;
    same(case, "raw reflect", (layer.reflect)(p, q), reflect(a, b).map(T::bits))?;
    same(case, "raw normalize", (layer.normalize)(p), normalize(a).map(T::bits))
}

fn diffuse<T: Raw>(
    case: &Case,
    draw: &mut Draw<'_>,
    light: &DistantSphere<T>,
    a: [T; 3],
    b: [T; 3],
) -> Result<(), Broken> {
    let layer = T::LAYER;
    let n_dot_l = if draw.byte().is_multiple_of(2) { T::dot(a, b) } else { T::wide_of(draw.bits()) };
    let (albedo, level) = (b[0], T::light_of(draw.bits() >> (draw.byte() % 64)));
    let of = |light: T::Light| T::level_of(light);
    let answer = (layer.lambert)(albedo.bits(), level, n_dot_l);
    same(case, "raw lambert", answer, T::light(lambert(albedo, of(level), n_dot_l)))?;
    let answer = (layer.lambert_disc)(albedo.bits(), level, n_dot_l, light);
    same(case, "raw lambert_disc", answer, T::light(lambert_disc(albedo, of(level), n_dot_l, light)))?;
    let answer = (layer.relative_illuminance)(n_dot_l, light);
    same(case, "raw relative_illuminance", answer, T::narrow(relative_illuminance(n_dot_l, light)))?;
    case.holds("relative illuminance is from 0 to 1", answer >= T::WIDE_ZERO && answer <= T::WIDE_ONE)
}

fn sampling<T: Raw>(
    case: &Case,
    draw: &mut Draw<'_>,
    light: &DistantSphere<T>,
    a: [T; 3],
    b: [T; 3],
) -> Result<(), Broken> {
    let (layer, p, q) = (T::LAYER, a.map(T::bits), b.map(T::bits));
    let cone = Cone::new(a, light);
    same(case, "raw cone", (layer.cone)(p, light), cone)?;
    same(case, "raw basis", (layer.basis)(p), basis(a).map(|v| v.map(T::bits)))?;
    same(case, "raw cone_contains", (layer.contains)(&cone, q), cone.contains(b))?;
    let point = [b[1], b[2]];
    let direction = cone.direction(point).map(T::bits);
    same(case, "raw cone_direction", (layer.direction)(&cone, point.map(T::bits)), direction)?;
    let (first, count) = (word(draw), u32::from(draw.byte() % 4));
    let last = points::<T>(first, count).last().map(|point| point.map(T::bits));
    same(case, "raw points", (layer.last_point)(first, count), last)?;
    let seen = soft_shadow(&cone, b, first, count, |direction| direction[0] > T::ZERO);
    let means = (layer.soft_shadow)(&cone, q, first, count, |direction| T::of(direction[0]) > T::ZERO);
    for (mean, exact) in means.into_iter().zip([seen.visible, seen.cosine].map(Scalar::exact)) {
        // 2 does not fit, nor does what is above it, of vectors that are not of length 1.
        let exact = (exact * f64::from(1 << 30)).min(f64::from(i32::MAX));
        case.at_most("raw soft_shadow", (f64::from(mean) - exact).abs(), 0.5)?;
    }
    case.holds("the visible share is from 0 to 1", (0..=1 << 30).contains(&means[0]))
}
