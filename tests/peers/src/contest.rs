//! sunglint's f32 beside the same written by hand over glam, on the pixels of a ball.

use glam::Vec3;
use indicatif::ProgressBar;
use sunglint::highlight::PointGgx;
use sunglint::scene::Channel;
use sunglint::trial::gloss::{self, CASES, Case};
use sunglint::trial::{Method, input};
use sunglint::{DistantSphere, SUN};

use crate::clock::{self, Contender, Cost};
use crate::glam_f32::{self, SUN_F32, Scene};
use crate::vector_error;

/// Pixels across the ball that is lit.
const SIDE: u32 = 64;

const SPHERE: DistantSphere<f32> = DistantSphere::<f32>::new(&SUN);

/// Varnish in the Sun.
pub const VARNISH: Case = CASES[1];

/// A job, and two that do it.
pub struct Contest {
    /// What is done.
    pub function: &'static str,
    /// Over what it is written by hand.
    pub peer: &'static str,
    /// sunglint's calls.
    pub own: Contender,
    /// The peer's.
    pub other: Contender,
    /// Worst errors of the two, in [`unit`](Self::unit), over random inputs.
    pub errors: fn() -> [f64; 2],
    /// Radians, or a share of the pixel's value.
    pub unit: &'static str,
}

impl Contest {
    /// Time of sunglint's call over the peer's.
    pub fn ratio(&self, rounds: usize) -> Cost {
        clock::costs(std::slice::from_ref(&self.own), &self.other, rounds, &ProgressBar::hidden())[0]
    }
}

/// All of them.
pub const ALL: [fn() -> Contest; 6] = [normalize, normalize_or_zero, reflect, factored, cap, pixel];

fn normalize() -> Contest {
    let [own, other] = sides(ball(), |&[_, r]| sunglint::normalize(r), |&[_, r]| r.normalize());
    let errors = || vector_error::normalize([&sunglint::normalize, &|v| Vec3::from(v).normalize().into()]);
    Contest { function: "normalize", peer: "normalize", own, other, errors, unit: "rad" }
}

/// The one of glam's that has an answer for zero, as sunglint's has.
fn normalize_or_zero() -> Contest {
    let [own, other] = sides(ball(), |&[_, r]| sunglint::normalize(r), |&[_, r]| r.normalize_or_zero());
    let errors = || vector_error::normalize([&sunglint::normalize, &|v| Vec3::from(v).normalize_or_zero().into()]);
    Contest { function: "normalize", peer: "normalize_or_zero", own, other, errors, unit: "rad" }
}

fn reflect() -> Contest {
    let [own, other] = sides(facing(), |&[n, v]| sunglint::reflect(n, v), |&[n, v]| glam_f32::reflect(n, v));
    let errors = || vector_error::reflect([&sunglint::reflect, &|n, v| glam_f32::reflect(n.into(), v.into()).into()]);
    Contest { function: "reflect", peer: "by hand", own, other, errors, unit: "rad" }
}

fn factored() -> Contest {
    let [own, other] =
        sides(ball(), |&[l, r]| sunglint::factored(l, r, &SPHERE), |&[l, r]| glam_f32::factored(l, r, &SUN_F32));
    let errors = || {
        let by_glam = |l: [f32; 3], r: [f32; 3]| glam_f32::factored(l.into(), r.into(), &SUN_F32).into();
        vector_error::direction(Method::Factored, [&|l, r| sunglint::factored(l, r, &SPHERE), &by_glam])
    };
    Contest { function: "factored", peer: "by hand", own, other, errors, unit: "rad" }
}

fn cap() -> Contest {
    let [own, other] = sides(ball(), |&[l, r]| sunglint::cap(l, r, &SPHERE), |&[l, r]| glam_f32::cap(l, r, &SUN_F32));
    let errors = || {
        let by_glam = |l: [f32; 3], r: [f32; 3]| glam_f32::cap(l.into(), r.into(), &SUN_F32).into();
        vector_error::direction(Method::Cap, [&|l, r| sunglint::cap(l, r, &SPHERE), &by_glam])
    };
    Contest { function: "cap", peer: "by hand", own, other, errors, unit: "rad" }
}

/// Lambert, and GGX at the disc's nearest point with Karis's factor.
fn pixel() -> Contest {
    let l = rounded([1.0, 2.0, 3.0].map(|lane: f64| lane / 14_f64.sqrt()));
    let scene = gloss::scene(&VARNISH, l, PointGgx::karis).expect("varnish is within every format's ranges");
    let by_glam = Scene::new(l.into(), VARNISH.alpha as f32);
    let own = move |&[n, v]: &Pair| scene.shade_channel(n, v, Channel::Green);
    let [own, other] = sides(facing(), own, move |&[n, v]| by_glam.shade(n, v));
    let errors = || vector_error::pixel(&VARNISH, &|n, v, l| Scene::new(l, VARNISH.alpha as f32).shade(n, v));
    Contest { function: "pixel, karis", peer: "by hand", own, other, errors, unit: "relative" }
}

type Pair = [[f32; 3]; 2];

/// The two sides of a contest on `inputs`.
fn sides<O: 'static, P: 'static>(
    inputs: Vec<Pair>,
    own: impl Fn(&Pair) -> O + 'static,
    other: impl Fn(&[Vec3; 2]) -> P + 'static,
) -> [Contender; 2] {
    let vectors = inputs.iter().map(|pair| pair.map(Vec3::from)).collect();
    [Contender::new(inputs, own, |&[first, _]| first), Contender::new(vectors, other, |&[first, _]| first)]
}

/// Direction to the light and mirror ray of a ball's pixels.
fn ball() -> Vec<Pair> {
    input::ball(SIDE).map(|pair| [pair.l, pair.r].map(rounded)).collect()
}

/// Normal and direction to the viewer of a ball's pixels.
fn facing() -> Vec<Pair> {
    const V: [f64; 3] = [0.0, 0.0, 1.0];
    let normal = |r: [f64; 3]| {
        // Halfway between the viewer and the mirror ray.
        let sum = [0, 1, 2].map(|i| r[i] + V[i]);
        let length = sum.iter().map(|lane| lane * lane).sum::<f64>().sqrt();
        sum.map(|lane| lane / length)
    };
    input::ball(SIDE).map(|pair| [normal(pair.r), V].map(rounded)).collect()
}

fn rounded(v: [f64; 3]) -> [f32; 3] {
    v.map(|lane| lane as f32)
}
