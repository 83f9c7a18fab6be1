//! Whole pixels by `raw::PixelQ14`, and beside them the generic ones.

use std::f64::consts::PI;

use sunglint::fixed::types::I2F14;
use sunglint::material::{Material, Surface};
use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::raw::{self, PixelQ14, SphereQ14};
use sunglint::scene::Channel;
use sunglint::trial::gloss::{ALBEDO, CASES, Case, F0};
use sunglint::trial::{Shading, gloss};
use sunglint::{Real, oracle};

/// Worst, root mean square and mean of a relative error.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    worst: f64,
    square: f64,
    sum: f64,
    count: f64,
}

impl Errors {
    fn add(&mut self, error: f64) {
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

const PI_Q16: u32 = 205_887;

fn truth(case: &Case, pixel: &Pixel) -> f64 {
    let unit = pixel.unit();
    let n_dot_l = (0..3).map(|i| unit.n[i] * unit.l[i]).sum::<f64>().min(1.0);
    let matt = oracle::diffuse::relative_illuminance(n_dot_l, case.light.sin(), case.light.cos());
    let glossy = Glossy { alpha: case.alpha, f0: F0, ratio: case.light.sin() };
    ALBEDO * matt + PI * Shading::DiscGgx.truth(&glossy, pixel)
}

fn errors(case: &Case, count: usize) -> Errors {
    let surface = Surface::of(&Material::new([ALBEDO; 3], case.alpha, [F0; 3]).unwrap());
    let light = SphereQ14::new(&case.light);
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
fn five_cases() {
    for case in CASES {
        let found = errors(&case, 20_000);
        let generic = gloss::arithmetic::<I2F14>(Shading::DiscGgx, &case, case.pixels(1, 20_000));
        println!(
            "{:24} worst {:.2e} rms {:.2e} bias {:+.2e}; generic worst {:.2e} rms {:.2e}",
            case.name,
            found.worst,
            found.rms(),
            found.mean(),
            generic.max,
            generic.rms()
        );
    }
}

#[test]
fn unused() {
    let _ = raw::SUN_Q14;
}
