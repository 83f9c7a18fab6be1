//! Calls every integer function on inputs that the compiler cannot know. The image links only if nothing can panic;
//! `.ci/run` then looks for float symbols in it.
#![no_std]
#![no_main]

mod from_c;
mod generic;
mod image;

use core::hint::black_box;

use sunglint::fixed::types::{I2F14, I2F30, I16F16, U16F48, U20F12};
use sunglint::material::{Material, Surface};
use sunglint::raw::{self, SUN_Q14, SUN_Q30};
use sunglint::real::{Constant, Scaled};
use sunglint::scene::Channel;
use sunglint::{DistantSphere, SUN, highlight, normalization, soft};

use image::keep;

#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    loop {
        generic::call::<I2F14>(SUN_Q14);
        generic::call::<I2F30>(SUN_Q30);
        generic::call::<I16F16>(DistantSphere::<I16F16>::new(&SUN));
        generic::black_body::<Scaled>();
        scaled();
        light();
        raw_q14();
        raw_q30();
        raw_quantities();
        soft_floats();
        raw_scenes();
        from_c::call();
        image::plant();
    }
}

fn scaled() {
    let number = black_box(Scaled::from_bits(black_box(0), black_box(0)));
    keep((Scaled::to_bits(number, black_box(0)), Scaled::to_unsigned(number, black_box(0))));
    keep(Scaled::from_unsigned(black_box(0), black_box(0)));
    keep(Constant::scaled(black_box(Constant::new(0.0))));
}

fn light() {
    let (ratio, other) = black_box((I2F30::ZERO, I2F30::ZERO));
    keep((DistantSphere::<I2F14>::from_ratio_q30(ratio), DistantSphere::<I2F30>::from_ratio_q30(ratio)));
    keep((DistantSphere::<I16F16>::from_ratio_q30(ratio), normalization::versine_q30(ratio)));
    keep((normalization::solid_angle_q30(ratio), normalization::size_factor_q30(ratio)));
    keep((normalization::inverse_size_factor_q30(ratio), normalization::white_radiance_q30(ratio)));
    keep(normalization::radiance_q12(black_box(U20F12::ZERO), black_box(U16F48::ZERO)));
    keep(normalization::sun_radius_at_q16(black_box(I16F16::ZERO)));
    keep((highlight::karis_q30(ratio, other), highlight::exact_rp_q30(ratio, other)));
}

fn raw_q14() {
    let (l, r) = black_box(([0, 0, 0], [0, 0, 0]));
    let light = black_box(SUN_Q14);
    keep((raw::cap_q14(l, r, &light), raw::factored_q14(l, r, &light), raw::disc_q14(l, r, &light)));
    keep((raw::reflect_q14(l, r), raw::normalize_q14(l), raw::basis_q14(l)));
    let (albedo, level, n_dot_l) = black_box((0, 0, 0));
    keep((raw::lambert_q14(albedo, level, n_dot_l), raw::lambert_disc_q14(albedo, level, n_dot_l, &light)));
    keep((raw::relative_illuminance_q14(n_dot_l, &light), raw::sphere_q14(black_box(0))));
    let cone = black_box(raw::cone_q14(l, &light));
    keep((raw::cone_direction_q14(&cone, black_box([0; 2])), raw::cone_contains_q14(&cone, r)));
    raw::points_q14(black_box(0), black_box(1)).for_each(keep);
    keep(raw::soft_shadow_q14(&cone, r, black_box(0), black_box(1), |direction| black_box(direction) == [0; 3]));
}

fn raw_q30() {
    let (l, r) = black_box(([0, 0, 0], [0, 0, 0]));
    let light = black_box(SUN_Q30);
    keep((raw::cap_q30(l, r, &light), raw::factored_q30(l, r, &light), raw::disc_q30(l, r, &light)));
    keep((raw::reflect_q30(l, r), raw::normalize_q30(l), raw::basis_q30(l)));
    let (albedo, level, n_dot_l) = black_box((0, 0, 0));
    keep((raw::lambert_q30(albedo, level, n_dot_l), raw::lambert_disc_q30(albedo, level, n_dot_l, &light)));
    keep((raw::relative_illuminance_q30(n_dot_l, &light), raw::sphere_q30(black_box(0))));
    let cone = black_box(raw::cone_q30(l, &light));
    keep((raw::cone_direction_q30(&cone, black_box([0; 2])), raw::cone_contains_q30(&cone, r)));
    raw::points_q30(black_box(0), black_box(1)).for_each(keep);
    keep(raw::soft_shadow_q30(&cone, r, black_box(0), black_box(1), |direction| black_box(direction) == [0; 3]));
}

fn raw_quantities() {
    let (a, b, c, cos) = black_box((0_u32, 0_u32, 0_u32, 0_i16));
    keep((raw::irradiance_q16(a, cos, b), raw::diffuse_radiance_q16(cos, a), raw::area_radiance_q16(a, b, c)));
    keep((raw::relative_to_peak_q16(a), raw::relative_to_peak_frequency_q16(a), raw::tint_q16(a, [a, b, c])));
}

fn soft_floats() {
    let (l, r, x) = black_box(([0.0; 3], [0.0; 3], 0.0));
    keep((soft::cap(l, r, &black_box(SUN_Q30)), soft::reflect(l, r), soft::normalize(l)));
    keep((soft::root(x), soft::reciprocal_root(x), raw::reciprocal_root_q16(black_box(0))));
}

/// The whole pixel by the default highlight; the others are in `generic`.
fn raw_scenes() {
    const MATERIAL: Material = match Material::new([0.5; 3], 0.1, [0.04; 3]) {
        Ok(material) => material,
        Err(_) => panic!("reflectances are from 0 to 1"),
    };
    let (n, v) = black_box(([0, 0, 0], [0, 0, 0]));
    let mut scene = raw::SceneQ14::<2>::new(&Surface::of(&black_box(MATERIAL)));
    keep(raw::lamp_q14(n, &black_box(SUN_Q14), black_box([0; 3])).and_then(|lamp| scene.push(&lamp)));
    let scene = black_box(scene);
    keep((raw::shade_q14(&scene, n, v), raw::shade_channel_q14(&scene, n, v, black_box(Channel::Red))));
    let surface = Surface::of(&black_box(MATERIAL));
    if let Ok(pixel) = raw::PixelQ14::new(n, &black_box(SUN_Q14), &surface, black_box([0; 3])) {
        let pixel = black_box(pixel);
        keep((raw::PixelQ14::shade(&pixel, n, v), raw::PixelQ14::shade_channel(&pixel, n, v, black_box(Channel::Red))));
    }
    let (n, v) = black_box(([0, 0, 0], [0, 0, 0]));
    let mut scene = raw::SceneQ30::<2>::new(&Surface::of(&black_box(MATERIAL)));
    keep(raw::lamp_q30(n, &black_box(SUN_Q30), black_box([0; 3])).and_then(|lamp| scene.push(&lamp)));
    let scene = black_box(scene);
    keep((raw::shade_q30(&scene, n, v), raw::shade_channel_q30(&scene, n, v, black_box(Channel::Red))));
    keep(raw::surface_q14(black_box([0; 3]), black_box(0), black_box([0; 3])));
    keep(raw::surface_q30(black_box([0; 3]), black_box(0), black_box([0; 3])));
}
