//! Radiometry: how much light leaves a lamp, crosses the space between and arrives.
//!
//! | quantity | formula | unit | function |
//! |---|---|---|---|
//! | radiance of a lamp | `L = Phi / (A Omega)` | W/(m^2 sr) | [`area_radiance`], [`non_directional_radiance`], [`lambertian_radiance`], [`sphere_radiance`] |
//! | intensity of a point | `I = Phi / (4 pi)` | W/sr | [`point_intensity`] |
//! | irradiance by a point | `E = I cos / r^2` | W/m^2 | [`irradiance`] |
//! | solid angle of a small patch | `A cos / r^2` | sr | [`patch_solid_angle`] |
//! | projected area | `A cos` | m^2 | [`projected_area`] |
//! | power of a beam | `Phi = E A` | W | [`beam_power`] |
//! | radiosity of a matt surface | `B = rho E` | W/m^2 | [`radiosity`] |
//! | radiance of a matt surface | `L = rho E / pi` | W/(m^2 sr) | [`diffuse_radiance`] |
//! | flux between two small patches | `L A cos A' cos' / r^2` | W | [`flux`] |
//! | a point or directional light as a small sphere | `L = colour (d/R)^2` | | [`SphereLight`] |
//!
//! Everything is written over [`Scalar`]: a float format itself, or [`Scaled`](crate::real::Scaled) beside fixed-point
//! lanes and levels, which [`Real::of_lane`](crate::Real::of_lane), [`Real::of_level`](crate::Real::of_level) and
//! [`Real::level`](crate::Real::level) convert. [`raw`](crate::raw) has the ones that a pixel needs on bits.
//!
//! # Range
//!
//! Intermediates stay in range wherever factors and answer do, also in f16, where factors may be subnormal or so great
//! that one over them is: those give up a power of two ([`Scalar::NEAR_ONE`]), which costs floats two comparisons a
//! factor. Functions of what is lit take any
//! input: a cosine that is negative or NaN counts as 0 (no light from below the horizon is subtracted), a distance that
//! is zero, negative or NaN gives 0, and what overflows is the greatest finite number. Functions that describe a lamp
//! refuse what cannot be with a [`RadiometryError`].
//!
//! Error: one rounding a factor; relative, for factors and answers over all that the format holds, those below the
//! least normal number counted as that one (searched for, `tests/figures.rs`): at most 5.8e-16 in f64, 2.9e-7 in f32,
//! 3e-7 in micromath, 2.6e-3 in f16, 2.8e-9 beside fixed point; of [`SphereLight::radiance`] 1.1e-15, 4.8e-7, 1.1e-5
//! (micromath's root), 4.1e-3, 4.1e-9. Each formula's is in `trial::property::radiometry`.

mod error;
mod sphere_light;

pub use error::RadiometryError;
pub use sphere_light::SphereLight;

use crate::product::{quotient, saturated};
use crate::real::{Constant, Scalar};

const PI: Constant = Constant::new(core::f64::consts::PI);

const FOUR_PI: Constant = Constant::new(4.0 * core::f64::consts::PI);

/// Radiance of a lamp of `power` watts, `area` square metres, that shines evenly into `solid_angle` steradians: `Phi /
/// (A Omega)`.
///
/// # Errors
/// [`RadiometryError::Power`], [`RadiometryError::Area`] and [`RadiometryError::SolidAngle`] for what is out of range,
/// [`RadiometryError::Overflow`] where the answer is.
#[inline]
pub fn area_radiance<S: Scalar>(power: S, area: S, solid_angle: S) -> Result<S, RadiometryError<S>> {
    let power = not_negative(power).map_err(RadiometryError::Power)?;
    let area = positive(area).map_err(RadiometryError::Area)?;
    let solid_angle = positive(solid_angle).map_err(RadiometryError::SolidAngle)?;
    in_range(quotient([power], [area, solid_angle]))
}

/// Radiance of a lamp that shines evenly into all directions: `Phi / (4 pi A)`.
///
/// No surface does so. A surface is seen from one side alone and foreshortened, so a lamp whose radiance is the same
/// from everywhere has to have 4 times this radiance to give the power off: [`lambertian_radiance`]. A sphere with
/// this radiance lights a distant surface with a quarter of what [`point_intensity`] of the same power does.
///
/// # Errors
/// Those of [`area_radiance`].
#[inline]
pub fn non_directional_radiance<S: Scalar>(power: S, area: S) -> Result<S, RadiometryError<S>> {
    area_radiance(power, area, S::constant(FOUR_PI))
}

/// Radiance of a lamp that looks equally bright from everywhere: `Phi / (pi A)`, since the cosine of foreshortening
/// averages the half of the sky down from `2 pi` to `pi`.
///
/// # Errors
/// Those of [`area_radiance`].
#[inline]
pub fn lambertian_radiance<S: Scalar>(power: S, area: S) -> Result<S, RadiometryError<S>> {
    area_radiance(power, area, S::constant(PI))
}

