//! Measures whole lit pixels: a highlight method in a format, on a surface under a light.
//!
//! A pixel is what [`Scene::shade_channel`] makes of a surface of albedo [`ALBEDO`] and reflectance [`F0`] under an
//! illuminance of pi, in which a white surface would be exactly white. Errors are relative to the pixel's true value.

use core::f64::consts::PI;

use oorandom::Rand64;

use super::found::Found;
use super::input::{on_sphere, turned};
use super::shading::{Make, Shading, ShadingVisitor};
use crate::highlight::Highlight;
use crate::light::{DistantLight, SUN};
use crate::oracle;
use crate::oracle::highlight::{Glossy, Pixel};
use crate::oracle::quadrature::Quadrature;
use crate::real::{Real, Scalar};
use crate::scene::{Channel, Lamp, Scene};
use crate::sphere::DistantSphere;

/// Diffuse reflectance of the surface that is lit: a dark wood, a wet road.
pub const ALBEDO: f64 = 0.2;

/// Its reflectance at normal incidence: that of glass.
pub const F0: f64 = 0.04;

/// A light and a roughness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// Name, as tables and charts print it.
    pub name: &'static str,
    /// The light.
    pub light: DistantLight,
    /// The GGX width.
    pub alpha: f64,
}

/// What the study shows and the budgets are for: the Sun on a polish, on varnish and on chalk, and two lamps.
pub const CASES: [Case; 5] = [
    Case { name: "Sun, alpha 0.001", light: SUN, alpha: 0.001 },
    Case { name: "Sun, alpha 0.0625", light: SUN, alpha: 0.0625 },
    Case { name: "Sun, alpha 1", light: SUN, alpha: 1.0 },
    Case { name: "lamp 0.05, alpha 0.01", light: lamp(0.05), alpha: 0.01 },
    Case { name: "lamp 0.3, alpha 0.1", light: lamp(0.3), alpha: 0.1 },
];

const fn lamp(ratio: f64) -> DistantLight {
    match DistantLight::from_ratio(ratio) {
        Ok(lamp) => lamp,
        Err(_) => panic!("a ratio lies within 0 to 1"),
    }
}

impl Case {
    /// The surface and the light as the oracle takes them, for a roughness and a reflectance that were rounded.
    fn glossy<T: Real>(&self) -> Glossy {
        let rounded = |value: f64| T::Scalar::nearest(value).exact();
        Glossy { alpha: rounded(self.alpha), f0: rounded(F0), ratio: self.light.sin() }
    }

    /// `count` random pixels: incidence up to 75 degrees, the mirror ray from a hundredth to ten times the highlight's
    /// width off the light's centre, evenly in the logarithm, the viewer at least 3 degrees above the surface, and all
    /// of it turned at random.
    pub fn pixels(&self, seed: u64, count: usize) -> impl Iterator<Item = Pixel> + use<> {
        let width = self.light.angular_radius() + 2.0 * self.alpha;
        pixels(seed, count, move |part| (width * libm::pow(10.0, 3.0 * part - 2.0)).min(1.5))
    }

    /// The same with the mirror ray between two angles in radians off the light's centre, evenly in the logarithm.
    pub fn pixels_off(seed: u64, count: usize, [least, most]: [f64; 2]) -> impl Iterator<Item = Pixel> {
        pixels(seed, count, move |part| least * libm::pow(most / least, part))
    }
}

/// Random pixels; `away` makes the angle between mirror ray and light of a number from 0 to 1.
fn pixels(seed: u64, count: usize, away: impl Fn(f64) -> f64) -> impl Iterator<Item = Pixel> {
    let mut source = Rand64::new(u128::from(seed));
    (0..).map(move |_| pixel(&mut source, &away)).filter(|pixel| cosine(pixel.n, pixel.v) > 0.05).take(count)
}

fn pixel(source: &mut Rand64, away: impl Fn(f64) -> f64) -> Pixel {
    let n = on_sphere(source);
    let l = turned(n, on_sphere(source), 75_f64.to_radians() * source.rand_float());
    let away = away(source.rand_float());
    let r = turned(l, on_sphere(source), away);
    let twice = 2.0 * cosine(n, r);
    Pixel { n, v: [0, 1, 2].map(|i| twice * n[i] - r[i]), l }
}

