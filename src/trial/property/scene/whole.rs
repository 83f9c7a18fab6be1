//! Whole pixels under up to three lamps.

use core::f64::consts::PI;

use super::super::highlight::pixel;
use super::super::{Broken, Case, inputs};
use crate::highlight::Highlight;
use crate::light::DistantLight;
use crate::material::Surface;
use crate::oracle::highlight::Pixel;
use crate::real::{Real, Scalar};
use crate::scene::{Channel, Lamp, Scene, SceneError};
use crate::sphere::DistantSphere;
use crate::trial::draw::Draw;
use crate::trial::format::{Format, Visitor};
use crate::trial::shading::{Make, Shading, ShadingVisitor};

/// How many lamps there is room for.
const ROOM: usize = 3;

/// A lamp before it is rounded.
#[derive(Clone, Copy)]
struct Lit {
    light: DistantLight,
    direction: [f64; 3],
    levels: [f64; 3],
}

/// A scene and a pixel before they are rounded.
#[derive(Clone, Copy)]
struct Whole {
    format: Format,
    method: Shading,
    colours: [[f64; 3]; 2],
    alpha: f64,
    lamps: [Lit; ROOM],
    pixel: [[f64; 3]; 2],
}

/// Reads a scene and says what it breaks.
pub(super) fn hold(draw: &mut Draw<'_>, format: Format) -> Result<(), Broken> {
    // The default method half of the time.
    let method = if draw.byte().is_multiple_of(2) { Shading::ConeGgx } else { draw.one_of(Shading::ALL) };
    let colours = [(); 2].map(|()| [(); 3].map(|()| if draw.byte().is_multiple_of(4) { 0.0 } else { draw.fraction() }));
    let alpha = pixel::alpha(draw);
    let light = draw.light();
    let Pixel { n, v, l } = pixel::pixel(draw, &light, alpha);
    let first = Lit { light, direction: l, levels: [(); 3].map(|()| draw.logarithmic(1e-2, 1e3)) };
    let mut lamp = || Lit {
        light: draw.light(),
        direction: draw.direction(),
        levels: [(); 3].map(|()| draw.logarithmic(1e-2, 1e3)),
    };
    let lamps = [first, lamp(), lamp()];
    // Any bits in place of directions, one time of eight.
    let pixel =
        if draw.byte().is_multiple_of(8) { [(); 2].map(|()| [(); 3].map(|()| draw.any(format))) } else { [n, v] };
    format.visit(Whole { format, method, colours, alpha, lamps, pixel })
}

impl Visitor for Whole {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        self.method.visit(Of::<T> { whole: self, pixel: self.pixel.map(|vector| vector.map(T::from_f64)) })
    }
}

struct Of<T> {
    whole: Whole,
    pixel: [[T; 3]; 2],
}

/// Channels one place on.
fn turned<A: Copy>([red, green, blue]: [A; 3]) -> [A; 3] {
    [green, blue, red]
}

impl Whole {
    fn case(&self) -> Case {
        let mut numbers = inputs([self.pixel[0], self.pixel[1], self.lamps[0].direction]);
        numbers[9] = self.alpha;
        Case { format: self.format, inputs: numbers }
    }

    fn surface<T: Real>(&self) -> Option<Surface<T>> {
        let [albedo, f0] = self.colours.map(|colour| colour.map(T::Scalar::nearest));
        Surface::new(albedo, T::Scalar::nearest(self.alpha), f0).ok()
    }

    fn scene<T: Real, H: Highlight<T>>(&self, method: Make<T, H>, lamps: &[Lit]) -> Option<Scene<T, ROOM, H>> {
        let mut scene = Scene::with_highlight(&self.surface()?, method);
        for lamp in lamps {
            scene.push(&lamp.rounded()?).ok()?;
        }
        Some(scene)
    }

    fn recoloured(mut self) -> Self {
        self.colours = self.colours.map(turned);
        self.lamps = self.lamps.map(|lamp| Lit { levels: turned(lamp.levels), ..lamp });
        self
    }
}

impl Lit {
    fn rounded<T: Real>(&self) -> Option<Lamp<T>> {
        let levels = self.levels.map(|level| T::level(T::Scalar::nearest(level)));
        Lamp::new(self.direction.map(T::from_f64), DistantSphere::of(&self.light), levels).ok()
    }
}

fn numbers<T: Real>(levels: [T::Level; 3]) -> [f64; 3] {
    levels.map(|level| T::of_level(level).exact())
}

impl<T: Real> ShadingVisitor<T> for Of<T> {
    type Output = Result<(), Broken>;

