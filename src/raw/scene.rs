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

/// [`Surface::new`] from numbers in Q30 (1073741824 is 1), for a material that changes at run time: `albedo` and `f0`
/// from 0 to 1, `alpha` 0 or from 5e-4 (536871) to 1.
///
/// ```
/// use sunglint::material::MaterialError;
/// use sunglint::raw::surface_q14;
///
/// // A road: albedo 0.2, alpha 1/16, reflectance 0.04 at normal incidence.
/// let [fifth, f0] = [214_748_365, 42_949_673];
/// let road = surface_q14([fifth; 3], 1 << 26, [f0; 3]).unwrap();
/// assert_eq!(road.alpha().to_bits(30), 1 << 26);
/// assert!(matches!(surface_q14([fifth; 3], (1 << 30) + 1, [f0; 3]), Err(MaterialError::Alpha(_))));
/// ```
///
/// # Errors
/// [`MaterialError`] for what is out of 0 to 1, and for an `alpha` between 0 and 5e-4.
pub fn surface_q14(albedo: [i32; 3], alpha: i32, f0: [i32; 3]) -> Result<SurfaceQ14, MaterialError<Scaled>> {
    surface(albedo, alpha, f0)
}

/// [`surface_q14`] for Q30 vectors.
///
/// ```
/// use sunglint::material::{Material, Surface};
/// use sunglint::raw::surface_q30;
///
/// // The same as from a constant, where the numbers are the same.
/// let half = surface_q30([1 << 29; 3], 1 << 26, [1 << 25; 3]).unwrap();
/// assert_eq!(half, Surface::of(&Material::new([0.5; 3], 0.0625, [0.03125; 3]).unwrap()));
/// ```
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

/// [`Lamp::new`] from a Q14 direction and an illuminance in Q16, any. Exact but for the rounding of 32 bits to 31.
///
/// ```
/// use sunglint::raw::{SUN_Q14, lamp_q14};
/// use sunglint::scene::SceneError;
///
/// assert!(lamp_q14([9830, 0, 13_107], &SUN_Q14, [205_887; 3]).is_ok());
/// // Half as long as it should be.
/// assert!(matches!(lamp_q14([0, 0, 8192], &SUN_Q14, [205_887; 3]), Err(SceneError::Direction(_))));
/// ```
///
/// # Errors
/// [`SceneError::Direction`] where the length is not within a tenth of 1.
pub fn lamp_q14(direction: [i16; 3], light: &SphereQ14, illuminance: [u32; 3]) -> Result<LampQ14, SceneError<Scaled>> {
    Lamp::new(q14(direction), *light, each(illuminance, U16F16::from_bits))
}

/// [`Lamp::new`] from a Q30 direction and an illuminance in Q32, any, of which 31 bits are significant.
///
/// ```
/// use sunglint::raw::{SUN_Q30, SceneQ30, lamp_q30, shade_q30, surface_q30};
///
/// // Matt white under 100 000 lx of sunlight: 31 830.99 cd/m^2.
/// let white = surface_q30([1 << 30; 3], 1 << 30, [0; 3]).unwrap();
/// let mut scene = SceneQ30::<1>::new(&white);
/// scene.push(&lamp_q30([0, 0, 1 << 30], &SUN_Q30, [100_000 << 32; 3]).unwrap()).unwrap();
/// let [red, ..] = shade_q30(&scene, [0, 0, 1 << 30], [644_245_094, 0, 858_993_459]);
/// assert_eq!(red >> 32, 31_830);
/// ```
///
/// # Errors
/// [`SceneError::Direction`] where the length is not within a tenth of 1.
pub fn lamp_q30(direction: [i32; 3], light: &SphereQ30, illuminance: [u64; 3]) -> Result<LampQ30, SceneError<Scaled>> {
    Lamp::new(q30(direction), *light, each(illuminance, U32F32::from_bits))
}

/// [`Scene::shade`] in Q14: red, green and blue in Q16, at most `2^32 - 1`. With [`ConeGgx`] under the Sun the root mean
/// square error is 1.7e-4 of the value for an alpha of 1/16; `trial::gloss` has those of other cases.
///
/// ```
/// use sunglint::raw::{SUN_Q14, SceneQ14, lamp_q14, shade_q14, surface_q14};
///
/// // A black mirror, the Sun 37 degrees from straight up.
/// let mirror = surface_q14([0; 3], 0, [1 << 30; 3]).unwrap();
/// let mut scene = SceneQ14::<1>::new(&mirror);
/// scene.push(&lamp_q14([9830, 0, 13_107], &SUN_Q14, [65_536; 3]).unwrap()).unwrap();
/// let up = [0, 0, 16_384];
/// assert_eq!(shade_q14(&scene, up, up), [0; 3]);
/// // In it the Sun is as bright as it is: illuminance 1 over its solid angle.
/// let [red, ..] = shade_q14(&scene, up, [-9830, 0, 13_107]);
/// assert_eq!(red >> 16, 14_718);
/// ```
pub fn shade_q14<const LIGHTS: usize, H: Highlight<I2F14>>(
    scene: &SceneQ14<LIGHTS, H>,
    n: [i16; 3],
    v: [i16; 3],
) -> [u32; 3] {
    each(scene.shade(q14(n), q14(v)), U16F16::to_bits)
}

