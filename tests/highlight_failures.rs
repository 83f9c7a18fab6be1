//! The catalogue of what goes wrong with highlights elsewhere, each with its figure, and that it does not here; and the
//! white furnace of the specular lobe.

mod exact;

use std::f64::consts::PI;

use half::f16;
use sunglint::highlight::{ConeGgx, Highlight, PointGgx, ShiftedConeGgx, smith};
use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::oracle::quadrature::Quadrature;
use sunglint::trial::{Format, Shading, Visitor, input};
use sunglint::{DistantLight, DistantSphere, Real, Scalar};

fn assert_near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected}");
}

/// GGX by `(n.h)^2 (alpha^2 - 1) + 1`, as it is mostly written, over its peak, at `h = n`.
fn subtracted<T: sunglint::Float>(n: [T; 3], alpha: T) -> f64 {
    let cosine = T::dot(n, n);
    let square = alpha * alpha;
    let rest = cosine * cosine * (square - T::ONE) + T::ONE;
    let density = square / (rest * rest);
    density.exact() * alpha.exact() * alpha.exact()
}

/// The same by the cone of half vectors under a point light, seen along the normal.
fn by_the_cone<T: Real>(n: [T; 3], alpha: f64) -> f64 {
    let point = DistantSphere::<T>::of(&DistantLight::from_ratio(0.0).unwrap());
    let gloss = ConeGgx::new(&point, T::Scalar::nearest(alpha)).shade(n, n, n);
    // D V (n.l) is 1/4 of the peak 1 / (pi alpha^2) here.
    let [level, gain] = [gloss.level, gloss.gain].map(Scalar::exact);
    level * gain * 4.0 * PI * alpha * alpha
}

fn normals<T: Real>() -> impl Iterator<Item = [T; 3]> {
    input::random(3, 20_000, 0.1).map(|pair| pair.l.map(T::from_f64))
}

#[test]
fn ggx_by_subtraction_is_a_third_wrong_in_f32() {
    let alpha = 1e-3;
    let error = |value: f64| (value - 1.0).abs();
    let worst = exact::worst(normals::<f32>().map(|n| error(subtracted(n, alpha as f32))));
    println!("f32, alpha {alpha}, h = n: {worst:.2}");
    assert!(worst > 0.3, "{worst}");
    // n is as far from unit length as f32 rounds it.
    let ours = exact::worst(normals::<f32>().map(|n| error(by_the_cone(n, alpha))));
    assert!(ours < 1e-6, "{ours}");
}

#[test]
fn ggx_by_subtraction_is_lost_in_f16() {
    let wrong = |value: f64| f64::from(u8::from(!(value > 0.5 && value < 2.0)));
    let share = normals::<f16>().map(|n| wrong(subtracted(n, f16::nearest(0.01)))).sum::<f64>() / 20_000.0;
    println!("f16, alpha 0.01, h = n: {share:.2} are off by a factor of two or are no number");
    assert!(share > 0.9, "{share}");
    let ours = exact::worst(normals::<f16>().map(|n| (by_the_cone(n, f16::nearest(0.01).exact()) - 1.0).abs()));
    assert!(ours < 0.01, "{ours}");
}

/// The peak of alpha 0.001 is above f16's greatest number, and the square of alpha below its least normal one.
#[test]
fn the_peak_overflows_f16_and_alpha_squared_is_subnormal() {
    let alpha = f16::nearest(1e-3);
    assert!(!(alpha * alpha).is_normal());
    assert!((f16::ONE / (f16::nearest(PI) * (alpha * alpha))).is_infinite());
    // A perceptual roughness of 0.04, the least that renderers allow: its fourth power.
    assert!(!f16::nearest(0.04_f64.powi(4)).is_normal());
    let n = [f16::ZERO, f16::ZERO, f16::ONE];
    assert_near(by_the_cone(n, alpha.exact()), 1.0, 2e-3);
}

