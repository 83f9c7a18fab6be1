//! Calls every integer function on inputs that the compiler cannot know. The panic handler calls a function that does
//! not exist, so that the image links only if nothing can panic; `.ci/run` then looks for float symbols in it.
#![no_std]
#![no_main]

use core::hint::black_box;
use core::panic::PanicInfo;

use sunglint::blackbody;
use sunglint::fixed::types::{I2F30, I16F16, U16F16, U16F48, U20F12};
use sunglint::highlight::{ConeGgx, DiscGgx, Highlight, PointGgx, ShiftedConeGgx, exact_rp_q30, karis_q30};
use sunglint::material::{Material, Surface};
use sunglint::radiometry::{Patch, SphereLight, flux, patch_solid_angle, sphere_radiance};
use sunglint::raw::{self, SUN_Q14, SUN_Q30};
use sunglint::real::{Scalar, Scaled};
use sunglint::scene::Channel;
use sunglint::{DistantSphere, Real, SUN, cap, disc, factored, normalization, normalize, reflect};
use sunglint::{illuminance, lambert, lambert_disc};

unsafe extern "C" {
    safe fn there_is_a_panic() -> !;
}

#[panic_handler]
fn panicked(_: &PanicInfo) -> ! {
    there_is_a_panic()
}

#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    loop {
        q14();
        q30();
        q16();
        light();
        radiometry();
        black_body();
        sampling();
        scene();
        #[cfg(feature = "planted_panic")]
        keep(black_box([0; 3])[black_box(0_usize)]);
        #[cfg(feature = "planted_float")]
        keep(black_box(1.0_f64) + black_box(2.0_f64));
    }
}

/// Makes the compiler compute `answer`.
fn keep<T>(answer: T) {
    let _ = black_box(answer);
}

fn q14() {
    let (l, r) = black_box(([0, 0, 0], [0, 0, 0]));
    keep((raw::cap_q14(l, r, &SUN_Q14), raw::factored_q14(l, r, &SUN_Q14), raw::disc_q14(l, r, &SUN_Q14)));
    keep((raw::reflect_q14(l, r), raw::normalize_q14(l)));
    let (albedo, level, n_dot_l) = black_box((0, 0, 0));
    keep((raw::lambert_q14(albedo, level, n_dot_l), raw::lambert_disc_q14(albedo, level, n_dot_l, &SUN_Q14)));
    keep(raw::relative_illuminance_q14(n_dot_l, &SUN_Q14));
}

fn q30() {
    let (l, r) = black_box(([0, 0, 0], [0, 0, 0]));
    keep((raw::cap_q30(l, r, &SUN_Q30), raw::factored_q30(l, r, &SUN_Q30), raw::disc_q30(l, r, &SUN_Q30)));
    keep((raw::reflect_q30(l, r), raw::normalize_q30(l)));
    let (albedo, level, n_dot_l) = black_box((0, 0, 0));
    keep((raw::lambert_q30(albedo, level, n_dot_l), raw::lambert_disc_q30(albedo, level, n_dot_l, &SUN_Q30)));
    keep(raw::relative_illuminance_q30(n_dot_l, &SUN_Q30));
}

fn q16() {
    const LIGHT: DistantSphere<I16F16> = DistantSphere::<I16F16>::new(&SUN);
    let (l, r) = black_box(([I16F16::ZERO; 3], [I16F16::ZERO; 3]));
    keep((cap(l, r, &LIGHT), factored(l, r, &LIGHT), disc(l, r, &LIGHT), reflect(l, r), normalize(l)));
    let (n_dot_l, level) = black_box((0, U16F16::ZERO));
    keep((lambert(I16F16::ZERO, level, n_dot_l), lambert_disc(I16F16::ZERO, level, n_dot_l, &LIGHT)));
    keep(illuminance::<I16F16>(I16F16::of_level(level), n_dot_l, &LIGHT));
}

fn light() {
    let ratio = black_box(I2F30::ZERO);
    keep((raw::sphere_q14(ratio.to_bits()), raw::sphere_q30(ratio.to_bits())));
    keep((DistantSphere::<I16F16>::from_ratio_q30(ratio), normalization::versine_q30(ratio)));
    keep((normalization::solid_angle_q30(ratio), normalization::size_factor_q30(ratio)));
    keep((normalization::inverse_size_factor_q30(ratio), normalization::white_radiance_q30(ratio)));
    keep(normalization::radiance_q12(black_box(U20F12::ZERO), black_box(U16F48::ZERO)));
    keep(normalization::sun_radius_at_q16(black_box(I16F16::ZERO)));
    keep((karis_q30(ratio, ratio), exact_rp_q30(ratio, ratio)));
}

