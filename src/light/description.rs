//! How a light was described, which is what is stored of it.

use super::{DistantLight, LightError};

/// The constructors of a [`DistantLight`], by their names, with what they take.
///
/// ```
/// use sunglint::DistantLight;
/// use sunglint::light::Description;
///
/// let lamp = DistantLight::try_from(Description::Angle(0.53))?;
/// assert_eq!(Ok(lamp), DistantLight::from_angle(0.53));
/// assert_eq!(lamp.description(), Description::Angle(0.53));
/// # Ok::<(), sunglint::LightError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename = "DistantLight", rename_all = "snake_case", deny_unknown_fields))]
#[non_exhaustive]
pub enum Description {
    /// Of [`DistantLight::from_ratio`].
    Ratio(f64),
    /// Of [`DistantLight::from_radius_and_distance`].
    RadiusAndDistance {
        /// The radius.
        radius: f64,
        /// The distance, in the same unit.
        distance: f64,
    },
    /// Of [`DistantLight::from_angular_radius`], in radians.
    AngularRadius(f64),
    /// Of [`DistantLight::from_angle`]: the diameter, in degrees.
    Angle(f64),
}

impl TryFrom<Description> for DistantLight {
    type Error = LightError;

    fn try_from(description: Description) -> Result<Self, LightError> {
        match description {
            Description::Ratio(ratio) => Self::from_ratio(ratio),
            Description::RadiusAndDistance { radius, distance } => Self::from_radius_and_distance(radius, distance),
            Description::AngularRadius(theta) => Self::from_angular_radius(theta),
            Description::Angle(angle) => Self::from_angle(angle),
        }
    }
}

impl From<DistantLight> for Description {
    fn from(light: DistantLight) -> Self {
        light.description()
    }
}
