//! The least scene: some distant lights, one material, no geometry. Needs the feature `heapless`, which is on by
//! default.
//!
//! ```
//! use sunglint::material::{Material, Surface};
//! use sunglint::scene::{Lamp, Scene};
//! use sunglint::{DistantSphere, SUN};
//!
//! const SUN_F32: DistantSphere<f32> = DistantSphere::<f32>::new(&SUN);
//!
//! let sea = Material::new([0.01, 0.03, 0.05], 0.02, [0.02; 3])?;
//! let mut scene = Scene::<f32, 1>::new(&Surface::of(&sea));
//! // Illuminance pi makes a white surface that faces the light exactly white.
//! scene.push(&Lamp::new([0.6, 0.0, 0.8], SUN_F32, [core::f32::consts::PI; 3])?)?;
//! let [red, green, blue] = scene.shade([0.0, 0.0, 1.0], [-0.6, 0.0, 0.8]);
//! assert!(red > 10.0 && blue > red);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! In I2F14 and I2F30 all of this is integer arithmetic: directions in Q14 or Q30, cosines in Q28 or Q60, brightness in
//! [`Scaled`](crate::real::Scaled) numbers, light levels in U16F16 or U32F32, which saturate.

use core::fmt;

use crate::diffuse::relative_illuminance;
use crate::highlight::{ConeGgx, Gloss, Highlight};
use crate::material::Surface;
use crate::real::{Constant, INVERSE_PI, Real, Scalar};
use crate::sphere::DistantSphere;

/// A distant light where it stands: direction, size, and how bright it is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lamp<T: Real> {
    direction: [T; 3],
    sphere: DistantSphere<T>,
    illuminance: [T::Scalar; 3],
}

impl<T: Real> Lamp<T> {
    /// A light whose centre is in the unit `direction` from every surface, and that gives a surface that faces it
    /// `illuminance` in red, green and blue: 0 to the greatest level, in any unit; radiances come out in that unit per
    /// steradian.
    ///
    /// # Errors
    /// [`SceneError::Direction`] where the length is not within a tenth of 1, [`SceneError::Illuminance`] for negative,
    /// infinite and NaN levels.
    ///
    /// ```
    /// use sunglint::scene::{Lamp, SceneError};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let sun = DistantSphere::<f32>::new(&SUN);
    /// // Lux: radiances are then candela per square metre. Or pi, in which a white surface is exactly 1.
    /// assert!(Lamp::new([0.0, 0.6, 0.8], sun, [100_000.0; 3]).is_ok());
    /// assert_eq!(Lamp::new([0.0, 0.0, 2.0], sun, [1.0; 3]), Err(SceneError::Direction(4.0)));
    /// assert_eq!(Lamp::new([0.0, 0.6, 0.8], sun, [-1.0; 3]), Err(SceneError::Illuminance(-1.0)));
    /// ```
    pub fn new(
        direction: [T; 3],
        sphere: DistantSphere<T>,
        illuminance: [T::Level; 3],
    ) -> Result<Self, SceneError<T::Scalar>> {
        const SHORT: Constant = Constant::new(0.81);
        const LONG: Constant = Constant::new(1.21);
        let square = T::scalar(T::dot(direction, direction));
        let fits = square >= T::Scalar::constant(SHORT) && square <= T::Scalar::constant(LONG);
        if !fits {
            return Err(SceneError::Direction(square));
        }
        let [red, green, blue] = illuminance;
        let illuminance = [T::of_level(red), T::of_level(green), T::of_level(blue)];
        let bright = |level: T::Scalar| level >= T::Scalar::ZERO && level <= T::Scalar::MAX;
        match illuminance.into_iter().find(|&level| !bright(level)) {
            Some(level) => Err(SceneError::Illuminance(level)),
            None => Ok(Self { direction, sphere, illuminance }),
        }
    }
}

/// A light and its highlight's constants for the scene's material.
#[derive(Clone, Copy, Debug)]
struct Lit<T: Real, H> {
    lamp: Lamp<T>,
    highlight: H,
}

/// One material under up to `LIGHTS` distant lights.
///
/// `H` is the method of its highlights: [`ConeGgx`] from [`new`](Scene::new), any other by
/// [`with_highlight`](Scene::with_highlight).
#[derive(Clone, Debug)]
pub struct Scene<T: Real, const LIGHTS: usize, H = ConeGgx<T>> {
    surface: Surface<T>,
    method: fn(&DistantSphere<T>, T::Scalar) -> H,
    lights: heapless::Vec<Lit<T, H>, LIGHTS>,
}

/// Red, green or blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Channel {
    /// The first.
    Red,
    /// The second.
    Green,
    /// The third.
    Blue,
}

