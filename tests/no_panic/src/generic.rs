//! Every public function that is generic over the format, but those that take or give an f64: in the integer formats
//! all of it is integer arithmetic.
//!
//! Functions are named in full, by their module or type, so that `tests/no_panic.rs` finds each.

use core::hint::black_box;

use sunglint::blackbody::WideRange;
use sunglint::highlight::{ConeGgx, DiscGgx, Gloss, Highlight, PointGgx, ShiftedConeGgx};
use sunglint::material::{Material, Surface};
use sunglint::radiometry::{Patch, SphereLight};
use sunglint::real::{Constant, Scalar};
use sunglint::sampling::Cone;
use sunglint::scene::{Channel, Lamp, Scene};
use sunglint::shadow::SoftShadow;
use sunglint::{DistantSphere, Real, blackbody, diffuse, highlight, radiometry, sampling, shadow, specular};

use crate::image::keep;

const MATERIAL: Material = match Material::new([0.5; 3], 0.1, [0.04; 3]) {
    Ok(material) => material,
    Err(_) => panic!("reflectances are from 0 to 1"),
};

/// All of it in one format, under a light of any constants.
pub fn call<T: Real>(light: DistantSphere<T>) {
    real::<T>();
    scalar::<T::Scalar>();
    directions(light);
    diffuse(light);
    sampling(light);
    every_highlight(light);
    radiometry::<T>();
}

fn vector<T: Real>() -> [T; 3] {
    black_box([T::ZERO; 3])
}

fn number<S: Scalar>() -> S {
    black_box(S::ZERO)
}

fn wide<T: Real>() -> T::Wide {
    black_box(T::WIDE_ZERO)
}

fn level<T: Real>() -> T::Level {
    black_box(<T as Real>::level(number()))
}

fn real<T: Real>() {
    let (a, b): ([T; 3], [T; 3]) = (vector(), vector());
    keep((<T as Real>::add(a[0], b[0]), <T as Real>::sub(a[0], b[0]), <T as Real>::of_lane(a[0])));
    keep((<T as Real>::scalar(wide::<T>()), <T as Real>::narrow(number()), <T as Real>::lane(number())));
    keep((<T as Real>::level(number()), <T as Real>::of_level(level::<T>())));
    keep((<T as Real>::dot(a, b), <T as Real>::twice(wide::<T>()), <T as Real>::square(a)));
    keep((<T as Real>::diff(wide::<T>(), a, wide::<T>(), b), <T as Real>::magnify(a), <T as Real>::normalize(a)));
    keep(<T as Real>::within(wide::<T>(), black_box(0), wide::<T>()));
    keep(<T as Real>::rim(a, wide::<T>(), b, wide::<T>(), wide::<T>()));
    keep(<T as Real>::halfway(a, b, vector(), number(), black_box(true)));
}

fn scalar<S: Scalar>() {
    let (a, b): (S, S) = (number(), number());
    keep((a + b, a - b, a * b, a / b, a.partial_cmp(&b), a == b));
    keep((<S as Scalar>::root(a), <S as Scalar>::hypotenuse(a, b)));
    keep((<S as Scalar>::from_q31(black_box(0)), <S as Scalar>::to_q31(a)));
    keep(<S as Scalar>::constant(black_box(Constant::new(0.0))));
    keep((blackbody::relative_to_peak(a), blackbody::relative_to_peak_frequency(a), blackbody::tint(a, [a, b, b])));
    keep((highlight::smith(a, b, number()), highlight::schlick(a), sampling::sin_cos(a)));
}

fn directions<T: Real>(light: DistantSphere<T>) {
    let (l, r): ([T; 3], [T; 3]) = (vector(), vector());
    let light = black_box(light);
    keep((DistantSphere::sin(&light), DistantSphere::sin_square(&light)));
    keep((DistantSphere::cos(&light), DistantSphere::versine(&light), DistantSphere::to_array(&light)));
    keep((<T as Real>::cap(l, r, &light), specular::cap(l, r, &light)));
    keep((specular::factored(l, r, &light), specular::disc(l, r, &light)));
    keep((specular::reflect(l, r), specular::normalize(l)));
}

fn diffuse<T: Real>(light: DistantSphere<T>) {
    let light = black_box(light);
    let albedo = black_box(T::ZERO);
    keep(diffuse::lambert(albedo, level::<T>(), wide::<T>()));
    keep(diffuse::lambert_disc(albedo, level::<T>(), wide::<T>(), &light));
    keep(diffuse::relative_illuminance(wide::<T>(), &light));
    keep(diffuse::illuminance(number(), wide::<T>(), &light));
}

