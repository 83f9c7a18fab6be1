//! Calls every function in the float formats, and all that takes or gives an f64, on inputs that the compiler cannot
//! know. The image links only if nothing can panic: not the core, nor libm, half and micromath as far as it calls them.
#![no_std]
#![no_main]

mod generic;
mod image;

use core::hint::black_box;

use sunglint::fixed::types::{I2F14, I2F30, I16F16};
use sunglint::half::f16;
use sunglint::material::Material;
use sunglint::micromath::F32;
use sunglint::real::{Constant, Float, Scalar, Scaled};
use sunglint::{DistantLight, DistantSphere, Real, SUN, UnfactoredSphere, highlight, normalization, specular};

use image::keep;

#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    loop {
        float(DistantSphere::<f64>::new(&black_box(SUN)));
        float(DistantSphere::<f32>::new(&black_box(SUN)));
        float(DistantSphere::<F32>::new(&black_box(SUN)));
        float(DistantSphere::<f16>::new(&black_box(SUN)));
        generic::black_body::<f64>();
        generic::black_body::<f32>();
        generic::black_body::<F32>();
        of_f64::<I2F14>();
        of_f64::<I2F30>();
        of_f64::<I16F16>();
        keep(DistantSphere::<I2F14>::new(&black_box(SUN)));
        keep(DistantSphere::<I2F30>::new(&black_box(SUN)));
        keep(DistantSphere::<I16F16>::new(&black_box(SUN)));
        light();
        image::plant();
    }
}

fn float<T: Float>(light: DistantSphere<T>) {
    generic::call::<T>(light);
    of_f64::<T>();
    let (a, b) = black_box((<T as Scalar>::ZERO, <T as Scalar>::ZERO));
    keep((<T as Float>::over_root(a, b), DistantSphere::<T>::from_ratio(a)));
    keep((normalization::versine(a), normalization::solid_angle(a), normalization::size_factor(a)));
    keep((normalization::inverse_size_factor(a), normalization::radiance(a, b), normalization::white_radiance(a)));
    keep((normalization::sun_radius_at(a), highlight::karis(a, b), highlight::exact_rp(a, b)));
}

fn of_f64<T: Real>() {
    let value = black_box(0.0);
    keep((<T as Real>::from_f64(value), <T as Real>::to_f64(black_box(T::ZERO))));
    keep((<T as Real>::wide(value), <T as Real>::square_of(value)));
    keep((<T::Scalar as Scalar>::nearest(value), <T::Scalar as Scalar>::exact(black_box(T::Scalar::ZERO))));
    let light = black_box(SUN);
    let (l, r) = black_box(([T::ZERO; 3], [T::ZERO; 3]));
    keep(DistantSphere::<T>::of(&light));
    keep(specular::epic(l, r, &black_box(UnfactoredSphere::<T>::of(&light))));
}

fn light() {
    let (a, b) = black_box((0.0, 0.0));
    keep((DistantLight::from_ratio(a), DistantLight::from_radius_and_distance(a, b)));
    keep((DistantLight::from_angular_radius(a), DistantLight::from_angle(a)));
    let light = black_box(SUN);
    keep((DistantLight::sin(&light), DistantLight::cos(&light), DistantLight::versine(&light)));
    keep((DistantLight::description(&light), DistantLight::try_from(DistantLight::description(&light))));
    keep((DistantLight::radius(&light), DistantLight::distance(&light), DistantLight::angular_radius(&light)));
    keep((DistantLight::solid_angle(&light), DistantLight::size_factor(&light), DistantLight::radiance(&light, a)));
    keep((DistantLight::white_radiance(&light), DistantLight::size_factor_q48(&light)));
    keep((DistantLight::solid_angle_q48(&light), DistantLight::inverse_size_factor_q12(&light)));
    keep((Scaled::new(a), Constant::value(Constant::new(a)), Material::new(black_box([a; 3]), b, black_box([b; 3]))));
}
