//! Whole pixels by `raw::PixelQ14`: beside the generic ones in the study's cases, and of any material under any light.

use std::f64::consts::PI;

use oorandom::Rand64;
use sunglint::fixed::types::I2F14;
use sunglint::material::{Material, Surface};
use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::raw::{PixelQ14, SUN_Q14, SphereQ14, SurfaceQ14};
use sunglint::scene::{Channel, SceneError};
use sunglint::trial::gloss::{ALBEDO, CASES, Case, F0};
use sunglint::trial::{Shading, gloss};
use sunglint::{DistantLight, Real, oracle};

/// Pi in Q16, under which a white surface is white.
const PI_Q16: u32 = 205_887;

/// Worst, root mean square and mean.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    worst: f64,
    square: f64,
    sum: f64,
    count: f64,
}

impl Errors {
    fn add(&mut self, error: f64) {
        assert!(error.is_finite());
        self.worst = self.worst.max(error.abs());
        self.square += error * error;
        self.sum += error;
        self.count += 1.0;
    }

    fn rms(&self) -> f64 {
        (self.square / self.count).sqrt()
    }

    fn mean(&self) -> f64 {
        self.sum / self.count
    }
}

fn q14(v: [f64; 3]) -> [i16; 3] {
    v.map(|lane| I2F14::from_f64(lane).to_bits())
}