/// Radiance of a sphere of `power` watts and `radius` metres that looks equally bright from everywhere: `Phi / (4 pi^2
/// R^2)`.
///
/// From afar it lights as [`point_intensity`] of the same power.
///
/// # Errors
/// [`RadiometryError::Power`] and [`RadiometryError::Length`] for what is out of range, [`RadiometryError::Overflow`]
/// where the answer is.
#[inline]
pub fn sphere_radiance<S: Scalar>(power: S, radius: S) -> Result<S, RadiometryError<S>> {
    const FOUR_PI_SQUARED: Constant = Constant::new(39.478_417_604_357_43);
    let power = not_negative(power).map_err(RadiometryError::Power)?;
    let radius = positive(radius).map_err(RadiometryError::Length)?;
    in_range(quotient([power], [S::constant(FOUR_PI_SQUARED), radius, radius]))
}

/// Intensity in W/sr of a point of `power` watts that shines evenly into all directions: `Phi / (4 pi)`.
///
/// # Errors
/// [`RadiometryError::Power`] where that is negative, NaN or infinite.
#[inline]
pub fn point_intensity<S: Scalar>(power: S) -> Result<S, RadiometryError<S>> {
    let power = not_negative(power).map_err(RadiometryError::Power)?;
    Ok(power / S::constant(FOUR_PI))
}

/// Irradiance in W/m^2 by a point of `intensity` W/sr at `distance` metres, whose direction makes an angle of cosine
/// `cos` with the surface's normal: `I cos / r^2`.
#[inline]
pub fn irradiance<S: Scalar>(intensity: S, cos: S, distance: S) -> S {
    foreshortened(intensity, cos, distance)
}

/// Solid angle in steradians of a patch of `area` square metres, small against its `distance` in metres, whose normal
/// makes an angle of cosine `cos` with the line of sight: `A cos / r^2`.
#[inline]
pub fn patch_solid_angle<S: Scalar>(area: S, cos: S, distance: S) -> S {
    foreshortened(area, cos, distance)
}

/// Area in square metres that `area` takes across a beam, its normal at an angle of cosine `cos` to it: `A cos`.
#[inline]
pub fn projected_area<S: Scalar>(area: S, cos: S) -> S {
    saturated(area * saturated(cos))
}

/// Power in watts of a beam of `irradiance` W/m^2 and `area` square metres across: `E A`.
#[inline]
pub fn beam_power<S: Scalar>(irradiance: S, area: S) -> S {
    saturated(irradiance * area)
}

/// Power in W/m^2 that leaves a surface of `albedo` under `irradiance`: `rho E`, into its whole half of the sky. What
/// a pixel shows of a matt surface is [`diffuse_radiance`].
#[inline]
pub fn radiosity<S: Scalar>(albedo: S, irradiance: S) -> S {
    saturated(albedo * irradiance)
}

/// Radiance in W/(m^2 sr) of a matt surface of `albedo` under `irradiance`, from everywhere: `rho E / pi`.
///
/// The classic slip is to leave out the `pi`: under a white sky of radiance 1, whose irradiance is `pi`, a white
/// surface has to have radiance 1.
#[inline]
pub fn diffuse_radiance<S: Scalar>(albedo: S, irradiance: S) -> S {
    saturated(quotient([albedo, irradiance], [S::constant(PI)]))
}

/// A small flat piece of a surface, as it lies to a line of sight.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Patch<S> {
    /// In square metres.
    pub area: S,
    /// Cosine of the angle between its normal and the line of sight.
    pub cos: S,
}

/// Power in watts that a patch of `radiance` W/(m^2 sr) sends to another at `distance` metres: the sender's projected
/// area times the receiver's solid angle, `L (A cos) (A' cos' / r^2)`.
///
/// The same is the receiver's projected area times the sender's solid angle: radiance does not change along a ray. So
/// the two patches may change places.
#[inline]
pub fn flux<S: Scalar>(radiance: S, sender: Patch<S>, receiver: Patch<S>, distance: S) -> S {
    let above = [radiance, sender.area, saturated(sender.cos), receiver.area, saturated(receiver.cos)];
    if distance > S::ZERO { saturated(quotient(above, [distance, distance])) } else { S::ZERO }
}

/// `value cos / distance^2`.
#[inline]
fn foreshortened<S: Scalar>(value: S, cos: S, distance: S) -> S {
    if distance > S::ZERO { saturated(quotient([value, saturated(cos)], [distance, distance])) } else { S::ZERO }
}

/// A number that is allowed to be zero; refused as it is.
fn not_negative<S: Scalar>(value: S) -> Result<S, S> {
    if value >= S::ZERO && value <= S::MAX { Ok(value) } else { Err(value) }
}

fn positive<S: Scalar>(value: S) -> Result<S, S> {
    if value > S::ZERO && value <= S::MAX { Ok(value) } else { Err(value) }
}

fn in_range<S: Scalar>(value: S) -> Result<S, RadiometryError<S>> {
    if value <= S::MAX { Ok(value) } else { Err(RadiometryError::Overflow) }
}