fn sampling<T: Real>(light: DistantSphere<T>) {
    let (l, n): ([T; 3], [T; 3]) = (vector(), vector());
    let cone = black_box(Cone::new(l, &black_box(light)));
    keep((Cone::direction(&cone, black_box([T::ZERO; 2])), Cone::contains(&cone, n), Cone::pdf(&cone)));
    keep((Cone::solid_angle(&cone), Cone::mean_cosine(&cone), sampling::basis(l)));
    sampling::points::<T>(black_box(0), black_box(1)).for_each(keep);
    let seen = black_box(shadow::soft_shadow(&cone, n, black_box(0), black_box(1), |direction| {
        keep(direction);
        black_box(true)
    }));
    keep(SoftShadow::radiance(&seen, number(), number()));
}

fn every_highlight<T: Real>(light: DistantSphere<T>) {
    pixel(light, ConeGgx::new);
    pixel(light, ShiftedConeGgx::new);
    pixel(light, DiscGgx::new);
    pixel(light, DiscGgx::directional);
    pixel(light, PointGgx::none);
    pixel(light, PointGgx::karis);
    pixel(light, PointGgx::karis_third);
    pixel(light, PointGgx::exact_rp);
    let surface = black_box(Surface::<T>::of(&black_box(MATERIAL)));
    keep(Scene::<T, 2>::new(&surface));
    keep(Surface::<T>::new([number(); 3], number(), [number(); 3]).map(|surface| Surface::alpha(&surface)));
}

/// The method alone, and a scene of it.
fn pixel<T: Real, H: Highlight<T>>(light: DistantSphere<T>, method: fn(&DistantSphere<T>, T::Scalar) -> H) {
    let (n, v, l): ([T; 3], [T; 3], [T; 3]) = (vector(), vector(), vector());
    let highlight = black_box(method(&black_box(light), number()));
    let gloss = black_box(Highlight::shade(&highlight, n, v, l));
    keep(Gloss::radiance(&gloss, number(), number()));
    let surface = black_box(Surface::<T>::of(&black_box(MATERIAL)));
    let mut scene = black_box(Scene::<T, 2, H>::with_highlight(&surface, method));
    keep(Lamp::new(l, black_box(light), [level::<T>(); 3]).and_then(|lamp| Scene::push(&mut scene, &lamp)));
    let scene = black_box(scene);
    keep((Scene::lights(&scene), Scene::shade(&scene, n, v)));
    keep(Scene::shade_channel(&scene, n, v, black_box(Channel::Red)));
}

fn radiometry<T: Real>() {
    let (a, b, c): (T::Scalar, T::Scalar, T::Scalar) = (number(), number(), number());
    keep((radiometry::area_radiance(a, b, c), radiometry::non_directional_radiance(a, b)));
    keep((radiometry::lambertian_radiance(a, b), radiometry::sphere_radiance(a, b), radiometry::point_intensity(a)));
    keep((radiometry::irradiance(a, b, c), radiometry::patch_solid_angle(a, b, c), radiometry::projected_area(a, b)));
    keep((radiometry::beam_power(a, b), radiometry::radiosity(a, b), radiometry::diffuse_radiance(a, b)));
    keep(radiometry::flux(a, Patch { area: b, cos: c }, Patch { area: number(), cos: number() }, number()));
    let triple = || black_box([T::Scalar::ZERO; 3]);
    keep(SphereLight::of_direction(triple(), a, b, triple()));
    keep(SphereLight::like_the_sun(triple(), a, triple()));
    if let Ok(light) = black_box(SphereLight::of_point(triple(), triple(), a, triple())) {
        keep((SphereLight::centre(&light), SphereLight::radius(&light), SphereLight::distance(&light)));
        keep((SphereLight::colour(&light), SphereLight::ratio(&light), SphereLight::radiance(&light)));
        keep(SphereLight::radiance_levels::<T>(&light));
    }
}

/// Planck's law in SI units.
pub fn black_body<S: WideRange>() {
    let (a, b): (S, S) = (number(), number());
    keep((blackbody::radiance_per_wavelength(a, b), blackbody::radiance_per_frequency(a, b)));
    keep((blackbody::peak_wavelength(a), blackbody::peak_frequency(a)));
    keep((blackbody::radiant_exitance(a), blackbody::total_radiance(a)));
}
