//! Samples of a cone from the definition, and areas on the sphere.

use core::f64::consts::PI;

use super::{Vector, cross, integral, length, scale};

/// The direction whose versine of the angle from `l` is `z` times that of `theta`, at `turn` turns about `l` from the
/// first vector of [`basis`] towards the second.
pub fn direction(l: Vector, theta: f64, [z, turn]: [f64; 2]) -> Vector {
    // 1 - cos(a) = 2 sin^2(a / 2), and the cosine of the half by parts that do not cancel.
    let [sine, cosine] = [libm::sin(theta / 2.0), libm::cos(theta / 2.0)];
    let half = libm::atan2(libm::sqrt(z) * sine, libm::sqrt((1.0 - z) + z * cosine * cosine));
    at(l, 2.0 * half, turn)
}

/// The direction at `angle` from `l`, at `turn` turns about it from the first vector of [`basis`] towards the second.
pub fn at(l: Vector, angle: f64, turn: f64) -> Vector {
    let [t, b] = basis(l);
    let [sin, cos] = turned(turn);
    super::turn(l, [0, 1, 2].map(|i| cos * t[i] + sin * b[i]), angle)
}

/// Solid angle of a disc in closed form.
pub fn solid_angle(theta: f64) -> f64 {
    let half = libm::sin(theta / 2.0);
    4.0 * PI * half * half
}

/// Sine and cosine of `turn` turns, within 1e-16: the nearest quarter taken off, so that the angle is at most pi/4.
pub fn turned(turn: f64) -> [f64; 2] {
    let quarters = libm::rint(4.0 * turn);
    let angle = 2.0 * PI * (turn - quarters / 4.0);
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    match quarters as i64 & 3 {
        0 => [sin, cos],
        1 => [cos, -sin],
        2 => [-sin, -cos],
        _ => [-cos, sin],
    }
}

/// The x axis carried along by the least rotation from the z axis, or its negative, whichever is nearer, to `l`; and
/// what completes it to the right-handed frame of `l`.
pub fn basis(l: Vector) -> [Vector; 2] {
    let unit = scale(l, 1.0 / length(l));
    let pole = [0.0, 0.0, if unit[2] < 0.0 { -1.0 } else { 1.0 }];
    let axis = cross(pole, unit);
    let size = length(axis);
    let x = [1.0, 0.0, 0.0];
    let t = if size == 0.0 { x } else { rotated(x, scale(axis, 1.0 / size), super::angle_between(pole, unit)) };
    [t, cross(unit, t)]
}

/// `v` rotated by `angle` about the unit vector `axis` (Rodrigues).
fn rotated(v: Vector, axis: Vector, angle: f64) -> Vector {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let aside = cross(axis, v);
    let along = super::dot(axis, v) * (1.0 - cos);
    [0, 1, 2].map(|i| cos * v[i] + sin * aside[i] + along * axis[i])
}

/// Solid angle that two discs of angular radii `a` and `b`, whose centres are `distance` apart, have in common: the
/// integral over the rings of the first.
pub fn overlap(a: f64, b: f64, distance: f64) -> f64 {
    // The middle of what the second disc has of the ring, and where it begins and ends to have parts of rings.
    let ends = [0.0, libm::fabs(distance - b).min(a), (distance + b).min(a), a];
    let ring = |t: f64| libm::sin(t) * arc(t, b, distance);
    (0..3).map(|i| smooth_integral(ring, ends[i], ends[i + 1])).sum()
}

/// How much of the ring at the angle `t` lies within `b` of a point that is `distance` away, in radians: the spherical
/// law of cosines, in sines of halves so that it holds for small angles.
fn arc(t: f64, b: f64, distance: f64) -> f64 {
    let half_square = |angle: f64| {
        let half = libm::sin(angle / 2.0);
        half * half
    };
    let scale = libm::sin(t) * libm::sin(distance);
    let rest = half_square(b) - half_square(t - distance);
    // sin^2 of half the azimuth at which the ring meets the disc's edge.
    let sine_square = if scale > 0.0 { rest / scale } else { f64::INFINITY * if rest >= 0.0 { 1.0 } else { -1.0 } };
    4.0 * libm::asin(libm::sqrt(sine_square.clamp(0.0, 1.0)))
}

/// Mean over a disc of angular radius `theta` of the cosine to a normal, the disc's centre being `zenith` from it and
/// what is beyond 90 degrees counting as 0: the integral over the rings.
pub fn mean_cosine(theta: f64, zenith: f64) -> f64 {
    let ring = |t: f64| {
        let (middle, swing) = (libm::cos(t) * libm::cos(zenith), libm::sin(t) * libm::sin(zenith));
        let rise = if middle >= swing {
            PI
        } else if middle <= -swing {
            0.0
        } else {
            libm::acos(-middle / swing)
        };
        2.0 * libm::sin(t) * (middle * rise + swing * libm::sin(rise))
    };
    // Where the ring begins to set.
    let sets = libm::fabs(PI / 2.0 - zenith).min(theta);
    let rises = (PI - libm::fabs(PI / 2.0 - zenith)).clamp(sets, theta.max(sets));
    let sum =
        smooth_integral(ring, 0.0, sets) + smooth_integral(ring, sets, rises) + smooth_integral(ring, rises, theta);
    sum / solid_angle(theta)
}

/// The integral with the ends drawn out, so that roots at either end do no harm.
fn smooth_integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    // t = from + (to - from) (3 s^2 - 2 s^3).
    let width = to - from;
    integral(|s| f(from + width * s * s * (3.0 - 2.0 * s)) * width * 6.0 * s * (1.0 - s), 0.0, 1.0)
}

/// Solid angle of a sphere of ratio `x`, at distance 1, as a sum over its surface: of `cos / r^2` over `count` rings of
/// its visible side.
pub fn solid_angle_by_area(x: f64, count: u32) -> f64 {
    // Rings at the angle t from the point that faces the viewer; visible up to cos(t) = x.
    let last = libm::acos(x);
    let step = last / f64::from(count);
    let ring = |i: u32| {
        let t = (f64::from(i) + 0.5) * step;
        let (sin, cos) = (libm::sin(t), libm::cos(t));
        let square = (1.0 - x) * (1.0 - x) + 4.0 * x * libm::sin(t / 2.0) * libm::sin(t / 2.0);
        // The cosine at the surface between its normal and the way to the viewer.
        let facing = (cos - x) / libm::sqrt(square);
        facing / square * 2.0 * PI * x * x * sin * step
    };
    (0..count).map(ring).sum()
}

/// Solid angle of what `sees` of the hemisphere about the z axis, as a sum over `count` by `4 count` cells of equal
/// solid angle.
pub fn solid_angle_by_hemisphere(count: u32, mut sees: impl FnMut(Vector) -> bool) -> f64 {
    let cell = |i: u32, parts: u32| (f64::from(i) + 0.5) / f64::from(parts);
    let mut seen = 0_u64;
    for i in 0..count {
        let z = cell(i, count);
        let ring = libm::sqrt((1.0 - z) * (1.0 + z));
        for j in 0..4 * count {
            let turn = 2.0 * PI * cell(j, 4 * count);
            seen += u64::from(sees([ring * libm::cos(turn), ring * libm::sin(turn), z]));
        }
    }
    2.0 * PI * seen as f64 / (4.0 * f64::from(count) * f64::from(count))
}
