//! The lights that are tried: the Sun from three planets, and area lights.

use crate::light::{ASTRONOMICAL_UNIT_KM, DistantLight, SOLAR_RADIUS_KM, SUN};

/// A light with a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Name, as tables and charts print it.
    pub name: &'static str,
    /// The light.
    pub light: DistantLight,
}

/// The lights of the study: the Sun from the semi-major axes of Earth's, Mars's and Jupiter's orbits (1, 1.523 71 and
/// 5.202 89 astronomical units: Standish's mean elements, J2000), and two area lights.
pub const STUDY: [Light; 5] = [
    Light { name: "Sun from Earth", light: SUN },
    Light { name: "Sun from Mars", light: sun_from(1.523_71) },
    Light { name: "Sun from Jupiter", light: sun_from(5.202_89) },
    Light { name: "area light 0.05", light: ratio(0.05) },
    Light { name: "area light 0.5", light: ratio(0.5) },
];

/// The lights that the error budgets are for: the Sun and ratios from the tiny to the whole half of the sky.
pub const BUDGETED: [Light; 6] = [
    Light { name: "Sun", light: SUN },
    Light { name: "0.0001", light: ratio(1e-4) },
    Light { name: "0.05", light: ratio(0.05) },
    Light { name: "0.5", light: ratio(0.5) },
    Light { name: "0.9", light: ratio(0.9) },
    Light { name: "1", light: ratio(1.0) },
];

const fn sun_from(astronomical_units: f64) -> DistantLight {
    match DistantLight::from_radius_and_distance(SOLAR_RADIUS_KM, astronomical_units * ASTRONOMICAL_UNIT_KM) {
        Ok(light) => light,
        Err(_) => panic!("planets are outside the Sun"),
    }
}

const fn ratio(ratio: f64) -> DistantLight {
    match DistantLight::from_ratio(ratio) {
        Ok(light) => light,
        Err(_) => panic!("a ratio lies within 0 to 1"),
    }
}
