//! Surfaces and pixels off bytes, in the places that are hard for a highlight.

use core::f64::consts::{FRAC_PI_2, PI};

use crate::light::DistantLight;
use crate::material::LEAST_ALPHA;
use crate::oracle::highlight::Pixel;
use crate::trial::draw::Draw;

/// A roughness that a material may have: a mirror, the least, the greatest, and all between.
pub fn alpha(draw: &mut Draw<'_>) -> f64 {
    match draw.byte() % 8 {
        0 => draw.one_of([0.0, LEAST_ALPHA, 1.0, 1e-3]),
        1 => draw.between(0.5, 1.0),
        _ => draw.logarithmic(LEAST_ALPHA, 1.0),
    }
}

/// Normal, viewer and light. Mostly the light somewhere above the surface and the mirror ray about its disc, in widths
/// of its highlight; else all three anywhere, or two of them the same or opposite.
pub fn pixel(draw: &mut Draw<'_>, light: &DistantLight, alpha: f64) -> Pixel {
    let n = draw.direction();
    match draw.byte() % 16 {
        0 => Pixel { n, v: draw.direction(), l: draw.direction() },
        1 => {
            let v = draw.direction();
            Pixel { n, v, l: v }
        }
        2 => {
            let v = draw.direction();
            Pixel { n, v, l: v.map(|lane| -lane) }
        }
        3 => {
            // Beside the viewer's opposite, where the half vector may be anything.
            let v = draw.direction();
            let off = draw.logarithmic(1e-6, 1.0);
            Pixel { n, v, l: draw.turned(v.map(|lane| -lane), off) }
        }
        _ => reflecting(draw, light, alpha, n),
    }
}

fn reflecting(draw: &mut Draw<'_>, light: &DistantLight, alpha: f64, n: [f64; 3]) -> Pixel {
    let incidence = match draw.byte() % 8 {
        0 => 0.0,
        1 => draw.between(0.0, PI),
        2 => FRAC_PI_2 + draw.one_of([-1.0, 1.0]) * draw.logarithmic(1e-6, 1e-1),
        3 => FRAC_PI_2 - draw.logarithmic(1e-3, 1.0),
        _ => draw.between(0.0, FRAC_PI_2),
    };
    let l = draw.turned(n, incidence);
    let theta = light.angular_radius();
    let r = match draw.byte() % 4 {
        0 => draw.beside(l, theta),
        1 => {
            let away = draw.logarithmic(1e-2, 1e3) * alpha;
            draw.turned(l, away.min(PI))
        }
        2 => {
            // Where a narrow highlight falls off, beside the rim.
            let away = theta + draw.between(-4.0, 4.0) * alpha;
            draw.turned(l, away.clamp(0.0, PI))
        }
        _ => l,
    };
    Pixel { n, v: mirrored(n, r), l }
}

/// The direction whose mirror image about `n` is `r`.
pub fn mirrored(n: [f64; 3], r: [f64; 3]) -> [f64; 3] {
    let twice = 2.0 * cosine(n, r);
    [0, 1, 2].map(|i| twice * n[i] - r[i])
}

/// The dot product in f64.
pub fn cosine(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