fn cosine(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A pixel in a format, and what that is exactly.
fn rounded<T: Real>(pixel: &Pixel) -> ([[T; 3]; 3], Pixel) {
    let lanes = [pixel.n, pixel.v, pixel.l].map(|vector| vector.map(T::from_f64));
    let [n, v, l] = lanes.map(|vector| vector.map(T::to_f64));
    (lanes, Pixel { n, v, l })
}

/// The diffuse part of a pixel's true value.
fn diffuse(case: &Case, pixel: &Pixel, albedo: f64) -> f64 {
    let pixel = pixel.unit();
    // Of unit vectors, but for a rounding.
    let n_dot_l = cosine(pixel.n, pixel.l).min(1.0);
    albedo * oracle::diffuse::relative_illuminance(n_dot_l, case.light.sin(), case.light.cos())
}

/// The exact value of a whole pixel by the method's own formula.
pub fn truth<T: Real>(shading: Shading, case: &Case, pixel: &Pixel) -> f64 {
    let albedo = T::Scalar::nearest(ALBEDO).exact();
    diffuse(case, pixel, albedo) + PI * shading.truth(&case.glossy::<T>(), pixel)
}

/// The true value of a whole pixel on the surface as it is in the format: the BRDF integrated over the disc.
pub fn integrated<T: Real, const N: usize>(case: &Case, pixel: &Pixel, rule: &Quadrature<N>) -> f64 {
    let albedo = T::Scalar::nearest(ALBEDO).exact();
    diffuse(case, pixel, albedo) + PI * rule.highlight(&case.glossy::<T>(), pixel)
}

/// Relative arithmetic error of whole pixels: computed against the exact value of the method's formula at the rounded
/// inputs.
pub fn arithmetic<T: Real>(shading: Shading, case: &Case, pixels: impl Iterator<Item = Pixel>) -> Found<9> {
    arithmetic_of_code::<T>(shading, case, pixels, |lanes| level(shading, case, lanes))
}

/// What a method makes of a whole pixel: of normal, viewer and light.
pub fn level<T: Real>(shading: Shading, case: &Case, [n, v, l]: [[T; 3]; 3]) -> f64 {
    shading.visit(Whole { case, n, v, l })
}

/// The same of `code`, which makes a level of normal, viewer and light in its own way.
pub fn arithmetic_of_code<T: Real>(
    shading: Shading,
    case: &Case,
    pixels: impl Iterator<Item = Pixel>,
    code: impl Fn([[T; 3]; 3]) -> f64,
) -> Found<9> {
    let mut found = Found::new();
    for pixel in pixels {
        let (lanes, exact) = rounded::<T>(&pixel);
        let value = code(lanes);
        let truth = truth::<T>(shading, case, &exact);
        found.add_signed(value / truth - 1.0, inputs(&exact));
    }
    found
}

/// Shades a whole pixel.
struct Whole<'a, T> {
    case: &'a Case,
    n: [T; 3],
    v: [T; 3],
    l: [T; 3],
}

impl<T: Real> ShadingVisitor<T> for Whole<'_, T> {
    type Output = f64;

    fn visit<H: Highlight<T> + 'static>(self, method: Make<T, H>) -> f64 {
        let shaded = scene(self.case, self.l, method).map(|scene| scene.shade_channel(self.n, self.v, Channel::Green));
        shaded.map_or(f64::NAN, |level| T::of_level(level).exact())
    }
}

/// Relative error that rounding directions, roughness and reflectances into the format makes by itself.
pub fn input<T: Real>(shading: Shading, case: &Case, pixels: impl Iterator<Item = Pixel>) -> Found<9> {
    let mut found = Found::new();
    for pixel in pixels {
        let (_, exact) = rounded::<T>(&pixel);
        let ratio = truth::<T>(shading, case, &exact) / truth::<f64>(shading, case, &pixel);
        found.add_signed(ratio - 1.0, inputs(&exact));
    }
    found
}

/// The truth: the whole pixel with the BRDF integrated over the disc, at the directions, the roughness and the
/// reflectances as the format holds them.
pub fn integral<T: Real, const N: usize>(case: &Case, pixel: &Pixel, rule: &Quadrature<N>) -> f64 {
    let (_, exact) = rounded::<T>(pixel);
    integrated::<T, N>(case, &exact, rule)
}

