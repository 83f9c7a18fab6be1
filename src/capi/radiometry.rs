//! Radiometry.

use super::RadianceQ16Made;
use crate::raw;

/// Irradiance by a point, `I cos / r^2`: `intensity` in W/sr and `distance` in metres in Q16, the cosine of the angle
/// to the surface's normal in Q14; the answer in W/m^2 in Q16.
///
/// Within half a unit of the last place and 2.1e-9 of the answer. A negative cosine, and a distance of 0, give 0; what
/// is too great is 2^32 - 1.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_irradiance_q16(intensity: u32, cos: i16, distance: u32) -> u32 {
    raw::irradiance_q16(intensity, cos, distance)
}

/// Radiance of a matt surface, `rho E / pi`: `albedo` in Q14, from 0 to 1; `irradiance` in W/m^2 and the answer in
/// W/(m^2 sr), both in Q16.
///
/// Within half a unit of the last place and 1.3e-9 of the answer. A negative albedo gives 0; an answer that is too
/// great is 2^32 - 1.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_diffuse_radiance_q16(albedo: i16, irradiance: u32) -> u32 {
    raw::diffuse_radiance_q16(albedo, irradiance)
}

/// Radiance of a lamp that shines evenly, `Phi / (A Omega)`: watts, square metres and steradians in Q16, the answer in
/// W/(m^2 sr) in Q16.
///
/// Within half a unit of the last place and 1.7e-9 of the answer. `SUNGLINT_AREA` and `SUNGLINT_SOLID_ANGLE` where that
/// is 0; the radiance is then 0. `SUNGLINT_OVERFLOW` from 65536 W/(m^2 sr) on; it is then 2^32 - 1.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_area_radiance_q16(power: u32, area: u32, solid_angle: u32) -> RadianceQ16Made {
    RadianceQ16Made::of(raw::area_radiance_q16(power, area, solid_angle))
}
