//! The truth about highlights: the whole BRDF integrated over the disc, and what each method's formula is exactly.
//!
//! All are radiances towards `v` over the light's illuminance on a plane that faces it. Vectors may be of any length.

use core::f64::consts::PI;

use super::{Vector, angle_between, cross, dot, length, nearest_in_disc, scale, turn};

/// A glossy surface under a disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glossy {
    /// GGX width, from 0 to 1.
    pub alpha: f64,
    /// Reflectance at normal incidence.
    pub f0: f64,
    /// Radius over distance of the light, from 0 to 1.
    pub ratio: f64,
}

/// Directions to shade with: normal, to the viewer, to the light's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Normal.
    pub n: Vector,
    /// To the viewer.
    pub v: Vector,
    /// To the light's centre.
    pub l: Vector,
}

impl Pixel {
    /// The same with every vector at length 1.
    pub fn unit(self) -> Self {
        let [n, v, l] = [self.n, self.v, self.l].map(|vector| scale(vector, 1.0 / length(vector)));
        Self { n, v, l }
    }

    /// The same with the light or the viewer moved by `distance`: in their plane, out of it and along themselves, to
    /// and fro; with the normal moved as far towards their half vector, but not beyond it; and with the light moved
    /// towards the mirror ray, likewise, and away from it; and with the light or the viewer moved so that the half
    /// vector comes nearer to the normal.
    pub fn beside(&self, distance: f64) -> [Self; 17] {
        let &Self { n, v, l } = self;
        let about = |axis: Vector, toward: Vector| {
            let [first, second] = frame(axis, toward);
            let moved = |side: Vector, distance: f64| add(axis, scale(side, distance));
            [first, second, axis].map(|side| [moved(side, distance), moved(side, -distance)])
        };
        let [[a, b], [c, d], [e, f]] = about(l, v).map(|pair| pair.map(|l| Self { n, v, l }));
        let [[g, h], [i, j], [k, m]] = about(v, l).map(|pair| pair.map(|v| Self { n, v, l }));
        let toward = Self { n: nearest_in_disc(n, add(l, v), distance), v, l };
        let near = Self { n, v, l: nearest_in_disc(l, mirror(self), distance) };
        let away = Self { n, v, l: [0, 1, 2].map(|i| 2.0 * l[i] - turn(l, mirror(self), distance)[i]) };
        let lean = self.off_the_normal(0.0, distance);
        let by_light = Self { n, v, l: add(l, lean) };
        let by_viewer = Self { n, v: add(v, lean), l };
        [a, b, c, d, e, f, g, h, i, j, k, m, toward, near, away, by_light, by_viewer]
    }

    /// How far the disc's nearest point lies from the mirror ray, which way, and at most `distance`.
    pub fn off_the_mirror(&self, ratio: f64, distance: f64) -> Vector {
        let r = mirror(self);
        let apart = add(r, scale(nearest_in_disc(self.l, r, super::angular_radius(ratio)), -1.0));
        at_most(apart, distance)
    }

    /// How far the sum of the viewer and the disc's nearest point lies from the normal, which way, and at most
    /// `distance`.
    pub fn off_the_normal(&self, ratio: f64, distance: f64) -> Vector {
        let nearest = nearest_in_disc(self.l, mirror(self), super::angular_radius(ratio));
        let sum = add(nearest, self.v);
        at_most(add(scale(self.n, dot(self.n, sum)), scale(sum, -1.0)), distance)
    }
}

/// A vector, or its part of a length.
fn at_most(vector: Vector, most: f64) -> Vector {
    let size = length(vector);
    if size > most { scale(vector, most / size) } else { vector }
}

impl Glossy {
    /// `D V F (n.l)` for a light in the single direction `l`: GGX and Smith by their tangents, `D = 1 / (pi alpha^2
    /// cos^4 (1 + tan^2 / alpha^2)^2)`, `V = 1 / (4 (n.l) (n.v) (1 + L(v) + L(l)))`.
    pub fn brdf(&self, pixel: &Pixel) -> f64 {
        self.brdf_of_unit(&pixel.unit())
    }

    /// The same for vectors of length 1, with plain products: the integrals over a disc call this millions of times.
    pub(super) fn brdf_of_unit(&self, &Pixel { n, v, l }: &Pixel) -> f64 {
        let [n_dot_l, n_dot_v] = [plain_dot(n, l), plain_dot(n, v)];
        if n_dot_l <= 0.0 || n_dot_v <= 0.0 {
            return 0.0;
        }
        let h = add(l, v);
        let size = plain_dot(h, h);
        let cosine_square = (n_dot_l + n_dot_v) * (n_dot_l + n_dot_v) / size;
        let side = [n[1] * h[2] - n[2] * h[1], n[2] * h[0] - n[0] * h[2], n[0] * h[1] - n[1] * h[0]];
        let sine_square = plain_dot(side, side) / size;
        let slope_square = sine_square / cosine_square / (self.alpha * self.alpha);
        let spread = self.alpha * cosine_square * (1.0 + slope_square);
        self.visibility(n_dot_l, n_dot_v) * self.fresnel(libm::sqrt(size) / 2.0) / (PI * spread * spread)
    }

