//! The direction methods as a list.

use crate::light::DistantLight;
use crate::oracle;
use crate::real::Real;
use crate::specular;
use crate::sphere::{DistantSphere, UnfactoredSphere};

/// One of the four direction methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// [`specular::epic`].
    Epic,
    /// [`specular::factored`].
    Factored,
    /// [`specular::disc`].
    Disc,
    /// [`specular::cap`].
    Cap,
}

/// A light's constants for all methods.
#[derive(Clone, Copy, Debug)]
pub struct Constants<T: Real> {
    /// For all but `epic`.
    pub sphere: DistantSphere<T>,
    /// For `epic`.
    pub unfactored: UnfactoredSphere<T>,
}

impl<T: Real> Constants<T> {
    /// The constants of `light` in the format `T`.
    pub fn of(light: &DistantLight) -> Self {
        Self { sphere: DistantSphere::of(light), unfactored: UnfactoredSphere::of(light) }
    }
}

impl Method {
    /// All methods, in the order of tables.
    pub const ALL: [Self; 4] = [Self::Epic, Self::Factored, Self::Disc, Self::Cap];

    /// The method of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    /// Name of the function.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Epic => "epic",
            Self::Factored => "factored",
            Self::Disc => "disc",
            Self::Cap => "cap",
        }
    }

    /// The method's answer in the format `T`.
    #[inline]
    pub fn direction<T: Real>(self, l: [T; 3], r: [T; 3], light: &Constants<T>) -> [T; 3] {
        match self {
            Self::Epic => specular::epic(l, r, &light.unfactored),
            Self::Factored => specular::factored(l, r, &light.sphere),
            Self::Disc => specular::disc(l, r, &light.sphere),
            Self::Cap => specular::cap(l, r, &light.sphere),
        }
    }

    /// The exact value of the method's own formula.
    pub fn truth(self, l: [f64; 3], r: [f64; 3], light: &DistantLight) -> [f64; 3] {
        match self {
            Self::Epic | Self::Factored => oracle::factored_direction(l, r, light.sin()),
            Self::Disc | Self::Cap => oracle::nearest_in_disc(l, r, light.angular_radius()),
        }
    }

    /// Whether the formula's direction is well defined: the representative point may fall into the origin, and beside
    /// `-l` every direction of the rim is as near.
    pub fn is_defined(self, l: [f64; 3], r: [f64; 3], light: &DistantLight, epsilon: f64) -> bool {
        match self {
            Self::Epic | Self::Factored => oracle::factored_length(l, r, light.sin()) > 0.1,
            Self::Disc | Self::Cap => oracle::angle_between(l, r.map(|lane| -lane)) > epsilon,
        }
    }
}
