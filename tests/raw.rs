//! The raw-bits layer is the `fixed` layer on bits.

use fixed::types::{I2F14, I2F30, U16F16, U32F32};
use sunglint::highlight::PointGgx;
use sunglint::material::{Material, Surface};
use sunglint::raw::{SUN_Q14, SUN_Q30};
use sunglint::sampling::{Cone, basis, points};
use sunglint::scene::{Channel, Scene};
use sunglint::shadow::soft_shadow;
use sunglint::trial::input;
use sunglint::{Real, SUN, Scalar, cap, disc, factored, normalize, raw, reflect};

#[test]
fn q14_is_i2f14() {
    for pair in input::random(1, 2000, SUN.angular_radius()) {
        let (l, r) = (pair.l.map(I2F14::from_f64), pair.r.map(I2F14::from_f64));
        let (a, b) = (l.map(I2F14::to_bits), r.map(I2F14::to_bits));
        assert_eq!(raw::cap_q14(a, b, &SUN_Q14), cap(l, r, &SUN_Q14).map(I2F14::to_bits));
        assert_eq!(raw::factored_q14(a, b, &SUN_Q14), factored(l, r, &SUN_Q14).map(I2F14::to_bits));
        assert_eq!(raw::disc_q14(a, b, &SUN_Q14), disc(l, r, &SUN_Q14).map(I2F14::to_bits));
        assert_eq!(raw::reflect_q14(a, b), reflect(l, r).map(I2F14::to_bits));
        assert_eq!(raw::normalize_q14(a), normalize(l).map(I2F14::to_bits));
    }
}

#[test]
fn q30_is_i2f30() {
    for pair in input::random(2, 2000, SUN.angular_radius()) {
        let (l, r) = (pair.l.map(I2F30::from_f64), pair.r.map(I2F30::from_f64));
        let (a, b) = (l.map(I2F30::to_bits), r.map(I2F30::to_bits));
        assert_eq!(raw::cap_q30(a, b, &SUN_Q30), cap(l, r, &SUN_Q30).map(I2F30::to_bits));
        assert_eq!(raw::factored_q30(a, b, &SUN_Q30), factored(l, r, &SUN_Q30).map(I2F30::to_bits));
        assert_eq!(raw::disc_q30(a, b, &SUN_Q30), disc(l, r, &SUN_Q30).map(I2F30::to_bits));
        assert_eq!(raw::reflect_q30(a, b), reflect(l, r).map(I2F30::to_bits));
        assert_eq!(raw::normalize_q30(a), normalize(l).map(I2F30::to_bits));
    }
}

#[test]
fn a_lamp_from_bits_is_one_from_i2f30() {
    let ratio = I2F30::from_num(0.05);
    assert_eq!(raw::sphere_q14(ratio.to_bits()), raw::SphereQ14::from_ratio_q30(ratio));
    assert_eq!(raw::sphere_q30(ratio.to_bits()), raw::SphereQ30::from_ratio_q30(ratio));
    assert!(raw::sphere_q14(-1).is_err() && raw::sphere_q30(i32::MAX).is_err());
}

/// The Sun straight above, the mirror ray 10 degrees beside it: worked out by hand.
#[test]
fn a_known_direction() {
    let (l, r) = ([0, 0, 16384], [2845, 0, 16135]);
    // sin and cos of the Sun's 0.2665 degrees, in Q14: 76.19 and 16383.82.
    assert_eq!(raw::cap_q14(l, r, &SUN_Q14), [76, 0, 16384]);
}

#[test]
fn sampling_in_q14_is_that_of_i2f14() {
    for (pair, point) in input::random(3, 500, SUN.angular_radius()).zip(points::<I2F14>(0, 500)) {
        let (l, r) = (pair.l.map(I2F14::from_f64), pair.r.map(I2F14::from_f64));
        let (a, b) = (l.map(I2F14::to_bits), r.map(I2F14::to_bits));
        let (cone, raw_cone) = (Cone::new(l, &SUN_Q14), raw::cone_q14(a, &SUN_Q14));
        assert_eq!(raw::basis_q14(a), basis(l).map(|v| v.map(I2F14::to_bits)));
        let direction = raw::cone_direction_q14(&raw_cone, point.map(I2F14::to_bits));
        assert_eq!(direction, cone.direction(point).map(I2F14::to_bits));
        assert_eq!(raw::cone_contains_q14(&raw_cone, b), cone.contains(r));
        let seen = soft_shadow(&cone, r, 7, 20, |direction| direction[0] > l[0]);
        let means = raw::soft_shadow_q14(&raw_cone, b, 7, 20, |direction| direction[0] > a[0]);
        for (mean, exact) in means.into_iter().zip([seen.visible, seen.cosine].map(Scalar::exact)) {
            assert!((f64::from(mean) - exact * 2_f64.powi(30)).abs() <= 0.5, "{mean} {exact}");
        }
    }
    assert!(raw::points_q14(3, 100).eq(points::<I2F14>(3, 100).map(|point| point.map(I2F14::to_bits))));
}

