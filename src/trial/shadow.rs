//! Soft shadows against areas on the sphere: what is measured, and the budgets.

use core::f64::consts::FRAC_PI_2;

use oorandom::Rand64;

use super::format::Format;
use super::found::{Found, worse};
use super::lights::{BUDGETED, Light};
use super::sampling::lights;
use crate::light::DistantLight;
use crate::oracle;
use crate::oracle::cone::{mean_cosine, overlap};
use crate::real::{Real, Scalar};
use crate::sampling::Cone;
use crate::shadow::soft_shadow;
use crate::sphere::DistantSphere;

/// What stands before the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Occluder {
    /// A half-plane whose edge crosses the disc.
    Plane,
    /// A sphere from a third to three times as wide as the light.
    Sphere,
    /// The surface itself, behind whose horizon the light sets; the error is the greater of both means'.
    Horizon,
}

impl Occluder {
    /// All occluders.
    pub const ALL: [Self; 3] = [Self::Plane, Self::Sphere, Self::Horizon];
}

/// Numbers of directions that are tried.
pub const COUNTS: [u32; 5] = [16, 64, 256, 1024, 65536];

/// The lights that are tried.
pub const LIGHTS: [Light; 3] = [BUDGETED[0], BUDGETED[2], BUDGETED[3]];

/// Worst error with `count` directions under the light at `light` in [`LIGHTS`]: `2 count^-0.75`, which the points
/// make, and what the format makes of a disc that is few of its steps wide, however many the directions.
///
/// Twice is 1.12 times the worst of 400 scenes for each occluder, number up to 1024 and light, 1.7, rounded up; the
/// rest is 1.12 times what the worst of 40 scenes with 65 536 directions, or those of fewer, have beyond that.
pub fn budget(format: Format, light: usize, count: u32) -> f64 {
    let rest = FLOORS.get(light).map_or(0.0, |floors| floors[format as usize]);
    2.0 * libm::pow(count.into(), -0.75) + rest
}

/// The Sun is ten steps of f16 and 76 of I2F14 wide, from its centre to the rim.
const FLOORS: [[f64; 7]; 3] =
    [[0.0, 0.0, 0.0, 4.0e-2, 2.1e-3, 0.0, 0.0], [0.0, 0.0, 0.0, 1.4e-3, 0.0, 0.0, 0.0], [0.0; 7]];

/// One light that is partly hidden.
struct Scene {
    /// Edge's distance from the disc's centre, in radians.
    offset: f64,
    /// The occluder's angular radius.
    radius: f64,
    /// Where the occluder's centre, or the normal, is.
    centre: [f64; 3],
}

/// Error of the visible share under `light` with `count` directions, over `scenes` scenes; in those of
/// [`Occluder::Horizon`] that of the mean cosine too, as a share of the greatest cosine there.
pub fn error<T: Real>(light: &DistantLight, occluder: Occluder, count: u32, seed: u64, scenes: usize) -> Found {
    let sphere = DistantSphere::<T>::of(light);
    let theta = light.angular_radius();
    let mut source = Rand64::new(u128::from(seed) + 77);
    let mut found = Found::new();
    for l in lights(seed, scenes) {
        let l = l.map(T::from_f64);
        let scene = Scene::new(l.map(T::to_f64), occluder, theta, &mut source);
        let n = if occluder == Occluder::Horizon { scene.centre.map(T::from_f64) } else { l };
        let first = source.rand_u64() as u32;
        let seen = soft_shadow(&Cone::new(l, &sphere), n, first, count, |a| scene.sees(occluder, a.map(T::to_f64)));
        let [visible, cosine] = [seen.visible, seen.cosine].map(Scalar::exact);
        // Of the directions as rounded.
        let zenith = oracle::angle_between(l.map(T::to_f64), n.map(T::to_f64));
        let inputs = [visible, cosine, scene.offset, scene.radius, zenith, first.into()];
        if occluder == Occluder::Horizon {
            let share = overlap(theta, FRAC_PI_2, zenith) / oracle::cone::solid_angle(theta);
            let most = libm::cos((zenith - theta).max(0.0));
            found.add(worse((visible - share).abs(), (cosine - mean_cosine(theta, zenith)).abs() / most), inputs);
        } else {
            found.add_signed(visible - scene.visible(theta), inputs);
        }
    }
    found
}

impl Scene {
    fn new(l: [f64; 3], occluder: Occluder, theta: f64, source: &mut Rand64) -> Self {
        let mut between = |from: f64, to: f64| from + (to - from) * source.rand_float();
        let (part, size, turn) = (between(-0.95, 0.95), between(-1.0, 1.0), between(0.0, 1.0));
        let offset = part * theta;
        let radius = match occluder {
            Occluder::Sphere => (theta * libm::pow(3.0, size)).min(1.2),
            Occluder::Plane | Occluder::Horizon => FRAC_PI_2,
        };
        // The occluder's edge is `offset` beyond the centre of the light.
        let distance = radius + offset;
        let centre = oracle::cone::at(l, distance.abs(), turn);
        Self { offset, radius, centre }
    }

    fn sees(&self, occluder: Occluder, direction: [f64; 3]) -> bool {
        occluder == Occluder::Horizon || oracle::angle_between(direction, self.centre) > self.radius
    }

    fn visible(&self, theta: f64) -> f64 {
        let hidden = overlap(theta, self.radius, (self.radius + self.offset).abs());
        1.0 - hidden / oracle::cone::solid_angle(theta)
    }
}
