//! Whole pixels.

use sunglint::material::MaterialError;
use sunglint::raw::{PixelQ14, normalize_q14, reflect_q14, sphere_q14, surface_q14};
use sunglint::scene::Channel;

use super::status::{ALBEDO, ALPHA, DIRECTION, F0, OK};
use super::{CASES, Hash, Source};

/// Normals and viewers of every pixel.
const VIEWS: u32 = 4;

/// 1/1024 in Q30, which is above the least that is allowed.
const LEAST_ALPHA: i32 = 1 << 20;

/// Channels as C numbers them.
const CHANNELS: [Channel; 3] = [Channel::Red, Channel::Green, Channel::Blue];

/// Lights of all sizes on materials, of which about half are allowed; C's others are black.
pub fn hash() -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for _ in 0..CASES {
        let (l, made) = pixel(&mut source);
        hash.add_32(made.err().unwrap_or(OK));
        for _ in 0..VIEWS {
            let [n, v] = view(&mut source, l);
            let channel = CHANNELS.get(source.bits() as usize & 3).copied();
            let one = |pixel: &PixelQ14| channel.map_or(0, |channel| pixel.shade_channel(n, v, channel));
            let (colour, level) = made.as_ref().map_or(([0; 3], 0), |pixel| (pixel.shade(n, v), one(pixel)));
            hash.add_q30(colour.map(|level| level as i32));
            hash.add_32(level);
        }
    }
    // C's pointer to no pixel: a colour and a level.
    hash.add(&[0; 3 * 4 + 4]);
    hash.0
}

/// Normal and viewer: of any length, where the mirror image is, or anywhere.
fn view(source: &mut Source, l: [i16; 3]) -> [[i16; 3]; 2] {
    let [n, v] = [0; 2].map(|_: u8| source.lanes_q14());
    let unit = normalize_q14(n);
    match source.bits() & 7 {
        0 => [n, v],
        1..4 => [unit, reflect_q14(unit, l)],
        _ => [unit, normalize_q14(v)],
    }
}

/// The direction to the light, and a pixel or C's status of what is wrong first: numbers out of range are in eight places,
/// and the greater part is rough enough.
fn pixel(source: &mut Source) -> ([i16; 3], Result<PixelQ14, u32>) {
    let any = source.lanes_q14();
    let sphere = sphere_q14(source.ratio()).unwrap();
    let mut numbers = [0; 7].map(|_: i32| source.ratio());
    let wrong = source.bits() as usize & 15;
    if wrong < 12 {
        numbers[3] |= LEAST_ALPHA;
    }
    let replaced = source.signed();
    if let Some(number) = numbers.get_mut(wrong) {
        *number = replaced;
    }
    let illuminance = [0; 3].map(|_: u32| source.bits() >> 8);
    let direction = if wrong == 7 { any } else { normalize_q14(any) };
    let [red, green, blue, alpha, r, g, b] = numbers;
    let surface = surface_q14([red, green, blue], alpha, [r, g, b]).map_err(|error| match error {
        MaterialError::Albedo(_) => ALBEDO,
        MaterialError::F0(_) => F0,
        _ => ALPHA,
    });
    let made = |surface| PixelQ14::new(direction, &sphere, &surface, illuminance).map_err(|_| DIRECTION);
    (direction, surface.and_then(made))
}