impl<T: Real, const LIGHTS: usize> Scene<T, LIGHTS> {
    /// A surface in the dark.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::material::{Material, Surface};
    /// use sunglint::scene::Scene;
    ///
    /// let sea = Material::new([0.01, 0.03, 0.05], 0.02, [0.02; 3])?;
    /// let night = Scene::<f16, 2>::new(&Surface::of(&sea));
    /// let up = [f16::ZERO, f16::ZERO, f16::ONE];
    /// assert_eq!(night.shade(up, up), [f16::ZERO; 3]);
    /// # Ok::<(), sunglint::material::MaterialError>(())
    /// ```
    pub fn new(surface: &Surface<T>) -> Self {
        Self::with_highlight(surface, ConeGgx::new)
    }
}

impl<T: Real, const LIGHTS: usize, H: Highlight<T>> Scene<T, LIGHTS, H> {
    /// A surface in the dark whose highlights are made by `method`, such as
    /// [`PointGgx::karis`](crate::highlight::PointGgx::karis).
    ///
    /// ```
    /// use sunglint::highlight::PointGgx;
    /// use sunglint::material::{Material, Surface};
    /// use sunglint::scene::{Channel, Lamp, Scene};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let black = Material::new([0.0; 3], 0.001, [0.04; 3])?;
    /// let mut scene = Scene::<f32, 1, _>::with_highlight(&Surface::of(&black), PointGgx::karis);
    /// let up = [0.0, 0.0, 1.0];
    /// scene.push(&Lamp::new(up, DistantSphere::<f32>::new(&SUN), [1.0; 3])?)?;
    /// // f0 / (4 pi (alpha + x/2)^2)
    /// assert!((scene.shade_channel(up, up, Channel::Red) / 287.8 - 1.0).abs() < 1e-3);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn with_highlight(surface: &Surface<T>, method: fn(&DistantSphere<T>, T::Scalar) -> H) -> Self {
        Self { surface: *surface, method, lights: heapless::Vec::new() }
    }

    /// Adds a light.
    ///
    /// # Errors
    /// [`SceneError::Full`] where there are `LIGHTS` of them; the scene is as before.
    ///
    /// ```
    /// use sunglint::material::{Material, Surface};
    /// use sunglint::scene::{Lamp, Scene, SceneError};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let mut scene = Scene::<f64, 1>::new(&Surface::of(&Material::new([0.5; 3], 0.1, [0.04; 3])?));
    /// let noon = Lamp::new([0.0, 0.6, 0.8], DistantSphere::<f64>::new(&SUN), [100_000.0; 3])?;
    /// assert_eq!(scene.push(&noon), Ok(()));
    /// assert_eq!(scene.push(&noon), Err(SceneError::Full { capacity: 1 }));
    /// assert_eq!(scene.lights(), 1);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn push(&mut self, lamp: &Lamp<T>) -> Result<(), SceneError<T::Scalar>> {
        let highlight = (self.method)(&lamp.sphere, self.surface.alpha);
        self.lights.push(Lit { lamp: *lamp, highlight }).map_err(|_| SceneError::Full { capacity: LIGHTS })
    }

    /// How many lights there are.
    ///
    /// ```
    /// use sunglint::material::{Material, Surface};
    /// use sunglint::scene::{Lamp, Scene};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let mut scene = Scene::<f32, 4>::new(&Surface::of(&Material::new([0.5; 3], 0.1, [0.04; 3])?));
    /// let sun = DistantSphere::<f32>::new(&SUN);
    /// for direction in [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, -0.6, 0.8]] {
    ///     scene.push(&Lamp::new(direction, sun, [1.0; 3])?)?;
    /// }
    /// assert_eq!(scene.lights(), 3);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn lights(&self) -> usize {
        self.lights.len()
    }

    /// Radiance in red, green and blue that a surface of unit normal `n` sends towards the unit direction `v`.
    ///
    /// Of each light: Lambert's law for what of the disc is above the surface
    /// ([`relative_illuminance`]), and the highlight while its centre is. Black without lights, where `n` faces
    /// away from all of them or from the viewer, and for NaN. Levels saturate; those of f64 and f32 (micromath too) may
    /// do so from a sixteenth of the greatest number on.
    ///
    /// ```
    /// use sunglint::fixed::types::{I2F14, U16F16};
    /// use sunglint::material::{Material, Surface};
    /// use sunglint::scene::{Lamp, Scene};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let mut scene = Scene::<I2F14, 1>::new(&Surface::of(&Material::new([0.75, 0.5, 0.25], 0.5, [0.0; 3])?));
    /// let [up, east] = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]].map(|lanes: [f64; 3]| lanes.map(I2F14::from_num));
    /// scene.push(&Lamp::new(up, DistantSphere::<I2F14>::new(&SUN), [U16F16::PI; 3])?)?;
    /// // Facing a light of illuminance pi a matt surface shows its albedo, to a step of 2^-16; from its edge it is not seen.
    /// let close = |level: U16F16, albedo: f64| (level.to_num::<f64>() - albedo).abs() < 2e-5;
    /// let [red, green, blue] = scene.shade(up, up);
    /// assert!(close(red, 0.75) && close(green, 0.5) && close(blue, 0.25));
    /// assert_eq!(scene.shade(up, east), [U16F16::ZERO; 3]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn shade(&self, n: [T; 3], v: [T; 3]) -> [T::Level; 3] {
        let mut sum = [T::Scalar::ZERO; 3];
        for lit in &self.lights {
            let (facing, gloss) = lit.seen(n, v);
            let [red, green, blue] = sum;
            sum = [
                red + self.reflected(lit, facing, &gloss, Channel::Red),
                green + self.reflected(lit, facing, &gloss, Channel::Green),
                blue + self.reflected(lit, facing, &gloss, Channel::Blue),
            ];
        }
        let [red, green, blue] = sum;
        [T::level(red), T::level(green), T::level(blue)]
    }

    /// The same in one channel, for what has but one.
    ///
    /// ```
    /// use sunglint::fixed::types::{I2F30, U32F32};
    /// use sunglint::material::{Material, Surface};
    /// use sunglint::scene::{Channel, Lamp, Scene};
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// // A grey display.
    /// let mut scene = Scene::<I2F30, 1>::new(&Surface::of(&Material::new([0.2; 3], 0.3, [0.04; 3])?));
    /// let up = [I2F30::ZERO, I2F30::ZERO, I2F30::ONE];
    /// scene.push(&Lamp::new(up, DistantSphere::<I2F30>::new(&SUN), [U32F32::PI; 3])?)?;
    /// assert_eq!(scene.shade_channel(up, up, Channel::Green), scene.shade(up, up)[1]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn shade_channel(&self, n: [T; 3], v: [T; 3], channel: Channel) -> T::Level {
        let mut sum = T::Scalar::ZERO;
        for lit in &self.lights {
            let (facing, gloss) = lit.seen(n, v);
            sum = sum + self.reflected(lit, facing, &gloss, channel);
        }
        T::level(sum)
    }

    /// One light's part in one channel.
    #[inline]
    fn reflected(&self, lit: &Lit<T, H>, facing: T::Scalar, gloss: &Gloss<T::Scalar>, channel: Channel) -> T::Scalar {
        let illuminance = channel.of(lit.lamp.illuminance);
        let diffuse = channel.of(self.surface.albedo) * facing * illuminance;
        diffuse + gloss.radiance(illuminance, channel.of(self.surface.f0))
    }
}