/// The whole pixel in both formats, by the default highlight and by the others.
fn scene() {
    const MATERIAL: Material = match Material::new([0.5; 3], 0.1, [0.04; 3]) {
        Ok(material) => material,
        Err(_) => panic!("reflectances are from 0 to 1"),
    };
    let (n, v) = black_box(([0, 0, 0], [0, 0, 0]));
    let mut scene = raw::SceneQ14::<2>::new(&Surface::of(&MATERIAL));
    keep(raw::lamp_q14(n, &SUN_Q14, black_box([0; 3])).and_then(|lamp| scene.push(&lamp)));
    keep((raw::shade_q14(&scene, n, v), raw::shade_channel_q14(&scene, n, v, Channel::Red)));
    let (n, v) = black_box(([0, 0, 0], [0, 0, 0]));
    let mut scene = raw::SceneQ30::<2>::new(&Surface::of(&MATERIAL));
    keep(raw::lamp_q30(n, &SUN_Q30, black_box([0; 3])).and_then(|lamp| scene.push(&lamp)));
    keep((raw::shade_q30(&scene, n, v), raw::shade_channel_q30(&scene, n, v, Channel::Red)));
    let number = black_box(Scaled::ZERO);
    keep(Surface::<I2F30>::new([number; 3], number, [number; 3]));
    keep((raw::surface_q14(black_box([0; 3]), 0, [0; 3]), raw::surface_q30(black_box([0; 3]), 0, [0; 3])));
    others(SUN_Q30);
    others(DistantSphere::<I16F16>::new(&SUN));
}

fn others<T: Real<Scalar = Scaled>>(sphere: DistantSphere<T>) {
    let (n, v, l) = black_box(([T::ZERO; 3], [T::ZERO; 3], [T::ZERO; 3]));
    let alpha = black_box(Scaled::ZERO);
    keep((PointGgx::none(&sphere, alpha).shade(n, v, l), PointGgx::karis(&sphere, alpha).shade(n, v, l)));
    keep((PointGgx::karis_third(&sphere, alpha).shade(n, v, l), PointGgx::exact_rp(&sphere, alpha).shade(n, v, l)));
    keep((DiscGgx::new(&sphere, alpha).shade(n, v, l), DiscGgx::directional(&sphere, alpha).shade(n, v, l)));
    keep((ConeGgx::new(&sphere, alpha).shade(n, v, l), ShiftedConeGgx::new(&sphere, alpha).shade(n, v, l)));
}

fn radiometry() {
    let (bits, cos) = black_box((0_u32, 0_i16));
    keep((raw::irradiance_q16(bits, cos, bits), raw::diffuse_radiance_q16(cos, bits)));
    keep(raw::area_radiance_q16(bits, bits, bits));
    let number = black_box(Scaled::ZERO);
    let patch = Patch { area: number, cos: number };
    keep((flux(number, patch, patch, number), patch_solid_angle(number, number, number)));
    keep(sphere_radiance(number, number));
    let light = SphereLight::of_point([number; 3], [Scaled::ONE; 3], number, [number; 3]);
    keep(light.and_then(|light| light.radiance_levels::<I16F16>()));
    keep(SphereLight::like_the_sun([number; 3], number, [number; 3]));
}

fn black_body() {
    let bits = black_box(0_u32);
    keep((raw::relative_to_peak_q16(bits), raw::relative_to_peak_frequency_q16(bits), raw::tint_q16(bits, [bits; 3])));
    let number = black_box(Scaled::ZERO);
    keep((blackbody::radiance_per_wavelength(number, number), blackbody::radiance_per_frequency(number, number)));
    keep((blackbody::peak_wavelength(number), blackbody::peak_frequency(number)));
    keep((blackbody::radiant_exitance(number), blackbody::total_radiance(number)));
}

fn sampling() {
    let l = black_box([0, 0, 0]);
    let cone = raw::cone_q14(l, &SUN_Q14);
    keep((raw::basis_q14(l), raw::cone_direction_q14(&cone, black_box([0; 2])), raw::cone_contains_q14(&cone, l)));
    keep(raw::points_q14(black_box(0), black_box(1)).last());
    keep(raw::soft_shadow_q14(&cone, l, black_box(0), black_box(1), |direction| black_box(direction) == [0; 3]));
    keep((cone.pdf(), cone.solid_angle(), cone.mean_cosine()));
    let l = black_box([0, 0, 0]);
    let cone = raw::cone_q30(l, &SUN_Q30);
    keep((raw::basis_q30(l), raw::cone_direction_q30(&cone, black_box([0; 2])), raw::cone_contains_q30(&cone, l)));
    keep(raw::points_q30(black_box(0), black_box(1)).last());
    let one = black_box(sunglint::real::Scaled::from_bits(1, 0));
    let seen = sunglint::shadow::soft_shadow(&cone, [I2F30::ZERO; 3], black_box(0), black_box(1), |_| black_box(true));
    keep((raw::soft_shadow_q30(&cone, l, black_box(0), black_box(1), |_| black_box(true)), seen.radiance(one, one)));
}
