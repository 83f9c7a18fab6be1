//! Whole lit pixels.

use super::{ColourQ16, MaterialQ30, PixelQ14, PixelQ14Made, SphereQ14, VectorQ14};
use crate::raw;
use crate::scene::Channel;

/// The constants of a material under one light: its centre in the unit `direction`, in Q14; `illuminance`, in unsigned
/// Q16 and a unit of your choice, what it gives to a surface that faces it. Once a light.
///
/// `SUNGLINT_ALBEDO`, `SUNGLINT_F0` and `SUNGLINT_ALPHA` where the material is out of its ranges, `SUNGLINT_DIRECTION`
/// where the direction's length is not within a tenth of 1; the pixel is then black.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_pixel_q14(
    direction: VectorQ14,
    light: SphereQ14,
    material: MaterialQ30,
    illuminance: ColourQ16,
) -> PixelQ14Made {
    let MaterialQ30 { albedo, alpha, f0 } = material;
    match raw::surface_q14(albedo.into(), alpha, f0.into()) {
        Ok(surface) => {
            let pixel = raw::PixelQ14::new(direction.into(), &light.into(), &surface, illuminance.into());
            PixelQ14Made::of(pixel.map_err(Into::into))
        }
        Err(error) => PixelQ14Made::of(Err(error.into())),
    }
}

/// Radiance in red, green and blue, in Q16 and the illuminance's unit, that a surface of the unit normal `n` sends
/// towards the unit direction `v` to the camera, both in Q14: Lambert's law, and GGX averaged over the light's disc
/// with Smith's shadowing and Schlick's reflectance.
///
/// Within 6e-5 of the diffuse part, 6e-4 of the highlight (root mean square 4e-5) times the formula's condition, which
/// is 2 away from the disc's image and grows at the rim of a sharp one and near the horizon, 2e-5 of what the highlight
/// would be with a reflectance of 1, and 0.6 of the last place. No highlight where `n.v` or `n.l` is at most 2^-14,
/// nor for a mirror (`alpha` 0) under a point. For more lights add up their pixels, saturating.
/// Black where the surface faces away from the camera, and where `pixel` is NULL; what is too great is 2^32 - 1.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_pixel_q14_shade(pixel: Option<&PixelQ14>, n: VectorQ14, v: VectorQ14) -> ColourQ16 {
    pixel.map_or([0; 3], |pixel| pixel.shade(n.into(), v.into())).into()
}

/// `sunglint_pixel_q14_shade` in one channel: 0 is red, 1 green, 2 blue. Any other gives 0, and so does a `pixel` that
/// is NULL.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_pixel_q14_shade_channel(
    pixel: Option<&PixelQ14>,
    n: VectorQ14,
    v: VectorQ14,
    channel: u32,
) -> u32 {
    let channel = match channel {
        0 => Channel::Red,
        1 => Channel::Green,
        2 => Channel::Blue,
        _ => return 0,
    };
    pixel.map_or(0, |pixel| pixel.shade_channel(n.into(), v.into(), channel))
}
