//! The directions of a distant sphere's disc: even samples of them, their density, and whether a direction is one.
//!
//! With `l` the unit direction to the light's centre, `x` radius over distance and `w` the versine, all directions `a`
//! with `|a - l|^2 <= 2 w` are of the disc. Neither `acos` nor a cosine is asked: in f32 both tell no more than 183
//! angles within the Sun's radius.

mod basis;
mod points;
mod turn;

pub use basis::basis;
pub use points::points;
pub use turn::sin_cos;

use crate::light::LightError;
use crate::real::{Constant, Real, Scalar, at_most, positive, within_one};
use crate::specular::finite;
use crate::sphere::DistantSphere;
use crate::vec3::{each, zip};

/// The directions to a distant sphere: a cone about `l`, with all that sampling needs of it, computed once per light.
///
/// ```
/// use sunglint::sampling::{Cone, points};
/// use sunglint::{DistantSphere, SUN};
///
/// let cone = Cone::new([0.0, 0.6, 0.8], &DistantSphere::<f32>::new(&SUN));
/// assert!(points(0, 16).all(|point| cone.contains(cone.direction(point))));
/// assert!((cone.pdf().unwrap() * cone.solid_angle() - 1.0).abs() < 1e-7);
/// ```
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cone<T: Real> {
    l: [T; 3],
    basis: [[T; 3]; 2],
    /// No wider than half the sky. Wider cones are told by what is left of the sky, which is about `-l`.
    narrow: bool,
    versine: T::Scalar,
    /// The sine at `z` is `reach sqrt(z (near + far (1 - z)))`.
    reach: T::Scalar,
    near: T::Scalar,
    far: T::Scalar,
    /// Square of the chord from the rim to `l`, or to `-l`, in the scale of [`Real::square`].
    chord_square: T::Scalar,
    /// In that scale.
    solid_angle: T::Scalar,
    mean_cosine: T::Scalar,
}

impl<T: Real> Cone<T> {
    /// The directions of `light` about the unit direction `l` to its centre.
    ///
    /// An `l` that is not finite, or longer than 2, is taken for zero; samples are then meaningless but finite.
    ///
    /// ```
    /// use sunglint::fixed::types::I2F14;
    /// use sunglint::sampling::Cone;
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let lanes = |bits: [i16; 3]| bits.map(I2F14::from_bits);
    /// let cone = Cone::new(lanes([0, 9830, 13107]), &DistantSphere::<I2F14>::new(&SUN));
    /// assert!(cone.contains(lanes([0, 9830, 13107])) && !cone.contains(lanes([0, 0, 16384])));
    /// // Nothing is where a direction is no number.
    /// let nowhere = Cone::new([f32::NAN, 0.0, 1.0], &DistantSphere::<f32>::new(&SUN));
    /// assert!(nowhere.direction([0.5, 0.5]).into_iter().all(f32::is_finite));
    /// ```
    #[inline]
    pub fn new(l: [T; 3], light: &DistantSphere<T>) -> Self {
        let (zero, one) = (T::Scalar::ZERO, T::Scalar::ONE);
        let [sin, cos, versine] = each([light.sin, light.cos, light.versine], T::scalar);
        let narrow = cos >= zero;
        let scaled = scale::<T>() * sin;
        // The full sphere has -2 for its cosine.
        let size = if narrow { cos } else { at_most(zero - cos, one) };
        // Tangent of half the angular radius, or of half of what that leaves of 180 degrees: at most 1. Neither it nor
        // the versine of a small disc is taken from the light's versine, which is subnormal in f16.
        let tangent = sin / (one + size);
        let square = tangent * tangent;
        let (versine, scaled_versine) =
            if narrow { (sin * tangent, scaled * tangent) } else { (versine, scale::<T>() * versine) };
        let (reach, near, far) = if narrow { (sin, one, square) } else { (versine, square, one) };
        let mean_cosine =
            if narrow { (one + cos) / (one + one) } else { (one + (one - sin * sin)) / (versine + versine) };
        let chord_square = scaled * (tangent + tangent);
        let solid_angle = scaled_versine * T::Scalar::constant(TAU);
        let l = finite(l);
        Self { l, basis: basis(l), narrow, versine, reach, near, far, chord_square, solid_angle, mean_cosine }
    }

