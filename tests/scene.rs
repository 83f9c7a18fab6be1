//! The least scene: what it adds up, what it refuses, and that it is the same in every format.

use std::f32::consts::PI;

use fixed::types::{I2F14, I2F30, I16F16, U16F16, U32F32};
use half::f16;
use micromath::F32;
use sunglint::highlight::{ConeGgx, DiscGgx, Highlight, PointGgx, ShiftedConeGgx};
use sunglint::material::{Material, MaterialError, Surface};
use sunglint::real::Scaled;
use sunglint::scene::{Channel, Lamp, Scene, SceneError};
use sunglint::{DistantLight, DistantSphere, Real, SUN, Scalar};

const WHITE: Material = match Material::new([1.0; 3], 0.25, [0.0; 3]) {
    Ok(white) => white,
    Err(_) => panic!("white is a colour"),
};

const VARNISH: Material = match Material::new([0.5, 0.25, 0.125], 0.0625, [0.04, 0.05, 0.06]) {
    Ok(varnish) => varnish,
    Err(_) => panic!("these are reflectances"),
};

fn lanes<T: Real>(v: [f64; 3]) -> [T; 3] {
    v.map(T::from_f64)
}

fn level<T: Real>(value: f64) -> T::Level {
    T::level(T::Scalar::nearest(value))
}

fn lamp<T: Real>(direction: [f64; 3], light: &DistantLight, illuminance: f64) -> Lamp<T> {
    Lamp::new(lanes(direction), DistantSphere::of(light), [level::<T>(illuminance); 3]).unwrap()
}

fn values<T: Real>(levels: [T::Level; 3]) -> [f64; 3] {
    levels.map(|level| T::of_level(level).exact())
}

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const SLANT: [f64; 3] = [0.6, 0.0, 0.8];

/// A white surface that faces a light of illuminance pi is exactly white.
fn is_white<T: Real>() {
    let mut scene = Scene::<T, 1>::new(&Surface::of(&WHITE));
    scene.push(&lamp(UP, &SUN, std::f64::consts::PI)).unwrap();
    // Straight on, where a reflectance of zero has no highlight.
    assert_eq!(values::<T>(scene.shade(lanes(UP), lanes(UP))), [1.0; 3], "{}", T::NAME);
}

#[test]
fn a_white_surface_is_white() {
    is_white::<f64>();
    is_white::<f32>();
    is_white::<F32>();
    is_white::<f16>();
    is_white::<I2F14>();
    is_white::<I2F30>();
    is_white::<I16F16>();
}

fn is_dark<T: Real>() {
    let black = [0.0; 3];
    let mut scene = Scene::<T, 2>::new(&Surface::of(&VARNISH));
    assert_eq!(values::<T>(scene.shade(lanes(UP), lanes(SLANT))), black);
    assert_eq!(T::of_level(scene.shade_channel(lanes(UP), lanes(SLANT), Channel::Red)).exact(), 0.0);
    scene.push(&lamp([-0.6, 0.0, 0.8], &SUN, 1.0)).unwrap();
    assert!(values::<T>(scene.shade(lanes(UP), lanes(SLANT))).into_iter().all(|channel| channel > 0.0));
    // From below the surface, and with the light below it.
    assert_eq!(values::<T>(scene.shade(lanes(UP), lanes([0.6, 0.0, -0.8]))), black);
    assert_eq!(values::<T>(scene.shade(lanes([0.0, 0.0, -1.0]), lanes([0.6, 0.0, -0.8]))), black);
}

#[test]
fn no_lights_are_black_and_so_is_what_faces_away() {
    is_dark::<f64>();
    is_dark::<f32>();
    is_dark::<F32>();
    is_dark::<f16>();
    is_dark::<I2F14>();
    is_dark::<I2F30>();
    is_dark::<I16F16>();
}

#[test]
fn one_light_too_many_is_refused_and_nothing_is_lost() {
    let mut scene = Scene::<f32, 2>::new(&Surface::of(&VARNISH));
    let sun = lamp([-0.6, 0.0, 0.8], &SUN, 1.0);
    scene.push(&sun).unwrap();
    scene.push(&sun).unwrap();
    let before = scene.shade(lanes(UP), lanes(SLANT));
    let error = scene.push(&sun).unwrap_err();
    assert_eq!(error, SceneError::Full { capacity: 2 });
    assert_eq!(error.to_string(), "one light too many, there is room for 2");
    assert_eq!((scene.lights(), scene.shade(lanes(UP), lanes(SLANT))), (2, before));
}

