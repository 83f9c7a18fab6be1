//! Highlights at lights, widths and pixels that nobody looks for, but a search over all of them has found: what the
//! kernels made of them, and what they make of them now.

mod exact;

use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::real::Scalar;
use sunglint::trial::{Format, Shading, Visitor};
use sunglint::{DistantLight, DistantSphere, Real};

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

/// A normal that leaned from the half vector by more than 173 widths of the highlight counted as one that leaned by so
/// much: 11 orders of magnitude too bright where viewer and light are grazing and opposite, and the highlight is
/// thousands of widths away.
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

/// Three steps towards the cone's root are not enough at grazing incidence, where its two poles are hundreds of times
/// apart: three times too bright. Beside its peak, of which the root's budget is a share, the highlight is faint here.
#[test]
fn the_cones_root_is_right_where_its_poles_are_far_apart() {
    let n = [-0.6960015143835844, -0.7180403136139402, -9.755192700070268e-7];
    let v = [0.7139564821399657, -0.7000096902668125, 0.015892612840136953];
    let l = [-0.7285488701240332, 0.6849938275927225, 9.306227881403438e-7];
    let light = DistantLight::from_ratio(1.5933631276020287e-2).unwrap();
    for (method, format, budget) in [
        (Shading::ConeGgx, Format::F64, 3.3e-12),
        (Shading::Shifted, Format::F64, 4.9e-12),
        (Shading::ConeGgx, Format::F32, 2.1e-4),
        (Shading::ConeGgx, Format::I2F30, 3.6e-8),
    ] {
        let at = At { method, light, alpha: 6.637046399001643e-4, pixel: Pixel { n, v, l } };
        assert_off_by(&format!("24 for 8.0, {} in {}", method.name(), format.name()), format, at, budget);
    }
}

/// `(v.h)^2 = (1 + m.v) / 2` has no digits left where the viewer is opposite to the light's point `m`: 15 times too
/// bright in f32, by half in f16.
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
