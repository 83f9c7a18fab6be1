//! Calls every integer function on inputs that the compiler cannot know. The panic handler calls a function that does
//! not exist, so that the image links only if nothing can panic; `.ci/run` then looks for float symbols in it.
#![no_std]
#![no_main]

use core::hint::black_box;
use core::panic::PanicInfo;

use sunglint::fixed::types::{I2F30, I16F16, U16F16, U16F48, U20F12};
use sunglint::highlight::{exact_rp_q30, karis_q30};
use sunglint::raw::{self, SUN_Q14, SUN_Q30};
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
