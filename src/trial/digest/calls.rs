//! The functions whose results are digested.

use fixed::types::{I2F14, I2F30, I16F16, U16F48, U20F12};

use super::hash::{Bits, Digest};
use super::source::{Digested, Source};
use crate::blackbody;
use crate::diffuse::{illuminance, lambert, lambert_disc, relative_illuminance};
use crate::highlight::{ConeGgx, DiscGgx, Highlight, PointGgx, ShiftedConeGgx, exact_rp_q30, karis_q30};
use crate::material::Surface;
use crate::normalization;
use crate::radiometry::{self, Patch, SphereLight};
use crate::raw::PixelQ14;
use crate::real::{Scalar, Scaled};
use crate::sampling::{Cone, basis, points, sin_cos};
use crate::scene::{Lamp, Scene};
use crate::shadow::soft_shadow;
use crate::specular::{cap, disc, epic, factored, normalize, reflect};
use crate::sphere::{DistantSphere, UnfactoredSphere};

pub(super) fn directions<T: Digested>(source: &mut Source, digest: &mut Digest) {
    let light = source.light::<T>();
    let l = source.direction::<T>();
    let r = source.beside(l);
    [cap(l, r, &light), factored(l, r, &light), disc(l, r, &light)].add_to(digest);
    [reflect(l, r), normalize(l), normalize(r)].add_to(digest);
    // Of distance 1, since other lengths are rounded in f64.
    let unfactored = UnfactoredSphere { radius: light.sin, radius_square: light.sin_square, distance: T::WIDE_ONE };
    epic(l, r, &unfactored).add_to(digest);
    [light.sin(), light.sin_square(), light.cos(), light.versine()].add_to(digest);
}

pub(super) fn diffuse<T: Digested>(source: &mut Source, digest: &mut Digest) {
    let light = source.light::<T>();
    let n = source.direction::<T>();
    let n_dot_l = T::dot(n, source.beside(n));
    let albedo = T::lane(source.part());
    let level = T::level(source.quantity());
    [lambert(albedo, level, n_dot_l), lambert_disc(albedo, level, n_dot_l, &light)].add_to(digest);
    [relative_illuminance(n_dot_l, &light), illuminance(source.quantity(), n_dot_l, &light)].add_to(digest);
}

pub(super) fn sampling<T: Digested>(source: &mut Source, digest: &mut Digest) {
    let light = source.light::<T>();
    let l = source.direction::<T>();
    let cone = Cone::new(l, &light);
    basis(l).add_to(digest);
    sin_cos(source.part::<T::Scalar>()).add_to(digest);
    [cone.solid_angle(), cone.mean_cosine()].add_to(digest);
    cone.pdf().add_to(digest);
    cone.contains(source.beside(l)).add_to(digest);
    cone.direction([T::raw(source.bits()), T::lane(source.part())]).add_to(digest);
    let n = source.direction::<T>();
    points::<T>(source.bits() as u32, 1).for_each(|point| point.add_to(digest));
    let seen = soft_shadow(&cone, n, source.bits() as u32, 4, |direction| direction[0] > T::ZERO);
    [seen.visible, seen.cosine, seen.radiance(source.part(), source.quantity())].add_to(digest);
}

/// All methods at one pixel.
pub(super) fn highlights<T: Digested>(source: &mut Source, digest: &mut Digest) {
    let light = source.light::<T>();
    let alpha = source.part();
    let n = source.direction::<T>();
    let l = source.beside(n);
    let v = if source.below(2) == 0 { reflect(n, source.beside(l)) } else { source.beside(n) };
    let mut shade = |highlight: &dyn Fn() -> crate::highlight::Gloss<T::Scalar>| {
        let gloss = highlight();
        [gloss.level, gloss.gain, gloss.fresnel, gloss.radiance(T::Scalar::ONE, T::Scalar::ZERO)].add_to(digest);
    };
    shade(&|| ConeGgx::new(&light, alpha).shade(n, v, l));
    shade(&|| ShiftedConeGgx::new(&light, alpha).shade(n, v, l));
    shade(&|| DiscGgx::new(&light, alpha).shade(n, v, l));
    shade(&|| DiscGgx::directional(&light, alpha).shade(n, v, l));
    shade(&|| PointGgx::none(&light, alpha).shade(n, v, l));
    shade(&|| PointGgx::karis(&light, alpha).shade(n, v, l));
    shade(&|| PointGgx::karis_third(&light, alpha).shade(n, v, l));
    shade(&|| PointGgx::exact_rp(&light, alpha).shade(n, v, l));
}

pub(super) fn scene<T: Digested>(source: &mut Source, digest: &mut Digest) {
    let channels = |source: &mut Source| [(); 3].map(|()| source.part());
    let Ok(surface) = Surface::<T>::new(channels(source), source.part(), channels(source)) else {
        return digest.add(0);
    };
    let mut scene = Scene::<T, 2>::new(&surface);
    let n = source.direction::<T>();
    for _ in 0..2 {
        let level = [(); 3].map(|()| T::level(source.quantity()));
        let lamp = Lamp::new(source.beside(n), source.light(), level);
        digest.add(lamp.and_then(|lamp| scene.push(&lamp)).is_ok().into());
    }
    scene.shade(n, source.beside(n)).add_to(digest);
}

