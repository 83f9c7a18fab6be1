//! Lights without a size, made into small spheres, so that a renderer with area lights needs no other kind.

use super::{RadiometryError, in_range, not_negative, positive};
use crate::light::{ASTRONOMICAL_UNIT_KM, SOLAR_RADIUS_KM};
use crate::product::quotient;
use crate::real::{Constant, Real, Scalar};
use crate::vec3::{each, zip};

/// The Sun's radius over its distance.
const SUN_RATIO: Constant = Constant::new(SOLAR_RADIUS_KM / ASTRONOMICAL_UNIT_KM);

/// A small sphere in place of a point or directional light, of a radiance that makes a white surface which faces it
/// from `distance` have exactly the light's colour.
///
/// The normalised form is the colour itself, which every format holds: what a facing white surface shows. The radiance
/// is `(distance / radius)^2` times that, 46 239 for a sphere that looks like the Sun: over the top of a signed Q16.16
/// and just within U16F16 and f16, while the Sun from Mars (107 352) is in neither. Hence [`SphereLight::radiance`] may
/// fail where the light itself is fine. Shading that multiplies the radiance by the disc's `sin^2` again needs the
/// colour only.
///
/// Surfaces elsewhere see the inverse square of their own distance, as they should of a lamp; for a directional light
/// choose a great distance.
///
/// ```
/// use sunglint::radiometry::SphereLight;
///
/// let sun = SphereLight::like_the_sun([0.0, 0.6, 0.8], 1000.0, [1.0, 0.9, 0.8_f32])?;
/// assert_eq!(sun.centre(), [0.0, 600.0, 800.0]);
/// assert!((sun.radius() - 4.650467).abs() < 1e-6);
/// assert!((sun.radiance()?[0] - 46_239.0).abs() < 1.0);
/// # Ok::<(), sunglint::radiometry::RadiometryError<f32>>(())
/// ```
///
/// With the feature `serde` it has four fields, `centre`, `radius`, `distance` and `colour`, which are checked when they
/// are read.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(try_from = "stored::Fields<S>", bound(deserialize = "S: Scalar + serde::Deserialize<'de>"))
)]
pub struct SphereLight<S> {
    centre: [S; 3],
    radius: S,
    distance: S,
    colour: [S; 3],
}

impl<S: Scalar> SphereLight<S> {
    /// A point light at `position` of the `colour` that it gives a white surface at `target`; any small `radius`, in
    /// the same unit, will do.
    ///
    /// # Errors
    /// [`RadiometryError::Length`] where the radius, or the distance of the two positions, is not positive and finite;
    /// [`RadiometryError::Inside`] where the radius is greater than that distance; [`RadiometryError::Colour`] where a
    /// channel is negative, NaN or infinite.
    pub fn of_point(position: [S; 3], target: [S; 3], radius: S, colour: [S; 3]) -> Result<Self, RadiometryError<S>> {
        let distance = length(zip(position, target, |a, b| a - b));
        Self::checked(position, radius, distance, colour)
    }

    /// A light from `direction`, of any length, put `distance` away from the origin.
    ///
    /// # Errors
    /// Those of [`SphereLight::of_point`], and [`RadiometryError::Length`] where the direction has no length.
    pub fn of_direction(direction: [S; 3], distance: S, radius: S, colour: [S; 3]) -> Result<Self, RadiometryError<S>> {
        let scale = positive(distance).map_err(RadiometryError::Length)?;
        let size = positive(length(direction)).map_err(RadiometryError::Length)?;
        Self::checked(each(direction, |lane| lane / size * scale), radius, distance, colour)
    }

    /// A light from `direction`, put `distance` away, that looks as large as the Sun: its radius is the distance times
    /// 695 700 / 149 597 870.7.
    ///
    /// # Errors
    /// Those of [`SphereLight::of_direction`].
    pub fn like_the_sun(direction: [S; 3], distance: S, colour: [S; 3]) -> Result<Self, RadiometryError<S>> {
        Self::of_direction(direction, distance, distance * S::constant(SUN_RATIO), colour)
    }