    /// `V (n.l)`.
    fn visibility(&self, n_dot_l: f64, n_dot_v: f64) -> f64 {
        if n_dot_l <= 0.0 || n_dot_v <= 0.0 {
            return 0.0;
        }
        let shadow = |cosine: f64| {
            let tangent_square = ((1.0 - cosine) * (1.0 + cosine)).max(0.0) / (cosine * cosine);
            (libm::sqrt(1.0 + self.alpha * self.alpha * tangent_square) - 1.0) / 2.0
        };
        1.0 / (4.0 * n_dot_v * (1.0 + shadow(n_dot_v) + shadow(n_dot_l)))
    }

    fn fresnel(&self, v_dot_h: f64) -> f64 {
        let rest = (1.0 - v_dot_h).max(0.0);
        self.f0 + (1.0 - self.f0) * (rest * rest * rest * rest * rest)
    }

    /// GGX at the disc's point nearest to the mirror ray, with its peak lowered to that of the width `width`; the point
    /// moved by `offset`.
    pub fn at_nearest_point(&self, pixel: &Pixel, width: f64, offset: Vector) -> f64 {
        let theta = super::angular_radius(self.ratio);
        let r = mirror(pixel);
        let l = add(scale(nearest_in_disc(pixel.l, r, theta), length(pixel.l)), offset);
        let factor = self.alpha / width;
        if self.alpha > 0.0 {
            return factor * factor * self.brdf_of_unit(&Pixel { l, ..*pixel });
        }
        // A mirror: the disc or nothing.
        let seen = width > 0.0 && angle_between(pixel.l, r) <= theta && dot(pixel.n, pixel.v) > 0.0;
        let n_dot_v = dot(pixel.n, pixel.v);
        if seen { self.fresnel(n_dot_v) / (4.0 * n_dot_v * PI * width * width) } else { 0.0 }
    }

    /// The image of the disc in a mirror of unit normal.
    pub(super) fn mirrored(&self, pixel: &Pixel) -> f64 {
        let seen = angle_between(pixel.l, mirror(pixel)) <= super::angular_radius(self.ratio);
        let n_dot_v = dot(pixel.n, pixel.v);
        if seen && n_dot_v > 0.0 { self.fresnel(n_dot_v) / (PI * self.ratio * self.ratio) } else { 0.0 }
    }

    /// GGX averaged over the disc as if its image in the half vectors were a circle, or with the disc's width in the
    /// direction of `n` alone.
    pub fn over_circle(&self, pixel: &Pixel, directional: bool) -> f64 {
        let (lean, smooth) = (Lean::of(pixel), self.smooth(pixel));
        if smooth == 0.0 {
            return 0.0;
        }
        let w = self.versine();
        let (a, z) = (self.alpha * self.alpha, lean.upright);
        let m = lean.along + lean.across;
        let circle = w / (2.0 * lean.v_dot_h);
        let spread = lean.along + lean.across * lean.v_dot_h * lean.v_dot_h + a * z * lean.v_dot_h;
        let wide = if directional && spread > 0.0 { w / 2.0 * (m + a * z) / spread } else { circle };
        let p = a * z + m - wide;
        let r = libm::hypot(p, 2.0 * libm::sqrt(a * z * circle));
        let density = if p < 0.0 { (r - p) / (2.0 * PI * circle * z * r) } else { 2.0 * a / (PI * r * (r + p)) };
        if r == 0.0 { 0.0 } else { density * smooth / (1.0 - w / 2.0) }
    }

    /// The exact share of the microfacets that mirror the disc, times the rest of the model at the disc's centre.
    pub fn over_cone(&self, pixel: &Pixel) -> f64 {
        if self.ratio == 0.0 {
            return if self.alpha > 0.0 { self.brdf_of_unit(pixel) } else { 0.0 };
        }
        let (lean, smooth) = (Lean::of(pixel), self.smooth(pixel));
        if smooth == 0.0 {
            return 0.0;
        }
        let factor = 4.0 * lean.v_dot_h / libm::sqrt(lean.upright);
        self.share(&lean) * factor * smooth / (PI * self.ratio * self.ratio)
    }

    /// The same with the rest of the model taken between the centre and the point nearest to the mirror ray, and that
    /// moved by `offset`.
    pub fn over_cone_shifted(&self, pixel: &Pixel, offset: Vector) -> f64 {
        if self.ratio == 0.0 {
            return self.over_cone(pixel);
        }
        let (w, a) = (self.versine(), self.alpha * self.alpha);
        let nearest = nearest_in_disc(pixel.l, mirror(pixel), super::angular_radius(self.ratio));
        let part = w / (w + a);
        let middle = add(add(scale(nearest, part), scale(pixel.l, a / (w + a))), offset);
        let [n_dot_m, n_dot_v] = [dot(pixel.n, middle), dot(pixel.n, pixel.v)];
        let half_square = (1.0 + dot(middle, pixel.v)) / 2.0;
        let slant = 2.0 * half_square / (n_dot_m + n_dot_v);
        let smooth = self.visibility(n_dot_m, n_dot_v) * self.fresnel(libm::sqrt(half_square));
        // Microfacets below the surface mirror nothing.
        if smooth == 0.0 || n_dot_v + dot(pixel.n, pixel.l) <= 0.0 {
            0.0
        } else {
            self.share(&Lean::of(pixel)) * 4.0 * slant * smooth / (PI * self.ratio * self.ratio)
        }
    }