pub(super) fn radiometry<T: Digested>(source: &mut Source, digest: &mut Digest) {
    let [a, b, c]: [T::Scalar; 3] = [(); 3].map(|()| source.quantity());
    let cos = source.part();
    radiometry::area_radiance(a, b, c).add_to(digest);
    radiometry::sphere_radiance(a, b).add_to(digest);
    radiometry::point_intensity(a).add_to(digest);
    [radiometry::irradiance(a, cos, b), radiometry::diffuse_radiance(cos, a)].add_to(digest);
    let patch = |area| Patch { area, cos };
    [radiometry::flux(a, patch(b), patch(c), source.quantity()), radiometry::radiosity(cos, a)].add_to(digest);
    let light = SphereLight::of_point([a, b, c], [(); 3].map(|()| source.quantity()), source.part(), [cos; 3]);
    light.and_then(|light| light.radiance()).add_to(digest);
    light.and_then(|light| light.radiance_levels::<T>()).add_to(digest);
    let light = SphereLight::like_the_sun([a, b, c], source.quantity(), [cos; 3]);
    light.map(|light| light.centre()).add_to(digest);
    light.map(|light| light.ratio()).add_to(digest);
}

pub(super) fn black_body<S: Scalar + Bits>(source: &mut Source, digest: &mut Digest) {
    let ratio = source.quantity::<S>();
    [blackbody::relative_to_peak(ratio), blackbody::relative_to_peak_frequency(ratio)].add_to(digest);
    blackbody::tint(source.quantity::<S>(), [(); 3].map(|()| source.part())).add_to(digest);
}

pub(super) fn normalization(source: &mut Source, digest: &mut Digest) {
    let [ratio, alpha] = [(); 2].map(|()| I2F30::from_bits(source.share() as i32));
    [normalization::versine_q30(ratio), normalization::solid_angle_q30(ratio)].add_to(digest);
    normalization::size_factor_q30(ratio).add_to(digest);
    [normalization::inverse_size_factor_q30(ratio), normalization::white_radiance_q30(ratio)].add_to(digest);
    let [intensity, divisor] = [(); 2].map(|()| source.bits() >> source.below(64));
    let intensity = U20F12::from_bits(intensity as u32);
    normalization::radiance_q12(intensity, U16F48::from_bits(divisor)).add_to(digest);
    normalization::sun_radius_at_q16(I16F16::from_bits(source.bits() as i32)).add_to(digest);
    [karis_q30(alpha, ratio), exact_rp_q30(alpha, ratio)].add_to(digest);
    DistantSphere::<I2F30>::from_ratio_q30(ratio).map(|light| light.versine()).add_to(digest);
}

/// Numbers of wide range from any bits, their arithmetic and the way back; and Planck's law.
pub(super) fn scaled(source: &mut Source, digest: &mut Digest) {
    let mut any = || Scaled::from_bits(source.bits() as i64 >> source.below(64), source.below(256) as i32 - 128);
    let [a, b] = [any(), any()];
    [a, b, a + b, a - b, a * b, a / b, a.root(), Scaled::hypotenuse(a, b)].add_to(digest);
    digest.add((a > b).into());
    let fraction = source.below(64);
    a.to_bits(fraction).add_to(digest);
    [a.to_unsigned(fraction), a.to_q31().into()].add_to(digest);
    let bits = source.bits();
    Scaled::from_unsigned(bits, -(fraction as i32)).add_to(digest);
    let [metres, kelvins] = [(); 2].map(|()| Scaled::from_bits(source.share().into(), -(source.below(64) as i32)));
    [blackbody::radiance_per_wavelength(metres, kelvins), blackbody::radiance_per_frequency(kelvins, metres)]
        .add_to(digest);
    [blackbody::peak_wavelength(kelvins), blackbody::peak_frequency(kelvins)].add_to(digest);
    [blackbody::radiant_exitance(kelvins), blackbody::total_radiance(kelvins)].add_to(digest);
}

/// Whole pixels by the kernel for Q14: about the mirror ray, and any.
pub(super) fn pixel(source: &mut Source, digest: &mut Digest) {
    let channels = |source: &mut Source| [(); 3].map(|()| source.part());
    let Ok(surface) = Surface::<I2F14>::new(channels(source), source.part(), channels(source)) else {
        return digest.add(0);
    };
    let light = source.light::<I2F14>();
    let n = source.direction::<I2F14>();
    let l = source.beside(n);
    let v = if source.below(2) == 0 { reflect(n, source.beside(l)) } else { source.beside(n) };
    let [n, v, l] = [n, v, l].map(|direction| direction.map(I2F14::to_bits));
    let levels = [(); 3].map(|()| (source.bits() >> 32) as u32 >> source.below(32));
    match PixelQ14::new(l, &light, &surface, levels) {
        Ok(pixel) => pixel.shade(n, v).into_iter().for_each(|level| digest.add(level.into())),
        Err(_) => digest.add(1),
    }
}
