//! Samples of a small sun by the cosine of their angle.

use std::collections::HashSet;
use std::f32::consts::PI;

use sunglint::oracle::{angle_between, closed};
use sunglint::sampling::Cone;
use sunglint::{DistantLight, DistantSphere, SUN};

use super::row::{CURE, FAILS, PresetRow, TRUTH, figure, per_cent};
use super::{Effort, Preset};

/// What is reported, and how it is run.
pub const PRESET: Preset = Preset {
    name: "path-tracer-small-sun",
    source: "mmp/pbrt-v3, pull request 212 (2018): sines by sqrt(1 - cos^2) are wrong in f32 from 1.5 \
             degrees down, and small spheres collapse to a point; LuxCoreRender/LuxCore, issue 443 (2020): soft shadows of small lights turn hard, and band",
    question: "Which directions of the Sun does a path tracer sample in f32, and with what density?",
    chart: None,
    measure,
    verdict,
};

/// A disc whose cosine f32 rounds to 1.
const TINY: f64 = 1e-4;

const ANGLES: &str = "different angles of the Sun's samples";
const OUTSIDE: &str = "samples outside the Sun, per cent";
const CENTRE: &str = "samples on the very centre of a disc of 0.0001, per cent";

const ACOS: &str = "acos(1 - z + z sqrt(1 - x^2)), f32";
const SINE: &str = "sine by sqrt(1 - cos^2), f32";
const SUBTRACTED: &str = "density 1 / (2 pi (1 - sqrt(1 - x^2))), f32";
const OURS: &str = "Cone, f32";

/// The sine of the Sun from Earth, of a light 0.02 degrees wide and of [`TINY`], with their names.
fn ratios() -> [(&'static str, f64); 3] {
    [("the Sun", SUN.sin()), ("a light 0.02 degrees wide", 0.01_f64.to_radians().sin()), ("a disc of 0.0001", TINY)]
}

/// Numbers that are evenly spread from 0 to 1.
fn even(count: u32) -> impl Iterator<Item = f32> {
    (0..count).map(move |index| ((f64::from(index) + 0.5) / f64::from(count)) as f32)
}

/// How many of `angles` differ, and how many are more than a millionth of the radius outside the Sun or no number.
fn spread(angles: impl Iterator<Item = f64>) -> [usize; 2] {
    let limit = SUN.angular_radius() * (1.0 + 1e-6);
    let angles: Vec<_> = angles.collect();
    let inside = angles.iter().filter(|&&angle| angle <= limit).count();
    let different: HashSet<_> = angles.iter().map(|angle| angle.to_bits()).collect();
    [different.len(), angles.len() - inside]
}

/// Samples about an axis.
fn cone(ratio: f64) -> Option<Cone<f32>> {
    Some(Cone::new([0.0, 0.0, 1.0], &DistantSphere::of(&DistantLight::from_ratio(ratio).ok()?)))
}

fn samples(count: u32) -> [PresetRow; 4] {
    let x = SUN.sin() as f32;
    let published = even(count).map(|z| f64::from(libm::acosf(1.0 - z + z * (1.0 - x * x).sqrt())));
    let here = cone(SUN.sin());
    let ours = even(count).map(|z| {
        let direction = here.map_or([f32::NAN; 3], |cone| cone.direction([z, 0.0]));
        angle_between([0.0, 0.0, 1.0], direction.map(f64::from))
    });
    let forms = [(FAILS, ACOS, spread(published)), (CURE, OURS, spread(ours))];
    let [[a, b], [c, d]] = forms.map(|(role, form, [angles, outside])| {
        let outside = per_cent(outside, count as usize);
        [
            PresetRow::new(role, form, ANGLES, angles as f64).at_least(10_000.0),
            PresetRow::new(role, form, OUTSIDE, outside).at_most(0.0),
        ]
    });
    [a, b, c, d]
}

/// Samples that cannot be told from the centre.
fn centres(count: u32) -> [PresetRow; 2] {
    let x = TINY as f32;
    let sine = |z: f32| {
        let cosine = 1.0 - z + z * (1.0 - x * x).sqrt();
        (1.0 - cosine * cosine).sqrt()
    };
    let here = cone(TINY);
    let across = |z: f32| {
        let [x, y, _] = here.map_or([0.0; 3], |cone| cone.direction([z, 0.3]));
        x.hypot(y)
    };
    let share = |sine: &dyn Fn(f32) -> f32| per_cent(even(count).filter(|&z| sine(z) == 0.0).count(), count as usize);
    [
        PresetRow::new(FAILS, SINE, CENTRE, share(&sine)).at_most(0.1),
        PresetRow::new(CURE, OURS, CENTRE, share(&across)).at_most(0.1),
    ]
}

fn density_of(light: &str) -> String {
    format!("density of {light} off by, per cent")
}

fn densities() -> Vec<PresetRow> {
    let rows = |(light, ratio): (&str, f64)| {
        let x = ratio as f32;
        let subtracted = 1.0 / (2.0 * PI * (1.0 - (1.0 - x * x).sqrt()));
        let ours = cone(f64::from(x)).and_then(|cone| cone.pdf().ok()).unwrap_or(f32::NAN);
        let off = |density: f32| 100.0 * (f64::from(density) * closed::solid_angle(x.into()) - 1.0).abs();
        [(FAILS, SUBTRACTED, subtracted), (CURE, OURS, ours)]
            .map(|(role, form, density)| PresetRow::new(role, form, &density_of(light), off(density)).at_most(0.1))
    };
    ratios().into_iter().flat_map(rows).collect()
}

fn measure(effort: Effort) -> Vec<PresetRow> {
    let count = effort.count(1 << 17, 1 << 21) as u32;
    let radius = PresetRow::new(TRUTH, "f64", "the Sun's radius, degrees", SUN.angular_radius().to_degrees());
    [vec![radius], samples(count).into(), centres(count / 4).into(), densities()].concat()
}

fn verdict(rows: &[PresetRow]) -> String {
    format!(
        "By the cosine the Sun has {} angles, {} % of the samples lie outside, and the density is {} % off ({} % for \
         a light 0.02 degrees wide); here {} angles, none outside, and {} %.",
        figure(rows, ACOS, ANGLES),
        figure(rows, ACOS, OUTSIDE),
        figure(rows, SUBTRACTED, &density_of("the Sun")),
        figure(rows, SUBTRACTED, &density_of("a light 0.02 degrees wide")),
        figure(rows, OURS, ANGLES),
        figure(rows, OURS, &density_of("the Sun")),
    )
}

#[cfg(test)]
mod tests {
    use super::super::row::value;
    use super::*;

    /// As `tests/sampling.rs` and `tests/light_failures.rs` have it.
    #[test]
    fn the_figures_are_those_on_record() {
        let rows = measure(Effort::Full);
        assert_eq!(value(&rows, ACOS, ANGLES), 183.0);
        assert_eq!(value(&rows, ACOS, OUTSIDE), per_cent(5761, 1 << 21));
        assert!(value(&rows, OURS, ANGLES) >= 1e6);
        assert_eq!(value(&rows, SINE, CENTRE), 100.0);
        let subtracted = |light| value(&rows, SUBTRACTED, &density_of(light));
        assert!((subtracted("the Sun") - 0.3).abs() < 0.05, "{}", subtracted("the Sun"));
        assert!((subtracted("a light 0.02 degrees wide") - 74.4).abs() < 0.1);
        assert_eq!(subtracted("a disc of 0.0001"), f64::INFINITY);
    }
}
