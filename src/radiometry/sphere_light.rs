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
    ///
    /// ```
    /// use sunglint::radiometry::{RadiometryError, SphereLight};
    ///
    /// // A bulb 2 m above a table that it makes white, as a ball of 5 cm.
    /// let bulb = SphereLight::of_point([0.0, 0.0, 2.0], [0.0; 3], 0.05, [1.0_f32; 3])?;
    /// assert_eq!(bulb.distance(), 2.0);
    /// let around = SphereLight::of_point([0.0, 0.0, 2.0], [0.0; 3], 3.0, [1.0_f32; 3]);
    /// assert_eq!(around, Err(RadiometryError::Inside { radius: 3.0, distance: 2.0 }));
    /// # Ok::<(), RadiometryError<f32>>(())
    /// ```
    pub fn of_point(position: [S; 3], target: [S; 3], radius: S, colour: [S; 3]) -> Result<Self, RadiometryError<S>> {
        let distance = length(zip(position, target, |a, b| a - b));
        Self::checked(position, radius, distance, colour)
    }

    /// A light from `direction`, of any length, put `distance` away from the origin.
    ///
    /// # Errors
    /// Those of [`SphereLight::of_point`], and [`RadiometryError::Length`] where the direction has no length.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::radiometry::{RadiometryError, SphereLight};
    ///
    /// let [distance, radius] = [100.0, 1.0].map(f16::from_f32);
    /// let direction = [0.0, 3.0, 4.0].map(f16::from_f32);
    /// let lamp = SphereLight::of_direction(direction, distance, radius, [f16::ONE; 3])?;
    /// assert_eq!(lamp.centre().map(f16::to_f32), [0.0, 60.0, 80.0]);
    /// let nowhere = SphereLight::of_direction([f16::ZERO; 3], distance, radius, [f16::ONE; 3]);
    /// assert_eq!(nowhere, Err(RadiometryError::Length(f16::ZERO)));
    /// # Ok::<(), RadiometryError<f16>>(())
    /// ```
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
    ///
    /// ```
    /// use sunglint::radiometry::{RadiometryError, SphereLight};
    ///
    /// let sun = SphereLight::like_the_sun([0.0, 0.0, 1.0], 149_597_870.7_f64, [1.0; 3])?;
    /// assert!((sun.radius() - 695_700.0).abs() < 1e-6);
    /// assert_eq!(SphereLight::like_the_sun([0.0, 0.0, 1.0], -1.0, [1.0; 3]), Err(RadiometryError::Length(-1.0)));
    /// # Ok::<(), RadiometryError<f64>>(())
    /// ```
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
    ///
    /// ```
    /// use sunglint::radiometry::SphereLight;
    ///
    /// let lamp = SphereLight::of_point([1.0, 2.0, 5.0_f32], [1.0, 2.0, 3.0], 0.1, [1.0; 3])?;
    /// assert_eq!(lamp.centre(), [1.0, 2.0, 5.0]);
    /// # Ok::<(), sunglint::radiometry::RadiometryError<f32>>(())
    /// ```
    pub fn centre(&self) -> [S; 3] {
        self.centre
    }

    /// How large it is.
    ///
    /// ```
    /// use sunglint::radiometry::SphereLight;
    ///
    /// // In the unit of the distance: of a kilometre, 4.65 m.
    /// let sun = SphereLight::like_the_sun([0.0, 0.0, 1.0], 1000.0_f32, [1.0; 3])?;
    /// assert!((sun.radius() - 4.650_467).abs() < 1e-6);
    /// # Ok::<(), sunglint::radiometry::RadiometryError<f32>>(())
    /// ```
    pub fn radius(&self) -> S {
        self.radius
    }

    /// How far it is from what it was normalised for.
    ///
    /// ```
    /// use sunglint::radiometry::SphereLight;
    /// use sunglint::real::Scaled;
    ///
    /// let [nought, three, four, five] = [0, 3, 4, 5].map(|metres| Scaled::from_bits(metres, 0));
    /// let lamp = SphereLight::of_point([nought, three, four], [nought; 3], Scaled::from_bits(1, -3), [three; 3])?;
    /// assert_eq!(lamp.distance(), five);
    /// # Ok::<(), sunglint::radiometry::RadiometryError<Scaled>>(())
    /// ```
    pub fn distance(&self) -> S {
        self.distance
    }

    /// What a white surface shows that faces it from that distance: the normalised form.
    ///
    /// ```
    /// use sunglint::radiometry::SphereLight;
    ///
    /// // What the radiance is made of, and what every format can hold.
    /// let evening = SphereLight::like_the_sun([0.0, 0.8, 0.6], 1000.0_f32, [1.0, 0.7, 0.4])?;
    /// assert_eq!(evening.colour(), [1.0, 0.7, 0.4]);
    /// # Ok::<(), sunglint::radiometry::RadiometryError<f32>>(())
    /// ```
    pub fn colour(&self) -> [S; 3] {
        self.colour
    }

    /// Radius over distance, the sine of its angular radius there.
    ///
    /// ```
    /// use sunglint::DistantLight;
    /// use sunglint::radiometry::SphereLight;
    ///
    /// let lamp = SphereLight::of_point([0.0, 0.0, 4.0], [0.0; 3], 0.5, [1.0_f64; 3])?;
    /// assert_eq!(lamp.ratio(), 0.125);
    /// // The same light, for highlights.
    /// assert_eq!(DistantLight::from_ratio(lamp.ratio())?.sin(), 0.125);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn ratio(&self) -> S {
        self.radius / self.distance
    }

    /// Radiance of the three channels: `colour (d / R)^2`.
    ///
    /// A distance that is subnormal, in f16 below 6.1e-5, has few digits, and so has the radiance then.
    ///
    /// # Errors
    /// [`RadiometryError::Overflow`] where that is infinite, in f16 from a white Sun's 46 239 times 1.417 on.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::radiometry::{RadiometryError, SphereLight};
    ///
    /// let sun = |colour: f32| {
    ///     let up = [f16::ZERO, f16::ZERO, f16::ONE];
    ///     SphereLight::like_the_sun(up, f16::from_f32(100.0), [f16::from_f32(colour); 3])
    /// };
    /// let [red, _, _] = sun(1.0)?.radiance()?;
    /// assert!((red.to_f32() / 46_239.0 - 1.0).abs() < 4.1e-3);
    /// // Half as bright again is more than f16 holds; the colour it holds.
    /// assert_eq!(sun(1.5)?.radiance(), Err(RadiometryError::Overflow));
    /// # Ok::<(), RadiometryError<f16>>(())
    /// ```
    pub fn radiance(&self) -> Result<[S; 3], RadiometryError<S>> {
        let channel =
            |colour: S| in_range(quotient([colour, self.distance, self.distance], [self.radius, self.radius]));
        let [red, green, blue] = self.colour;
        Ok([channel(red)?, channel(green)?, channel(blue)?])
    }

    /// The radiance as light levels of the format `T`.
    ///
    /// # Errors
    /// [`RadiometryError::Overflow`] where a channel is above the greatest level: 65 536 for I2F14 and I16F16,
    /// `2^32` for I2F30.
    ///
    /// ```
    /// use sunglint::fixed::types::{I2F14, I2F30};
    /// use sunglint::radiometry::{RadiometryError, SphereLight};
    /// use sunglint::real::Scaled;
    ///
    /// let [nought, one, thousand] = [0, 1, 1000].map(|bits| Scaled::from_bits(bits, 0));
    /// // (d / R)^2 is a million: too much for U16F16, not for U32F32.
    /// let lamp = SphereLight::of_point([nought, nought, thousand], [nought; 3], one, [one; 3])?;
    /// assert_eq!(lamp.radiance_levels::<I2F14>(), Err(RadiometryError::Overflow));
    /// assert_eq!(lamp.radiance_levels::<I2F30>()?.map(|level| level.to_num::<u32>()), [1_000_000; 3]);
    /// # Ok::<(), RadiometryError<Scaled>>(())
    /// ```
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