/// [`Scene::shade_channel`] in Q14: one channel in Q16, as [`shade_q14`] has it.
///
/// ```
/// use sunglint::raw::{SUN_Q14, SceneQ14, lamp_q14, shade_channel_q14, shade_q14, surface_q14};
/// use sunglint::scene::Channel;
///
/// let mut scene = SceneQ14::<1>::new(&surface_q14([0, 1 << 29, 1 << 30], 1 << 28, [0; 3]).unwrap());
/// scene.push(&lamp_q14([0, 0, 16_384], &SUN_Q14, [205_887; 3]).unwrap()).unwrap();
/// let (n, v) = ([0, 0, 16_384], [9830, 0, 13_107]);
/// // For a display of one colour.
/// assert_eq!(shade_channel_q14(&scene, n, v, Channel::Green), shade_q14(&scene, n, v)[1]);
/// ```
pub fn shade_channel_q14<const LIGHTS: usize, H: Highlight<I2F14>>(
    scene: &SceneQ14<LIGHTS, H>,
    n: [i16; 3],
    v: [i16; 3],
    channel: Channel,
) -> u32 {
    scene.shade_channel(q14(n), q14(v), channel).to_bits()
}

/// [`Scene::shade`] in Q30: red, green and blue in Q32, at most `2^64 - 1`. With [`ConeGgx`] under the Sun the root mean
/// square error is 2.8e-9 of the value for an alpha of 1/16; `trial::gloss` has those of other cases.
///
/// ```
/// use sunglint::raw::{SUN_Q30, SceneQ30, lamp_q30, shade_q30, surface_q30};
///
/// let mut scene = SceneQ30::<2>::new(&surface_q30([1 << 29; 3], 1 << 30, [0; 3]).unwrap());
/// assert_eq!(shade_q30(&scene, [0, 0, 1 << 30], [0, 0, 1 << 30]), [0; 3]); // no light yet
/// // Illuminance pi, in red alone: what grey is in red, in Q32.
/// let lamp = lamp_q30([0, 0, 1 << 30], &SUN_Q30, [13_493_037_705, 0, 0]).unwrap();
/// scene.push(&lamp).unwrap();
/// assert_eq!(shade_q30(&scene, [0, 0, 1 << 30], [0, 0, 1 << 30]), [1 << 31, 0, 0]);
/// ```
pub fn shade_q30<const LIGHTS: usize, H: Highlight<I2F30>>(
    scene: &SceneQ30<LIGHTS, H>,
    n: [i32; 3],
    v: [i32; 3],
) -> [u64; 3] {
    each(scene.shade(q30(n), q30(v)), U32F32::to_bits)
}

/// [`Scene::shade_channel`] in Q30: one channel in Q32, as [`shade_q30`] has it.
///
/// ```
/// use sunglint::highlight::PointGgx;
/// use sunglint::raw::{SUN_Q30, SceneQ30, lamp_q30, shade_channel_q30, surface_q30};
/// use sunglint::scene::Channel;
///
/// let gloss = surface_q30([0; 3], 1 << 26, [1 << 25; 3]).unwrap();
/// let mut scene = SceneQ30::<1, _>::with_highlight(&gloss, PointGgx::karis);
/// scene.push(&lamp_q30([0, 0, 1 << 30], &SUN_Q30, [1 << 32; 3]).unwrap()).unwrap();
/// // The middle of the highlight: GGX's 81.5 over 4, times 1/32, times Karis's 0.930 is 0.592.
/// let up = [0, 0, 1 << 30];
/// assert_eq!(shade_channel_q30(&scene, up, up, Channel::Red) >> 16, 38_782);
/// ```
pub fn shade_channel_q30<const LIGHTS: usize, H: Highlight<I2F30>>(
    scene: &SceneQ30<LIGHTS, H>,
    n: [i32; 3],
    v: [i32; 3],
    channel: Channel,
) -> u64 {
    scene.shade_channel(q30(n), q30(v), channel).to_bits()
}