    fn visit<H: Highlight<T> + 'static>(self, method: Make<T, H>) -> Self::Output {
        let Self { whole, pixel: [n, v] } = self;
        let case = whole.case();
        let scene = |whole: &Whole, lamps: &[Lit]| whole.scene::<T, H>(method, lamps);
        let shade = |whole: &Whole, lamps: &[Lit]| scene(whole, lamps).map(|scene| scene.shade(n, v));
        let Some(mut full) = scene(&whole, &whole.lamps) else {
            return case.holds("surfaces and lamps in range are taken", false);
        };
        let levels = full.shade(n, v);
        let found = numbers::<T>(levels);
        case.holds("levels are finite", found.into_iter().all(|level| level >= 0.0 && level.is_finite()))?;
        let channels = [Channel::Red, Channel::Green, Channel::Blue].map(|channel| full.shade_channel(n, v, channel));
        case.holds("a channel is the same alone", channels == levels)?;
        let recoloured = whole.recoloured();
        case.holds("channels are apart", shade(&recoloured, &recoloured.lamps) == Some(turned(levels)))?;
        case.holds("no lamps are black", shade(&whole, &[]).is_some_and(|levels| numbers::<T>(levels) == [0.0; 3]))?;
        let off = whole.lamps.map(|lamp| Lit { levels: [0.0; 3], ..lamp });
        case.holds("lamps that are off too", shade(&whole, &off).is_some_and(|off| numbers::<T>(off) == [0.0; 3]))?;
        let parts = whole.lamps.map(|lamp| shade(&whole, &[lamp]).map_or([f64::NAN; 3], numbers::<T>));
        adds_up(&case, most::<T>(), found, parts)?;
        let double = whole.lamps.map(|lamp| Lit { levels: lamp.levels.map(|level| 2.0 * level), ..lamp });
        let bright = shade(&whole, &double).map_or([f64::NAN; 3], numbers::<T>);
        // As twice itself, where levels round alike and no product of small ones is subnormal.
        if matches!(whole.format, Format::F64 | Format::F32 | Format::Micromath) {
            adds_up(&case, most::<T>(), bright, [found, found, [0.0; 3]])?;
        }
        let Some(lamp) = whole.lamps[0].rounded() else { return Ok(()) };
        case.holds("a full scene takes no more", full.push(&lamp) == Err(SceneError::Full { capacity: ROOM }))?;
        case.holds("and is as before", full.shade(n, v) == levels && full.lights() == ROOM)?;
        white::<T, H>(&case, &whole, method)
    }
}

fn most<T: Real>() -> f64 {
    T::of_level(T::level(T::Scalar::MAX)).exact()
}

/// The sum of the lamps, but for a rounding of each and of each sum; no more than the greatest level, which floats of 8
/// exponent bits or more may reach early, in a product whose next factor would have brought it back.
fn adds_up(case: &Case, most: f64, found: [f64; 3], parts: [[f64; 3]; 3]) -> Result<(), Broken> {
    let least = match case.format {
        Format::F64 | Format::F32 | Format::Micromath => 1e-37,
        // Its subnormal numbers, times the gain of the narrowest highlight.
        Format::F16 => 1.2e-4,
        Format::I2F14 | Format::I16F16 => 1.0 / 65536.0,
        Format::I2F30 => 1.0 / 4_294_967_296.0,
    };
    for (channel, found) in found.into_iter().enumerate() {
        let sum: f64 = parts.iter().map(|part| part[channel]).sum();
        let step = if case.format == Format::Micromath { Format::F32.step() } else { case.format.step() };
        let allowed = 3.0 * step * sum + 3.0 * least;
        let wide = matches!(case.format, Format::F64 | Format::F32 | Format::Micromath);
        if wide && found >= most && sum >= most / 16.0 {
            continue;
        }
        case.at_most("a pixel is the sum of its lamps", (found - sum.min(most)).abs(), allowed)?;
    }
    Ok(())
}

/// White that faces a light of illuminance pi is exactly white, whatever the roughness, the light's size and the axis.
fn white<T: Real, H: Highlight<T>>(case: &Case, whole: &Whole, method: Make<T, H>) -> Result<(), Broken> {
    let mut axis = [0.0; 3];
    axis[whole.lamps[1].direction[0].to_bits() as usize % 3] = if whole.alpha < 0.1 { 1.0 } else { -1.0 };
    let facing = Lit { direction: axis, levels: [PI; 3], ..whole.lamps[0] };
    let white = Whole { colours: [[1.0; 3], [0.0; 3]], ..*whole };
    let axis = axis.map(T::from_f64);
    let levels = white.scene::<T, H>(method, &[facing]).map(|scene| numbers::<T>(scene.shade(axis, axis)));
    case.holds("white is white", levels == Some([1.0; 3]))
}
