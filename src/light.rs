//! A distant light as it is described: radius over distance, an angle, or a radius and a distance, in f64.

mod description;

use core::fmt;

pub use self::description::Description;
use crate::constant;

/// The Sun seen from one astronomical unit: the IAU's nominal solar radius (2015 resolution B3, 695 700 km) over the
/// astronomical unit (2012 resolution B2, 149 597 870.7 km). Radius over distance is 0.004 650 467 26.
pub const SUN: DistantLight = match DistantLight::from_radius_and_distance(SOLAR_RADIUS_KM, ASTRONOMICAL_UNIT_KM) {
    Ok(sun) => sun,
    Err(_) => panic!("the Sun is farther away than it is wide"),
};

/// The IAU's nominal solar radius in kilometres.
pub const SOLAR_RADIUS_KM: f64 = 695_700.0;

/// The astronomical unit in kilometres.
pub const ASTRONOMICAL_UNIT_KM: f64 = 149_597_870.7;

/// A light at a distance that no movement in the scene changes: a sphere of which only the angle counts.
///
/// Holds the sine, cosine and versine (`1 - cos`) of the angular radius in f64, each within four units in the
/// last place (`tests/light.rs`), and is built in constants as well as at run time:
///
/// ```
/// use sunglint::DistantLight;
///
/// const LAMP: DistantLight = match DistantLight::from_ratio(0.05) {
///     Ok(lamp) => lamp,
///     Err(_) => panic!("a ratio lies between 0 and 1"),
/// };
/// assert_eq!(LAMP.sin(), 0.05);
/// ```
///
/// To light pixels, put its constants into a number format: [`DistantSphere`](crate::DistantSphere).
///
/// With the feature `serde` it is written as it was described, under the constructor's name, and read by that
/// constructor, which refuses what it always refuses. In JSON:
///
/// ```json
/// [
///     { "radius_and_distance": { "radius": 695700.0, "distance": 149597870.7 } },
///     { "ratio": 0.05 },
///     { "angle": 0.53 },
///     { "angular_radius": 0.00465 }
/// ]
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Description", into = "Description"))]
pub struct DistantLight {
    sin: f64,
    cos: f64,
    versine: f64,
    description: Description,
}

impl DistantLight {
    /// A sphere whose radius over distance is `ratio`, from 0 (a point at infinity) to 1 (seen from its surface).
    ///
    /// ```
    /// use sunglint::{DistantLight, LightError};
    ///
    /// // A lamp 10 cm across, one metre away.
    /// let lamp = DistantLight::from_ratio(0.05 / 1.0).unwrap();
    /// assert!((lamp.angular_radius().to_degrees() - 2.866).abs() < 0.001);
    /// // From nearer than its surface there is no disc.
    /// assert_eq!(DistantLight::from_ratio(1.5), Err(LightError::Ratio(1.5)));
    /// ```
    ///
    /// # Errors
    /// [`LightError::Ratio`] for NaN, negative values and values above 1.
    pub const fn from_ratio(ratio: f64) -> Result<Self, LightError> {
        if !(ratio >= 0.0 && ratio <= 1.0) {
            return Err(LightError::Ratio(ratio));
        }
        Ok(Self::sphere(ratio, [ratio, 1.0], Description::Ratio(ratio)))
    }

    /// A sphere of `radius` at `distance`, both in the same unit.
    ///
    /// ```
    /// use sunglint::{DistantLight, LightError, SUN};
    ///
    /// // The Moon, in kilometres, is a little narrower than the Sun.
    /// let moon = DistantLight::from_radius_and_distance(1737.4, 384_400.0).unwrap();
    /// assert!((moon.sin() / SUN.sin() - 0.972).abs() < 0.001);
    /// assert_eq!(DistantLight::from_radius_and_distance(1.0, 0.0), Err(LightError::Distance(0.0)));
    /// ```
    ///
    /// # Errors
    /// [`LightError::Distance`] where `distance` is not positive and finite, [`LightError::Radius`] where `radius` is
    /// NaN, negative or greater than `distance` (the viewer would be inside).
    pub const fn from_radius_and_distance(radius: f64, distance: f64) -> Result<Self, LightError> {
        if !(distance > 0.0 && distance <= f64::MAX) {
            return Err(LightError::Distance(distance));
        }
        if !(radius >= 0.0 && radius <= distance) {
            return Err(LightError::Radius { radius, distance });
        }
        let description = Description::RadiusAndDistance { radius, distance };
        Ok(Self::sphere(radius / distance, [radius, distance], description))
    }

