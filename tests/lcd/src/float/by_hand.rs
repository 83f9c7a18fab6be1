//! A lit pixel as one writes it down in f32: the formula of `PixelQ14` with nothing for the ends of the range.

use core::f32::consts::{FRAC_1_PI, PI};

use libm::sqrtf;

use super::Lit;

/// One minus the cosine of the Sun's radius of 4.65e-3 radians.
const VERSINE: f32 = 1.081_348e-5;

/// A material in the Sun: Lambert, and GGX averaged over the disc with Smith's shadowing and Schlick's reflectance.
pub struct ByHand {
    albedo: [f32; 3],
    alpha_square: f32,
    f0: f32,
    sun: [f32; 3],
    illuminance: f32,
}

impl Lit for ByHand {
    fn new(albedo: [f32; 3], alpha: f32, f0: f32, sun: [f32; 3], illuminance: f32) -> Option<Self> {
        Some(Self { albedo, alpha_square: alpha * alpha, f0, sun, illuminance })
    }

    fn shade(&self, n: [f32; 3], v: [f32; 3]) -> [f32; 3] {
        let (n_dot_l, n_dot_v) = (dot(n, self.sun), dot(n, v));
        if n_dot_l <= 0.0 || n_dot_v <= 0.0 {
            return [0.0; 3];
        }
        let sum = [self.sun[0] + v[0], self.sun[1] + v[1], self.sun[2] + v[2]];
        let square = dot(sum, sum);
        let length = sqrtf(square);
        let missing = 1.0 - 0.5 * length;
        let missing_square = missing * missing;
        let fresnel = self.f0 + (1.0 - self.f0) * (missing_square * missing_square * missing);
        let gloss = self.distribution(n, sum, n_dot_l + n_dot_v, length) * self.shadow(n_dot_l, n_dot_v) * fresnel;
        let light = self.illuminance * n_dot_l;
        self.albedo.map(|albedo| (albedo * FRAC_1_PI + gloss) * light)
    }
}

impl ByHand {
    /// GGX over the disc; for a disc that is narrower than the lobe no difference in it cancels.
    fn distribution(&self, n: [f32; 3], sum: [f32; 3], upright: f32, length: f32) -> f32 {
        let tilt = cross(n, sum);
        let rough = self.alpha_square * upright * upright;
        let disc = VERSINE * length;
        let p = rough + dot(tilt, tilt) - disc;
        let h = sqrtf(p * p + 4.0 * rough * disc);
        let square = length * length;
        2.0 * self.alpha_square * square * square / (PI * h * (h + p))
    }

    /// Smith's, over four times the cosines.
    fn shadow(&self, n_dot_l: f32, n_dot_v: f32) -> f32 {
        let root = |cosine: f32| sqrtf(cosine * cosine + self.alpha_square * (1.0 - cosine * cosine));
        0.5 / (n_dot_l * root(n_dot_v) + n_dot_v * root(n_dot_l))
    }
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