#[test]
fn sampling_in_q30_is_that_of_i2f30() {
    for (pair, point) in input::random(4, 500, SUN.angular_radius()).zip(points::<I2F30>(0, 500)) {
        let (l, r) = (pair.l.map(I2F30::from_f64), pair.r.map(I2F30::from_f64));
        let (a, b) = (l.map(I2F30::to_bits), r.map(I2F30::to_bits));
        let (cone, raw_cone) = (Cone::new(l, &SUN_Q30), raw::cone_q30(a, &SUN_Q30));
        assert_eq!(raw::basis_q30(a), basis(l).map(|v| v.map(I2F30::to_bits)));
        let direction = raw::cone_direction_q30(&raw_cone, point.map(I2F30::to_bits));
        assert_eq!(direction, cone.direction(point).map(I2F30::to_bits));
        assert_eq!(raw::cone_contains_q30(&raw_cone, b), cone.contains(r));
        let seen = soft_shadow(&cone, r, 7, 20, |direction| direction[0] > l[0]);
        let means = raw::soft_shadow_q30(&raw_cone, b, 7, 20, |direction| direction[0] > a[0]);
        for (mean, exact) in means.into_iter().zip([seen.visible, seen.cosine].map(Scalar::exact)) {
            assert!((f64::from(mean) - exact * 2_f64.powi(30)).abs() <= 0.5, "{mean} {exact}");
        }
    }
    assert!(raw::points_q30(3, 100).eq(points::<I2F30>(3, 100).map(|point| point.map(I2F30::to_bits))));
}

#[test]
fn a_scene_from_bits_is_one_from_the_types() {
    let material = Material::new([0.5, 0.25, 0.125], 0.01, [0.04, 0.05, 0.06]).unwrap();
    let (l, illuminance) = ([0.6, 0.0, 0.8], [3.0, 2.0, 1.0]);
    let q14 = |v: [f64; 3]| v.map(I2F14::from_f64);
    let q30 = |v: [f64; 3]| v.map(I2F30::from_f64);
    let mut coarse = Scene::<I2F14, 1>::new(&Surface::of(&material));
    let lamp = raw::lamp_q14(q14(l).map(I2F14::to_bits), &SUN_Q14, illuminance.map(|level| (level * 65536.0) as u32));
    coarse.push(&lamp.unwrap()).unwrap();
    let mut fine = Scene::<I2F30, 1>::new(&Surface::of(&material));
    let lamp =
        raw::lamp_q30(q30(l).map(I2F30::to_bits), &SUN_Q30, illuminance.map(|level| (level * 4294967296.0) as u64));
    fine.push(&lamp.unwrap()).unwrap();
    assert!(raw::lamp_q14([0; 3], &SUN_Q14, [1; 3]).is_err() && raw::lamp_q30([0; 3], &SUN_Q30, [1; 3]).is_err());
    let bits = |value: f64| (value * f64::from(1 << 30)).round() as i32;
    let (albedo, f0) = ([0.5, 0.25, 0.125].map(bits), [0.0, 0.5, 1.0].map(bits));
    let same = Material::new([0.5, 0.25, 0.125], 0.0625, [0.0, 0.5, 1.0]).unwrap();
    assert_eq!(raw::surface_q14(albedo, bits(0.0625), f0), Ok(Surface::of(&same)));
    assert_eq!(raw::surface_q30(albedo, bits(0.0625), f0), Ok(Surface::of(&same)));
    assert!(raw::surface_q14(albedo, bits(1e-4), f0).is_err() && raw::surface_q30([-1, 0, 0], 0, f0).is_err());
    let mut karis = raw::SceneQ14::<1, _>::with_highlight(&Surface::of(&material), PointGgx::karis);
    karis.push(&raw::lamp_q14(q14(l).map(I2F14::to_bits), &SUN_Q14, [65536; 3]).unwrap()).unwrap();
    for pair in input::random(3, 500, SUN.angular_radius()) {
        let (n, v) = (pair.l, pair.r);
        let (a, b) = (q14(n), q14(v));
        let [c, d] = [a, b].map(|v| v.map(I2F14::to_bits));
        assert_eq!(raw::shade_q14(&karis, c, d), karis.shade(a, b).map(U16F16::to_bits));
        let [c, d] = [a, b].map(|v| v.map(I2F14::to_bits));
        let levels = coarse.shade(a, b).map(U16F16::to_bits);
        assert_eq!(raw::shade_q14(&coarse, c, d), levels);
        assert_eq!(raw::shade_channel_q14(&coarse, c, d, Channel::Blue), levels[2]);
        let (a, b) = (q30(n), q30(v));
        let [c, d] = [a, b].map(|v| v.map(I2F30::to_bits));
        let levels = fine.shade(a, b).map(U32F32::to_bits);
        assert_eq!(raw::shade_q30(&fine, c, d), levels);
        assert_eq!(raw::shade_channel_q30(&fine, c, d, Channel::Blue), levels[2]);
    }
}
