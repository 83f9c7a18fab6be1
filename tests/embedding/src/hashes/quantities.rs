//! Diffuse light, radiometry and black bodies.

use sunglint::radiometry::RadiometryError;
use sunglint::raw::{
    area_radiance_q16, diffuse_radiance_q16, irradiance_q16, lambert_disc_q14, lambert_disc_q30, lambert_q14,
    lambert_q30, relative_illuminance_q14, relative_illuminance_q30, relative_to_peak_frequency_q16,
    relative_to_peak_q16, sphere_q14, sphere_q30, tint_q16,
};

use super::status::{AREA, OK, OVERFLOW, SOLID_ANGLE};
use super::{CASES, Hash, Source};

/// Any albedo, illuminance and cosine under discs of all sizes, in both formats.
pub fn diffuse() -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for _ in 0..CASES {
        let ratio = source.ratio();
        let sphere = sphere_q14(ratio).unwrap();
        let (albedo, illuminance, cosine) = (source.lane_q14(), source.size(), source.signed());
        hash.add_32(lambert_q14(albedo, illuminance, cosine));
        hash.add_32(lambert_disc_q14(albedo, illuminance, cosine, &sphere));
        hash.add_32(relative_illuminance_q14(cosine, &sphere) as u32);

        let sphere = sphere_q30(ratio).unwrap();
        let (albedo, illuminance, cosine) = (source.signed(), source.wide(), source.signed_wide());
        hash.add_64(lambert_q30(albedo, illuminance, cosine));
        hash.add_64(lambert_disc_q30(albedo, illuminance, cosine, &sphere));
        hash.add_64(relative_illuminance_q30(cosine, &sphere) as u64);
    }
    hash.0
}

/// Quantities of any size, zeros among them.
pub fn radiometry() -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for _ in 0..CASES {
        let (intensity, cosine, distance) = (source.size(), source.lane_q14(), source.size());
        hash.add_32(irradiance_q16(intensity, cosine, distance));
        hash.add_32(diffuse_radiance_q16(cosine, intensity));
        let (power, area, solid_angle) = (source.size(), source.size(), source.size());
        let made = area_radiance_q16(power, area, solid_angle);
        let (status, radiance) = match made {
            Ok(radiance) => (OK, radiance),
            Err(RadiometryError::Area(_)) => (AREA, 0),
            Err(RadiometryError::SolidAngle(_)) => (SOLID_ANGLE, 0),
            Err(_) => (OVERFLOW, u32::MAX),
        };
        hash.add_32(status);
        hash.add_32(radiance);
    }
    hash.0
}

/// Ratios, temperatures and wavelengths of any size.
pub fn black_bodies() -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for _ in 0..CASES {
        let ratio = source.size();
        hash.add_32(relative_to_peak_q16(ratio) as u32);
        hash.add_32(relative_to_peak_frequency_q16(ratio) as u32);
        let temperature = source.size();
        hash.add_q30(tint_q16(temperature, [0; 3].map(|_: u8| source.size())));
    }
    hash.0
}
