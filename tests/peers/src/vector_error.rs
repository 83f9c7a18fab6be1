//! Worst errors of f32 functions, sunglint's and a peer's, against f64 at the same rounded inputs.

use core::f64::consts::PI;

use glam::Vec3;
use sunglint::SUN;
use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::oracle::{angle_between, diffuse};
use sunglint::trial::gloss::{self, ALBEDO, Case, F0};
use sunglint::trial::{Found, Method, Shading, input};

type Vector = [f32; 3];

/// A function of one direction.
pub type OfOne<'a> = &'a dyn Fn(Vector) -> Vector;

/// A function of two directions.
pub type OfTwo<'a> = &'a dyn Fn(Vector, Vector) -> Vector;

/// Random inputs of each.
const SAMPLES: usize = 200_000;

/// How near to the light's opposite, in radians, no formula has one answer.
const OPPOSITE: f64 = 1e-6;

/// Radians between the answers and their inputs.
pub fn normalize<const N: usize>(functions: [OfOne; N]) -> [f64; N] {
    functions.map(|function| {
        let mut found = Found::<3>::new();
        for pair in input::random(1, SAMPLES, 0.0) {
            // No unit vector, which would hardly be rounded.
            let v = rounded(pair.r.map(|lane| 0.7 * lane));
            found.add(angle(function(v), exact(v)), exact(v));
        }
        found.max
    })
}

/// Radians between the answers and `2 (n.v) n - v`.
pub fn reflect<const N: usize>(functions: [OfTwo; N]) -> [f64; N] {
    functions.map(|function| {
        let mut found = Found::<3>::new();
        for pair in input::random(1, SAMPLES, 0.0) {
            let (n, v) = (rounded(pair.l), rounded(pair.r));
            let ([a, b, c], [d, e, f]) = (exact(n), exact(v));
            let twice = 2.0 * a.mul_add(d, b.mul_add(e, c * f));
            let truth = [twice.mul_add(a, -d), twice.mul_add(b, -e), twice.mul_add(c, -f)];
            found.add(angle(function(n, v), truth), exact(n));
        }
        found.max
    })
}

/// Radians between the answers under the Sun and the exact value of the method's formula.
pub fn direction<const N: usize>(method: Method, functions: [OfTwo; N]) -> [f64; N] {
    functions.map(|function| {
        let mut found = Found::<3>::new();
        for pair in input::random(1, SAMPLES, SUN.angular_radius()) {
            let (l, r) = (rounded(pair.l), rounded(pair.r));
            if method.is_defined(exact(l), exact(r), &SUN, OPPOSITE) {
                let truth = method.truth(exact(l), exact(r), &SUN);
                found.add(angle(function(l, r), truth), exact(l));
            }
        }
        found.max
    })
}

/// Relative errors of whole pixels by Karis: sunglint's, and those of `peer`, a function of normal, viewer and light.
pub fn pixel(case: &Case, peer: &dyn Fn(Vec3, Vec3, Vec3) -> f32) -> [f64; 2] {
    let glossy = Glossy { alpha: single(case.alpha), f0: single(F0), ratio: SUN.sin() };
    let mut found = Found::<3>::new();
    for Pixel { n, v, l } in case.pixels(1, SAMPLES) {
        let [n, v, l] = [n, v, l].map(rounded);
        let pixel = Pixel { n: exact(n), v: exact(v), l: exact(l) };
        let truth = matt(&pixel.unit()) + PI * Shading::Karis.truth(&glossy, &pixel);
        found.add((f64::from(peer(n.into(), v.into(), l.into())) / truth - 1.0).abs(), pixel.n);
    }
    [gloss::arithmetic::<f32>(Shading::Karis, case, case.pixels(1, SAMPLES)).max, found.max]
}

/// The diffuse part of a pixel in the Sun.
fn matt(pixel: &Pixel) -> f64 {
    let n_dot_l: f64 = pixel.n.iter().zip(pixel.l).map(|(n, l)| n * l).sum();
    single(ALBEDO) * diffuse::relative_illuminance(n_dot_l.min(1.0), SUN.sin(), SUN.cos())
}

/// NaN where the answer is no direction.
fn angle(answer: Vector, truth: [f64; 3]) -> f64 {
    if answer == [0.0; 3] { f64::NAN } else { angle_between(exact(answer), truth) }
}

/// As f32 has it.
fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

fn rounded(v: [f64; 3]) -> Vector {
    v.map(|lane| lane as f32)
}

fn exact(v: Vector) -> [f64; 3] {
    v.map(f64::from)
}