    fn checked(centre: [S; 3], radius: S, distance: S, colour: [S; 3]) -> Result<Self, RadiometryError<S>> {
        let distance = positive(distance).map_err(RadiometryError::Length)?;
        let radius = positive(radius).map_err(RadiometryError::Length)?;
        if radius > distance {
            return Err(RadiometryError::Inside { radius, distance });
        }
        for channel in colour {
            not_negative(channel).map_err(RadiometryError::Colour)?;
        }
        Ok(Self { centre, radius, distance, colour })
    }

    /// Where it is.
    pub fn centre(&self) -> [S; 3] {
        self.centre
    }

    /// How large it is.
    pub fn radius(&self) -> S {
        self.radius
    }

    /// How far it is from what it was normalised for.
    pub fn distance(&self) -> S {
        self.distance
    }

    /// What a white surface shows that faces it from that distance: the normalised form.
    pub fn colour(&self) -> [S; 3] {
        self.colour
    }

    /// Radius over distance, the sine of its angular radius there.
    pub fn ratio(&self) -> S {
        self.radius / self.distance
    }

    /// Radiance of the three channels: `colour (d / R)^2`.
    ///
    /// A distance that is subnormal, in f16 below 6.1e-5, has few digits, and so has the radiance then.
    ///
    /// # Errors
    /// [`RadiometryError::Overflow`] where that is infinite, in f16 from a white Sun's 46 239 times 1.417 on.
    pub fn radiance(&self) -> Result<[S; 3], RadiometryError<S>> {
        let channel =
            |colour: S| in_range(quotient([colour, self.distance, self.distance], [self.radius, self.radius]));
        let [red, green, blue] = self.colour;
        Ok([channel(red)?, channel(green)?, channel(blue)?])
    }

    /// The radiance as light levels of the format `T`.
    ///
    /// # Errors
    /// [`RadiometryError::Overflow`] where a channel is above the greatest level: 65 536 for I2F14 and I16F16.
    pub fn radiance_levels<T: Real<Scalar = S>>(&self) -> Result<[T::Level; 3], RadiometryError<S>> {
        let radiance = self.radiance()?;
        let top = T::of_level(T::level(S::MAX));
        if radiance.into_iter().all(|channel| channel <= top) {
            Ok(each(radiance, T::level))
        } else {
            Err(RadiometryError::Overflow)
        }
    }
}

#[cfg(feature = "serde")]
mod stored {
    use super::{RadiometryError, Scalar, SphereLight};

    /// What a file has of a light, before it is checked.
    #[derive(serde::Deserialize)]
    #[serde(rename = "SphereLight", deny_unknown_fields)]
    pub(super) struct Fields<S> {
        centre: [S; 3],
        radius: S,
        distance: S,
        colour: [S; 3],
    }

    impl<S: Scalar> TryFrom<Fields<S>> for SphereLight<S> {
        type Error = RadiometryError<S>;

        fn try_from(fields: Fields<S>) -> Result<Self, RadiometryError<S>> {
            Self::checked(fields.centre, fields.radius, fields.distance, fields.colour)
        }
    }
}

/// The length of a vector, by its greatest lane, so that no square leaves the range; NaN or zero for NaN.
fn length<S: Scalar>(v: [S; 3]) -> S {
    let size = each(v, |lane| if lane < S::ZERO { S::ZERO - lane } else { lane });
    let greatest = size.into_iter().fold(S::ZERO, |most, lane| if lane <= most { most } else { lane });
    if !(greatest > S::ZERO && greatest <= S::MAX) {
        return greatest;
    }
    let [x, y, z] = each(v, |lane| lane / greatest);
    greatest * (x * x + y * y + z * z).root()
}
