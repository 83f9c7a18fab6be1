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
///
/// ```
/// use sunglint::radiometry::{RadiometryError, area_radiance};
///
/// // A projector: 20 W through 5 cm^2 into a tenth of a steradian.
/// let radiance = area_radiance(20.0_f32, 5e-4, 0.1)?;
/// assert!((radiance / 4e5 - 1.0).abs() < 1e-6);
/// assert_eq!(area_radiance(20.0_f32, 0.0, 0.1), Err(RadiometryError::Area(0.0)));
/// assert_eq!(area_radiance(1e30_f32, 1e-5, 1e-5), Err(RadiometryError::Overflow));
/// # Ok::<(), RadiometryError<f32>>(())
/// ```
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
///
/// ```
/// use sunglint::radiometry::{lambertian_radiance, non_directional_radiance};
///
/// // A quarter of what a surface has to have that gives off as much.
/// let [even, seen] = [non_directional_radiance(40.0_f64, 0.5)?, lambertian_radiance(40.0, 0.5)?];
/// assert!((even - 6.3662).abs() < 1e-4 && (seen / even - 4.0).abs() < 1e-15);
/// # Ok::<(), sunglint::radiometry::RadiometryError<f64>>(())
/// ```
#[inline]
pub fn non_directional_radiance<S: Scalar>(power: S, area: S) -> Result<S, RadiometryError<S>> {
    area_radiance(power, area, S::constant(FOUR_PI))
}

/// Radiance of a lamp that looks equally bright from everywhere: `Phi / (pi A)`, since the cosine of foreshortening
/// averages the half of the sky down from `2 pi` to `pi`.
///
/// # Errors
/// Those of [`area_radiance`].
///
/// ```
/// use sunglint::half::f16;
/// use sunglint::radiometry::{RadiometryError, lambertian_radiance};
///
/// // A panel of 60 cm squared that gives off 36 W of light: 100 W/m^2, over pi.
/// let [power, area] = [36.0, 0.36].map(f16::from_f32);
/// assert!((lambertian_radiance(power, area)?.to_f32() / 31.831 - 1.0).abs() < 2e-3);
/// assert_eq!(lambertian_radiance(-power, area), Err(RadiometryError::Power(-power)));
/// # Ok::<(), RadiometryError<f16>>(())
/// ```
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
///
/// ```
/// use sunglint::radiometry::{RadiometryError, sphere_radiance};
///
/// // The Sun: 3.828e26 W and 695 700 km are 20 MW/(m^2 sr).
/// assert!((sphere_radiance(3.828e26_f64, 6.957e8)? / 2.0034e7 - 1.0).abs() < 1e-4);
/// assert_eq!(sphere_radiance(60.0, -0.03), Err(RadiometryError::Length(-0.03)));
/// # Ok::<(), RadiometryError<f64>>(())
/// ```
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
///
/// ```
/// use sunglint::radiometry::{RadiometryError, point_intensity};
/// use sunglint::real::{Scalar, Scaled};
///
/// // 10 W in integers alone.
/// let intensity = point_intensity(Scaled::from_bits(10, 0))?;
/// assert!((intensity.exact() - 0.795_774_715).abs() < 1e-9);
/// let negative = Scaled::from_bits(-10, 0);
/// assert_eq!(point_intensity(negative), Err(RadiometryError::Power(negative)));
/// # Ok::<(), RadiometryError<Scaled>>(())
/// ```
#[inline]
pub fn point_intensity<S: Scalar>(power: S) -> Result<S, RadiometryError<S>> {
    let power = not_negative(power).map_err(RadiometryError::Power)?;
    Ok(power / S::constant(FOUR_PI))
}

/// Irradiance in W/m^2 by a point of `intensity` W/sr at `distance` metres, whose direction makes an angle of cosine
/// `cos` with the surface's normal: `I cos / r^2`.
///
/// ```
/// use sunglint::radiometry::irradiance;
///
/// // 8 W/sr two metres above a table; as much from 60 degrees off; and from under it.
/// assert_eq!([1.0, 0.5, -1.0].map(|cos| irradiance(8.0_f32, cos, 2.0)), [2.0, 1.0, 0.0]);
/// // In the lamp itself it is 0, not infinite.
/// assert_eq!(irradiance(8.0_f32, 1.0, 0.0), 0.0);
/// ```
#[inline]
pub fn irradiance<S: Scalar>(intensity: S, cos: S, distance: S) -> S {
    foreshortened(intensity, cos, distance)
}