    /// A disc in the sky of angular radius `theta` radians, from 0 to pi.
    ///
    /// ```
    /// use sunglint::{DistantLight, LightError};
    ///
    /// let lamp = DistantLight::from_angular_radius(0.1).unwrap();
    /// assert!((lamp.sin() - 0.099_833).abs() < 1e-6);
    /// // Degrees in place of radians are refused where they can be told.
    /// assert_eq!(DistantLight::from_angular_radius(30.0), Err(LightError::AngularRadius(30.0)));
    /// ```
    ///
    /// # Errors
    /// [`LightError::AngularRadius`] for NaN and values out of that range.
    pub const fn from_angular_radius(theta: f64) -> Result<Self, LightError> {
        if !(theta >= 0.0 && theta <= core::f64::consts::PI) {
            return Err(LightError::AngularRadius(theta));
        }
        let half = constant::sin(theta / 2.0);
        Ok(Self::disc(constant::sin(theta), constant::cos(theta), half, Description::AngularRadius(theta)))
    }

    /// A disc in the sky as UsdLux `angle` gives it: the angular *diameter* in *degrees*, from 0 to 360.
    ///
    /// ```
    /// use sunglint::{DistantLight, LightError, SUN};
    ///
    /// // UsdLux's default is the Sun's diameter, rounded: half a per cent less.
    /// let usd = DistantLight::from_angle(0.53).unwrap();
    /// assert!((usd.sin() / SUN.sin() - 0.9945).abs() < 1e-4);
    /// assert_eq!(DistantLight::from_angle(400.0), Err(LightError::Angle(400.0)));
    /// ```
    ///
    /// # Errors
    /// [`LightError::Angle`] for NaN and values out of that range.
    pub const fn from_angle(angle: f64) -> Result<Self, LightError> {
        if !(angle >= 0.0 && angle <= 360.0) {
            return Err(LightError::Angle(angle));
        }
        let theta = angle / 2.0;
        let half = constant::sin_degrees(theta / 2.0);
        let description = Description::Angle(angle);
        Ok(Self::disc(constant::sin_degrees(theta), constant::cos_degrees(theta), half, description))
    }

    const fn sphere(sin: f64, [radius, distance]: [f64; 2], description: Description) -> Self {
        // Neither 1 - x^2 nor 1 - cos is formed by a subtraction that cancels, nor 1 - x from an x that was rounded.
        let cos = constant::sqrt((distance - radius) / distance * (1.0 + sin));
        Self { sin, cos, versine: sin * sin / (1.0 + cos), description }
    }

    /// `half` is the sine of half the angular radius.
    const fn disc(sin: f64, cos: f64, half: f64, description: Description) -> Self {
        // Only where the cosine is close to 1 does the difference cancel.
        let versine = if cos < 0.5 { 1.0 - cos } else { 2.0 * half * half };
        Self { sin, cos, versine, description }
    }

    /// Sine of the angular radius; radius over distance for all that subtend up to half the sky.
    ///
    /// ```
    /// use sunglint::{DistantLight, SUN};
    ///
    /// assert!((SUN.sin() - 695_700.0 / 149_597_870.7).abs() < 1e-18);
    /// // Three quarters of a turn wide: it falls again beyond half the sky.
    /// assert!((DistantLight::from_angle(270.0).unwrap().sin() - 0.5_f64.sqrt()).abs() < 1e-15);
    /// ```
    #[doc(alias = "ratio")]
    pub const fn sin(&self) -> f64 {
        self.sin
    }

    /// Cosine of the angular radius; negative beyond half the sky.
    ///
    /// ```
    /// use sunglint::{DistantLight, SUN};
    ///
    /// assert!((SUN.cos() - 0.999_989_186_5).abs() < 1e-10);
    /// assert_eq!(DistantLight::from_angle(360.0).unwrap().cos(), -1.0);
    /// ```
    pub const fn cos(&self) -> f64 {
        self.cos
    }

    /// `1 - cos` of the angular radius, from 0 to 2, to full precision for small discs.
    ///
    /// ```
    /// use sunglint::DistantLight;
    ///
    /// let star = DistantLight::from_ratio(1e-9).unwrap();
    /// assert_eq!(star.versine(), 5e-19);
    /// // By subtraction nothing is left of it.
    /// assert_eq!(1.0 - star.cos(), 0.0);
    /// ```
    pub const fn versine(&self) -> f64 {
        self.versine
    }

    /// What it was made of, and by which constructor.
    ///
    /// ```
    /// use sunglint::light::Description;
    /// use sunglint::{DistantLight, SUN};
    ///
    /// assert_eq!(DistantLight::from_ratio(0.05)?.description(), Description::Ratio(0.05));
    /// assert!(matches!(SUN.description(), Description::RadiusAndDistance { radius: 695_700.0, .. }));
    /// # Ok::<(), sunglint::LightError>(())
    /// ```
    pub const fn description(&self) -> Description {
        self.description
    }

