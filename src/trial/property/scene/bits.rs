//! The raw functions beside the generic ones.

use fixed::types::{I2F14, I2F30, U16F16, U32F32};

use super::super::{Broken, Case, inputs};
use crate::light::DistantLight;
use crate::material::Surface;
use crate::raw;
use crate::real::Scaled;
use crate::scene::{Channel, Lamp, Scene};
use crate::sphere::DistantSphere;
use crate::trial::draw::Draw;
use crate::trial::format::Format;

/// A material, a lamp and a pixel of any bits.
struct Any {
    albedo: [i32; 3],
    alpha: i32,
    f0: [i32; 3],
    light: DistantLight,
    direction: [f64; 3],
    levels: [u64; 3],
    pixel: [[u64; 3]; 2],
}

/// Reads bits, and says whether Q14 or Q30 break the equality.
pub(super) fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    // Within 0 to 1 seven times of eight.
    let unit = |draw: &mut Draw<'_>| {
        let bits = draw.bits();
        if bits & 7 == 0 { (bits >> 8) as i32 } else { ((bits >> 8) % ((1 << 30) + 1)) as i32 }
    };
    let any = Any {
        albedo: [(); 3].map(|()| unit(draw)),
        alpha: unit(draw),
        f0: [(); 3].map(|()| unit(draw)),
        light: draw.light(),
        direction: draw.direction(),
        levels: [(); 3].map(|()| draw.bits()),
        pixel: [(); 2].map(|()| [(); 3].map(|()| draw.bits())),
    };
    q14(&any)?;
    q30(&any)
}

fn number(bits: i32) -> Scaled {
    Scaled::from_bits(bits.into(), -30)
}

const CHANNELS: [Channel; 3] = [Channel::Red, Channel::Green, Channel::Blue];

fn q14(any: &Any) -> Result<(), Broken> {
    let case = Case { format: Format::I2F14, inputs: inputs([any.direction]) };
    let surface = raw::surface_q14(any.albedo, any.alpha, any.f0);
    let generic = Surface::<I2F14>::new(any.albedo.map(number), number(any.alpha), any.f0.map(number));
    case.holds("a raw surface is the generic one", surface == generic)?;
    let sphere = DistantSphere::<I2F14>::of(&any.light);
    let direction = any.direction.map(|lane| I2F14::saturating_from_num(lane).to_bits());
    let levels = any.levels.map(|bits| bits as u32);
    let lamp = raw::lamp_q14(direction, &sphere, levels);
    let same = lamp == Lamp::new(direction.map(I2F14::from_bits), sphere, levels.map(U16F16::from_bits));
    case.holds("a raw lamp is the generic one", same)?;
    let (Ok(surface), Ok(lamp)) = (surface, lamp) else { return Ok(()) };
    let mut scene = Scene::<I2F14, 1>::new(&surface);
    case.holds("there is room for one", scene.push(&lamp).is_ok())?;
    let [n, v] = any.pixel.map(|vector| vector.map(|bits| bits as i16));
    let levels = scene.shade(n.map(I2F14::from_bits), v.map(I2F14::from_bits)).map(U16F16::to_bits);
    case.holds("a raw pixel is the generic one", raw::shade_q14(&scene, n, v) == levels)?;
    let channels = CHANNELS.map(|channel| raw::shade_channel_q14(&scene, n, v, channel));
    case.holds("a raw channel is the generic one", channels == levels)
}

fn q30(any: &Any) -> Result<(), Broken> {
    let case = Case { format: Format::I2F30, inputs: inputs([any.direction]) };
    let surface = raw::surface_q30(any.albedo, any.alpha, any.f0);
    let generic = Surface::<I2F30>::new(any.albedo.map(number), number(any.alpha), any.f0.map(number));
    case.holds("a raw surface is the generic one", surface == generic)?;
    let sphere = DistantSphere::<I2F30>::of(&any.light);
    let direction = any.direction.map(|lane| I2F30::saturating_from_num(lane).to_bits());
    let lamp = raw::lamp_q30(direction, &sphere, any.levels);
    let same = lamp == Lamp::new(direction.map(I2F30::from_bits), sphere, any.levels.map(U32F32::from_bits));
    case.holds("a raw lamp is the generic one", same)?;
    let (Ok(surface), Ok(lamp)) = (surface, lamp) else { return Ok(()) };
    let mut scene = Scene::<I2F30, 1>::new(&surface);
    case.holds("there is room for one", scene.push(&lamp).is_ok())?;
    let [n, v] = any.pixel.map(|vector| vector.map(|bits| bits as i32));
    let levels = scene.shade(n.map(I2F30::from_bits), v.map(I2F30::from_bits)).map(U32F32::to_bits);
    case.holds("a raw pixel is the generic one", raw::shade_q30(&scene, n, v) == levels)?;
    let channels = CHANNELS.map(|channel| raw::shade_channel_q30(&scene, n, v, channel));
    case.holds("a raw channel is the generic one", channels == levels)
}