/// Relative error of the methods' formulas themselves, in the order of [`Shading::ALL`]: their exact values against the
/// [`integral`] in f64, which comes with each pixel.
pub fn models(case: &Case, pixels: impl Iterator<Item = (Pixel, f64)>) -> [Found<9>; Shading::ALL.len()] {
    let mut found = [Found::new(); Shading::ALL.len()];
    for (pixel, integral) in pixels {
        for (found, shading) in found.iter_mut().zip(Shading::ALL) {
            found.add_signed(truth::<f64>(shading, case, &pixel) / integral - 1.0, inputs(&pixel));
        }
    }
    found
}

/// A whole pixel of inputs that the format `T` holds: by the method's own formula, and by the BRDF integrated over the
/// disc.
pub fn truths<T: Real, const N: usize>(shading: Shading, case: &Case, pixel: &Pixel, rule: &Quadrature<N>) -> [f64; 2] {
    [truth::<T>(shading, case, pixel), integrated::<T, N>(case, pixel, rule)]
}

fn inputs(&Pixel { n, v, l }: &Pixel) -> [f64; 9] {
    [n[0], n[1], n[2], v[0], v[1], v[2], l[0], l[1], l[2]]
}

/// The scene of `case` in a format, with one light at `l`; `None` where `l` is no direction.
pub fn scene<T: Real, H: Highlight<T>>(case: &Case, l: [T; 3], method: Make<T, H>) -> Option<Scene<T, 1, H>> {
    let scalar = T::Scalar::nearest;
    let surface = crate::material::Surface::new([scalar(ALBEDO); 3], scalar(case.alpha), [scalar(F0); 3]).ok()?;
    let mut scene = Scene::with_highlight(&surface, method);
    let lamp = Lamp::new(l, DistantSphere::of(&case.light), [T::level(scalar(PI)); 3]).ok()?;
    scene.push(&lamp).ok()?;
    Some(scene)
}

/// Which methods share a row of budgets: those at one point of the disc do the same arithmetic, but [`Shading::None`]
/// leaves the range of U16F16.
pub const fn family(method: Shading) -> usize {
    match method {
        Shading::None => 0,
        Shading::Karis | Shading::KarisThird | Shading::ExactRp => 1,
        Shading::DiscGgx => 2,
        Shading::Directional => 3,
        Shading::ConeGgx => 4,
        Shading::Shifted => 5,
    }
}

/// How many families there are.
const FAMILIES: usize = 6;

/// Budgets for f64, f32, micromath, f16, I2F14, I2F30 and I16F16.
type Formats = [f64; 7];

/// Worst, root mean square and size of the mean of the relative error of [`PixelQ14`](crate::raw::PixelQ14) in each of
/// [`CASES`] (`tests/pixel_q14.rs`).
pub const PIXEL_Q14: [[f64; 3]; CASES.len()] = [
    [1.1e-1, 4.4e-3, 6.0e-5],
    [3.0e-3, 2.0e-4, 6.0e-5],
    [2.4e-4, 4.4e-5, 2.0e-5],
    [1.5e-2, 4.3e-4, 2.0e-5],
    [7.5e-4, 7.0e-5, 2.0e-5],
];

