//! The calls of the kernels, for the clock.

use sunglint::blackbody::{relative_to_peak, tint};
use sunglint::radiometry::{Patch, SphereLight, flux, irradiance};
use sunglint::sampling::{Cone, basis, sin_cos};
use sunglint::shadow::soft_shadow;
use sunglint::trial::input;
use sunglint::{DistantSphere, Real, SUN, Scalar, lambert, normalize, reflect, relative_illuminance};

use super::{DIRECTIONS, Kernel};
use crate::clock::Contender;

/// Pixels across the ball whose pixels make a batch.
const SIDE: u32 = 64;

/// The same for calls that do as much as some tens of others.
const SHORT_SIDE: u32 = 12;

impl Kernel {
    /// Its calls, for the pixels of a ball in scan order.
    pub fn calls<T: Real>(self) -> Contender {
        match self {
            Self::Normalize => Contender::new(pairs(), |&[_, r]: &[[T; 3]; 2]| normalize(r), |&[l, _]| l),
            Self::Reflect => Contender::new(pairs(), |&[l, r]: &[[T; 3]; 2]| reflect(l, r), |&[l, _]| l),
            Self::Basis => Contender::new(pairs(), |&[_, r]: &[[T; 3]; 2]| basis(r), |&[l, _]| l),
            Self::SinCos => Contender::new(each(|[x, ..]| number::<T>(x)), |&turn| sin_cos(turn), |&turn| turn),
            Self::ConeDirection => {
                let cone = sun_cone();
                let points = each(|[x, y, _]| [x, y].map(T::from_f64));
                Contender::new(points, move |&point| cone.direction(point), |&point| point)
            }
            Self::SoftShadow => soft_shadows::<T>(),
            Self::RelativeIlluminance => {
                let sun = DistantSphere::<T>::of(&SUN);
                let setting = each(|[x, ..]| T::wide(SUN.sin() * (2.0 * x - 1.0)));
                Contender::new(setting, move |&n_dot_l| relative_illuminance(n_dot_l, &sun), |&n_dot_l| n_dot_l)
            }
            Self::Lambert => {
                let matt = |[x, y, z]: [f64; 3]| (T::from_f64(x), level::<T>(100.0 * y), T::wide(z));
                let call = |&(albedo, level, n_dot_l): &_| lambert::<T>(albedo, level, n_dot_l);
                Contender::new(each(matt), call, |&(albedo, ..)| albedo)
            }
            Self::Irradiance | Self::Flux | Self::SphereLight => self.of_numbers::<T>(),
            Self::RelativeToPeak => {
                let ratios = each(|[x, ..]| number::<T>(0.5 + 9.5 * x));
                Contender::new(ratios, |&ratio| relative_to_peak(ratio), |&ratio| ratio)
            }
            Self::Tint => {
                let lamps = each(|[x, ..]| [1.0 + 9.0 * x, 0.611, 0.549, 0.464].map(number::<T>));
                Contender::new(
                    lamps,
                    |&[kilokelvins, r, g, b]| tint(kilokelvins, [r, g, b]),
                    |&[kilokelvins, ..]| kilokelvins,
                )
            }
        }
    }

    /// Those of radiometry, which all take some numbers.
    fn of_numbers<T: Real>(self) -> Contender {
        let inputs = each(|[x, y, z]| [10.0 * x, 0.1 + 0.9 * y, 0.1 + 0.9 * z, 1.0 + 10.0 * y].map(number::<T>));
        let part = |&[first, ..]: &[T::Scalar; 4]| first;
        match self {
            Self::Flux => {
                let call = |&[radiance, cos, area, distance]: &[T::Scalar; 4]| {
                    flux(radiance, Patch { area, cos }, Patch { area: cos, cos: area }, distance)
                };
                Contender::new(inputs, call, part)
            }
            Self::SphereLight => {
                let call = |&[x, y, radius, z]: &[T::Scalar; 4]| {
                    let colour = [T::Scalar::ONE; 3];
                    SphereLight::of_point([x, y, z], [T::Scalar::ZERO; 3], radius, colour)
                        .and_then(|light| light.radiance())
                };
                Contender::new(inputs, call, part)
            }
            _ => Contender::new(inputs, |&[intensity, cos, _, distance]| irradiance(intensity, cos, distance), part),
        }
    }
}

/// Half of the disc is hidden; every pixel has points of its own.
fn soft_shadows<T: Real>() -> Contender {
    let cone = sun_cone::<T>();
    let pixels: Vec<_> = input::ball(SHORT_SIDE).zip((0..).step_by(DIRECTIONS as usize)).collect();
    let pixels: Vec<_> = pixels.into_iter().map(|(pair, first)| (pair.l.map(T::from_f64), first)).collect();
    let call = move |&(n, first): &([T; 3], u32)| soft_shadow(&cone, n, first, DIRECTIONS, |a| a[0] > n[0]);
    Contender::new(pixels, call, |&(n, _)| n)
}

/// The Sun where the ball has it.
fn sun_cone<T: Real>() -> Cone<T> {
    let l = [1.0, 2.0, 3.0].map(|lane: f64| T::from_f64(lane / 14_f64.sqrt()));
    Cone::new(l, &DistantSphere::of(&SUN))
}

/// Directions to the light and along the mirror ray of the pixels.
fn pairs<T: Real>() -> Vec<[[T; 3]; 2]> {
    input::ball(SIDE).map(|pair| [pair.l.map(T::from_f64), pair.r.map(T::from_f64)]).collect()
}

/// An input of each pixel, by three numbers from 0 to 1.
fn each<I>(input: impl Fn([f64; 3]) -> I) -> Vec<I> {
    input::ball(SIDE).map(|pair| input(pair.r.map(|lane| 0.5 + 0.5 * lane))).collect()
}

fn level<T: Real>(value: f64) -> T::Level {
    T::level(T::Scalar::nearest(value))
}

/// As light levels hold it.
fn number<T: Real>(value: f64) -> T::Scalar {
    T::of_level(level::<T>(value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use sunglint::trial::{Format, Visitor};

    struct Once(Kernel);

    impl Visitor for Once {
        type Output = usize;

        fn visit<T: Real>(self) -> usize {
            let contender = self.0.calls::<T>();
            (contender.call)();
            (contender.empty)();
            contender.inputs
        }
    }

    #[test]
    fn every_kernel_can_be_timed_in_every_format() {
        for kernel in Kernel::ALL {
            assert!(Format::ALL.into_iter().all(|format| format.visit(Once(kernel)) > 50), "{}", kernel.name());
        }
    }
}
