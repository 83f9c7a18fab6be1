//! The ground truth of highlights: converged, and right where the answer is known otherwise.

use std::f64::consts::{PI, TAU};

use oorandom::Rand64;
use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::oracle::quadrature::Quadrature;
use sunglint::trial::found::{worse, worst};

const ALPHAS: [f64; 6] = [5e-4, 2e-3, 8e-3, 0.0625, 0.25, 1.0];

/// A surface of normal `(0, 0, 1)` lit from `incidence`, and a viewer whose mirror ray is `away` from the light on the
/// side `azimuth`.
fn pixel(incidence: f64, away: f64, azimuth: f64) -> Pixel {
    let (sin, cos) = incidence.sin_cos();
    let l = [sin, 0.0, cos];
    let (up, across) = (away.sin() * azimuth.cos(), away.sin() * azimuth.sin());
    let r = [away.cos() * sin + up * cos, across, away.cos() * cos - up * sin];
    Pixel { n: [0.0, 0.0, 1.0], v: [-r[0], -r[1], r[2]], l }
}

/// Pixels from a hundredth to ten times the highlight's width from its middle, the viewer 3 degrees above the surface
/// or more.
fn pixels(glossy: &Glossy, incidence: f64, count: usize) -> impl Iterator<Item = Pixel> {
    let mut source = Rand64::new(5);
    let width = glossy.ratio.asin() + 2.0 * glossy.alpha;
    let draw = move |_| {
        let away = (width * 10_f64.powf(3.0 * source.rand_float() - 2.0)).min(1.0);
        pixel(incidence, away, TAU * source.rand_float())
    };
    (0..).map(draw).filter(|pixel| pixel.v[2] > 0.05).take(count)
}

/// How far doubling the nodes from `N` to `M` moves a pixel, in units of the highlight's middle.
fn moved<const N: usize, const M: usize>(glossy: &Glossy, incidence: f64, count: usize) -> f64 {
    let (coarse, fine) = (Quadrature::<N>::new(), Quadrature::<M>::new());
    let middle = fine.highlight(glossy, &pixel(incidence, 0.0, 0.0));
    let apart = |pixel| (coarse.highlight(glossy, &pixel) - fine.highlight(glossy, &pixel)).abs() / middle;
    worst(pixels(glossy, incidence, count).map(apart))
}

fn worst_moved<const N: usize, const M: usize>(ratios: &[f64], degrees: &[f64], count: usize) -> f64 {
    let mut worst = 0.0_f64;
    for &ratio in ratios {
        for alpha in ALPHAS {
            for incidence in degrees {
                let glossy = Glossy { alpha, f0: 0.04, ratio };
                worst = worse(worst, moved::<N, M>(&glossy, incidence.to_radians(), count));
            }
        }
    }
    worst
}

#[test]
fn doubling_the_nodes_moves_no_pixel_by_a_millionth() {
    let small = worst_moved::<24, 48>(&[1e-4, 0.00465, 0.05], &[0.0, 30.0, 60.0, 80.0], 12);
    println!("ratios up to 0.05, incidence up to 80 degrees: {small:.1e}");
    assert!(small < 1e-6, "{small}");
    let large = worst_moved::<24, 48>(&[0.3], &[0.0, 30.0, 60.0, 70.0], 12);
    println!("ratio 0.3, up to 70 degrees: {large:.1e}");
    assert!(large < 1e-6, "{large}");
}

/// A disc of 17 degrees seen 80 degrees off the normal is cut by the horizon.
#[test]
fn a_disc_cut_by_the_horizon_converges_more_slowly() {
    let [first, second] = [worst_moved::<24, 48>(&[0.3], &[80.0], 12), worst_moved::<48, 96>(&[0.3], &[80.0], 6)];
    println!("ratio 0.3, 80 degrees: {first:.1e}, then {second:.1e}");
    assert!(first < 1e-4 && second < 1e-6, "{first} {second}");
}

#[test]
fn the_rule_is_exact_for_polynomials() {
    let rule = Quadrature::<8>::new();
    let computed = rule.integral(-1.0, 2.0, |x| x.powi(15));
    assert!((computed / ((2_f64.powi(16) - 1.0) / 16.0) - 1.0).abs() < 1e-14, "{computed}");
    assert!((rule.integral(0.0, PI, f64::sin) - 2.0).abs() < 1e-13);
}

