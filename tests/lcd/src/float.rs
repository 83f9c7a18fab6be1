//! The same ball in f32, to compare costs: geometry, light and tones by the same formulas. What is where stays the
//! integer code of the other.

mod by_hand;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use libm::sqrtf;
use sunglint::highlight::DiscGgx;
use sunglint::material::Surface;
use sunglint::scene::{Lamp, Scene};
use sunglint::{DistantSphere, SUN, normalize};

use crate::planet::{GROUND, ground, wave};
pub use by_hand::ByHand;

/// A material in the Sun.
pub trait Lit: Sized {
    /// Of its albedo and alpha; the reflectance at normal incidence and the light are the same for all.
    fn new(albedo: [f32; 3], alpha: f32, f0: f32, sun: [f32; 3], illuminance: f32) -> Option<Self>;

    /// Radiance towards `v`.
    fn shade(&self, n: [f32; 3], v: [f32; 3]) -> [f32; 3];
}

/// By the crate's scene, with the method of `PixelQ14`.
pub type ByScene = Scene<f32, 1, DiscGgx<f32>>;

impl Lit for ByScene {
    fn new(albedo: [f32; 3], alpha: f32, f0: f32, sun: [f32; 3], illuminance: f32) -> Option<Self> {
        let mut scene = Scene::with_highlight(&Surface::new(albedo, alpha, [f0; 3]).ok()?, DiscGgx::new);
        let lamp = Lamp::new(sun, DistantSphere::<f32>::new(&SUN), [illuminance; 3]).ok()?;
        scene.push(&lamp).ok()?;
        Some(scene)
    }

    fn shade(&self, n: [f32; 3], v: [f32; 3]) -> [f32; 3] {
        Scene::shade(self, n, v)
    }
}

/// [`planet::lit`](crate::planet::lit) in f32.
pub fn lit<L: Lit>() -> Option<[L; 4]> {
    let [sea, wood, sand, ice] = GROUND.map(|(albedo, alpha)| {
        let part = |part: i32| part as f32 / 256.0;
        let third = 1.0 / 3.0;
        L::new(albedo.map(part), part(alpha), part(5), [-2.0 * third, third, 2.0 * third], 10.0)
    });
    Some([sea?, wood?, sand?, ice?])
}

/// [`ball::colour`](crate::ball::colour) in f32, where the ball fills -1 to 1.
pub fn colour<L: Lit>(lit: &[L; 4], [x, y]: [f32; 2], [cos, sin]: [f32; 2]) -> Rgb565 {
    let square = 1.0 - x * x - y * y;
    if square <= 0.0 {
        return Rgb565::BLACK;
    }
    let z = sqrtf(square);
    let [east, north] = [x * (15.0 / 16.0) - y * (6.0 / 16.0), x * (6.0 / 16.0) + y * (15.0 / 16.0)];
    let place = [east * cos + z * sin, north, z * cos - east * sin].map(|lane| (lane * 16_384.0) as i32);
    let [r, g, b] = lit[ground(place)].shade([x, y, z], [0.0, 0.0, 1.0]);
    let day = y - 2.0 * x + 2.0 * z + 0.25;
    let haze = if day > 0.0 { day * ((1.0 - z) * (1.0 - z) * 0.5) } else { 0.0 };
    let [r, g, b] = [(r, haze * 0.25), (g, haze * 0.5), (b, haze)].map(|(ground, air)| {
        let level = ground + air;
        sqrtf(level / (1.0 + level))
    });
    Rgb565::new((r * 32.0) as u8, (g * 64.0) as u8, (b * 32.0) as u8)
}

/// [`ball::draw`](crate::ball::draw) in f32.
pub fn draw<D: DrawTarget<Color = Rgb565>, L: Lit>(display: &mut D, lit: &[L; 4], turn: u16) -> Result<(), D::Error> {
    let bounds = display.bounding_box();
    let size = bounds.size.width.min(bounds.size.height);
    let area = Rectangle::with_center(bounds.center(), Size::new_equal(size));
    let (step, middle) = ((17_000 / size.max(1) as i32) as f32 / 16_384.0, Point::new_equal(size as i32 - 1));
    let [cos, sin] = [i32::from(turn) + 16_384, turn.into()].map(|turn| wave(turn) as f32);
    let [cos, _, sin] = normalize([cos, 0.0, sin]);
    let colours = area.points().map(|point| {
        let Point { x, y } = (point - area.top_left) * 2 - middle;
        colour(lit, [x as f32 * step, -y as f32 * step], [cos, sin])
    });
    display.fill_contiguous(&area, colours)
}