    /// `V (n.l) F` at the centre.
    fn smooth(&self, pixel: &Pixel) -> f64 {
        let h = add(pixel.l, pixel.v);
        let visibility = self.visibility(dot(pixel.n, pixel.l), dot(pixel.n, pixel.v));
        if visibility > 0.0 { visibility * self.fresnel(dot(pixel.v, h) / length(h)) } else { 0.0 }
    }

    /// The share of the microfacets, by projected area, whose normals are in the cone of half vectors.
    ///
    /// By the eigenvalues of the cone's quadratic form after slopes were divided by `alpha`: the vector irradiance of
    /// an elliptic cone points along its axis.
    fn share(&self, lean: &Lean) -> f64 {
        let w = self.versine();
        let (a, c) = (self.alpha * self.alpha, 2.0 - w);
        // Where the disc reaches to the viewer's opposite, the formula is that of a very wide cone.
        let g = (2.0 * lean.v_dot_h * lean.v_dot_h - w).max(w / (a + w / 2.0) / 30_000.0);
        let (along, across) = (lean.along, lean.across);
        let m = along + across;
        let at_normal = w * lean.upright - c * along - g * across;
        if a == 0.0 {
            return if at_normal >= 0.0 { 1.0 } else { 0.0 };
        }
        // Coefficients of the characteristic polynomial: sums of principal minors.
        let trace_beside = w - c - g - at_normal;
        let minor_beside = c * g * lean.upright - w * (g * along + c * across);
        let minors_at = c * g * m - w * (c * (1.0 - across) + g * (1.0 - along));
        let square = at_normal + a * trace_beside;
        let linear = a * minors_at + a * a * minor_beside;
        let constant = a * a * w * c * g;
        let polynomial = |mu: f64| ((mu - square) * mu + linear) * mu - constant;
        let (mut low, mut high) = (0.0, w);
        for _ in 0..200 {
            let middle = if low == 0.0 { high / 16.0 } else { libm::sqrt(low * high) };
            if polynomial(middle) > 0.0 {
                high = middle
            } else {
                low = middle
            }
            if low == 0.0 && high < 1e-300 {
                break;
            }
        }
        let mu = (low + high) / 2.0;
        let slope = mu * (2.0 * mu - square) + constant / mu;
        let beside = mu * mu - a * trace_beside * mu + a * a * minor_beside;
        mu * libm::sqrt(beside.max(0.0)) / slope
    }

    fn versine(&self) -> f64 {
        super::closed::versine(self.ratio)
    }
}

/// How the normal leans from the half vector of the centre.
struct Lean {
    v_dot_h: f64,
    /// `(n.h)^2`.
    upright: f64,
    /// Squares of the normal's parts along `l - v` and along `l x v`.
    along: f64,
    across: f64,
}

impl Lean {
    fn of(pixel: &Pixel) -> Self {
        let &Pixel { n, v, l } = pixel;
        let h = add(l, v);
        let lean = angle_between(n, h);
        let (sine, cosine) = (libm::sin(lean), libm::cos(lean));
        let beside = add(l, scale(v, -1.0));
        let size = length(beside);
        let tilt = sine * sine;
        // Of what of the normal is across the half vector, which for vectors that are not quite of one length is not at
        // a right angle to their difference.
        let part = (dot(n, beside) - dot(n, h) / dot(h, h) * dot(h, beside)) / size;
        let along = if size > 0.0 { (part * part).min(tilt) } else { tilt / 2.0 };
        Self { v_dot_h: length(h) / 2.0, upright: cosine * cosine, along, across: tilt - along }
    }
}

fn plain_dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// The mirror direction of the viewer's.
pub(super) fn mirror(pixel: &Pixel) -> Vector {
    let twice = 2.0 * dot(pixel.n, pixel.v);
    [0, 1, 2].map(|i| twice * pixel.n[i] - pixel.v[i])
}

/// A direction in polar coordinates about `axis`, the azimuth counted from `first` to `second`.
pub(super) fn about(axis: Vector, [first, second]: [Vector; 2], polar: f64, azimuth: f64) -> Vector {
    let (sin, cos) = (libm::sin(polar), libm::cos(polar));
    let (across, along) = (sin * libm::sin(azimuth), sin * libm::cos(azimuth));
    [0, 1, 2].map(|i| cos * axis[i] + along * first[i] + across * second[i])
}

/// Two unit vectors that make a right-handed frame with `axis`, the first in the plane of `toward`.
pub(super) fn frame(axis: Vector, toward: Vector) -> [Vector; 2] {
    let second = cross(axis, toward);
    let size = length(second);
    let spare = if axis[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let second = if size > 1e-12 { second } else { cross(axis, spare) };
    let second = scale(second, 1.0 / length(second));
    [cross(second, axis), second]
}
