//! What a constructor made, or why it did not.

use super::{SphereQ14, SphereQ30};
use crate::light::LightError;
use crate::raw;

/// Why a constructor did not make what was asked for.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It did.
    Ok = 0,
    /// Radius over distance is out of 0 to 1.
    Ratio = 1,
}

/// A light for Q14 vectors, or why there is none; then the light is a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SphereQ14Made {
    /// Why there is none.
    pub status: Status,
    /// The light.
    pub sphere: SphereQ14,
}

/// A light for Q30 vectors, or why there is none; then the light is a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SphereQ30Made {
    /// Why there is none.
    pub status: Status,
    /// The light.
    pub sphere: SphereQ30,
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