impl<T: Real, H: Highlight<T>> Lit<T, H> {
    /// The plane's share of the light's illuminance over pi, and the highlight; nothing for a viewer below the surface.
    #[inline]
    fn seen(&self, n: [T; 3], v: [T; 3]) -> (T::Scalar, Gloss<T::Scalar>) {
        let visible = T::dot(n, v) > T::WIDE_ZERO;
        if !visible {
            return (T::Scalar::ZERO, Gloss::DARK);
        }
        let share = relative_illuminance(T::dot(n, self.lamp.direction), &self.lamp.sphere);
        let facing = share * T::Scalar::constant(INVERSE_PI);
        (facing, self.highlight.shade(n, v, self.lamp.direction))
    }
}

impl Channel {
    #[inline]
    fn of<S>(self, [red, green, blue]: [S; 3]) -> S {
        match self {
            Self::Red => red,
            Self::Green => green,
            Self::Blue => blue,
        }
    }
}

/// Why a light was not taken into a scene; holds the value, and displays the range allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SceneError<S = f64> {
    /// There is no room for another light.
    Full {
        /// How many there is room for.
        capacity: usize,
    },
    /// The square of the direction's length, which is not within 0.81 to 1.21.
    Direction(S),
    /// A channel of the illuminance is negative, infinite or NaN.
    Illuminance(S),
}

impl<S: Scalar> fmt::Display for SceneError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Full { capacity } => write!(f, "one light too many, there is room for {capacity}"),
            Self::Direction(square) => {
                write!(f, "a direction's squared length is {}, allowed is 0.81 to 1.21", square.exact())
            }
            Self::Illuminance(value) => {
                write!(f, "an illuminance is {}, allowed is any finite number from 0", value.exact())
            }
        }
    }
}

impl<S: Scalar> core::error::Error for SceneError<S> {}
