//! Radiometry on raw bits.

use crate::radiometry::{self, RadiometryError};
use crate::real::Scaled;

/// [`irradiance`](radiometry::irradiance) by a point: intensity in W/sr in Q16, cosine in Q14, distance in metres in
/// Q16; answer in W/m^2 in Q16, at most its greatest number; zero for a negative cosine and for no distance. Within half an
/// LSB and 2.1e-9 of the answer (`tests/radiometry.rs`).
///
/// ```
/// use sunglint::raw::irradiance_q16;
///
/// // 100 W/sr at 2 m, 60 degrees off the normal: 12.5 W/m^2.
/// assert_eq!(irradiance_q16(100 << 16, 8192, 2 << 16), 25 << 15);
/// assert_eq!(irradiance_q16(100 << 16, -8192, 2 << 16), 0);
/// ```
pub fn irradiance_q16(intensity: u32, cos: i16, distance: u32) -> u32 {
    bits(radiometry::irradiance(q16(intensity), Scaled::from_bits(cos.into(), -14), q16(distance)))
}

/// [`diffuse_radiance`](radiometry::diffuse_radiance) of a matt surface, `rho E / pi`: albedo in Q14, irradiance and
/// answer in Q16; zero for a negative albedo. Within half an LSB and 1.3e-9 of the answer.
///
/// ```
/// use sunglint::raw::diffuse_radiance_q16;
///
/// // A white surface under a white sky, whose irradiance is pi, looks as the sky does.
/// assert_eq!(diffuse_radiance_q16(16_384, 205_887), 65_536);
/// ```
pub fn diffuse_radiance_q16(albedo: i16, irradiance: u32) -> u32 {
    bits(radiometry::diffuse_radiance(Scaled::from_bits(albedo.into(), -14), q16(irradiance)))
}

/// [`area_radiance`](radiometry::area_radiance) of a lamp, `Phi / (A Omega)`: watts, square metres, steradians and
/// W/(m^2 sr), all in Q16. Within half an LSB and 1.7e-9 of the answer.
///
/// ```
/// use sunglint::radiometry::RadiometryError;
/// use sunglint::raw::area_radiance_q16;
///
/// // 60 W from 1/8 m^2, into pi steradians by the cosine: 152.8 W/(m^2 sr).
/// let radiance = area_radiance_q16(60 << 16, 1 << 13, 205_887).unwrap();
/// assert_eq!(radiance >> 16, 152);
/// assert_eq!(area_radiance_q16(60 << 16, 1, 1), Err(RadiometryError::Overflow));
/// ```
///
/// # Errors
/// Those of that function, and [`RadiometryError::Overflow`] from 65 536 W/(m^2 sr) on.
pub fn area_radiance_q16(power: u32, area: u32, solid_angle: u32) -> Result<u32, RadiometryError<Scaled>> {
    let radiance = radiometry::area_radiance(q16(power), q16(area), q16(solid_angle))?;
    u32::try_from(radiance.to_unsigned(16)).map_err(|_| RadiometryError::Overflow)
}

fn q16(bits: u32) -> Scaled {
    Scaled::from_unsigned(bits.into(), -16)
}

fn bits(value: Scaled) -> u32 {
    u32::try_from(value.to_unsigned(16)).unwrap_or(u32::MAX)
}