/// `V` reaches `1 / (4 alpha^2)`; with the cosine that it is always multiplied by, `1 / (2 alpha)`.
#[test]
fn smiths_visibility_alone_overflows_f16() {
    let [cosine, alpha] = [1e-3, 1e-3].map(f16::nearest);
    let shadow = |c: f64, a: f64| (a * a + (1.0 - a * a) * c * c).sqrt();
    let [c, a] = [cosine.exact(), alpha.exact()];
    let alone = 0.5 / (2.0 * c * shadow(c, a));
    assert!(f16::nearest(alone).is_infinite());
    assert_near(smith(cosine, cosine, alpha).exact() / (alone * c), 1.0, 2e-3);
    // Grazing to a 300th of a degree there is nothing to see.
    assert_eq!([smith(1.0, 1.0 / 16384.0, 0.0), smith(0.0, 1.0, 0.5), smith(f64::NAN, 1.0, 0.5)], [0.0; 3]);
    assert_near(smith(1.0, 1.001 / 16384.0, 0.0) / 4096.0, 1.0 / 1.001, 1e-12);
}

/// A lamp of ratio 0.3 on a polish: without an energy factor 93 000 times too bright, by Karis's 1.02 to 7 times.
#[test]
fn a_highlight_without_its_energy_is_brighter_than_the_reference() {
    let glossy = Glossy { alpha: 5e-4, f0: 0.04, ratio: 0.3 };
    let rule = Quadrature::<12>::new();
    let methods = |pixel: &Pixel| [Shading::None, Shading::Karis, Shading::Shifted].map(|m| m.truth(&glossy, pixel));
    let [none, karis, shifted] = rule.lobes(&glossy, 60_f64.to_radians(), methods);
    println!("60 degrees: none {:.3e}, karis {:.2}, cone {:.4}", none.energy, karis.energy, shifted.energy);
    assert_near(none.energy / 2.19e5, 1.0, 0.01);
    assert_near(karis.energy, 2.42, 0.03);
    assert_near(shifted.energy, 1.0, 1e-3);
}

/// A surface that reflects all (`F0 = 1`) sends out no more than arrives, whatever the roughness: GGX with Smith's
/// shadowing loses what bounces twice, and gains nothing.
#[test]
fn under_a_white_sky_the_lobe_never_exceeds_one() {
    let rule = Quadrature::<12>::new();
    for alpha in [5e-4, 0.01, 0.0625, 0.25, 0.5, 1.0] {
        for incidence in [0.0, 30.0, 60.0, 80.0_f64] {
            let glossy = Glossy { alpha, f0: 1.0, ratio: 1e-3 };
            let incidence = incidence.to_radians();
            let [lobe] = rule.lobes(&glossy, incidence, |_| [0.0]);
            // Of what arrives on the slanted surface.
            let reflected = lobe.truth / incidence.cos();
            assert!(reflected < 1.0 + 1e-4 && reflected > 0.3, "alpha {alpha}, {incidence}: {reflected}");
        }
    }
}

/// Of the roughest surface the reflectance along the normal is known: `1 - ln 2`.
#[test]
fn the_roughest_surface_reflects_one_less_the_logarithm_of_two() {
    let glossy = Glossy { alpha: 1.0, f0: 1.0, ratio: 1e-4 };
    let [lobe] = Quadrature::<16>::new().lobes(&glossy, 0.0, |_| [0.0]);
    assert_near(lobe.truth, 1.0 - std::f64::consts::LN_2, 2e-8);
}

/// The same by the crate's own highlights: a sky of 4000 discs of radiance 1, seen from `v`.
struct WhiteSky {
    alpha: f64,
    incidence: f64,
}

impl Visitor for WhiteSky {
    type Output = f64;

