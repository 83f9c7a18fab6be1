//! The same formulas over `glam::Vec3`, as one writes them for a desktop: no answer for zero vectors, NaN or large
//! discs.

use core::f32::consts::{FRAC_1_PI, PI};

use glam::Vec3;
use sunglint::SUN;
use sunglint::trial::gloss::{ALBEDO, F0};

/// A light's constants.
#[derive(Clone, Copy, Debug)]
pub struct Light {
    sin: f32,
    sin_square: f32,
    versine: f32,
}

/// The Sun from Earth.
pub const SUN_F32: Light =
    Light { sin: SUN.sin() as f32, sin_square: (SUN.sin() * SUN.sin()) as f32, versine: SUN.versine() as f32 };

/// The mirror direction.
#[inline]
pub fn reflect(n: Vec3, v: Vec3) -> Vec3 {
    n * (2.0 * n.dot(v)) - v
}

/// The representative point with the distance divided out.
#[inline]
pub fn factored(l: Vec3, r: Vec3, light: &Light) -> Vec3 {
    let d = r * l.dot(r) - l;
    let square = d.length_squared();
    let share = if square <= light.sin_square { 1.0 } else { light.sin / square.sqrt() };
    (l + d * share).normalize()
}

/// The nearest direction of the disc, without cancellation.
#[inline]
pub fn cap(l: Vec3, r: Vec3, light: &Light) -> Vec3 {
    let toward = l.dot(r) >= 0.0;
    let e = if toward { r - l } else { r + l };
    let s = e - l * e.dot(l);
    let square = s.length_squared();
    if toward && square <= light.sin_square { r } else { l + (s * (light.sin / square.sqrt()) - l * light.versine) }
}

/// A surface under a light.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    l: Vec3,
    light: Light,
    alpha: f32,
    alpha_square: f32,
    /// One over the square of Karis's width, over pi.
    peak: f32,
    albedo: f32,
    f0: f32,
    illuminance: f32,
}

impl Scene {
    /// The surface of `trial::gloss` with a roughness, under the Sun at `l`.
    pub fn new(l: Vec3, alpha: f32) -> Self {
        let width = (alpha + SUN_F32.sin / 2.0).min(1.0);
        let peak = FRAC_1_PI / (width * width);
        let (albedo, f0) = (ALBEDO as f32 * FRAC_1_PI, F0 as f32);
        Self { l, light: SUN_F32, alpha, alpha_square: alpha * alpha, peak, albedo, f0, illuminance: PI }
    }

    /// One channel of a pixel: Lambert, and GGX at the disc's nearest point with Karis's factor.
    #[inline]
    pub fn shade(&self, n: Vec3, v: Vec3) -> f32 {
        let n_dot_v = n.dot(v);
        if n_dot_v <= 0.0 {
            return 0.0;
        }
        let diffuse = self.albedo * n.dot(self.l).max(0.0);
        let p = cap(self.l, reflect(n, v), &self.light);
        let n_dot_l = n.dot(p);
        if n_dot_l <= 0.0 {
            return self.illuminance * diffuse;
        }
        let h = (p + v).normalize();
        let lean = n - h;
        let u = 0.5 * lean.length_squared();
        let (z, m) = (1.0 - u, u * (2.0 - u));
        let rest = z * z + m / self.alpha_square;
        let density = self.peak / (rest * rest);
        let toward = |cosine: f32| (self.alpha_square + (1.0 - self.alpha_square) * cosine * cosine).sqrt();
        let visibility = 0.5 / (n_dot_l * toward(n_dot_v) + n_dot_v * toward(n_dot_l));
        let missing = 1.0 - v.dot(h).min(1.0);
        let square = missing * missing;
        let fresnel = self.f0 + (1.0 - self.f0) * square * square * missing;
        self.illuminance * (diffuse + density * visibility * fresnel * n_dot_l)
    }

    /// The GGX width.
    pub fn alpha(&self) -> f32 {
        self.alpha
    }
}
