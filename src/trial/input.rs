//! Pairs of directions to try: random ones at every angle, and the hard ones.

use core::f64::consts::PI;

use oorandom::Rand64;

/// Directions to the light's centre and along the mirror ray, of unit length before they are rounded into a format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// To the light.
    pub l: [f64; 3],
    /// Along the mirror ray.
    pub r: [f64; 3],
}

/// `count` random pairs for a disc of angular radius `theta`. The angle between the two is spread over: all angles
/// evenly; the logarithms of 1e-6 to pi; the logarithms of 1e-6 to pi short of pi; the disc's rim within a factor of
/// 2, and within 1e-6 to 1e-2 of it. One light in eight lies on or beside an axis, where lanes are tiny.
pub fn random(seed: u64, count: usize, theta: f64) -> impl Iterator<Item = Pair> {
    let mut source = Rand64::new(u128::from(seed));
    (0..count).map(move |index| {
        let l = light(&mut source, index);
        let angle = angle(&mut source, index % 5, theta);
        Pair { l, r: turned(l, on_sphere(&mut source), angle.clamp(0.0, PI)) }
    })
}

/// The same lights, with angles between the two that `angle` makes of numbers from 0 to 1.
pub fn at_angles(seed: u64, count: usize, angle: impl Fn(f64) -> f64) -> impl Iterator<Item = Pair> {
    let mut source = Rand64::new(u128::from(seed));
    (0..count).map(move |index| {
        let l = light(&mut source, index);
        let angle = angle(source.rand_float());
        Pair { l, r: turned(l, on_sphere(&mut source), angle) }
    })
}

/// One in eight on or beside an axis.
fn light(source: &mut Rand64, index: usize) -> [f64; 3] {
    if index % 8 == 7 { beside_axis(source) } else { on_sphere(source) }
}

/// The light from `(1, 2, 3)` and the mirror ray turned from it by `angle` towards `(3, 0, -1)`: the scene of the
/// catalogue of failures.
pub fn scene(angle: f64) -> Pair {
    let l = unit([1.0, 2.0, 3.0]);
    Pair { l, r: turned(l, unit([3.0, 0.0, -1.0]), angle) }
}

/// Pairs that have broken some method: that scene about the rim, axes, parallel and opposite directions, right
/// angles, great differences, and single steps of a format apart.
pub fn hard(theta: f64) -> impl Iterator<Item = Pair> {
    let aside = unit([3.0, 0.0, -1.0]);
    let turns = TURNS.into_iter().map(move |turn| scene((turn * theta).min(PI)));
    let angles = ANGLES.into_iter().map(scene);
    let axes = LIGHTS.into_iter().map(unit).flat_map(move |l| {
        let rim = turned(l, aside, theta);
        LIGHTS.into_iter().map(unit).chain([l, l.map(|lane| -lane), rim]).map(move |r| Pair { l, r })
    });
    let far = [Pair { l: [0.0, 0.0, 1.0], r: [libm::sqrt(3.0) / 2.0, 0.0, -0.5] }];
    turns.chain(angles).chain(axes).chain(far)
}

/// The pixels of a ball in scan order, `side` by `side` of them less the corners, seen from `(0, 0, 1)` and lit from
/// `(1, 2, 3)`: what a renderer asks for, one pixel much like the next.
pub fn ball(side: u32) -> impl Iterator<Item = Pair> {
    let centre = move |pixel: u32| (2.0 * f64::from(pixel) + 1.0) / f64::from(side) - 1.0;
    (0..side * side).filter_map(move |pixel| {
        let (x, y) = (centre(pixel % side), centre(pixel / side));
        let square = 1.0 - x * x - y * y;
        let z = libm::sqrt(square.max(0.0));
        // The mirror image of (0, 0, 1) about the normal (x, y, z).
        (square > 0.0).then(|| Pair { l: unit([1.0, 2.0, 3.0]), r: [2.0 * z * x, 2.0 * z * y, 2.0 * z * z - 1.0] })
    })
}

/// Angles in units of the angular radius.
const TURNS: [f64; 20] = [
    0.0, 0.25, 0.5, 0.9, 0.99, 0.999, 0.9999, 0.999_999, 1.0, 1.000_001, 1.0001, 1.001, 1.01, 1.1, 1.5, 2.0, 3.0, 7.0,
    7.2, 20.0,
];

/// Angles in radians.
const ANGLES: [f64; 16] =
    [1e-6, 0.5e-4, 1e-4, 1.5e-4, 3e-4, 1e-3, 1e-2, 0.5, 1.0, PI / 2.0, 1.6, 2.0, 2.5, 3.0, PI - 1e-3, PI - 1e-6];

/// Lights on the axes, beside them and between them.
const LIGHTS: [[f64; 3]; 12] = [
    [1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, -1.0],
    [1.0, 2.0, 3.0],
    [3.0, 0.0, -1.0],
    [1e-3, 0.0, 1.0],
    [1e-5, 1e-5, -1.0],
    [0.0, 1.0, 3e-3],
    [1.0, 1e-4, 0.0],
];

fn angle(source: &mut Rand64, kind: usize, theta: f64) -> f64 {
    let between = |from: f64, to: f64, source: &mut Rand64| from + (to - from) * source.rand_float();
    let logarithmic =
        |from: f64, to: f64, source: &mut Rand64| libm::exp(between(libm::log(from), libm::log(to), source));
    match kind {
        0 => between(0.0, PI, source),
        1 => logarithmic(1e-6, PI, source),
        2 => PI - logarithmic(1e-6, PI, source),
        3 => theta * logarithmic(0.5, 2.0, source),
        _ if source.rand_float() < 0.5 => theta * (1.0 - logarithmic(1e-6, 1e-2, source)),
        _ => theta * (1.0 + logarithmic(1e-6, 1e-2, source)),
    }
}

pub(super) fn on_sphere(source: &mut Rand64) -> [f64; 3] {
    let z = 2.0 * source.rand_float() - 1.0;
    let turn = 2.0 * PI * source.rand_float();
    let ring = libm::sqrt((1.0 - z) * (1.0 + z));
    [ring * libm::cos(turn), ring * libm::sin(turn), z]
}

fn beside_axis(source: &mut Rand64) -> [f64; 3] {
    let mut lanes = [0.0; 3];
    lanes[source.rand_range(0..3) as usize] = if source.rand_float() < 0.5 { 1.0 } else { -1.0 };
    let distance = libm::exp(-14.0 * source.rand_float());
    let aside = on_sphere(source);
    unit([0, 1, 2].map(|i| lanes[i] + distance * aside[i]))
}

/// `l` turned by `angle` towards `aside`.
pub(super) fn turned(l: [f64; 3], aside: [f64; 3], angle: f64) -> [f64; 3] {
    let along = l[0] * aside[0] + l[1] * aside[1] + l[2] * aside[2];
    let across = [0, 1, 2].map(|i| aside[i] - along * l[i]);
    // Where the two are parallel, any perpendicular will do.
    let short = across.into_iter().all(|lane| lane.abs() < 1e-9);
    let perpendicular = if l[2].abs() < 0.9 { [l[1], -l[0], 0.0] } else { [0.0, l[2], -l[1]] };
    let tangent = unit(if short { perpendicular } else { across });
    unit([0, 1, 2].map(|i| libm::cos(angle) * l[i] + libm::sin(angle) * tangent[i]))
}

pub(super) fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = libm::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    v.map(|lane| lane / length)
}