    /// The direction of the disc at `[z, turn]`, two numbers in `[0, 1)`: evenly spread over the disc's solid angle if
    /// the numbers are over the square.
    ///
    /// The versine of its angle from `l` is `z w`, so that its sine is `sqrt(z (x^2 + w^2 (1 - z)))`, in which nothing
    /// is subtracted that cancels, for discs up to the full sphere. The turn begins at the first vector of [`basis`]
    /// and goes towards the second. `z = 0` is `l`, `z = 1` the rim. Numbers below 0, and NaN, are taken for 0 and
    /// those above 1 for 1.
    ///
    /// Every answer is within [`Cone::contains`]: one that rounding has put outside is moved inwards, first by
    /// what it is outside, then by twice that, until it is not.
    ///
    /// Worst error in radians, against exact arithmetic on the same `l`, light and numbers, for discs of an angular
    /// radius up to the one given (searched for, `tests/figures.rs`):
    ///
    /// | | f64 | f32 | micromath | f16 | I2F14 | I2F30 | I16F16 |
    /// |---|---|---|---|---|---|---|---|
    /// | 0.01 rad, as the Sun | 3.4e-16 | 1.2e-7 | 1.5e-7 | 9.8e-4 | 1.7e-4 | 1.9e-9 | 3.1e-5 |
    /// | the same over the Sun's radius | 7.4e-14 | 2.6e-5 | 3.3e-5 | 0.22 | 0.037 | 4.1e-7 | 6.7e-3 |
    /// | 0.5 rad | 6.2e-16 | 2.6e-7 | 4.3e-6 | 2.0e-3 | 1.7e-4 | 2.8e-9 | 3.7e-5 |
    /// | half the sky | 1.6e-15 | 6.0e-7 | 5.3e-6 | 5.3e-3 | 2.7e-4 | 3.9e-9 | 7.3e-5 |
    /// | the full sphere | 1.8e-15 | 6.7e-7 | 2.1e-5 | 5.7e-3 | 2.7e-4 | 5.0e-9 | 7.3e-5 |
    /// | any, the length's difference from 1 | 8.8e-16 | 4.8e-7 | 1.1e-5 | 3.6e-3 | 1.3e-4 | 3.5e-9 | 3.1e-5 |
    ///
    /// The worst are samples of the rim that have been moved inwards; the root mean square at the Sun is a
    /// quarter to an eighth of that (f32 1.5e-8, I2F14 2.6e-5).
    ///
    /// Source: own derivation, in place of the published `acos(1 - z + z sqrt(1 - x^2))`, which has 183 angles for the
    /// Sun in f32, some of them outside.
    ///
    /// ```
    /// use sunglint::sampling::Cone;
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let cone = Cone::new([0.0, 0.0, 1.0], &DistantSphere::<f64>::new(&SUN));
    /// assert_eq!(cone.direction([0.0, 0.7]), [0.0, 0.0, 1.0]);
    /// // A quarter of the solid angle is within half of the radius; a quarter turn from x is y.
    /// let [x, y, _] = cone.direction([0.25, 0.25]);
    /// assert!(x.abs() < 1e-15 && (y / SUN.sin() - 0.5).abs() < 1e-5);
    /// ```
    #[inline]
    pub fn direction(&self, point: [T; 2]) -> [T; 3] {
        let [z, turn] = point;
        let z = within_one(T::of_lane(z));
        let across = self.across(T::of_lane(turn));
        let direction = self.at(z, T::Scalar::ONE - z, across);
        if self.contains(direction) { direction } else { self.pulled_in(z, across, direction) }
    }