/// The sum over a grid of the disc in polar coordinates about its centre, which knows nothing of the mirror ray.
fn summed(glossy: &Glossy, pixel: &Pixel, rings: u32) -> f64 {
    let theta = glossy.ratio.asin();
    let rings = f64::from(rings);
    let mut sum = 0.0;
    for ring in 0..rings as u32 {
        for spoke in 0..4 * rings as u32 {
            let (polar, azimuth) =
                ((f64::from(ring) + 0.5) / rings * theta, (f64::from(spoke) + 0.5) / (4.0 * rings) * TAU);
            let [sin, _, cos] = pixel.l;
            let (up, across) = (polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin());
            let l = [polar.cos() * sin + up * cos, across, polar.cos() * cos - up * sin];
            sum += glossy.brdf(&Pixel { l, ..*pixel }) * polar.sin();
        }
    }
    sum * (theta / rings) * (TAU / (4.0 * rings)) / (PI * glossy.ratio * glossy.ratio)
}

#[test]
fn it_is_the_sum_over_the_disc() {
    let rule = Quadrature::<24>::new();
    for (ratio, alpha) in [(0.05, 0.0625), (0.3, 0.25), (0.3, 0.0625)] {
        let glossy = Glossy { alpha, f0: 0.04, ratio };
        for incidence in [0.0, 0.8, 1.2] {
            for away in [0.0, 0.5, 1.0, 1.5] {
                let pixel = pixel(incidence, away * ratio, 1.0);
                let [exact, grid] = [rule.highlight(&glossy, &pixel), summed(&glossy, &pixel, 150)];
                assert!((grid / exact - 1.0).abs() < 3e-4, "{ratio} {alpha} {incidence} {away}: {exact} {grid}");
            }
        }
    }
}

#[test]
fn a_tiny_disc_is_a_point() {
    let glossy = Glossy { alpha: 0.1, f0: 0.04, ratio: 1e-6 };
    for pixel in pixels(&glossy, 0.7, 50) {
        let [disc, point] = [Quadrature::<12>::new().highlight(&glossy, &pixel), glossy.brdf(&pixel)];
        assert!((disc / point - 1.0).abs() < 1e-9, "{disc} {point}");
    }
}

#[test]
fn a_mirror_shows_the_disc() {
    let glossy = Glossy { alpha: 0.0, f0: 1.0, ratio: 0.05 };
    let rule = Quadrature::<8>::new();
    let inside = rule.highlight(&glossy, &pixel(0.5, 0.0499, 2.0));
    assert!((inside * PI * 0.05 * 0.05 - 1.0).abs() < 1e-12, "{inside}");
    assert_eq!(rule.highlight(&glossy, &pixel(0.5, 0.0502, 2.0)), 0.0);
}

/// GGX's microfacets cover the surface once: the integral of `D (n.h)` over all half vectors is 1.
#[test]
fn ggx_is_normalised() {
    let rule = Quadrature::<40>::new();
    for alpha in [0.01_f64, 0.25, 1.0] {
        // With v along n, D (n.h) dw_h is D / 4 dw_l, and V (n.l) is known.
        let glossy = Glossy { alpha, f0: 1.0, ratio: 0.0 };
        let at = |angle: f64| {
            let l = [(2.0 * angle).sin(), 0.0, (2.0 * angle).cos()];
            let lit = glossy.brdf(&Pixel { n: [0.0, 0.0, 1.0], v: [0.0, 0.0, 1.0], l });
            let shadow = (1.0 + (alpha * (2.0 * angle).tan()).powi(2)).sqrt();
            let visibility = 1.0 / (4.0 * (1.0 + (shadow - 1.0) / 2.0));
            lit / visibility * angle.cos() * angle.sin() * TAU
        };
        let width = |t: f64| (alpha * t.tan()).atan();
        let slope = |t: f64| alpha / (t.cos().powi(2) + (alpha * t.sin()).powi(2));
        // Lights in the upper half: half vectors up to 45 degrees; the rest by the formula of GGX's cumulative share.
        let edge = (1.0 / alpha).atan();
        let covered = rule.integral(0.0, edge, |t| at(width(t)) * slope(t));
        let expected = 1.0 / (1.0 + alpha * alpha);
        assert!((covered / expected - 1.0).abs() < 1e-9, "{alpha}: {covered} {expected}");
    }
}