    /// Radius, in the unit that the light was given in; the ratio itself where no distance was given.
    ///
    /// ```
    /// use sunglint::{DistantLight, SUN};
    ///
    /// assert_eq!(SUN.radius(), 695_700.0); // kilometres
    /// assert_eq!(DistantLight::from_ratio(0.05).unwrap().radius(), 0.05);
    /// ```
    pub const fn radius(&self) -> f64 {
        match self.description {
            Description::RadiusAndDistance { radius, .. } => radius,
            _ if self.cos < 0.0 => 1.0,
            _ => self.sin,
        }
    }

    /// Distance, in the unit that the light was given in; 1 where none was given.
    ///
    /// ```
    /// use sunglint::{DistantLight, SUN};
    ///
    /// assert_eq!(SUN.distance(), 149_597_870.7); // kilometres
    /// assert_eq!(DistantLight::from_angle(0.53).unwrap().distance(), 1.0);
    /// ```
    pub const fn distance(&self) -> f64 {
        match self.description {
            Description::RadiusAndDistance { distance, .. } => distance,
            _ => 1.0,
        }
    }

    /// The angular radius in radians, from 0 to pi.
    ///
    /// ```
    /// // The Sun is 0.533 degrees wide.
    /// let diameter = 2.0 * sunglint::SUN.angular_radius();
    /// assert!((diameter.to_degrees() - 0.5329).abs() < 1e-4);
    /// ```
    pub fn angular_radius(&self) -> f64 {
        libm::atan2(self.sin, self.cos)
    }
}

/// Equal are lights whose sine, cosine, versine, radius and distance are, whichever constructor made them.
impl PartialEq for DistantLight {
    fn eq(&self, other: &Self) -> bool {
        let numbers = |light: &Self| [light.sin, light.cos, light.versine, light.radius(), light.distance()];
        numbers(self) == numbers(other)
    }
}

/// Why a light, or a quantity of a light, could not be made; holds the value, and displays the range allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum LightError {
    /// Radius over distance is not within 0 to 1.
    Ratio(f64),
    /// Radius over distance in raw Q30 bits is not within 0 to `2^30`.
    RatioQ30(i32),
    /// UsdLux `angle` is not within 0 to 360 degrees.
    Angle(f64),
    /// The angular radius is not within 0 to pi radians.
    AngularRadius(f64),
    /// The angular radius of a sphere is not within 0 to pi/2 radians.
    SphereAngularRadius(f64),
    /// The angular radius in raw Q30 bits is not within 0 to pi/2.
    AngularRadiusQ30(i32),
    /// The radius is negative, NaN or greater than the distance.
    Radius {
        /// The radius given.
        radius: f64,
        /// The distance given, which is the greatest radius allowed.
        distance: f64,
    },
    /// The distance is not positive and finite.
    Distance(f64),
    /// A distance in raw bits of a fixed-point format is not positive.
    DistanceBits(i32),
    /// The intensity is negative, NaN or infinite.
    Intensity(f64),
    /// The roughness width `alpha` is not within 0 to 1.
    Alpha(f64),
    /// The roughness width `alpha` in raw Q30 bits is not within 0 to `2^30`.
    AlphaQ30(i32),
    /// The answer is infinite or greater than the format's greatest number, whose name is held.
    Overflow(&'static str),
}

impl fmt::Display for LightError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Ratio(value) => write!(f, "radius over distance is {value}, allowed is 0 to 1"),
            Self::RatioQ30(bits) => write!(f, "radius over distance is {bits} in Q30, allowed is 0 to {}", 1 << 30),
            Self::Angle(value) => write!(f, "angle is {value} degrees, allowed is 0 to 360"),
            Self::AngularRadius(value) => write!(f, "angular radius is {value} radians, allowed is 0 to pi"),
            Self::SphereAngularRadius(value) => {
                write!(f, "angular radius of a sphere is {value} radians, allowed is 0 to pi/2")
            }
            Self::AngularRadiusQ30(bits) => {
                write!(f, "angular radius is {bits} in Q30, allowed is 0 to 1686629713 (pi/2)")
            }
            Self::Radius { radius, distance } => {
                write!(f, "radius is {radius}, allowed is 0 to the distance {distance}")
            }
            Self::Distance(value) => write!(f, "distance is {value}, allowed is any positive finite number"),
            Self::DistanceBits(bits) => write!(f, "distance is {bits} in raw bits, allowed is 1 to {}", i32::MAX),
            Self::Intensity(value) => write!(f, "intensity is {value}, allowed is any finite number from 0"),
            Self::Alpha(value) => write!(f, "alpha is {value}, allowed is 0 to 1"),
            Self::AlphaQ30(bits) => write!(f, "alpha is {bits} in Q30, allowed is 0 to {}", 1 << 30),
            Self::Overflow(format) => write!(f, "the answer is greater than the greatest number of {format}"),
        }
    }
}

impl core::error::Error for LightError {}
