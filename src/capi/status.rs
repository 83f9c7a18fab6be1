//! What a constructor made, or why it did not.

use super::{PixelQ14, SphereQ14, SphereQ30};
use crate::light::LightError;
use crate::material::MaterialError;
use crate::radiometry::RadiometryError;
use crate::raw;
use crate::real::Scaled;
use crate::scene::SceneError;

/// Why a constructor did not make what was asked for.
// 32 bits, whatever a C compiler takes for its enums: bare arm takes one byte, unless it is told otherwise.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Status {
    /// It did.
    Ok = 0,
    /// Radius over distance is out of 0 to 1.
    Ratio = 1,
    /// A direction's length is not within a tenth of 1.
    Direction = 2,
    /// A channel of the albedo is out of 0 to 1.
    Albedo = 3,
    /// `alpha` is neither 0 nor within 5e-4 to 1.
    Alpha = 4,
    /// A channel of the reflectance at normal incidence is out of 0 to 1.
    F0 = 5,
    /// The area is 0.
    Area = 6,
    /// The solid angle is 0.
    SolidAngle = 7,
    /// The answer is greater than its format's greatest number.
    Overflow = 8,
}

/// A light for Q14 vectors, or why there is none; then the light is a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphereQ14Made {
    /// Why there is none.
    pub status: Status,
    /// The light.
    pub sphere: SphereQ14,
}

/// A light for Q30 vectors, or why there is none; then the light is a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphereQ30Made {
    /// Why there is none.
    pub status: Status,
    /// The light.
    pub sphere: SphereQ30,
}

/// A material under one light, or why there is none; then it is black.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PixelQ14Made {
    /// Why there is none.
    pub status: Status,
    /// The material under the light.
    pub pixel: PixelQ14,
}

/// A radiance, or why there is none.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RadianceQ16Made {
    /// Why there is none.
    pub status: Status,
    /// The radiance in W/(m^2 sr), Q16.
    pub radiance: u32,
}

impl SphereQ14Made {
    pub(super) fn of(made: Result<raw::SphereQ14, LightError>) -> Self {
        const POINT: SphereQ14 = SphereQ14 { sin: 0, sin_square: 0, cos: 1 << 28, versine: 0 };
        made.map_or(Self { status: Status::Ratio, sphere: POINT }, |made| Self {
            status: Status::Ok,
            sphere: made.into(),
        })
    }
}

impl SphereQ30Made {
    pub(super) fn of(made: Result<raw::SphereQ30, LightError>) -> Self {
        const POINT: SphereQ30 = SphereQ30 { sin: 0, sin_square: 0, cos: 1 << 60, versine: 0 };
        made.map_or(Self { status: Status::Ratio, sphere: POINT }, |made| Self {
            status: Status::Ok,
            sphere: made.into(),
        })
    }
}

impl PixelQ14Made {
    pub(super) fn of(made: Result<PixelQ14, Status>) -> Self {
        match made {
            Ok(pixel) => Self { status: Status::Ok, pixel },
            Err(status) => Self { status, pixel: PixelQ14::BLACK },
        }
    }
}

impl RadianceQ16Made {
    pub(super) fn of(made: Result<u32, RadiometryError<Scaled>>) -> Self {
        let (status, radiance) = match made {
            Ok(radiance) => (Status::Ok, radiance),
            Err(RadiometryError::Area(_)) => (Status::Area, 0),
            Err(RadiometryError::SolidAngle(_)) => (Status::SolidAngle, 0),
            // No other argument can be out of range: integers without a sign are neither negative nor infinite.
            Err(_) => (Status::Overflow, u32::MAX),
        };
        Self { status, radiance }
    }
}

impl From<MaterialError<Scaled>> for Status {
    fn from(error: MaterialError<Scaled>) -> Self {
        match error {
            MaterialError::Albedo(_) => Self::Albedo,
            MaterialError::F0(_) => Self::F0,
            MaterialError::Alpha(_) => Self::Alpha,
        }
    }
}

impl From<SceneError<Scaled>> for Status {
    fn from(error: SceneError<Scaled>) -> Self {
        match error {
            // One light has no list to be full, and levels without a sign are all allowed.
            SceneError::Direction(_) | SceneError::Full { .. } | SceneError::Illuminance(_) => Self::Direction,
        }
    }
}