/// Greatest relative arithmetic error of [`arithmetic`], by [`family`], case and format: 1.12 times the worst of 50 000
/// pixels from each of the seeds 1 to 3, rounded up to two digits (an ignored test of `tests/gloss.rs` prints it
/// again).
pub const MAXIMA: [[Formats; CASES.len()]; FAMILIES] = [
    [
        [1.3e-12, 3.0e-4, 2.8e-4, 2.8e0, 8.4e-1, 5.2e-6, 8.4e-1],
        [2.9e-14, 4.8e-6, 2.3e-5, 4.4e-2, 5.3e-3, 9.9e-8, 1.6e-3],
        [2.0e-15, 8.2e-7, 7.9e-6, 6.4e-3, 1.9e-4, 5.8e-9, 1.6e-4],
        [1.9e-13, 2.6e-5, 6.7e-5, 2.7e-1, 3.1e-2, 5.0e-7, 8.9e-3],
        [8.0e-11, 4.6e-6, 1.3e-4, 6.0e-2, 7.7e-3, 1.2e-7, 2.1e-3],
    ],
    [
        [1.3e-12, 3.0e-4, 2.8e-4, 2.8e0, 3.1e-1, 5.2e-6, 7.6e-2],
        [2.9e-14, 4.9e-6, 2.4e-5, 4.4e-2, 5.3e-3, 1.0e-7, 1.6e-3],
        [2.0e-15, 8.4e-7, 1.5e-5, 6.5e-3, 2.1e-4, 5.8e-9, 1.6e-4],
        [1.9e-13, 2.6e-5, 6.7e-5, 2.7e-1, 3.1e-2, 5.0e-7, 8.9e-3],
        [8.1e-11, 4.4e-6, 1.3e-4, 6.2e-2, 7.7e-3, 1.2e-7, 2.1e-3],
    ],
    [
        [6.6e-13, 1.6e-4, 1.8e-4, 1.5e0, 1.4e-1, 2.6e-6, 3.8e-2],
        [2.2e-14, 4.1e-6, 3.0e-5, 3.1e-2, 5.1e-3, 6.2e-8, 1.2e-3],
        [4.4e-15, 6.3e-7, 1.3e-5, 6.3e-3, 2.0e-4, 4.8e-9, 1.6e-4],
        [9.9e-14, 1.5e-5, 6.6e-5, 1.3e-1, 1.6e-2, 2.9e-7, 3.9e-3],
        [8.0e-11, 1.6e-6, 4.4e-5, 1.5e-2, 1.2e-3, 2.0e-8, 2.7e-4],
    ],
    [
        [1.6e-12, 3.3e-4, 4.0e-4, 4.8e0, 9.2e-2, 1.5e-6, 1.9e-2],
        [2.2e-14, 4.1e-6, 3.1e-5, 3.0e-2, 5.1e-3, 6.1e-8, 1.2e-3],
        [4.3e-15, 6.9e-7, 1.3e-5, 6.3e-3, 2.0e-4, 5.2e-9, 1.6e-4],
        [1.9e-13, 3.8e-5, 1.6e-4, 2.2e-1, 8.3e-3, 1.6e-7, 1.8e-3],
        [8.0e-11, 4.6e-6, 1.1e-4, 5.1e-2, 7.8e-4, 1.9e-8, 2.2e-4],
    ],
    [
        [1.0e-12, 1.5e-4, 2.0e-4, 2.5e0, 1.3e-1, 4.7e-7, 2.0e-2],
        [2.3e-14, 4.4e-6, 3.4e-5, 3.2e-2, 5.0e-3, 6.0e-8, 1.1e-3],
        [3.0e-15, 5.4e-7, 1.3e-5, 3.9e-3, 2.2e-4, 4.9e-9, 1.6e-4],
        [1.4e-13, 1.7e-5, 8.4e-5, 1.4e-1, 6.5e-3, 3.2e-8, 1.8e-3],
        [8.0e-11, 2.1e-6, 4.7e-5, 1.8e-2, 4.2e-4, 1.6e-8, 1.7e-4],
    ],
    [
        [1.0e-12, 1.5e-4, 1.9e-4, 2.5e0, 1.3e-1, 4.7e-7, 2.0e-2],
        [2.0e-14, 4.7e-6, 3.4e-5, 3.1e-2, 5.0e-3, 5.9e-8, 1.1e-3],
        [3.3e-15, 6.2e-7, 1.4e-5, 4.1e-3, 2.2e-4, 4.8e-9, 1.6e-4],
        [1.3e-13, 1.8e-5, 7.9e-5, 1.4e-1, 6.5e-3, 3.1e-8, 1.8e-3],
        [8.0e-11, 2.3e-6, 4.4e-5, 1.9e-2, 4.4e-4, 1.6e-8, 1.7e-4],
    ],
];