    fn visit<T: Real>(self) -> f64 {
        const COUNT: u32 = 4000;
        let theta = 2.0 * (1.0 / f64::from(COUNT)).sqrt().asin();
        let light = DistantLight::from_angular_radius(theta).unwrap();
        let highlight = ConeGgx::<T>::new(&DistantSphere::of(&light), T::Scalar::nearest(self.alpha));
        let (sin, cos) = self.incidence.sin_cos();
        let [n, v] = [[0.0, 0.0, 1.0], [sin, 0.0, cos]].map(|vector| vector.map(T::from_f64));
        let illuminance = T::Scalar::nearest(light.size_factor());
        (0..COUNT / 2)
            .map(|index| {
                let z = 1.0 - (2.0 * f64::from(index) + 1.0) / f64::from(COUNT);
                let turn = f64::from(index) * PI * (3.0 - 5_f64.sqrt());
                let ring = (1.0 - z * z).sqrt();
                let l = [ring * turn.cos(), ring * turn.sin(), z].map(T::from_f64);
                highlight.shade(n, v, l).radiance(illuminance, T::Scalar::ONE).exact()
            })
            .sum()
    }
}

#[test]
fn a_sky_of_discs_is_reflected_as_one() {
    let rule = Quadrature::<12>::new();
    for alpha in [0.1, 0.5] {
        for incidence in [0.0, 0.8] {
            let glossy = Glossy { alpha, f0: 1.0, ratio: 1e-3 };
            let [lobe] = rule.lobes(&glossy, incidence, |_| [0.0]);
            // By reciprocity as much comes from a white sky to the viewer as goes from there to all sides.
            let expected = lobe.truth / f64::cos(incidence);
            for format in Format::ALL {
                let sum = format.visit(WhiteSky { alpha, incidence });
                // The discs overlap and leave gaps where the lobe is not much wider than they are.
                assert!((sum - expected).abs() < 0.01, "{} {alpha} {incidence}: {sum} {expected}", format.name());
                assert!(sum < 1.01, "{sum}");
            }
        }
    }
}

/// Half of the sky as one disc: the form for lights of any size keeps to one within the thickness of a line.
#[test]
fn half_the_sky_as_one_disc() {
    let sky = DistantSphere::<f64>::of(&DistantLight::from_ratio(1.0).unwrap());
    let n = [0.0, 0.0, 1.0];
    for alpha in [0.0, 1e-3, 0.0625] {
        let highlight = ShiftedConeGgx::new(&sky, alpha);
        for incidence in [0.0, 0.5, 1.0] {
            let v = [f64::sin(incidence), 0.0, f64::cos(incidence)];
            let reflected = highlight.shade(n, v, n).radiance(PI, 1.0);
            assert!(reflected < 1.02 && reflected > 0.9, "{alpha} {incidence}: {reflected}");
        }
    }
}

/// The image of the Sun in a mirror is the Sun: radiance `1 / (pi x^2)` of its illuminance.
#[test]
fn a_mirror_shows_the_sun_in_every_format() {
    struct Mirror;
    impl Visitor for Mirror {
        type Output = [f64; 2];

        fn visit<T: Real>(self) -> [f64; 2] {
            let sun = DistantSphere::<T>::of(&sunglint::SUN);
            let lanes = |v: [f64; 3]| v.map(T::from_f64);
            let [n, v, l] = [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]].map(lanes);
            let right = sunglint::SUN.size_factor();
            let cone = ConeGgx::new(&sun, T::Scalar::ZERO).shade(n, v, l).radiance(T::Scalar::ONE, T::Scalar::ONE);
            let karis = PointGgx::karis(&sun, T::Scalar::ZERO).shade(n, v, l).radiance(T::Scalar::ONE, T::Scalar::ONE);
            [cone.exact() * right, karis.exact() * right * v[2].to_f64()]
        }
    }
    for format in Format::ALL {
        let [cone, karis] = format.visit(Mirror);
        // f16: a few of its steps; micromath: its roots.
        let allowed = if format == Format::F16 { 6e-3 } else { 2.5e-4 };
        assert_near(cone, 1.0, allowed);
        assert_near(karis, 1.0, allowed);
    }
}

