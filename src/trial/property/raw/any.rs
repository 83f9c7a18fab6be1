//! Any bits at all in every format: no panic, and numbers where numbers are promised.

use crate::blackbody::{relative_to_peak, tint};
use crate::diffuse::{illuminance, lambert, lambert_disc, relative_illuminance};
use crate::highlight::{ConeGgx, DiscGgx, Highlight, PointGgx, ShiftedConeGgx};
use crate::material::Surface;
use crate::radiometry::{area_radiance, diffuse_radiance, irradiance, projected_area};
use crate::real::{Real, Scalar};
use crate::sampling::{Cone, basis, sin_cos};
use crate::scene::{Lamp, Scene};
use crate::shadow::soft_shadow;
use crate::specular::{cap, disc, epic, factored, normalize, reflect};
use crate::sphere::{DistantSphere, UnfactoredSphere};
use crate::trial::draw::Draw;
use crate::trial::format::{Format, Visitor};
use crate::trial::property::{Broken, Case, inputs};

pub(super) struct AnyBits<'a, 'b> {
    pub(super) format: Format,
    pub(super) draw: &'a mut Draw<'b>,
}

impl Visitor for AnyBits<'_, '_> {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self { format, draw } = self;
        let light = draw.light();
        let [a, b, c] = [(); 3].map(|()| [(); 3].map(|()| T::from_f64(draw.any(format))));
        let case = Case { format, inputs: inputs([a, b, c].map(|v| v.map(T::to_f64))) };
        let sphere = DistantSphere::<T>::of(&light);
        core::hint::black_box(epic(a, b, &UnfactoredSphere::of(&light)));
        directions(&case, &sphere, a, b)?;
        sampling(&case, &sphere, a, b, c)?;
        scalars(&case, &sphere, a, b)?;
        pixels(&case, &sphere, a, b, c)
    }
}

fn finite<T: Real>(v: [T; 3]) -> bool {
    v.into_iter().all(|lane| lane.to_f64().is_finite())
}

/// Finite and not negative.
fn quantity<S: Scalar>(value: S) -> bool {
    value >= S::ZERO && value <= S::MAX
}

fn directions<T: Real>(case: &Case, light: &DistantSphere<T>, a: [T; 3], b: [T; 3]) -> Result<(), Broken> {
    core::hint::black_box((factored(a, b, light), disc(a, b, light), reflect(a, b)));
    case.holds("cap is finite", finite(cap(a, b, light)))?;
    case.holds("normalize is finite", finite(normalize(a)))?;
    case.holds("basis is finite", basis(a).into_iter().all(finite))
}

fn sampling<T: Real>(case: &Case, light: &DistantSphere<T>, a: [T; 3], b: [T; 3], c: [T; 3]) -> Result<(), Broken> {
    let cone = Cone::new(a, light);
    case.holds("a sample is finite", finite(cone.direction([c[0], c[1]])))?;
    core::hint::black_box((cone.contains(b), cone.pdf().is_ok(), cone.solid_angle(), cone.mean_cosine()));
    let circle = sin_cos(T::of_lane(c[2])).map(Scalar::exact);
    case.holds(
        "sine and cosine are within 1",
        circle.iter().all(|value| value.abs() <= 1.0 + 2.0 * case.format.step()),
    )?;
    let seen = soft_shadow(&cone, b, 3, 2, |direction| finite(direction));
    case.holds("a share is from 0 to 1", quantity(seen.visible) && seen.visible <= T::Scalar::ONE)?;
    case.holds("a mean is not negative", quantity(seen.cosine))
}

fn scalars<T: Real>(case: &Case, light: &DistantSphere<T>, a: [T; 3], b: [T; 3]) -> Result<(), Broken> {
    let cosine = T::dot(a, b);
    let [x, y, z] = [T::of_lane(a[0]), T::of_lane(a[1]), T::of_lane(b[0])];
    let relative = relative_illuminance(cosine, light);
    case.holds("relative illuminance is from 0 to 1", quantity(relative) && relative <= T::Scalar::ONE)?;
    core::hint::black_box(illuminance(x, cosine, light));
    let level = T::level(x);
    for level in [lambert(a[1], level, cosine), lambert_disc(a[1], level, cosine, light)] {
        case.holds("a level is finite", quantity(T::of_level(level)))?;
    }
    case.holds("what is lit is finite", quantity(irradiance(x, y, z)) && quantity(diffuse_radiance(x, y)))?;
    case.holds("an area is finite", quantity(projected_area(x, y)))?;
    case.holds("a lamp's radiance is finite, or refused", area_radiance(x, y, z).map_or(true, quantity))?;
    case.holds("a black body's level is finite", quantity(relative_to_peak(x)))?;
    case.holds("a tint is finite", tint(x, [y, z, y]).into_iter().all(quantity))
}

fn pixels<T: Real>(case: &Case, light: &DistantSphere<T>, n: [T; 3], v: [T; 3], l: [T; 3]) -> Result<(), Broken> {
    let share = |lane: T| {
        let value = T::of_lane(lane);
        let size = if value < T::Scalar::ZERO { T::Scalar::ZERO - value } else { value };
        if size <= T::Scalar::ONE { size } else { T::Scalar::ONE }
    };
    let alpha = share(n[0]);
    let glosses = [
        ConeGgx::new(light, alpha).shade(n, v, l),
        ShiftedConeGgx::new(light, alpha).shade(n, v, l),
        DiscGgx::new(light, alpha).shade(n, v, l),
        DiscGgx::directional(light, alpha).shade(n, v, l),
        PointGgx::none(light, alpha).shade(n, v, l),
        PointGgx::karis(light, alpha).shade(n, v, l),
        PointGgx::karis_third(light, alpha).shade(n, v, l),
        PointGgx::exact_rp(light, alpha).shade(n, v, l),
    ];
    case.holds("a highlight is finite", glosses.iter().all(|gloss| quantity(gloss.level)))?;
    let Ok(surface) = Surface::<T>::new([share(v[0]); 3], alpha, [share(v[1]); 3]) else { return Ok(()) };
    let mut scene = Scene::<T, 1>::new(&surface);
    let lamp = Lamp::new(l, *light, [T::level(T::of_lane(v[2])); 3]);
    core::hint::black_box(lamp.and_then(|lamp| scene.push(&lamp)).is_ok());
    let levels = scene.shade(n, v).map(T::of_level);
    case.holds("a pixel is finite", levels.into_iter().all(quantity))
}
