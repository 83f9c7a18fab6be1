//! Lights of every description, with the truth of their constants.

use std::f64::consts::PI;

use sunglint::DistantLight;

use super::{Big, big, cosine, spread, square, versine};

/// What the sine, cosine and versine of an angular radius are.
pub struct Truth {
    pub sin: Big,
    pub cos: Big,
    pub versine: Big,
}

impl Truth {
    pub fn of_ratio(ratio: Big) -> Self {
        Self { cos: cosine(&ratio), versine: versine(&ratio), sin: ratio }
    }

    pub fn of_angle(theta: &Big) -> Self {
        let (sin, cos) = theta.sin_cos();
        let half = (theta / big(2.0)).sin();
        Self { sin, cos, versine: big(2.0) * square(&half) }
    }

    /// In units of a turn, so that the zeros at 180 and 360 degrees are zeros.
    pub fn of_degrees(angle: f64) -> Self {
        let (sin, cos) = big(angle).sin_cos_unit(720);
        let half = big(angle).sin_unit(1440);
        Self { sin, cos, versine: big(2.0) * square(&half) }
    }
}

pub fn ratios() -> impl Iterator<Item = f64> {
    spread(1000, 1e-6, 1.0).chain([0.0, 1e-12, 1.0_f64.next_down()])
}

pub fn angles() -> impl Iterator<Item = f64> {
    let neighbours = [90.0_f64, 180.0, 270.0, 360.0].into_iter().flat_map(|angle| [angle.next_down(), angle]);
    let named = [0.0, 1e-6, 0.53, 179.999, 180.0_f64.next_up(), 180.001, 359.99];
    spread(1000, 1e-6, 360.0).chain(neighbours).chain(named)
}

pub fn angular_radii() -> impl Iterator<Item = f64> {
    let quarter = PI / 2.0;
    spread(1000, 1e-6, PI).chain([0.0, quarter.next_down(), quarter, quarter.next_up(), PI.next_down()])
}

pub fn by_ratio() -> impl Iterator<Item = (DistantLight, Truth)> {
    ratios().map(|ratio| (DistantLight::from_ratio(ratio).unwrap(), Truth::of_ratio(big(ratio))))
}

pub fn by_distance() -> impl Iterator<Item = (DistantLight, Truth)> {
    ratios().map(|ratio| {
        let (radius, distance) = (ratio * 149_597_870.7, 149_597_870.7);
        let light = DistantLight::from_radius_and_distance(radius, distance).unwrap();
        (light, Truth::of_ratio(big(radius) / big(distance)))
    })
}

pub fn by_angular_radius() -> impl Iterator<Item = (DistantLight, Truth)> {
    angular_radii().map(|theta| (DistantLight::from_angular_radius(theta).unwrap(), Truth::of_angle(&big(theta))))
}

pub fn by_angle() -> impl Iterator<Item = (DistantLight, Truth)> {
    angles().map(|angle| (DistantLight::from_angle(angle).unwrap(), Truth::of_degrees(angle)))
}

pub fn lights() -> impl Iterator<Item = (DistantLight, Truth)> {
    by_ratio().chain(by_distance()).chain(by_angular_radius()).chain(by_angle())
}