/// A surface of normal `(0, 0, 1)`, and a viewer who sees the light's centre mirrored in it, `degrees` off the normal.
fn mirrored(degrees: f64) -> Pixel {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Pixel { n: [0.0, 0.0, 1.0], v: [-sin, 0.0, cos], l: [sin, 0.0, cos] }
}

/// Where a large disc reaches to the viewer's opposite, its half vectors fit no cone, and the formula as it stands has
/// nothing to give: yet there the highlight is brightest.
#[test]
fn a_large_lamp_at_grazing_incidence_is_not_black() {
    // 12 % to 36 % is what the centre's shadowing makes of so large a disc.
    for (ratio, alpha, degrees, most) in [
        (0.3, 0.01, 82.0, 0.01),
        (0.3, 0.01, 85.0, 0.02),
        (0.5, 0.1, 75.0, 0.2),
        (1.0, 0.1, 50.0, 0.04),
        (1.0, 0.1, 80.0, 0.36),
    ] {
        let (glossy, pixel) = (Glossy { alpha, f0: 0.04, ratio }, mirrored(degrees));
        let sphere = DistantSphere::<f64>::of(&DistantLight::from_ratio(ratio).unwrap());
        let truth = Quadrature::<48>::new().highlight(&glossy, &pixel);
        let cone = Shading::ConeGgx.radiance(&glossy, &sphere, [pixel.n, pixel.v, pixel.l]);
        let error = (cone / truth - 1.0).abs();
        println!("ratio {ratio}, alpha {alpha}, {degrees} degrees: {error:.3}");
        assert!(error <= most && error >= most / 4.0, "{ratio} {alpha} {degrees}: {cone} {truth}");
    }
}

/// Worst error of a method where `n`, `v` and `l` are anywhere, the latter two a degree above the surface or more, in units of
/// the highlight's truth there or straight on, whichever is greater.
struct Anywhere {
    method: Shading,
    glossy: Glossy,
}

impl Visitor for Anywhere {
    type Output = f64;

    fn visit<T: Real>(self) -> f64 {
        let Self { method, glossy } = self;
        let rounded = |value: f64| T::Scalar::nearest(value).exact();
        let glossy = Glossy { alpha: rounded(glossy.alpha), f0: rounded(glossy.f0), ..glossy };
        let sphere = DistantSphere::<T>::of(&DistantLight::from_ratio(glossy.ratio).unwrap());
        let middle = method.truth(&glossy, &mirrored(0.0));
        let directions = |seed| input::random(seed, 20_000, 1.0).map(|pair| pair.l.map(T::from_f64));
        let error = |[n, v, l]: [[T; 3]; 3]| {
            let [n, v, l] = [n, v, l].map(|vector| vector.map(T::to_f64));
            let truth = method.truth(&glossy, &Pixel { n, v, l });
            (method.radiance(&glossy, &sphere, [n, v, l].map(|vector| vector.map(T::from_f64))) - truth).abs()
                / truth.max(middle)
        };
        let above = |n: [T; 3], direction: [T; 3]| T::scalar(T::dot(n, direction)).exact() > 0.0175;
        let pixels = directions(1).zip(directions(2)).zip(directions(3)).map(|((n, v), l)| [n, v, l]);
        exact::worst(pixels.filter(|&[n, v, l]| above(n, v) && above(n, l)).map(error))
    }
}