    /// Whether the unit vector `direction` is within the disc: `|direction - l|^2 <= 2 w`, or where the disc is wider
    /// than half the sky `|direction + l|^2 >= 2 (2 - w)`.
    ///
    /// For small discs the difference is exact. Directions on the wrong side of the rim are at most so far from it, in
    /// radians, with lengths off by what rounding to the format does to them, for angular radii from 0.001 up to that
    /// given, or to 0.001 short of it (searched for, `tests/figures.rs`):
    ///
    /// | | f64 | f32 | micromath | f16 | I2F14 | I2F30 | I16F16 |
    /// |---|---|---|---|---|---|---|---|
    /// | 0.01 rad, as the Sun | 5.9e-18 | 1.6e-9 | 1.6e-9 | 2.1e-4 | 3.2e-6 | 1.4e-11 | 1.2e-7 |
    /// | 0.5 rad | 2.5e-16 | 8.0e-8 | 8.2e-8 | 6.5e-4 | 2.6e-5 | 6.0e-10 | 5.8e-6 |
    /// | half the sky | 7.5e-16 | 3.6e-7 | 3.6e-7 | 2.6e-3 | 8.9e-5 | 1.4e-9 | 2.6e-5 |
    /// | the full sphere | 1.0e-15 | 3.6e-7 | 3.6e-7 | 3.0e-3 | 8.9e-5 | 1.6e-9 | 2.6e-5 |
    ///
    /// A disc below 0.001 rad, or so near to the full sphere, is finer than the lights of the narrow formats: there up
    /// to 4.8e-4 in f16, 6.8e-5 in I2F14, 1.8e-5 in I16F16 and 1.1e-9 in I2F30. In f32 and micromath a disc below
    /// 0.001 rad has up to 3.1e-9.
    ///
    /// False for NaN and infinities.
    ///
    /// ```
    /// use sunglint::sampling::Cone;
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// // The Sun's rim is 0.004 650 467 rad from its centre.
    /// let cone = Cone::new([0.0, 0.0, 1.0], &DistantSphere::<f32>::new(&SUN));
    /// let beside = |x: f32| [x, 0.0, (1.0 - x * x).sqrt()];
    /// assert!(cone.contains(beside(0.004_650)) && !cone.contains(beside(0.004_651)));
    /// assert!(!cone.contains([f32::NAN, 0.0, 1.0]));
    /// ```
    #[inline]
    pub fn contains(&self, direction: [T; 3]) -> bool {
        let square = self.chord_square_to(direction);
        if self.narrow { square <= self.chord_square } else { square >= self.chord_square && square <= T::Scalar::MAX }
    }

    /// The solid angle `2 pi w` in steradians, in f16 subnormal below `x = 0.0044`.
    ///
    /// Relative error of it, as `tests/figures.rs` asserts for angular radii from 1e-5 (I2F14 and I16F16 0.001, f16
    /// 0.0045) up to the full sphere: f64 1.3e-15, f32 and micromath 3.6e-7, f16 2.8e-3, I2F14 4.2e-6, I2F30 2.7e-9,
    /// I16F16 2.7e-7.
    ///
    /// ```
    /// use sunglint::sampling::Cone;
    /// use sunglint::{DistantLight, DistantSphere, SUN};
    ///
    /// let solid_angle = |light| Cone::new([0.0, 0.0, 1.0], &DistantSphere::<f32>::of(light)).solid_angle();
    /// assert!((solid_angle(&SUN) / 6.794_3e-5 - 1.0).abs() < 1e-5);
    /// // All directions.
    /// assert!((solid_angle(&DistantLight::from_angle(360.0)?) / 12.566_371 - 1.0).abs() < 3.6e-7);
    /// # Ok::<(), sunglint::LightError>(())
    /// ```
    #[inline]
    pub fn solid_angle(&self) -> T::Scalar {
        self.solid_angle / scale::<T>()
    }

    /// Density of the samples per steradian, `1 / (2 pi w)`: 1 over [`Cone::solid_angle`] to 1 ULP. 1 for a point (`x =
    /// 0`), which is sampled whole.
    ///
    /// # Errors
    /// [`LightError::Overflow`] where that is infinite, in f16 below `x = 0.0022`.
    /// [`soft_shadow`](crate::shadow::soft_shadow) needs no density.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::sampling::Cone;
    /// use sunglint::{DistantLight, DistantSphere, LightError, SUN};
    ///
    /// let up = [f16::ZERO, f16::ZERO, f16::ONE];
    /// let pdf = |light| Cone::new(up, &DistantSphere::<f16>::of(light)).pdf();
    /// assert!((pdf(&SUN)?.to_f32() / 14_718.0 - 1.0).abs() < 3e-3);
    /// // A fifth as wide it is 25 times that, which f16 does not hold.
    /// assert_eq!(pdf(&DistantLight::from_ratio(SUN.sin() / 5.0)?), Err(LightError::Overflow("f16")));
    /// # Ok::<(), LightError>(())
    /// ```
    #[inline]
    pub fn pdf(&self) -> Result<T::Scalar, LightError> {
        if self.narrow && self.reach <= T::Scalar::ZERO {
            return Ok(T::Scalar::ONE);
        }
        let pdf = scale::<T>() / self.solid_angle;
        if pdf <= T::Scalar::MAX { Ok(pdf) } else { Err(LightError::Overflow(T::NAME)) }
    }

