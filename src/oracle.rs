//! The truth in f64, from the definitions: angles by `atan2`, rotations, and integrals summed by Simpson's rule.
//!
//! Shares no code with what it judges. `tests/oracle.rs` holds it against 192-bit arithmetic: directions are within
//! 5e-16 rad.

pub mod highlight;
pub mod planck;
pub mod quadrature;
pub mod radiometry;

use core::f64::consts::PI;

pub mod cone;
pub mod diffuse;

type Vector = [f64; 3];

/// The angle between two vectors of any length, in radians, to full precision for small angles too; 0 for a zero
/// vector.
pub fn angle_between(a: Vector, b: Vector) -> f64 {
    libm::atan2(length(cross(a, b)), dot(a, b))
}

/// The angular radius of a sphere whose radius over distance is `ratio`.
pub fn angular_radius(ratio: f64) -> f64 {
    libm::atan2(ratio, libm::sqrt((1.0 - ratio) * (1.0 + ratio)))
}

/// The nearest direction to `r` within `theta` of `l`: `l` turned towards `r` by the angle between them, at most by
/// `theta`.
///
/// At `r = -l` it is `l`. Lengths do not matter; the answer has length 1.
pub fn nearest_in_disc(l: Vector, r: Vector, theta: f64) -> Vector {
    if angle_between(l, r) <= theta { scale(r, 1.0 / length(r)) } else { turn(l, r, theta) }
}

/// The exact value of the representative point with the distance divided out, `P = l + D sat(x / |D|)` with `D =
/// (l.r) r - l`, normalised; `l` where `P` is zero.
///
/// In the plane of `l` and `r`, at the angle `a`, `D` is `sin(a)` long and `P` turns `l` by the angle whose tangent is
/// `m cos(a) / (1 - m sin(a))`, `m` being the smaller of `x` and `sin(a)`.
pub fn factored_direction(l: Vector, r: Vector, ratio: f64) -> Vector {
    let [along, across] = factored_point(l, r, ratio);
    turn(l, r, libm::atan2(across, along))
}

/// How long `P` of [`factored_direction`] is: where that is near 0 its direction hangs on the last bits of the inputs.
pub fn factored_length(l: Vector, r: Vector, ratio: f64) -> f64 {
    let [along, across] = factored_point(l, r, ratio);
    libm::hypot(along, across)
}

/// `P` in the plane of `l` and `r`: its part along `l`, and across `l` on the side of `r`.
fn factored_point(l: Vector, r: Vector, ratio: f64) -> [f64; 2] {
    let size = length(l) * length(r);
    // Not by way of the angle: near a right one, the cosine has more digits than that.
    let (sin, cos) = (length(cross(l, r)) / size, dot(l, r) / size);
    // 1 - m sin, where nothing is subtracted that cancels.
    if sin <= ratio { [cos * cos, sin * cos] } else { [(1.0 - ratio) + ratio * cos * cos / (1.0 + sin), ratio * cos] }
}

/// Illuminance of a plane that faces a disc of radiance 1 and angular radius `theta`, counting both sides of the plane:
/// the integral of `|cos|` over the disc.
pub fn illuminance(theta: f64) -> f64 {
    // In two parts, since the integrand has a corner at pi/2.
    let integrand = |t: f64| 2.0 * PI * libm::fabs(libm::cos(t)) * libm::sin(t);
    let front = if theta < PI / 2.0 { theta } else { PI / 2.0 };
    integral(integrand, 0.0, front) + integral(integrand, front, theta)
}

/// Solid angle of a disc of angular radius `theta`: the integral of 1 over it.
pub fn solid_angle(theta: f64) -> f64 {
    integral(|t| 2.0 * PI * libm::sin(t), 0.0, theta)
}

/// Power that a sphere of `radius` and radiance 1 emits: the integral over its surface and over all directions outward.
pub fn sphere_power(radius: f64) -> f64 {
    let area = integral(|t| 2.0 * PI * radius * radius * libm::sin(t), 0.0, PI);
    area * illuminance(PI / 2.0)
}

/// The normalisation quantities of a sphere in closed form, through the angle: for judging narrow formats to their
/// last place. `tests/oracle.rs` holds them against 192 bits.
pub mod closed {
    use super::{PI, angular_radius};

    /// `2 sin^2(theta / 2)`.
    pub fn versine(ratio: f64) -> f64 {
        let half = libm::sin(angular_radius(ratio) / 2.0);
        2.0 * half * half
    }

    /// `4 pi sin^2(theta / 2)`.
    pub fn solid_angle(ratio: f64) -> f64 {
        2.0 * PI * versine(ratio)
    }

    /// `pi sin^2(theta)`, 1 for 0.
    pub fn size_factor(ratio: f64) -> f64 {
        let sin = libm::sin(angular_radius(ratio));
        if sin == 0.0 { 1.0 } else { PI * sin * sin }
    }
}

/// Simpson's rule on 2000 intervals.
fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    const INTERVALS: u32 = 2000;
    let step = (to - from) / f64::from(INTERVALS);
    let weight = |i: u32| match i {
        0 | INTERVALS => 1.0,
        i if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    (0..=INTERVALS).map(|i| weight(i) * f(from + step * f64::from(i))).sum::<f64>() * step / 3.0
}

/// `l` turned by `angle` towards `r`, at length 1; `l` where the two are parallel.
fn turn(l: Vector, r: Vector, angle: f64) -> Vector {
    let axis = cross(l, r);
    let toward = cross(axis, l);
    let size = length(toward);
    let unit = scale(l, 1.0 / length(l));
    if size == 0.0 {
        return unit;
    }
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    [0, 1, 2].map(|i| cos * unit[i] + sin * toward[i] / size)
}

fn cross(a: Vector, b: Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| difference(a[i], b[j], a[j], b[i]))
}

/// `a b - c d` with the rounding of `c d` put back, so that it is right to the last places however much cancels.
fn difference(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let cd = c * d;
    let lost = libm::fma(-c, d, cd);
    libm::fma(a, b, -cd) + lost
}

/// The dot product with the rounding of every product and sum put back at the end, so that it is right to the last
/// places however much cancels (Ogita, Rump and Oishi, 2005).
fn dot(a: Vector, b: Vector) -> f64 {
    let (mut sum, mut lost) = (0.0, 0.0);
    for i in 0..3 {
        let product = a[i] * b[i];
        let next = sum + product;
        let kept = next - sum;
        lost += libm::fma(a[i], b[i], -product) + ((sum - (next - kept)) + (product - kept));
        sum = next;
    }
    sum + lost
}

fn length(v: Vector) -> f64 {
    libm::hypot(libm::hypot(v[0], v[1]), v[2])
}

fn scale(v: Vector, factor: f64) -> Vector {
    v.map(|lane| lane * factor)
}