/// A tilt of many widths times a wide opening overflows f16; what came of it was the whole peak and more, where hardly
/// anything is.
#[test]
fn no_pixel_anywhere_is_brighter_than_it_should() {
    // f16 at a degree above the surface: what rounding does to n.v there.
    let budgets = [
        (Shading::ConeGgx, [1.6e-12, 2.4e-5, 4.7e-5, 0.15, 9.8e-3, 6.8e-8, 5.4e-4]),
        (Shading::Shifted, [1.6e-12, 2.4e-5, 4.5e-5, 0.15, 9.8e-3, 6.7e-8, 5.4e-4]),
    ];
    let sun = sunglint::SUN.sin();
    for (method, budgets) in budgets {
        for (format, budget) in Format::ALL.into_iter().zip(budgets) {
            let cases = [(1e-3, sun), (0.01, sun), (0.01, 0.05), (0.1, 0.3)];
            let errors = cases.map(|(alpha, ratio)| {
                let glossy = Glossy { alpha, f0: 0.04, ratio };
                format.visit(Anywhere { method, glossy })
            });
            exact::assert_tight(
                &format!("{} in {}", method.name(), format.name()),
                exact::worst(errors.into_iter()),
                budget,
            );
        }
    }
}

/// The BRDF summed over what of a disc is above the surface, over pi.
fn summed(glossy: &Glossy, light: &DistantLight, pixel: &Pixel) -> f64 {
    const COUNT: u32 = 40_000;
    let lit = (0..COUNT).map(|index| {
        let z = (f64::from(index) + 0.5) / f64::from(COUNT);
        let turn = f64::from(index) * PI * (3.0 - 5_f64.sqrt());
        let ring = (1.0 - z * z).sqrt();
        let l = [ring * turn.cos(), ring * turn.sin(), z];
        let inside = f64::dot(l, pixel.l) >= light.cos();
        if inside { glossy.brdf(&Pixel { l, ..*pixel }) } else { 0.0 }
    });
    lit.sum::<f64>() * 2.0 / f64::from(COUNT)
}

/// The sine falls again beyond half the sky: by it the highlight of a light of 359 degrees was 13 000 times too bright, and that
/// of the full sphere zero.
#[test]
fn beyond_half_the_sky_a_highlight_is_that_of_half() {
    let half = DistantLight::from_angle(180.0).unwrap();
    for angle in [181.0, 225.0, 270.0, 359.0, 360.0] {
        let light = DistantLight::from_angle(angle).unwrap();
        for (alpha, most) in [(0.1, 0.01), (0.5, 0.28)] {
            let glossy = Glossy { alpha, f0: 1.0, ratio: 1.0 };
            let mut worst = 0.0_f64;
            for pixel in [mirrored(0.0), mirrored(37.0), Pixel { l: [0.0, 0.0, 1.0], ..mirrored(37.0) }] {
                let of = |light| {
                    let sphere = DistantSphere::<f64>::of(light);
                    Shading::Shifted.radiance(&glossy, &sphere, [pixel.n, pixel.v, pixel.l])
                };
                worst = worst.max((of(&light) / summed(&glossy, &light, &pixel) - 1.0).abs());
                // But for the point nearest to the mirror ray.
                assert_near(of(&light), of(&half), 1e-12);
            }
            println!("{angle} degrees, alpha {alpha}: {worst:.3}");
            assert!(worst <= most && worst >= most / 4.0, "{angle} {alpha}: {worst}");
        }
    }
}

/// Relative error of a method at a pixel that a search has found.
struct At {
    method: Shading,
    light: DistantLight,
    alpha: f64,
    pixel: Pixel,
}

impl Visitor for At {
    type Output = f64;

    fn visit<T: Real>(self) -> f64 {
        let Self { method, light, alpha, pixel: Pixel { n, v, l } } = self;
        let glossy = Glossy { alpha: T::Scalar::nearest(alpha).exact(), f0: 1.0, ratio: light.sin() };
        let lanes = [n, v, l].map(|vector| vector.map(T::from_f64));
        let [n, v, l] = lanes.map(|vector| vector.map(T::to_f64));
        let truth = method.truth(&glossy, &Pixel { n, v, l });
        method.radiance::<T>(&glossy, &DistantSphere::of(&light), lanes) / truth - 1.0
    }
}