/// Solid angle in steradians of a patch of `area` square metres, small against its `distance` in metres, whose normal
/// makes an angle of cosine `cos` with the line of sight: `A cos / r^2`.
///
/// ```
/// use sunglint::half::f16;
/// use sunglint::radiometry::patch_solid_angle;
///
/// // A window of half a square metre four metres away, facing, and turned by 60 degrees.
/// let solid_angle = |cos: f32| {
///     let [area, cos, distance] = [0.5, cos, 4.0].map(f16::from_f32);
///     patch_solid_angle(area, cos, distance).to_f32()
/// };
/// assert_eq!([1.0, 0.5].map(solid_angle), [1.0 / 32.0, 1.0 / 64.0]);
/// ```
#[inline]
pub fn patch_solid_angle<S: Scalar>(area: S, cos: S, distance: S) -> S {
    foreshortened(area, cos, distance)
}

/// Area in square metres that `area` takes across a beam, its normal at an angle of cosine `cos` to it: `A cos`.
///
/// ```
/// use sunglint::radiometry::projected_area;
///
/// // A sheet of half a square metre at 60 degrees to the beam; seen from behind it takes none of it.
/// assert_eq!([0.5, -0.5].map(|cos| projected_area(0.5_f64, cos)), [0.25, 0.0]);
/// ```
#[inline]
pub fn projected_area<S: Scalar>(area: S, cos: S) -> S {
    saturated(area * saturated(cos))
}

/// Power in watts of a beam of `irradiance` W/m^2 and `area` square metres across: `E A`.
///
/// ```
/// use sunglint::micromath::F32;
/// use sunglint::radiometry::beam_power;
///
/// // Sunlight on a solar panel of 2 m^2 across the beam.
/// assert_eq!(beam_power(F32(1000.0), F32(2.0)), F32(2000.0));
/// ```
#[inline]
pub fn beam_power<S: Scalar>(irradiance: S, area: S) -> S {
    saturated(irradiance * area)
}

/// Power in W/m^2 that leaves a surface of `albedo` under `irradiance`: `rho E`, into its whole half of the sky. What
/// a pixel shows of a matt surface is [`diffuse_radiance`].
///
/// ```
/// use sunglint::radiometry::radiosity;
///
/// // Snow at noon sends most of what arrives back up; an albedo that is negative counts as none.
/// assert_eq!(radiosity(0.75_f32, 1000.0), 750.0);
/// assert_eq!(radiosity(-0.75_f32, 1000.0), 0.0);
/// ```
#[inline]
pub fn radiosity<S: Scalar>(albedo: S, irradiance: S) -> S {
    saturated(albedo * irradiance)
}

/// Radiance in W/(m^2 sr) of a matt surface of `albedo` under `irradiance`, from everywhere: `rho E / pi`.
///
/// The classic slip is to leave out the `pi`: under a white sky of radiance 1, whose irradiance is `pi`, a white
/// surface has to have radiance 1.
///
/// ```
/// use sunglint::half::f16;
/// use sunglint::radiometry::diffuse_radiance;
///
/// // A white surface under a white sky of radiance 1.
/// assert_eq!(diffuse_radiance(f16::ONE, f16::PI), f16::ONE);
/// ```
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
///
/// ```
/// use sunglint::radiometry::{Patch, flux};
///
/// // A lamp of 100 W/(m^2 sr) and a sensor of 1 cm^2 half a metre before it, which is turned by 60 degrees.
/// let lamp = Patch { area: 0.01_f64, cos: 1.0 };
/// let sensor = Patch { area: 1e-4, cos: 0.5 };
/// let power = flux(100.0, lamp, sensor, 0.5);
/// assert!((power - 2e-4).abs() < 1e-12);
/// assert!((flux(100.0, sensor, lamp, 0.5) / power - 1.0).abs() < 1e-14);
/// ```
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