/// Root mean square of the same, likewise.
pub const MEANS: [[Formats; CASES.len()]; FAMILIES] = [
    [
        [5.2e-14, 1.5e-5, 1.7e-5, 2.2e-1, 1.6e-1, 2.2e-7, 1.6e-1],
        [1.5e-15, 4.1e-7, 7.7e-6, 3.4e-3, 3.1e-4, 6.1e-9, 7.9e-5],
        [2.5e-16, 8.1e-8, 1.2e-6, 6.8e-4, 4.2e-5, 8.2e-10, 3.6e-5],
        [5.0e-15, 1.4e-6, 8.3e-6, 1.2e-2, 1.1e-3, 2.1e-8, 2.8e-4],
        [3.1e-12, 2.9e-7, 7.5e-6, 2.4e-3, 1.7e-4, 3.1e-9, 4.7e-5],
    ],
    [
        [5.1e-14, 1.5e-5, 1.8e-5, 1.7e-1, 1.2e-2, 2.2e-7, 2.9e-3],
        [1.5e-15, 4.2e-7, 8.6e-6, 3.4e-3, 3.1e-4, 6.5e-9, 7.9e-5],
        [2.5e-16, 8.1e-8, 2.4e-6, 6.8e-4, 4.2e-5, 8.2e-10, 3.6e-5],
        [4.6e-15, 1.3e-6, 1.2e-5, 1.1e-2, 1.1e-3, 2.0e-8, 2.7e-4],
        [3.4e-12, 2.7e-7, 1.2e-5, 2.0e-3, 1.5e-4, 2.9e-9, 4.3e-5],
    ],
    [
        [3.6e-14, 1.1e-5, 1.6e-5, 8.4e-2, 4.6e-3, 7.3e-8, 1.2e-3],
        [1.4e-15, 3.8e-7, 1.1e-5, 3.2e-3, 1.9e-4, 3.2e-9, 5.0e-5],
        [3.0e-16, 7.7e-8, 2.2e-6, 6.5e-4, 4.2e-5, 8.2e-10, 3.5e-5],
        [3.1e-15, 8.9e-7, 9.0e-6, 7.1e-3, 4.1e-4, 6.8e-9, 1.1e-4],
        [3.5e-12, 1.7e-7, 4.4e-6, 1.5e-3, 5.9e-5, 1.5e-9, 2.6e-5],
    ],
    [
        [4.8e-14, 1.2e-5, 1.7e-5, 1.1e-1, 3.0e-3, 4.5e-8, 7.6e-4],
        [1.4e-15, 3.8e-7, 1.1e-5, 3.2e-3, 1.9e-4, 3.2e-9, 5.0e-5],
        [3.0e-16, 7.7e-8, 2.2e-6, 6.5e-4, 4.2e-5, 8.2e-10, 3.5e-5],
        [4.4e-15, 1.1e-6, 8.7e-6, 8.5e-3, 2.4e-4, 4.1e-9, 6.5e-5],
        [3.4e-12, 1.9e-7, 4.6e-6, 1.7e-3, 5.5e-5, 1.5e-9, 2.5e-5],
    ],
    [
        [4.4e-14, 1.1e-5, 1.8e-5, 9.3e-2, 2.2e-3, 2.7e-8, 4.9e-4],
        [1.4e-15, 3.4e-7, 1.3e-5, 2.8e-3, 1.7e-4, 2.8e-9, 4.6e-5],
        [2.9e-16, 7.9e-8, 2.2e-6, 6.7e-4, 4.4e-5, 8.7e-10, 3.6e-5],
        [4.0e-15, 9.9e-7, 1.1e-5, 7.8e-3, 1.3e-4, 2.6e-9, 3.6e-5],
        [3.4e-12, 1.5e-7, 6.2e-6, 1.3e-3, 3.5e-5, 1.3e-9, 2.3e-5],
    ],
    [
        [4.4e-14, 1.1e-5, 1.7e-5, 9.3e-2, 2.2e-3, 2.7e-8, 4.9e-4],
        [1.3e-15, 3.6e-7, 1.1e-5, 2.8e-3, 1.7e-4, 2.9e-9, 4.6e-5],
        [2.6e-16, 8.0e-8, 2.0e-6, 6.7e-4, 4.4e-5, 8.7e-10, 3.6e-5],
        [4.0e-15, 9.9e-7, 9.8e-6, 7.9e-3, 1.4e-4, 2.6e-9, 3.7e-5],
        [3.4e-12, 1.6e-7, 5.5e-6, 1.5e-3, 4.3e-5, 1.4e-9, 2.4e-5],
    ],
];