fn assert_off_by(what: &str, format: Format, at: At, budget: f64) {
    exact::assert_tight(what, format.visit(at).abs(), budget);
}

/// A normal that leaned from the half vector by more than 173 widths of the highlight counted as one that leaned by so much: 11
/// orders of magnitude too bright where viewer and light are grazing and opposite, and the highlight is thousands of widths away.
#[test]
fn a_lean_of_many_widths_is_not_cut_off() {
    let v = [0.0001258314815683579, -0.7388064386587111, 0.6739176732827761];
    let l = [0.0001177494635073672, 0.7449217061840618, -0.6671518850988056];
    let pixel = Pixel { n: [1.0, 0.0, 0.0], v, l };
    let at = At { method: Shading::Directional, light: sunglint::SUN, alpha: 1.6377555512658386e-3, pixel };
    assert_off_by("5.5e7 for 2.3e-4", Format::F64, at, 2.2e-15);
    let n = [-0.31586407399780025, 0.9358571092742001, -0.1562093396005826];
    let v = [0.13892296559279368, 0.2091089674737131, 0.9679740953935603];
    let l = [-0.1392964144000181, -0.20832729037794961, -0.9680889675123253];
    let light = DistantLight::from_ratio(6.546838499658737e-4).unwrap();
    let at = At { method: Shading::ConeGgx, light, alpha: 5e-4, pixel: Pixel { n, v, l } };
    assert_off_by("612 for 0.289", Format::F64, at, 3.5e-13);
}

/// Three steps towards the cone's root are not enough at grazing incidence, where its two poles are hundreds of times apart:
/// three times too bright. Beside its peak, of which the root's budget is a share, the highlight is faint here.
#[test]
fn the_cones_root_is_right_where_its_poles_are_far_apart() {
    let n = [-0.6960015143835844, -0.7180403136139402, -9.755192700070268e-7];
    let v = [0.7139564821399657, -0.7000096902668125, 0.015892612840136953];
    let l = [-0.7285488701240332, 0.6849938275927225, 9.306227881403438e-7];
    let light = DistantLight::from_ratio(1.5933631276020287e-2).unwrap();
    for (method, format, budget) in [
        (Shading::ConeGgx, Format::F64, 4.1e-7),
        (Shading::Shifted, Format::F64, 4.1e-7),
        (Shading::ConeGgx, Format::F32, 2.1e-4),
        (Shading::ConeGgx, Format::I2F30, 4.1e-7),
    ] {
        let at = At { method, light, alpha: 6.637046399001643e-4, pixel: Pixel { n, v, l } };
        assert_off_by(&format!("24 for 8.0, {} in {}", method.name(), format.name()), format, at, budget);
    }
}

/// `(v.h)^2 = (1 + m.v) / 2` has no digits left where the viewer is opposite to the light's point `m`: 15 times too bright
/// in f32, by half in f16.
#[test]
fn the_half_vector_of_an_opposite_viewer_keeps_its_digits() {
    let point = DistantLight::from_ratio(0.0).unwrap();
    let n = [-0.000287386414129287, -0.9999999403953552, -1.0510822903597727e-5];
    let v = [0.6867499351501465, -0.000252366007771343, -0.7268936634063721];
    let l = [-0.6867499947547913, 0.00012707871792372316, 0.7268936634063721];
    let at = At { method: Shading::Shifted, light: point, alpha: 4.559032991528511e-2, pixel: Pixel { n, v, l } };
    assert_off_by("12 800 for 840", Format::F32, at, 2e-5);
    let n = [0.61083984375, -0.456787109375, -0.646484375];
    let v = [-0.7314453125, -0.0908203125, -0.67578125];
    let l = [0.77001953125, 0.061737060546875, 0.634765625];
    let at = At { method: Shading::Shifted, light: point, alpha: 5.380859375e-1, pixel: Pixel { n, v, l } };
    assert_off_by("0.75 for 0.51", Format::F16, at, 8.1e-3);
}