#[test]
fn lights_add_up_and_channels_are_apart() {
    let surface = Surface::of(&VARNISH);
    let shade = |lamps: &[Lamp<f64>]| {
        let mut scene = Scene::<f64, 2>::new(&surface);
        lamps.iter().for_each(|lamp| scene.push(lamp).unwrap());
        let channels = [Channel::Red, Channel::Green, Channel::Blue];
        let levels = scene.shade(UP, SLANT);
        assert_eq!(levels, channels.map(|channel| scene.shade_channel(UP, SLANT, channel)));
        levels
    };
    let (sun, disc) = (lamp([-0.6, 0.0, 0.8], &SUN, 2.0), lamp(UP, &DistantLight::from_ratio(0.2).unwrap(), 3.0));
    let (one, other, both) = (shade(&[sun]), shade(&[disc]), shade(&[sun, disc]));
    for channel in 0..3 {
        assert!((both[channel] - one[channel] - other[channel]).abs() < 1e-15 * both[channel] * 4.0);
    }
    // The diffuse parts alone are as the albedos; far from the highlight so is the whole, but for the reflectance.
    assert!(other[0] > 1.9 * other[1] && other[1] > 1.9 * other[2]);
}

/// The diffuse part fades while the disc sets; it is lit until the last of it is gone.
#[test]
fn the_sun_sets() {
    let mut scene = Scene::<f64, 1>::new(&Surface::of(&WHITE));
    scene.push(&lamp(UP, &SUN, std::f64::consts::PI)).unwrap();
    let at = |elevation: f64| {
        let n = [elevation.cos(), 0.0, elevation.sin()];
        scene.shade_channel(n, n, Channel::Green)
    };
    let x = SUN.sin();
    let levels: Vec<f64> = (-11..=11).map(|step| at(f64::from(step) / 10.0 * x)).collect();
    assert_eq!(levels[0], 0.0);
    assert!(levels[2..].windows(2).all(|pair| pair[0] < pair[1]), "{levels:?}");
    // The centre sets: 2 x / (3 pi).
    assert!((levels[11] / (2.0 * x / (3.0 * std::f64::consts::PI)) - 1.0).abs() < 1e-4, "{}", levels[11]);
}

/// A mirror under the Sun at noon is 1.5e4 times as bright as white: more than U16F16 holds of 100 000 lx.
#[test]
fn levels_saturate() {
    let mirror = Material::new([0.0; 3], 0.0, [1.0; 3]).unwrap();
    let mut scene = Scene::<I2F14, 1>::new(&Surface::of(&mirror));
    scene.push(&lamp(UP, &SUN, 60_000.0)).unwrap();
    assert_eq!(scene.shade(lanes(UP), lanes(UP)), [U16F16::MAX; 3]);
    let mut scene = Scene::<I2F30, 1>::new(&Surface::of(&mirror));
    scene.push(&lamp(UP, &SUN, 4e9)).unwrap();
    assert_eq!(scene.shade(lanes(UP), lanes(UP)), [U32F32::MAX; 3]);
    let mut scene = Scene::<f16, 1>::new(&Surface::of(&mirror));
    scene.push(&lamp(UP, &SUN, 60_000.0)).unwrap();
    assert_eq!(scene.shade(lanes(UP), lanes(UP)), [f16::MAX; 3]);
}

#[test]
fn the_method_is_the_callers_choice() {
    let surface = Surface::<f32>::of(&VARNISH);
    let sun = lamp([-0.6, 0.0, 0.8], &SUN, PI.into());
    let mut cone = Scene::<f32, 1>::new(&surface);
    cone.push(&sun).unwrap();
    let mut none = Scene::<f32, 1, _>::with_highlight(&surface, PointGgx::none);
    none.push(&sun).unwrap();
    let [own, plain] = [
        cone.shade_channel(lanes(UP), lanes(SLANT), Channel::Red),
        none.shade_channel(lanes(UP), lanes(SLANT), Channel::Red),
    ];
    // In the middle of a highlight that is 20 times as wide as the Sun the two differ by 1.6 thousandths.
    assert!((1.001..1.002).contains(&(plain / own)), "{plain} {own}");
}

#[test]
fn bad_lamps_are_refused_with_the_value() {
    let sphere = DistantSphere::<f32>::new(&SUN);
    let short = Lamp::new([0.5, 0.0, 0.0], sphere, [1.0; 3]).unwrap_err();
    assert_eq!(short, SceneError::Direction(0.25));
    assert_eq!(short.to_string(), "a direction's squared length is 0.25, allowed is 0.81 to 1.21");
    for bad in [-1.0, f32::INFINITY, f32::NAN] {
        assert!(matches!(Lamp::new([1.0, 0.0, 0.0], sphere, [1.0, bad, 1.0]), Err(SceneError::Illuminance(_))));
    }
    assert!(matches!(Lamp::new([f32::NAN, 0.0, 1.0], sphere, [1.0; 3]), Err(SceneError::Direction(_))));
    let zero = Lamp::new([I2F14::ZERO; 3], DistantSphere::<I2F14>::new(&SUN), [U16F16::ONE; 3]);
    assert_eq!(zero, Err(SceneError::Direction(Scaled::ZERO)));
}