    /// What UsdLux `sizeFactor` is of the solid angle: `(1 + cos) / 2`, the mean over the disc of the cosine at a
    /// surface that faces it; beyond half the sky `(2 - sin^2) / (2 w)`, counting both sides of the surface.
    ///
    /// ```
    /// use sunglint::sampling::Cone;
    /// use sunglint::{DistantLight, DistantSphere};
    ///
    /// // Under half the sky the mean cosine is 1/2: illuminance pi over a solid angle of 2 pi.
    /// let sky = DistantSphere::<f64>::of(&DistantLight::from_ratio(1.0)?);
    /// assert_eq!(Cone::new([0.0, 0.0, 1.0], &sky).mean_cosine(), 0.5);
    /// # Ok::<(), sunglint::LightError>(())
    /// ```
    #[inline]
    pub fn mean_cosine(&self) -> T::Scalar {
        self.mean_cosine
    }

    /// Unit vector across `l`.
    #[inline]
    fn across(&self, turn: T::Scalar) -> [T; 3] {
        let [sin, cos] = sin_cos(turn);
        let [t, b] = self.basis;
        T::diff(T::narrow(cos), t, T::narrow(T::Scalar::ZERO - sin), b)
    }

    /// The direction at `z`, `rest` being `1 - z` with digits of its own: beside `-l` the angle hangs on them.
    #[inline]
    fn at(&self, z: T::Scalar, rest: T::Scalar, across: [T; 3]) -> [T; 3] {
        let sin = self.reach * (z * (self.near + self.far * rest)).root();
        T::rim(self.l, T::narrow(z * self.versine), across, T::square(across), T::narrow(sin))
    }

    #[inline]
    fn chord_square_to(&self, direction: [T; 3]) -> T::Scalar {
        let chord = zip(direction, self.l, if self.narrow { T::sub } else { T::add });
        T::scalar(T::square(chord))
    }

    /// The sample at `z`, which lies `outside` by a rounding, moved inwards: first by what it is outside, then
    /// by twice that, until it is not.
    #[cold]
    fn pulled_in(&self, z: T::Scalar, across: [T; 3], outside: [T; 3]) -> [T; 3] {
        let beyond = self.chord_square_to(outside) - self.chord_square;
        let beyond = if self.narrow { beyond } else { T::Scalar::ZERO - beyond };
        // The square of the chord is 2 w z. In f16 that may underflow.
        let pulls = [beyond * T::Scalar::constant(PI) / self.solid_angle].into_iter();
        let mut pull =
            pulls.chain(LEAST_PULLS.map(T::Scalar::constant)).find(|&pull| positive(pull)).unwrap_or(T::Scalar::ONE);
        while pull < T::Scalar::ONE {
            let direction = self.at(within_one(z - pull), T::Scalar::ONE - z + pull, across);
            if self.contains(direction) {
                return direction;
            }
            pull = pull + pull;
        }
        self.l
    }
}

const PI: Constant = Constant::new(core::f64::consts::PI);

/// The least numbers of f16: with subnormals, and where those are flushed.
const LEAST_PULLS: [Constant; 2] = [Constant::new(1.0 / (1 << 24) as f64), Constant::new(1.0 / (1 << 14) as f64)];

const TAU: Constant = Constant::new(core::f64::consts::TAU);

/// The scale of [`Real::square`].
#[inline]
fn scale<T: Real>() -> T::Scalar {
    T::scalar(T::square([T::lane(T::Scalar::ONE), T::ZERO, T::ZERO]))
}
