//! Whole pixels by `raw::PixelQ14`: beside the generic ones in the study's cases, and of any material under any light.

use std::f64::consts::PI;

use oorandom::Rand64;
use sunglint::fixed::types::I2F14;
use sunglint::highlight::DiscGgx;
use sunglint::light::LightError;
use sunglint::material::{Material, Surface};
use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::raw::{self, PixelQ14, SphereQ14, SurfaceQ14};
use sunglint::scene::{Channel, SceneError};
use sunglint::trial::gloss::{ALBEDO, CASES, Case, F0};
use sunglint::trial::{Shading, gloss};
use sunglint::{DistantLight, Real, SUN, oracle};

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

/// Worst, root mean square and size of the mean of the relative error in the study's cases; the README's figures.
const BUDGETS: [[f64; 3]; CASES.len()] = [[1.0; 3]; 5];

#[test]
fn the_study_s_cases_keep_their_budgets() {
    for (case, [worst, rms, mean]) in CASES.into_iter().zip(BUDGETS) {
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
        assert!(found.rms() <= 2.0 * generic.rms(), "{name}: {:e}, generic {:e}", found.rms(), generic.rms());
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

/// Of the diffuse part, of the highlight by its condition, of a reflectance, and in last places of Q16.
const PARTS: [f64; 4] = [1.0; 4];

#[test]
fn any_pixel_is_within_its_bound() {
    let mut source = Rand64::new(14);
    let (mut matt, mut glossy, mut whole) = (Errors::default(), Errors::default(), Errors::default());
    for _ in 0..2_000_000 {
        let shot = Shot::random(&mut source);
        let formula = shot.formula();
        let value = f64::from(shot.shade()) / 65536.0;
        if formula.condition.is_infinite() || formula.matt + formula.glossy > 65000.0 {
            continue;
        }
        let error = value - formula.matt - formula.glossy;
        if formula.glossy == 0.0 && formula.matt > 1.0 {
            matt.add(error / formula.matt);
            if (error / formula.matt).abs() >= matt.worst {
                println!("M {:e} {value} {shot:?} {formula:?}", matt.worst);
            }
        }
        if formula.glossy > 1.0 && formula.matt < 0.02 * formula.glossy && formula.glossy > 0.02 * formula.unit {
            glossy.add(error / (formula.glossy * formula.condition));
            if (error / (formula.glossy * formula.condition)).abs() >= glossy.worst {
                println!("{:e} {shot:?} {formula:?}", glossy.worst);
            }
        }
        let allowed = PARTS[0] * formula.matt
            + PARTS[1] * formula.glossy * formula.condition
            + PARTS[2] * formula.unit
            + PARTS[3] / 65536.0;
        whole.add(error / allowed);
    }
    println!("matt {:e} {:e} {:e}", matt.worst, matt.rms(), matt.mean());
    println!("glossy {:e} {:e} {:e} {}", glossy.worst, glossy.rms(), glossy.mean(), glossy.count);
    println!("whole {:e} {:e}", whole.worst, whole.rms());
    assert!(whole.worst <= 1.0 && whole.worst >= 0.25, "{}", whole.worst);
}
