//! What is made from bits is refused exactly where its documentation says, and levels saturate.

use super::layer::Raw;
use super::{lanes, word};
use crate::light::LightError;
use crate::material::{MaterialError, Surface};
use crate::real::{Scalar, Scaled};
use crate::scene::{Channel, Scene, SceneError};
use crate::sphere::DistantSphere;
use crate::trial::draw::Draw;
use crate::trial::property::{Broken, Case, inputs};

/// 1 in Q30.
const ONE: i32 = 1 << 30;

/// The least `alpha` but 0, 5e-4, rounded up into Q30.
const LEAST: i32 = 536_871;

/// Reads a case and says what it breaks.
pub(super) fn hold<T: Raw>(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let direction = lanes(draw, T::FORMAT).map(T::from_f64);
    let case = Case { format: T::FORMAT, inputs: inputs([direction.map(T::to_f64)]) };
    let light = sphere::<T>(&case, draw)?;
    let surface = surface::<T>(&case, draw)?;
    scene(&case, draw, direction, &light, &surface)
}

/// The light of a ratio, or the Sun where it is out of range.
fn sphere<T: Raw>(case: &Case, draw: &mut Draw<'_>) -> Result<DistantSphere<T>, Broken> {
    let ratio = word(draw) as i32;
    let made = (T::LAYER.sphere)(ratio);
    case.holds("a ratio is from 0 to 1", made.is_ok() == (0..=ONE).contains(&ratio))?;
    match made {
        Ok(light) => {
            let [sin, square] = [light.sin(), light.sin_square()].map(|wide| T::scalar(wide).exact());
            // Half a unit of Q28 of the square and, twice, of the sine.
            case.at_most("the square is the sine's", (square - sin * sin).abs(), 6e-9)?;
            Ok(light)
        }
        Err(error) => {
            case.holds("the error has the ratio", error == LightError::RatioQ30(ratio))?;
            Ok(DistantSphere::of(&crate::light::SUN))
        }
    }
}

/// A surface, or a white one where a number is out of range.
fn surface<T: Raw>(case: &Case, draw: &mut Draw<'_>) -> Result<Surface<T>, Broken> {
    let share =
        |draw: &mut Draw<'_>| if draw.byte().is_multiple_of(8) { word(draw) } else { word(draw) & (ONE as u32 - 1) };
    let mut shares = || [(); 3].map(|()| share(draw) as i32);
    let (albedo, f0) = (shares(), shares());
    let alpha = word(draw) as i32;
    let number = |bits: i32| Scaled::from_bits(bits.into(), -30);
    let outside = |bits: &i32| !(0..=ONE).contains(bits);
    let expected = if let Some(bits) = albedo.into_iter().find(outside) {
        Some(MaterialError::Albedo(number(bits)))
    } else if let Some(bits) = f0.into_iter().find(outside) {
        Some(MaterialError::F0(number(bits)))
    } else if alpha == 0 || (LEAST..=ONE).contains(&alpha) {
        None
    } else {
        Some(MaterialError::Alpha(number(alpha)))
    };
    let made = (T::LAYER.surface)(albedo, alpha, f0);
    case.holds("a material is refused as documented", made.err() == expected)?;
    let same = made.is_err() || made == Surface::new(albedo.map(number), number(alpha), f0.map(number));
    case.holds("raw surface", same)?;
    let white = || (T::LAYER.surface)([ONE; 3], ONE, [ONE; 3]);
    made.or_else(|_| white()).map_err(|_| case.holds("white is a material", false).unwrap_err())
}

/// A lamp is refused by its length alone; a brighter one makes nothing darker, also where levels end.
fn scene<T: Raw>(
    case: &Case,
    draw: &mut Draw<'_>,
    direction: [T; 3],
    light: &DistantSphere<T>,
    surface: &Surface<T>,
) -> Result<(), Broken> {
    let layer = T::LAYER;
    let bits = draw.bits() >> (draw.byte() % 64);
    let (dim, bright) = (T::light_of(bits >> 1), T::light_of(bits));
    let (dim, bright) = if dim < bright { (dim, bright) } else { (bright, dim) };
    let lamp = |level| (layer.lamp)(direction.map(T::bits), light, [level; 3]);
    let square: f64 = direction.into_iter().map(|lane| lane.to_f64() * lane.to_f64()).sum();
    // Q60 is rounded to 31 bits, as the limits are.
    let near = |limit: f64| (square - limit).abs() < 2e-9 * limit;
    let fits = (0.81..=1.21).contains(&square);
    let (Ok(dim), Ok(bright)) = (lamp(dim), lamp(bright)) else {
        let refused = matches!(lamp(dim), Err(SceneError::Direction(_)));
        return case.holds("a direction is refused as documented", refused && (!fits || near(0.81) || near(1.21)));
    };
    case.holds("a direction is taken as documented", fits || near(0.81) || near(1.21))?;
    let [mut less, mut more] = [(); 2].map(|()| Scene::<T, 2>::new(surface));
    let [n, v] = [(); 2].map(|()| lanes(draw, T::FORMAT).map(T::from_f64));
    for (scene, lamp) in [(&mut less, dim), (&mut more, bright)] {
        let room = scene.push(&lamp).is_ok() && scene.push(&lamp).is_ok();
        let full = scene.push(&lamp) == Err(SceneError::Full { capacity: 2 });
        case.holds("there is room for two lights", room && full && scene.lights() == 2)?;
    }
    let levels = (layer.shade)(&more, n.map(T::bits), v.map(T::bits));
    case.holds("raw shade", levels == more.shade(n, v).map(T::light))?;
    let green = (layer.shade_channel)(&more, n.map(T::bits), v.map(T::bits), Channel::Green);
    case.holds("raw shade_channel", green == levels[1])?;
    let darker = less.shade(n, v).map(T::light);
    case.holds("a brighter lamp makes nothing darker", (0..3).all(|channel| darker[channel] <= levels[channel]))
}
