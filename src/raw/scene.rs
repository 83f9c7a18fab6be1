//! The least scene on raw bits. Needs the feature `heapless`.

use fixed::types::{I2F14, I2F30, U16F16, U32F32};

use super::{SphereQ14, SphereQ30, q14, q30};
use crate::highlight::{ConeGgx, Highlight};
use crate::material::{MaterialError, Surface};
use crate::real::{Real, Scaled};
use crate::scene::{Channel, Lamp, Scene, SceneError};
use crate::vec3::each;

/// A material for Q14 vectors, from [`Surface::of`] or [`surface_q14`].
pub type SurfaceQ14 = Surface<I2F14>;

/// A material for Q30 vectors, from [`Surface::of`] or [`surface_q30`].
pub type SurfaceQ30 = Surface<I2F30>;

/// A light where it stands, for Q14 vectors.
pub type LampQ14 = Lamp<I2F14>;

/// A light where it stands, for Q30 vectors.
pub type LampQ30 = Lamp<I2F30>;

/// A material under up to `LIGHTS` lights, for Q14 vectors; its highlights are [`ConeGgx`] unless another type is
/// named.
pub type SceneQ14<const LIGHTS: usize, H = ConeGgx<I2F14>> = Scene<I2F14, LIGHTS, H>;

/// A material under up to `LIGHTS` lights, for Q30 vectors; its highlights are [`ConeGgx`] unless another type is
/// named.
pub type SceneQ30<const LIGHTS: usize, H = ConeGgx<I2F30>> = Scene<I2F30, LIGHTS, H>;

/// [`Surface::new`] from numbers in Q30 (1073741824 is 1), for a material that changes at run time.
///
/// # Errors
/// [`MaterialError`] for what is out of 0 to 1, and for an `alpha` between 0 and 5e-4.
pub fn surface_q14(albedo: [i32; 3], alpha: i32, f0: [i32; 3]) -> Result<SurfaceQ14, MaterialError<Scaled>> {
    surface(albedo, alpha, f0)
}

/// [`surface_q14`] for Q30 vectors.
///
/// # Errors
/// [`MaterialError`] for what is out of 0 to 1, and for an `alpha` between 0 and 5e-4.
pub fn surface_q30(albedo: [i32; 3], alpha: i32, f0: [i32; 3]) -> Result<SurfaceQ30, MaterialError<Scaled>> {
    surface(albedo, alpha, f0)
}

fn surface<T: Real<Scalar = Scaled>>(
    albedo: [i32; 3],
    alpha: i32,
    f0: [i32; 3],
) -> Result<Surface<T>, MaterialError<Scaled>> {
    let number = |bits: i32| Scaled::from_bits(bits.into(), -30);
    Surface::new(each(albedo, number), number(alpha), each(f0, number))
}

/// [`Lamp::new`] from a Q14 direction and an illuminance in Q16.
///
/// # Errors
/// [`SceneError::Direction`] where the length is not within a tenth of 1.
pub fn lamp_q14(direction: [i16; 3], light: &SphereQ14, illuminance: [u32; 3]) -> Result<LampQ14, SceneError<Scaled>> {
    Lamp::new(q14(direction), *light, each(illuminance, U16F16::from_bits))
}

/// [`Lamp::new`] from a Q30 direction and an illuminance in Q32.
///
/// # Errors
/// [`SceneError::Direction`] where the length is not within a tenth of 1.
pub fn lamp_q30(direction: [i32; 3], light: &SphereQ30, illuminance: [u64; 3]) -> Result<LampQ30, SceneError<Scaled>> {
    Lamp::new(q30(direction), *light, each(illuminance, U32F32::from_bits))
}

/// [`Scene::shade`] in Q14: red, green and blue in Q16, at most `2^32 - 1`.
pub fn shade_q14<const LIGHTS: usize, H: Highlight<I2F14>>(
    scene: &SceneQ14<LIGHTS, H>,
    n: [i16; 3],
    v: [i16; 3],
) -> [u32; 3] {
    each(scene.shade(q14(n), q14(v)), U16F16::to_bits)
}

/// [`Scene::shade_channel`] in Q14: one channel in Q16.
pub fn shade_channel_q14<const LIGHTS: usize, H: Highlight<I2F14>>(
    scene: &SceneQ14<LIGHTS, H>,
    n: [i16; 3],
    v: [i16; 3],
    channel: Channel,
) -> u32 {
    scene.shade_channel(q14(n), q14(v), channel).to_bits()
}

/// [`Scene::shade`] in Q30: red, green and blue in Q32, at most `2^64 - 1`.
pub fn shade_q30<const LIGHTS: usize, H: Highlight<I2F30>>(
    scene: &SceneQ30<LIGHTS, H>,
    n: [i32; 3],
    v: [i32; 3],
) -> [u64; 3] {
    each(scene.shade(q30(n), q30(v)), U32F32::to_bits)
}

/// [`Scene::shade_channel`] in Q30: one channel in Q32.
pub fn shade_channel_q30<const LIGHTS: usize, H: Highlight<I2F30>>(
    scene: &SceneQ30<LIGHTS, H>,
    n: [i32; 3],
    v: [i32; 3],
    channel: Channel,
) -> u64 {
    scene.shade_channel(q30(n), q30(v), channel).to_bits()
}
