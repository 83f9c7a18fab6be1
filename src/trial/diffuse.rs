//! Diffuse light in a format against the oracle, with its error budgets.

use core::f64::consts::PI;

use oorandom::Rand64;

use super::format::Format;
use super::found::Found;
use super::input;
use crate::diffuse::{illuminance, lambert, relative_illuminance};
use crate::light::DistantLight;
use crate::oracle::diffuse as oracle;
use crate::real::{Real, Scalar};
use crate::sphere::DistantSphere;

/// Budgets for f64, f32, micromath, f16, I2F14, I2F30 and I16F16: 1.12 times the worst of 100 000 inputs from each of
/// the seeds 1 to 3, rounded up to two digits; an ignored test of `tests/diffuse.rs` prints them again.
pub type Maxima = [f64; 7];

/// Budgets of [`lambert_error`].
pub const LAMBERT: Maxima = [4.5, 3.2, 3.2, 3.0, 0.57, 2.5, 0.57];

/// Budgets of [`relative_illuminance_error`] under the lights of [`BUDGETED`](super::lights::BUDGETED).
pub const RELATIVE: [Maxima; 6] = [
    [2.8e-7, 9.3e-7, 1.3e-5, 4.7e-3, 2.9e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 7.1e-7, 1.3e-5, 1.3e-3, 2.8e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 9.3e-7, 1.3e-5, 5.5e-3, 2.9e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 8.1e-7, 1.7e-5, 3.6e-3, 2.9e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 8.5e-7, 1.6e-5, 5.0e-3, 2.9e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 8.7e-7, 1.6e-5, 2.6e-3, 2.9e-7, 2.9e-7, 2.9e-7],
];

/// Budgets of [`illuminance_error`] under the same lights.
pub const ABSOLUTE: [Maxima; 6] = [
    [2.8e-7, 9.3e-7, 1.3e-5, 1.5e-3, 2.9e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 7.3e-7, 1.3e-5, 5.5e-4, 2.8e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 9.7e-7, 1.3e-5, 5.1e-3, 2.9e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 8.3e-7, 1.7e-5, 4.0e-3, 2.9e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 8.9e-7, 1.6e-5, 5.8e-3, 2.9e-7, 2.9e-7, 2.9e-7],
    [2.8e-7, 8.6e-7, 1.6e-5, 2.3e-3, 2.9e-7, 2.9e-7, 2.9e-7],
];

/// Budgets of [`vectors_error`] under the same lights.
pub const VECTORS: [Maxima; 6] = [
    [1.5e-8, 1.4e-4, 1.4e-4, 0.88, 0.11, 1.6e-6, 0.024],
    [2.7e-8, 5.2e-3, 5.2e-3, 44.0, 4.5, 7.2e-5, 1.2],
    [1.5e-8, 1.1e-5, 1.6e-5, 0.099, 9.2e-3, 1.4e-7, 2.3e-3],
    [2.0e-8, 1.5e-6, 1.6e-5, 0.013, 9.0e-4, 2.7e-8, 2.4e-4],
    [3.8e-8, 9.5e-7, 2.2e-5, 6.6e-3, 5.8e-4, 4.6e-8, 1.5e-4],
    [6.6e-7, 1.9e-6, 3.6e-5, 6.4e-3, 2.7e-4, 6.6e-7, 6.6e-5],
];

/// Error of [`lambert`] in units of the last place: the format's, and in fixed point the level's, or that of 31
/// bits where it is coarser.
pub fn lambert_error<T: Real>(seed: u64, count: usize) -> Found {
    let mut source = Rand64::new(u128::from(seed));
    let mut found = Found::new();
    for index in 0..count {
        let albedo = T::from_f64(source.rand_float());
        let level = T::Scalar::nearest(logarithmic(&mut source, 0.01, 1000.0));
        let level = T::level(level);
        let cosine = match index % 2 {
            0 => source.rand_float(),
            _ => logarithmic(&mut source, 1e-4, 1.0),
        };
        let n_dot_l = T::wide(if index % 8 == 0 { -cosine } else { cosine });
        let [level_value, cosine] = [T::of_level(level), T::scalar(n_dot_l)].map(T::Scalar::exact);
        let truth = albedo.to_f64() / PI * level_value * cosine.max(0.0);
        let answer = T::of_level(lambert(albedo, level, n_dot_l)).exact();
        let error = (answer - truth) / level_unit::<T>(truth);
        found.add_signed(error, [albedo.to_f64(), level_value, cosine, 0.0, 0.0, 0.0]);
    }
    found
}

/// Relative error of [`relative_illuminance`], at the cosine and the sine as they are in the format (in I2F30 and
/// I16F16 their 31 leading bits).
///
/// In formats that cannot hold 1e-30, answers below the least normal number of f16, 6.1e-5, count as that one.
pub fn relative_illuminance_error<T: Real>(light: &DistantLight, seed: u64, count: usize) -> Found {
    let sines = sines(seed, count, light.sin());
    relative_illuminance_error_at::<T>(light, sines.map(T::wide))
}

/// The same for given cosines `n.l`.
pub fn relative_illuminance_error_at<T: Real>(light: &DistantLight, cosines: impl Iterator<Item = T::Wide>) -> Found {
    let sphere = DistantSphere::<T>::of(light);
    over(
        light,
        &sphere,
        cosines,
        |n_dot_l| relative_illuminance(n_dot_l, &sphere).exact(),
        |sine, x| oracle::relative_illuminance(sine, x, light.cos()),
    )
}