fn exact(v: [i16; 3]) -> [f64; 3] {
    v.map(|lane| f64::from(lane) / 16384.0)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The exact value of a case's pixel by the method's formula.
fn truth(case: &Case, pixel: &Pixel) -> f64 {
    let unit = pixel.unit();
    let matt = oracle::diffuse::relative_illuminance(dot(unit.n, unit.l).min(1.0), case.light.sin(), case.light.cos());
    let glossy = Glossy { alpha: case.alpha, f0: F0, ratio: case.light.sin() };
    ALBEDO * matt + PI * Shading::DiscGgx.truth(&glossy, pixel)
}

fn surface(case: &Case) -> SurfaceQ14 {
    Surface::of(&Material::new([ALBEDO; 3], case.alpha, [F0; 3]).unwrap())
}

fn of_case(case: &Case, count: usize) -> Errors {
    let (surface, light) = (surface(case), SphereQ14::new(&case.light));
    let mut errors = Errors::default();
    for pixel in case.pixels(1, count) {
        let [n, v, l] = [pixel.n, pixel.v, pixel.l].map(q14);
        let shader = PixelQ14::new(l, &light, &surface, [PI_Q16; 3]).unwrap();
        let value = f64::from(shader.shade_channel(n, v, Channel::Green)) / 65536.0;
        let [n, v, l] = [n, v, l].map(exact);
        errors.add(value / truth(case, &Pixel { n, v, l }) - 1.0);
    }
    errors
}

#[test]
fn the_study_s_cases_keep_their_budgets() {
    for (case, [worst, rms, mean]) in CASES.into_iter().zip(gloss::PIXEL_Q14) {
        let found = of_case(&case, 20_000);
        let generic = gloss::arithmetic::<I2F14>(Shading::DiscGgx, &case, case.pixels(1, 20_000));
        println!(
            "{:24} worst {:.2e} rms {:.2e} mean {:+.2e}; generic worst {:.2e} rms {:.2e}",
            case.name,
            found.worst,
            found.rms(),
            found.mean(),
            generic.max,
            generic.rms()
        );
        let name = case.name;
        for (what, found, budget) in [("worst", found.worst, worst), ("rms", found.rms(), rms)] {
            assert!(found <= budget && found >= budget / 4.0, "{name}: {what} {found:e}, budget {budget:e}");
        }
        assert!(found.mean().abs() <= mean, "{name}: mean {:e}", found.mean());
        assert!(found.rms() <= 1.3 * generic.rms(), "{name}: {:e}, generic {:e}", found.rms(), generic.rms());
    }
}

/// One light on one material, and a pixel.
#[derive(Clone, Copy, Debug)]
struct Shot {
    alpha: f64,
    ratio: f64,
    albedo: f64,
    f0: f64,
    illuminance: u32,
    n: [i16; 3],
    v: [i16; 3],
    l: [i16; 3],
}

impl Shot {
    fn random(source: &mut Rand64) -> Self {
        let logarithmic = |source: &mut Rand64, from: f64, to: f64| from * (to / from).powf(source.rand_float());
        let direction = |source: &mut Rand64| loop {
            let v = [(); 3].map(|()| 2.0 * source.rand_float() - 1.0);
            if (0.01..1.0).contains(&dot(v, v)) {
                return v.map(|lane| lane / dot(v, v).sqrt());
            }
        };
        let alpha = if source.rand_range(0..16) == 0 { 0.0 } else { logarithmic(source, 5e-4, 1.0) };
        let ratio = [0.0, 1.0, logarithmic(source, 1e-5, 1.0)][source.rand_range(0..32).min(2) as usize];
        // As the light's constants have it.
        let ratio = (ratio * 2_f64.powi(28)).round() / 2_f64.powi(28);
        let (n, l) = (direction(source), direction(source));
        let mirror = [0, 1, 2].map(|i| 2.0 * dot(n, l) * n[i] - l[i]);
        let aside = direction(source);
        let away = logarithmic(source, 1e-2, 10.0) * (ratio + 2.0 * alpha);
        let beside = [0, 1, 2].map(|i| mirror[i] + away * aside[i]);
        let beside = beside.map(|lane| lane / dot(beside, beside).sqrt());
        let v = if source.rand_range(0..2) == 0 { beside } else { direction(source) };
        Self {
            alpha,
            ratio,
            albedo: source.rand_float(),
            f0: source.rand_float(),
            illuminance: logarithmic(source, 256.0, 1e9) as u32,
            n: q14(n),
            v: q14(v),
            l: q14(l),
        }
    }

    fn shader(&self) -> PixelQ14 {
        let surface = Surface::of(&Material::new([self.albedo; 3], self.alpha, [self.f0; 3]).unwrap());
        let light = SphereQ14::new(&DistantLight::from_ratio(self.ratio).unwrap());
        PixelQ14::new(self.l, &light, &surface, [self.illuminance; 3]).unwrap()
    }

    fn shade(&self) -> u32 {
        self.shader().shade_channel(self.n, self.v, Channel::Green)
    }

    /// The formula in f64 at the vectors as they are, and by how much an error of a part of its terms may move it.
    fn formula(&self) -> Formula {
        let [n, v, l] = [self.n, self.v, self.l].map(exact);
        let (n_dot_l, n_dot_v) = (dot(n, l), dot(n, v));
        let least = 1.0 / 16384.0;
        let e = f64::from(self.illuminance) / 65536.0;
        let (sin, cos) = (self.ratio, (1.0 - self.ratio * self.ratio).sqrt());
        let visible = n_dot_v > 0.0;
        let share = match n_dot_l {
            above if above >= sin => above,
            below if below <= -sin => 0.0,
            _ => oracle::diffuse::relative_illuminance(n_dot_l, sin, cos),
        };
        let matt = if visible { self.albedo / PI * e * share } else { 0.0 };
        if n_dot_l <= least || n_dot_v <= least {
            return Formula { matt, glossy: 0.0, unit: 0.0, condition: 1.0 };
        }
        let s = [0, 1, 2].map(|i| l[i] + v[i]);
        let c = [0, 1, 2].map(|i| n[(i + 1) % 3] * s[(i + 2) % 3] - n[(i + 2) % 3] * s[(i + 1) % 3]);
        let (square, a) = (dot(s, s), self.alpha * self.alpha);
        let w = sin * sin / (1.0 + cos);
        let v_dot_h = square.sqrt() / 2.0;
        let (m, z2, t) = (dot(c, c) / square, (n_dot_l + n_dot_v).powi(2) / square, w / (2.0 * v_dot_h));
        let p = a * z2 + m - t;
        let r = p.hypot(2.0 * (a * z2 * t).sqrt());
        let d = if p < 0.0 { (r - p) / (2.0 * PI * t * z2 * r) } else { 2.0 * a / (PI * r * (r + p)) };
        let root = |c: f64| (c * c + a * (1.0 - c * c).max(0.0)).sqrt();
        let visibility = n_dot_l / (2.0 * (n_dot_l * root(n_dot_v) + n_dot_v * root(n_dot_l)));
        let fresnel = self.f0 + (1.0 - self.f0) * (1.0 - v_dot_h).max(0.0).powi(5);
        let unit = if r > 0.0 { e * d * visibility / (1.0 - w / 2.0) } else { 0.0 };
        // Cosines of Smith's roots are squared in Q30.
        let least = n_dot_l.min(n_dot_v);
        let coarse = 2_f64.powi(-20) / (least * least + a);
        let condition = if r > 0.0 { 1.0 + coarse + (a * z2 + m + t) / r } else { f64::INFINITY };
        Formula { matt, glossy: unit * fresnel, unit, condition }
    }
}

#[derive(Clone, Copy, Debug)]
struct Formula {
    matt: f64,
    glossy: f64,
    /// The highlight of a reflectance of 1.
    unit: f64,
    condition: f64,
}

/// Of the diffuse part, of the highlight by its condition, of what that would be with a reflectance of 1, and in last
/// places of Q16.
const PARTS: [f64; 4] = [6.0e-5, 6.0e-4, 2.0e-5, 0.6];

#[test]
fn any_pixel_is_within_its_bound() {
    let mut source = Rand64::new(14);
    let (mut matt, mut glossy, mut whole) = (Errors::default(), Errors::default(), Errors::default());
    for _ in 0..1_000_000 {
        let shot = Shot::random(&mut source);
        let formula = shot.formula();
        let value = shot.shade();
        let sum = formula.matt + formula.glossy;
        // The rim of a mirror's image is a step.
        if formula.condition.is_infinite() {
            continue;
        }
        let part = PARTS[0] * formula.matt + PARTS[1] * formula.glossy * formula.condition + PARTS[2] * formula.unit;
        if sum - part >= 65536.0 {
            assert_eq!(value, u32::MAX, "{shot:?}");
            continue;
        }
        let error = f64::from(value) / 65536.0 - sum.min(65536.0);
        let ratio = error / (part + PARTS[3] / 65536.0);
        assert!(ratio.abs() <= 1.0, "{ratio} of {shot:?}, {formula:?}");
        whole.add(ratio);
        // Where one of the parts is alone.
        if formula.glossy == 0.0 && formula.matt > 4.0 {
            matt.add(error / formula.matt);
        }
        if formula.glossy > 4.0 && formula.matt < 0.01 * formula.glossy && formula.glossy > 0.1 * formula.unit {
            glossy.add(error / (formula.glossy * formula.condition));
        }
    }
    println!("matt {:e} {:e} {:+e} of {}", matt.worst, matt.rms(), matt.mean(), matt.count);
    println!("glossy {:e} {:e} {:+e} of {}", glossy.worst, glossy.rms(), glossy.mean(), glossy.count);
    println!("whole {:e} {:e}", whole.worst, whole.rms());
    assert!(matt.count > 5_000.0 && matt.worst >= PARTS[0] / 4.0, "{matt:?}");
    assert!(glossy.count > 10_000.0 && glossy.worst >= PARTS[1] / 4.0, "{glossy:?}");
    assert!(glossy.rms() <= 4.5e-5 && glossy.mean().abs() <= 2.5e-5, "{glossy:?}");
    assert!(whole.worst >= 0.25, "{whole:?}");
}

/// Debug assertions find what wraps without saying so.
#[test]
fn any_bits_give_some_colour() {
    let mut source = Rand64::new(15);
    let any = |source: &mut Rand64| {
        [(); 3].map(|()| {
            [source.rand_u64() as i16, i16::MIN, i16::MAX, 0, 1, -1][source.rand_range(0..20).min(5) as usize]
        })
    };
    for _ in 0..300_000 {
        let shot = Shot::random(&mut source);
        let shader = shot.shader();
        let (n, v) = (any(&mut source), any(&mut source));
        let colour = shader.shade(n, v);
        assert_eq!(colour, [Channel::Red, Channel::Green, Channel::Blue].map(|c| shader.shade_channel(n, v, c)));
        let behind = shot.v.map(|lane| -lane);
        if dot(exact(shot.n), exact(shot.v)) >= 0.0 {
            assert_eq!(shader.shade(shot.n, behind), [0; 3], "{shot:?}");
        }
    }
}

#[test]
fn more_light_is_never_darker_but_for_rounding() {
    let mut source = Rand64::new(16);
    for _ in 0..20_000 {
        let mut shot = Shot::random(&mut source);
        let mut before = 0;
        for bit in 8..32 {
            shot.illuminance = 1 << bit;
            let value = shot.shade();
            assert!(value >= before, "{before} {value} {shot:?}");
            // Twice the light is twice as bright.
            if before > 1 << 16 && value < u32::MAX {
                let ratio = f64::from(value) / f64::from(before);
                assert!((ratio - 2.0).abs() < 1e-4, "{ratio} {shot:?}");
            }
            before = value;
        }
    }
}

/// The channels differ in reflectance and illuminance alone.
#[test]
fn each_channel_is_its_own() {
    let colours = ([0.1, 0.2, 0.3], [0.02, 0.04, 0.9], [65_536, 131_072, 400_000]);
    let coloured = Surface::of(&Material::new(colours.0, 0.1, colours.1).unwrap());
    let (n, v, l) = ([0, 0, 16384], [-9000, 0, 13691], [9830, 0, 13107]);
    let together = PixelQ14::new(l, &SUN_Q14, &coloured, colours.2).unwrap().shade(n, v);
    for (channel, expected) in together.into_iter().enumerate() {
        let grey = Surface::of(&Material::new([colours.0[channel]; 3], 0.1, [colours.1[channel]; 3]).unwrap());
        let alone = PixelQ14::new(l, &SUN_Q14, &grey, [colours.2[channel]; 3]).unwrap().shade(n, v);
        assert_eq!(alone, [expected; 3]);
    }
}

/// Of a point at the zenith, worked out by hand: `n`, `v`, `l` and `h` are one, so `D = 1 / (pi alpha^2)`, `V = 1/4`,
/// `F = f0`; and on a mirror under a point there is no highlight.
#[test]
fn known_pixels() {
    let up = [0, 0, 16384];
    let point = SphereQ14::new(&DistantLight::from_ratio(0.0).unwrap());
    let shade = |alpha: f64| {
        let surface = Surface::of(&Material::new([0.5; 3], alpha, [0.25; 3]).unwrap());
        PixelQ14::new(up, &point, &surface, [PI_Q16; 3]).unwrap().shade_channel(up, up, Channel::Red)
    };
    // 1/2 and 1/16 over alpha^2.
    let rough = f64::from(shade(0.5)) / 65536.0;
    assert!((rough / 0.75 - 1.0).abs() < 1e-4, "{rough}");
    let mirror = f64::from(shade(0.0)) / 65536.0;
    assert!((mirror / 0.5 - 1.0).abs() < 1e-4, "{mirror}");
}

#[test]
fn a_light_beyond_half_the_sky_is_one() {
    let light = SphereQ14::new(&DistantLight::from_angle(270.0).unwrap());
    let surface = Surface::of(&Material::new([1.0; 3], 1.0, [0.0; 3]).unwrap());
    let shade = |n: [i16; 3]| {
        let pixel = PixelQ14::new([0, 0, 16384], &light, &surface, [PI_Q16; 3]).unwrap();
        f64::from(pixel.shade_channel(n, n, Channel::Red)) / 65536.0
    };
    // White all over, and what is below the horizon sees the other half.
    assert!(shade([0, 0, 16384]) > 0.999 && shade([16384, 0, 0]) > 0.5 && shade([0, 0, -16384]) > 0.0);
}

#[test]
fn a_direction_that_is_none_is_refused() {
    let surface = surface(&CASES[1]);
    for direction in [[0, 0, 0], [0, 0, 14000], [16384, 16384, 0]] {
        assert!(matches!(PixelQ14::new(direction, &SUN_Q14, &surface, [1; 3]), Err(SceneError::Direction(_))));
    }
}