#[test]
fn bad_materials_are_refused_with_the_value() {
    let good = [0.5; 3];
    for bad in [-0.1, 1.1, f64::INFINITY, f64::NAN] {
        assert!(matches!(Material::new([0.5, bad, 0.5], 0.1, good), Err(MaterialError::Albedo(_))));
        assert!(matches!(Material::new(good, 0.1, [bad, 0.5, 0.5]), Err(MaterialError::F0(_))));
        assert!(matches!(Material::new(good, bad, good), Err(MaterialError::Alpha(_))));
        let scalar = |value: f64| f32::nearest(value);
        assert!(Surface::<f32>::new([0.5, scalar(bad), 0.5], 0.1, [0.5; 3]).is_err());
        assert!(Surface::<f32>::new([0.5; 3], scalar(bad), [0.5; 3]).is_err());
        assert!(Surface::<f32>::new([0.5; 3], 0.1, [0.5, 0.5, scalar(bad)]).is_err());
    }
    assert_eq!(Material::new(good, 1e-4, good), Err(MaterialError::Alpha(1e-4)));
    let message = Material::new(good, 1e-4, good).unwrap_err().to_string();
    assert_eq!(message, "alpha is 0.0001, allowed is 0 or 0.0005 to 1");
    for alpha in [0.0, 5e-4, 1.0] {
        assert!(Material::new(good, alpha, good).is_ok());
    }
    let fixed = Surface::<I2F30>::new([Scaled::ONE; 3], Scaled::new(-0.5), [Scaled::ZERO; 3]);
    assert_eq!(fixed, Err(MaterialError::Alpha(Scaled::new(-0.5))));
}

/// A surface from a material is one from the same numbers.
#[test]
fn a_surface_is_its_material() {
    fn check<T: Real>() {
        let scalar = T::Scalar::nearest;
        let parts =
            Surface::<T>::new([0.5, 0.25, 0.125].map(scalar), scalar(0.0625), [0.04, 0.05, 0.06].map(scalar)).unwrap();
        assert_eq!(parts, Surface::of(&VARNISH));
        assert_eq!(parts.alpha().exact(), 0.0625);
    }
    check::<f64>();
    check::<f16>();
    check::<I2F14>();
}

/// The highlight of any method, in any format, at inputs on every edge: finite, and not negative.
fn edges<T: Real, H: Highlight<T>>(method: fn(&DistantSphere<T>, T::Scalar) -> H) {
    let least = T::from_f64(1e-30);
    let grazing = T::from_f64(1e-3);
    let one = T::from_f64(1.0);
    let zero = T::ZERO;
    let directions = [
        [zero, zero, one],
        [one, zero, zero],
        [zero, zero, T::from_f64(-1.0)],
        [one, zero, grazing],
        [T::from_f64(-1.0), zero, grazing],
        [one, zero, least],
        lanes(SLANT),
        lanes([-0.6, 0.0, 0.8]),
        [zero; 3],
    ];
    for alpha in [0.0, 5e-4, 1e-3, 0.1, 1.0] {
        for angle in [0.0, 1e-4, 0.01, 0.53, 35.0, 180.0, 181.0, 270.0, 360.0] {
            let sphere = DistantSphere::<T>::of(&DistantLight::from_angle(angle).unwrap());
            let highlight = method(&sphere, T::Scalar::nearest(alpha));
            for n in directions {
                for v in directions {
                    for l in directions {
                        let gloss = highlight.shade(n, v, l);
                        let radiance = T::of_level(T::level(gloss.radiance(T::Scalar::ONE, T::Scalar::ONE))).exact();
                        let found = [gloss.level, gloss.gain, gloss.fresnel].map(Scalar::exact);
                        let fine = found.into_iter().chain([radiance]).all(|value| value >= 0.0 && value.is_finite());
                        assert!(fine, "{} alpha {alpha} angle {angle}: {n:?} {v:?} {l:?} gave {found:?}", T::NAME);
                    }
                }
            }
        }
    }
}

/// More than half of the sky is as bright as half of it.
#[test]
fn half_the_sky_is_the_most_a_highlight_shows() {
    let gloss = |angle: f64| {
        let sphere = DistantSphere::<f64>::of(&DistantLight::from_angle(angle).unwrap());
        ConeGgx::new(&sphere, 0.1).shade(UP, SLANT, UP)
    };
    assert_eq!([gloss(270.0), gloss(360.0)], [gloss(180.0); 2]);
}

fn all_edges<T: Real>() {
    edges::<T, _>(PointGgx::none);
    edges::<T, _>(PointGgx::karis);
    edges::<T, _>(PointGgx::exact_rp);
    edges::<T, _>(DiscGgx::new);
    edges::<T, _>(DiscGgx::directional);
    edges::<T, _>(ConeGgx::new);
    edges::<T, _>(ShiftedConeGgx::new);
}

#[test]
fn every_edge_has_a_finite_answer() {
    all_edges::<f64>();
    all_edges::<f32>();
    all_edges::<F32>();
    all_edges::<f16>();
    all_edges::<I2F14>();
    all_edges::<I2F30>();
    all_edges::<I16F16>();
}