/// Relative error of [`illuminance`] for the radiance 1; otherwise as [`relative_illuminance_error`].
pub fn illuminance_error<T: Real>(light: &DistantLight, seed: u64, count: usize) -> Found {
    let sphere = DistantSphere::<T>::of(light);
    let cosines = sines(seed, count, light.sin()).map(T::wide);
    over(
        light,
        &sphere,
        cosines,
        |n_dot_l| illuminance(T::Scalar::ONE, n_dot_l, &sphere).exact(),
        |sine, x| oracle::illuminance(sine, x, light.cos()),
    )
}

/// Absolute error of the relative illuminance near the horizon that rounding the vectors and the light into the format
/// makes, in units of what a flat disc gives when its centre sets, `2 x / (3 pi)`: centres up to two radii from the
/// horizon.
pub fn vectors_error<T: Real>(light: &DistantLight, seed: u64, count: usize) -> Found {
    let sphere = DistantSphere::<T>::of(light);
    let unit = 2.0 * light.sin() / (3.0 * PI);
    let mut source = Rand64::new(u128::from(seed));
    let mut found = Found::new();
    for pair in input::random(seed, count, 0.1) {
        let sine = (light.sin() * (4.0 * source.rand_float() - 2.0)).clamp(-1.0, 1.0);
        let Some(l) = at_elevation(pair.l, pair.r, sine) else { continue };
        let n_dot_l = T::dot(pair.l.map(T::from_f64), l.map(T::from_f64));
        let answer = relative_illuminance(n_dot_l, &sphere).exact();
        let truth = oracle::relative_illuminance(sine, light.sin(), light.cos());
        found.add_signed((answer - truth) / unit, [sine, 0.0, 0.0, 0.0, 0.0, 0.0]);
    }
    found
}

/// Sines of elevations for a disc of sine `x`: all, those at which the plane cuts the disc, and the last and the first
/// slivers down to `1e-7` of the radius.
fn sines(seed: u64, count: usize, x: f64) -> impl Iterator<Item = f64> {
    let mut source = Rand64::new(u128::from(seed));
    let random = (0..count).map(move |index| match index % 4 {
        0 => 2.0 * source.rand_float() - 1.0,
        1 => x * (2.0 * source.rand_float() - 1.0),
        2 => x * (logarithmic(&mut source, 1e-7, 1.0) - 1.0),
        _ => x * (1.0 - logarithmic(&mut source, 1e-7, 1.0)),
    });
    random.chain([-1.0, -x, 0.0, x, 1.0])
}

/// `kernel` against `truth`, which takes cosine and sine as the format holds them.
fn over<T: Real>(
    light: &DistantLight,
    sphere: &DistantSphere<T>,
    cosines: impl Iterator<Item = T::Wide>,
    kernel: impl Fn(T::Wide) -> f64,
    truth: impl Fn(f64, f64) -> f64,
) -> Found {
    let x = T::scalar(sphere.sin()).exact();
    let least = if narrow::<T>() { Format::F16.ulp(0.0) * 1024.0 } else { f64::MIN_POSITIVE };
    let mut found = Found::new();
    for n_dot_l in cosines {
        let cosine = T::scalar(n_dot_l).exact();
        let truth = truth(cosine, x);
        found.add_signed((kernel(n_dot_l) - truth) / truth.max(least), [cosine, x, light.cos(), 0.0, 0.0, 0.0]);
    }
    found
}

/// Whether the format's exponent has so few bits that small answers are subnormal.
fn narrow<T: Real>() -> bool {
    T::Scalar::nearest(1e-30).exact() == 0.0
}

/// The direction at the elevation of that sine over the plane whose normal is `n`, on the side of `aside`.
fn at_elevation(n: [f64; 3], aside: [f64; 3], sine: f64) -> Option<[f64; 3]> {
    let along = n[0] * aside[0] + n[1] * aside[1] + n[2] * aside[2];
    let flat = [0, 1, 2].map(|i| aside[i] - along * n[i]);
    let length = libm::sqrt(flat[0] * flat[0] + flat[1] * flat[1] + flat[2] * flat[2]);
    let across = libm::sqrt((1.0 - sine) * (1.0 + sine));
    (length > 1e-3).then(|| [0, 1, 2].map(|i| sine * n[i] + across * flat[i] / length))
}

/// A unit of the last place of the level at `value`; in fixed point of 31 bits where that is coarser.
fn level_unit<T: Real>(value: f64) -> f64 {
    let format = Format::named(T::NAME);
    let mantissa = libm::scalbn(1.0, libm::ilogb(value.max(1e-300)) - 30);
    match format {
        Some(Format::I2F14 | Format::I16F16) => mantissa.max(libm::scalbn(1.0, -16)),
        Some(Format::I2F30) => mantissa.max(libm::scalbn(1.0, -32)),
        Some(format) => format.ulp(value.max(1e-300)),
        None => Format::F16.ulp(value.max(1e-300)),
    }
}

fn logarithmic(source: &mut Rand64, from: f64, to: f64) -> f64 {
    libm::exp(libm::log(from) + libm::log(to / from) * source.rand_float())
}
