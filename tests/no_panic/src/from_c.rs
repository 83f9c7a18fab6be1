//! Every function for C.

use core::ffi::c_void;
use core::hint::black_box;
use core::ptr;

use sunglint::capi::{self, ColourQ16, MaterialQ30, PointQ14, PointQ30, VectorF32, VectorQ14, VectorQ30};
use sunglint::raw::{SUN_Q14, SUN_Q30};

use crate::image::keep;

extern "C" fn sees_q14(direction: VectorQ14, _: *mut c_void) -> bool {
    black_box(direction).x == 0
}

extern "C" fn sees_q30(direction: VectorQ30, _: *mut c_void) -> bool {
    black_box(direction).x == 0
}

pub fn call() {
    q14();
    q30();
    quantities();
    pixel();
    soft();
}

fn q14() {
    let (l, r) = black_box((VectorQ14::default(), VectorQ14::default()));
    let light = black_box(SUN_Q14.into());
    keep((capi::sunglint_cap_q14(l, r, light), capi::sunglint_factored_q14(l, r, light)));
    keep((capi::sunglint_reflect_q14(l, r), capi::sunglint_normalize_q14(l), capi::sunglint_basis_q14(l)));
    let (albedo, level, n_dot_l) = black_box((0, 0, 0));
    keep(capi::sunglint_lambert_q14(albedo, level, n_dot_l));
    keep(capi::sunglint_lambert_disc_q14(albedo, level, n_dot_l, light));
    keep((capi::sunglint_relative_illuminance_q14(n_dot_l, light), capi::sunglint_sphere_q14(black_box(0))));
    let cone = black_box(capi::sunglint_cone_q14(l, light));
    let there = black_box(Some(&cone));
    keep(capi::sunglint_cone_direction_q14(there, black_box(PointQ14::default())));
    keep((capi::sunglint_cone_contains_q14(there, r), capi::sunglint_point_q14(black_box(0))));
    let (first, count, sees) = black_box((0, 1, Some(sees_q14 as extern "C" fn(VectorQ14, *mut c_void) -> bool)));
    keep(capi::sunglint_soft_shadow_q14(there, r, first, count, sees, ptr::null_mut()));
}

fn q30() {
    let (l, r) = black_box((VectorQ30::default(), VectorQ30::default()));
    let light = black_box(SUN_Q30.into());
    keep((capi::sunglint_cap_q30(l, r, light), capi::sunglint_factored_q30(l, r, light)));
    keep((capi::sunglint_reflect_q30(l, r), capi::sunglint_normalize_q30(l), capi::sunglint_basis_q30(l)));
    let (albedo, level, n_dot_l) = black_box((0, 0, 0));
    keep(capi::sunglint_lambert_q30(albedo, level, n_dot_l));
    keep(capi::sunglint_lambert_disc_q30(albedo, level, n_dot_l, light));
    keep((capi::sunglint_relative_illuminance_q30(n_dot_l, light), capi::sunglint_sphere_q30(black_box(0))));
    let cone = black_box(capi::sunglint_cone_q30(l, light));
    let there = black_box(Some(&cone));
    keep(capi::sunglint_cone_direction_q30(there, black_box(PointQ30::default())));
    keep((capi::sunglint_cone_contains_q30(there, r), capi::sunglint_point_q30(black_box(0))));
    let (first, count, sees) = black_box((0, 1, Some(sees_q30 as extern "C" fn(VectorQ30, *mut c_void) -> bool)));
    keep(capi::sunglint_soft_shadow_q30(there, r, first, count, sees, ptr::null_mut()));
}

fn quantities() {
    let (a, b, c, cos) = black_box((0_u32, 0_u32, 0_u32, 0_i16));
    keep((capi::sunglint_irradiance_q16(a, cos, b), capi::sunglint_diffuse_radiance_q16(cos, a)));
    keep((capi::sunglint_area_radiance_q16(a, b, c), capi::sunglint_reciprocal_root_q16(a)));
    keep((capi::sunglint_relative_to_peak_q16(a), capi::sunglint_relative_to_peak_frequency_q16(a)));
    keep(capi::sunglint_tint_q16(a, black_box(ColourQ16::default())));
}

fn pixel() {
    let (n, v) = black_box((VectorQ14::default(), VectorQ14::default()));
    let (material, illuminance) = black_box((MaterialQ30::default(), ColourQ16::default()));
    let made = black_box(capi::sunglint_pixel_q14(n, black_box(SUN_Q14.into()), material, illuminance));
    let there = black_box(Some(&made.pixel));
    keep(capi::sunglint_pixel_q14_shade(there, n, v));
    keep(capi::sunglint_pixel_q14_shade_channel(there, n, v, black_box(0)));
}

fn soft() {
    let (l, r, x) = black_box((VectorF32::default(), VectorF32::default(), 0.0));
    keep((capi::sunglint_soft_cap(l, r, black_box(SUN_Q30.into())), capi::sunglint_soft_reflect(l, r)));
    keep((capi::sunglint_soft_normalize(l), capi::sunglint_soft_root(x), capi::sunglint_soft_reciprocal_root(x)));
}
