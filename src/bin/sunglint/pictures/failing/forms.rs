//! The forms of highlights that fail, as they are written elsewhere, and what they are held against.

use std::f64::consts::PI;

use fixed::types::I2F14;
use sunglint::highlight::{Highlight, PointGgx, schlick, smith};
use sunglint::material::Surface;
use sunglint::oracle::highlight::Pixel;
use sunglint::scene::{Channel, Lamp, Scene};
use sunglint::trial::Shading;
use sunglint::trial::gloss::{self, ALBEDO, Case, F0};
use sunglint::{DistantSphere, Float, Real, Scalar, cap, normalize, reflect, relative_illuminance};

use crate::pictures::lit;
use crate::pictures::patch::Patch;
use crate::pictures::sphere::Sphere;
use crate::pixels::ball_light;

/// `code` against the exact value of `method`'s formula at the rounded vectors, so that the form alone is to blame.
pub fn against<T: Real>(
    (method, case): (Shading, &Case),
    (patch, side): (&Patch, u32),
    code: impl Fn([[T; 3]; 3]) -> f64,
) -> Sphere {
    let theta = case.light.angular_radius();
    Sphere::lit((patch, side, theta), code, |_, pixel| gloss::truth::<T>(method, case, pixel))
}

/// The cone in `T` against its exact value at the vectors before they were rounded.
pub fn unrounded<T: Real>(case: &Case, side: u32) -> Sphere {
    let (patch, theta) = (lit::patch(case), case.light.angular_radius());
    let v = [0.0, 0.0, 1.0];
    let normals: Vec<_> = (0..side).flat_map(|y| patch.row(y, side)).collect();
    let truth = |index: usize, rounded: &Pixel| {
        let n = normals[index].unwrap_or(rounded.n);
        gloss::truth::<f64>(Shading::ConeGgx, case, &Pixel { n, v, l: ball_light() })
    };
    Sphere::lit::<T>((&patch, side, theta), lit::code(Shading::ConeGgx, case), truth).exposed()
}

/// A thousandth of the light in I2F14, whose levels are multiplied by a thousand when they are shown.
pub fn brightened(case: &Case, side: u32) -> Sphere {
    const DIM: f64 = 1000.0;
    type S = <I2F14 as Real>::Scalar;
    let scalar = S::nearest;
    let surface = Surface::<I2F14>::new([scalar(ALBEDO); 3], scalar(case.alpha), [scalar(F0); 3]);
    let illuminance = I2F14::level(scalar(PI / DIM));
    let lamp = Lamp::new(ball_light().map(I2F14::from_f64), DistantSphere::of(&case.light), [illuminance; 3]);
    let scene = surface.ok().zip(lamp.ok()).and_then(|(surface, lamp)| {
        let mut scene = Scene::<I2F14, 1>::new(&surface);
        scene.push(&lamp).ok().map(|()| scene)
    });
    let code = |[n, v, _]: [[I2F14; 3]; 3]| {
        let level = scene.as_ref().map(|scene| scene.shade_channel(n, v, Channel::Green));
        level.map_or(f64::NAN, |level| DIM * I2F14::of_level(level).exact())
    };
    against((Shading::ConeGgx, case), (&lit::patch(case), side), code).exposed()
}

/// The whole of the light in I2F14.
pub fn in_the_light(case: &Case, side: u32) -> Sphere {
    let code = lit::code::<I2F14>(Shading::ConeGgx, case);
    against((Shading::ConeGgx, case), (&lit::patch(case), side), code).exposed()
}

/// A pixel of a surface that reflects `highlight`.
fn whole<T: Float>(sphere: &DistantSphere<T>, [n, v, l]: [[T; 3]; 3], highlight: impl Fn() -> T) -> f64 {
    let seen = T::dot(n, v) > <T as Scalar>::ZERO;
    let share = relative_illuminance(T::dot(n, l), sphere) * T::nearest(1.0 / PI);
    let diffuse = T::nearest(ALBEDO) * share * T::nearest(PI);
    if seen { (diffuse + highlight()).exact() } else { 0.0 }
}

/// GGX at the disc's nearest point with Karis's factor, its tail by `(n.h)^2 (alpha^2 - 1) + 1`.
pub fn subtracted<T: Float>(case: &Case) -> impl Fn([[T; 3]; 3]) -> f64 {
    let sphere = DistantSphere::<T>::of(&case.light);
    let [alpha, f0, pi] = [case.alpha, F0, PI].map(T::nearest);
    let one = <T as Scalar>::ONE;
    let factor = alpha / (alpha + T::nearest(case.light.sin() / 2.0));
    move |[n, v, l]| {
        whole(&sphere, [n, v, l], || {
            let point = cap(l, reflect(n, v), &sphere);
            let h = normalize([0, 1, 2].map(|i| <T as Real>::add(point[i], v[i])));
            let [n_dot_h, n_dot_l, n_dot_v, v_dot_h] = [[n, h], [n, point], [n, v], [v, h]].map(|[a, b]| T::dot(a, b));
            let square = alpha * alpha;
            let rest = n_dot_h * n_dot_h * (square - one) + one;
            let density = square / (pi * rest * rest);
            let reflectance = f0 + (one - f0) * schlick(v_dot_h);
            density * (factor * factor) * smith(n_dot_l, n_dot_v, alpha) * reflectance * pi
        })
    }
}

/// GGX at the disc's nearest point, times `alpha^2 / alpha'^2`.
pub fn squares_divided<T: Float>(case: &Case) -> impl Fn([[T; 3]; 3]) -> f64 {
    let sphere = DistantSphere::<T>::of(&case.light);
    let [alpha, f0, pi] = [case.alpha, F0, PI].map(T::nearest);
    let widened = alpha + T::nearest(case.light.sin() / 2.0);
    let factor = alpha * alpha / (widened * widened);
    let highlight = PointGgx::none(&sphere, alpha);
    move |[n, v, l]| whole(&sphere, [n, v, l], || highlight.shade(n, v, l).radiance(pi, f0) * factor)
}
