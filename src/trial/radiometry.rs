//! Radiometry: every formula in every format against its definition in twice f64's digits, with its error budgets.
//!
//! Each budget is 1.12 times the worst relative error of 100 000 random inputs from each of three seeds, rounded up to
//! two digits; an ignored test of `tests/radiometry.rs` prints them again.

use oorandom::Rand64;

use super::format::Format;
use super::found::Found;
use crate::oracle::radiometry::{PI, Parts, quotient, relative_error, square};
use crate::radiometry::{
    Patch, SphereLight, area_radiance, diffuse_radiance, flux, irradiance, lambertian_radiance, patch_solid_angle,
    point_intensity, sphere_radiance,
};
use crate::real::{Real, Scalar};

/// One of the formulas of [`radiometry`](crate::radiometry).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formula {
    /// `Phi / (A Omega)`.
    AreaRadiance,
    /// `Phi / (pi A)`.
    LambertianRadiance,
    /// `Phi / (4 pi^2 R^2)`.
    SphereRadiance,
    /// `Phi / (4 pi)`.
    PointIntensity,
    /// `I cos / r^2`.
    Irradiance,
    /// `A cos / r^2`.
    PatchSolidAngle,
    /// `rho E / pi`.
    DiffuseRadiance,
    /// `L A cos A' cos' / r^2`.
    Flux,
    /// `colour (d / R)^2` of a sphere from a position.
    SmallSphere,
}

impl Formula {
    /// All formulas, in the order of tables.
    pub const ALL: [Self; 9] = [
        Self::AreaRadiance,
        Self::LambertianRadiance,
        Self::SphereRadiance,
        Self::PointIntensity,
        Self::Irradiance,
        Self::PatchSolidAngle,
        Self::DiffuseRadiance,
        Self::Flux,
        Self::SmallSphere,
    ];

    /// Name of the formula.
    pub const fn name(self) -> &'static str {
        match self {
            Self::AreaRadiance => "area_radiance",
            Self::LambertianRadiance => "lambertian_radiance",
            Self::SphereRadiance => "sphere_radiance",
            Self::PointIntensity => "point_intensity",
            Self::Irradiance => "irradiance",
            Self::PatchSolidAngle => "patch_solid_angle",
            Self::DiffuseRadiance => "diffuse_radiance",
            Self::Flux => "flux",
            Self::SmallSphere => "SphereLight",
        }
    }

    /// Budget of the relative error.
    pub const fn maximum(self, format: Format) -> f64 {
        BUDGETS[self as usize][format as usize]
    }

    /// The answer in the scalars of a format: of four light levels and two cosines. Zero where it is refused.
    pub fn compute<S: Scalar>(self, [a, b, c, d]: [S; 4], [cos, other]: [S; 2]) -> S {
        let computed = match self {
            Self::AreaRadiance => area_radiance(a, b, c),
            Self::LambertianRadiance => lambertian_radiance(a, b),
            Self::SphereRadiance => sphere_radiance(a, b),
            Self::PointIntensity => point_intensity(a),
            Self::Irradiance => Ok(irradiance(a, cos, b)),
            Self::PatchSolidAngle => Ok(patch_solid_angle(a, cos, b)),
            Self::DiffuseRadiance => Ok(diffuse_radiance(cos, a)),
            Self::Flux => {
                let [sender, receiver] = [Patch { area: b, cos }, Patch { area: c, cos: other }];
                Ok(flux(a, sender, receiver, d))
            }
            Self::SmallSphere => SphereLight::of_point([a, b, c], [S::ZERO; 3], d, [S::ONE; 3])
                .and_then(|light| light.radiance())
                .map(|[red, _, _]| red),
        };
        computed.unwrap_or(S::ZERO)
    }

    /// The definition.
    pub fn truth(self, levels: [f64; 4], cosines: [f64; 2]) -> Parts {
        let exact = |value: f64| [value, 0.0];
        let ([a, b, c, d], [cos, other]) = (levels.map(exact), cosines.map(exact));
        let four = exact(4.0);
        match self {
            Self::AreaRadiance => quotient(&[a], &[b, c]),
            Self::LambertianRadiance => quotient(&[a], &[PI, b]),
            Self::SphereRadiance => quotient(&[a], &[four, PI, PI, b, b]),
            Self::PointIntensity => quotient(&[a], &[four, PI]),
            Self::Irradiance | Self::PatchSolidAngle => quotient(&[a, cos], &[b, b]),
            Self::DiffuseRadiance => quotient(&[cos, a], &[PI]),
            Self::Flux => quotient(&[a, b, cos, c, other], &[d, d]),
            Self::SmallSphere => quotient(&[square([levels[0], levels[1], levels[2]])], &[d, d]),
        }
    }

    /// Relative error, over levels from 0.001 to 10 000 and cosines from 0.01 to 1 as the format holds them, with
    /// answers from 1e-4 to 6e4, and spheres not larger than their distance.
    pub fn error<T: Real>(self, seed: u64, count: usize) -> Found {
        let mut source = Rand64::new(u128::from(seed));
        let mut found = Found::new();
        for _ in 0..count {
            let mut between = |least: f64, most: f64| least * libm::pow(most / least, source.rand_float());
            let levels = [0; 4].map(|_| T::of_level(T::level(T::Scalar::nearest(between(1e-3, 1e4)))));
            let cosines = [0; 2].map(|_| T::of_lane(T::from_f64(between(0.01, 1.0))));
            let ([a, b, c, d], [cos, other]) = (levels.map(Scalar::exact), cosines.map(Scalar::exact));
            let truth = self.truth([a, b, c, d], [cos, other]);
            let inside = self == Self::SmallSphere && truth[0] < 1.01;
            if (1e-4..=6e4).contains(&truth[0]) && !inside {
                let error = relative_error(self.compute(levels, cosines).exact(), truth);
                found.add_signed(error, [a, b, c, d, cos, other]);
            }
        }
        found
    }
}

/// Budgets for f64, f32, micromath, f16, I2F14, I2F30 and I16F16.
const BUDGETS: [[f64; 7]; 9] = [
    [3.2e-16, 1.8e-7, 1.8e-7, 1.5e-3, 1.5e-9, 1.5e-9, 1.5e-9],
    [3.6e-16, 2.0e-7, 2.0e-7, 1.7e-3, 1.5e-9, 1.6e-9, 1.5e-9],
    [4.7e-16, 2.4e-7, 2.4e-7, 2.3e-3, 1.7e-9, 1.8e-9, 1.7e-9],
    [1.7e-16, 9.8e-8, 9.8e-8, 8.6e-4, 6.5e-10, 6.5e-10, 6.5e-10],
    [3.8e-16, 2.1e-7, 2.1e-7, 1.8e-3, 1.8e-9, 2.0e-9, 1.9e-9],
    [3.8e-16, 2.1e-7, 2.1e-7, 1.8e-3, 1.8e-9, 2.0e-9, 1.9e-9],
    [2.7e-16, 1.5e-7, 1.5e-7, 1.3e-3, 1.1e-9, 9.9e-10, 1.1e-9],
    [5.2e-16, 3.0e-7, 3.0e-7, 2.5e-3, 2.2e-9, 2.4e-9, 2.3e-9],
    [8.1e-16, 4.3e-7, 1.1e-5, 3.5e-3, 3.9e-9, 3.7e-9, 3.9e-9],
];
