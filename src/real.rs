//! The seam: what one number format has to bring so that every formula of this crate runs in it.
//!
//! A formula is written once, over [`Real`]. The float formats share one implementation over [`Float`]
//! (`f64`, `f32`, `micromath::F32`, `half::f16`); the fixed-point formats keep squares and sums of products in a
//! wide accumulator and round once, when they narrow.

#[cfg(feature = "fixed")]
pub(crate) mod fixed;
pub(crate) mod float;
#[cfg(feature = "half")]
pub(crate) mod half;
#[cfg(feature = "micromath")]
mod micro;
mod scalar;
#[cfg(feature = "fixed")]
mod scaled;

pub use float::Float;
pub use scalar::{Constant, Scalar};
pub(crate) use scalar::{HALF, INVERSE_PI, at_most, positive, within_one};
#[cfg(feature = "fixed")]
pub use scaled::Scaled;

use core::fmt::Debug;

use crate::specular::nearest;
use crate::sphere::DistantSphere;

/// Cosine of 44.4 degrees, a disc of ratio 0.7: see [`Real::STEEP`].
pub(crate) const STEEP_COSINE: f64 = 0.714;

/// A number format in which directions are held and lit.
///
/// Lanes of unit vectors are of the type itself. Scalars that come from products of lanes (dot products, squares) and
/// the constants of a light are [`Real::Wide`]: the type itself for floats, twice the fraction bits for fixed point.
///
/// The trait is open: a study or a test may bring a format of its own. No method panics, and vectors of length up to
/// 1.16 never overflow.
pub trait Real: Copy + PartialOrd + Debug + 'static {
    /// Scalars of products: `f32` for `f32`, Q28 in an `i32` for I2F14, Q60 in an `i64` for I2F30.
    type Wide: Copy + PartialOrd + Debug + 'static;

    /// Numbers of wide range, in which brightness is computed: the type itself for floats, [`Scaled`] for fixed point.
    type Scalar: Scalar;

    /// Light levels (illuminance, radiance), never negative: the type itself for floats, U16F16 for I2F14 and I16F16,
    /// U32F32 for I2F30.
    type Level: Copy + PartialOrd + Debug + 'static;

    /// Name of the format, as tables and charts print it.
    const NAME: &'static str;

    /// 0, for lanes.
    const ZERO: Self;

    /// 0, for scalars.
    const WIDE_ZERO: Self::Wide;

    /// 1, for scalars.
    const WIDE_ONE: Self::Wide;

    /// The greatest finite scalar.
    const WIDE_MAX: Self::Wide;

    /// Between these two cosines of the angular radius, about -0.714 and 0.714, a disc's rim is told by its cosine;
    /// beyond them the sine is the better conditioned.
    const STEEP: [Self::Wide; 2];

    /// The nearest value of the format; a value out of range gives the nearest end (infinity for floats).
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// assert_eq!(I2F14::from_f64(0.5).to_bits(), 8192);
    /// assert_eq!(I2F14::from_f64(3.0), I2F14::MAX);
    /// assert_eq!(<f32 as Real>::from_f64(1e300), f32::INFINITY);
    /// ```
    fn from_f64(value: f64) -> Self;

    /// The exact value, for oracles and tables.
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// // The step of Q14, and what f32 makes of a tenth.
    /// assert_eq!(I2F14::from_bits(1).to_f64(), 1.0 / 16_384.0);
    /// assert_eq!(0.1_f32.to_f64(), 0.100_000_001_490_116_12);
    /// ```
    fn to_f64(self) -> f64;

    /// The nearest wide value; saturates like [`Real::from_f64`].
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// // Q28 in 32 bits ends at 8.
    /// assert_eq!((I2F14::wide(0.5), I2F14::wide(9.0)), (1 << 27, i32::MAX));
    /// ```
    fn wide(value: f64) -> Self::Wide;

    /// `a + b`, saturating in fixed point.
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// assert_eq!(Real::add(0.5_f32, 0.25), 0.75);
    /// assert_eq!(Real::add(I2F14::MAX, I2F14::ONE), I2F14::MAX);
    /// ```
    fn add(a: Self, b: Self) -> Self;

    /// `a - b`, saturating in fixed point.
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F30};
    ///
    /// // How far apart two directions are, lane by lane: exact.
    /// assert_eq!(Real::sub(I2F30::from_bits(7), I2F30::from_bits(4)).to_bits(), 3);
    /// assert_eq!(Real::sub(I2F30::MIN, I2F30::ONE), I2F30::MIN);
    /// ```
    fn sub(a: Self, b: Self) -> Self;

    /// A scalar of products as a number of wide range; exact but for the rounding of 60 bits to 31.
    ///
    /// ```
    /// use sunglint::{Real, Scalar, fixed::types::I2F14};
    ///
    /// // A cosine in Q28 becomes a number that can be squared, and squared again.
    /// let cos = I2F14::scalar(1 << 27);
    /// assert_eq!((cos * cos * cos * cos).exact(), 0.0625);
    /// ```
    fn scalar(wide: Self::Wide) -> Self::Scalar;

    /// The nearest scalar of products; saturates.
    ///
    /// ```
    /// use sunglint::real::Scaled;
    /// use sunglint::{Real, fixed::types::I2F30};
    ///
    /// assert_eq!(I2F30::narrow(Scaled::new(0.25)), 1 << 58);
    /// assert_eq!(I2F30::narrow(Scaled::new(100.0)), i64::MAX);
    /// ```
    fn narrow(scalar: Self::Scalar) -> Self::Wide;

    /// The lane as a number of wide range; exact.
    ///
    /// ```
    /// use sunglint::{Real, Scalar, fixed::types::I2F14};
    ///
    /// assert_eq!(I2F14::of_lane(I2F14::from_bits(-3)).exact(), -3.0 / 16_384.0);
    /// ```
    fn of_lane(lane: Self) -> Self::Scalar;

    /// The nearest lane; saturates.
    ///
    /// ```
    /// use sunglint::real::Scaled;
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// assert_eq!(I2F14::lane(Scaled::new(0.1)).to_bits(), 1638); // of 1638.4
    /// assert_eq!(I2F14::lane(Scaled::new(-5.0)), I2F14::MIN);
    /// ```
    fn lane(scalar: Self::Scalar) -> Self;

    /// The nearest level; saturates at zero and at the greatest finite one. NaN is zero.
    ///
    /// ```
    /// use sunglint::fixed::types::{I2F14, U16F16};
    /// use sunglint::{Real, real::Scaled};
    ///
    /// let level = |value| I2F14::level(Scaled::new(value));
    /// assert_eq!([level(0.5), level(-1.0), level(1e9)], [U16F16::lit("0.5"), U16F16::ZERO, U16F16::MAX]);
    /// assert_eq!([f32::NAN, f32::INFINITY].map(f32::level), [0.0, f32::MAX]);
    /// ```
    fn level(scalar: Self::Scalar) -> Self::Level;

    /// The level as a number of wide range; exact but for the rounding of 64 bits to 31.
    ///
    /// ```
    /// use sunglint::fixed::types::{I2F14, U16F16};
    /// use sunglint::{Real, Scalar};
    ///
    /// // A thousand lux, halved.
    /// let half = I2F14::of_level(U16F16::from_num(1000)) / I2F14::of_level(U16F16::from_num(2));
    /// assert_eq!(half.exact(), 500.0);
    /// ```
    fn of_level(level: Self::Level) -> Self::Scalar;

    /// The dot product, exact in fixed point.
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// let [a, b] = [[1, 2, 3], [4, 5, -6]].map(|v| v.map(I2F14::from_bits));
    /// assert_eq!(I2F14::dot(a, b), 4 + 10 - 18); // Q28, no bit lost
    /// ```
    fn dot(a: [Self; 3], b: [Self; 3]) -> Self::Wide;

    /// `2 a`, wrapping in fixed point.
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// assert_eq!(f32::twice(0.75), 1.5);
    /// assert_eq!(I2F14::twice(i32::MAX), -2);
    /// ```
    fn twice(a: Self::Wide) -> Self::Wide;

    /// `a x - b y` lane by lane; fixed point rounds once, after I2F30's scalars have been rounded to Q31.
    ///
    /// ```
    /// use sunglint::Real;
    ///
    /// // The mirror direction, as `reflect` makes it: 2 (n.v) n - v.
    /// let (n, v) = ([0.0, 0.0, 1.0], [0.6, 0.0, 0.8]);
    /// let r = f32::diff(f32::twice(f32::dot(n, v)), n, f32::WIDE_ONE, v);
    /// assert_eq!(r, [-0.6, 0.0, 0.8]);
    /// ```
    fn diff(a: Self::Wide, x: [Self; 3], b: Self::Wide, y: [Self; 3]) -> [Self; 3];

    /// `v` times a power of two, exactly, so that what is subtracted from `v` next is rounded relative to its size;
    /// and the exponent. Floats do so by themselves, hence the default of no magnification.
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// let short = [1, 0, -2].map(I2F14::from_bits);
    /// assert_eq!(I2F14::magnify(short), ([4096, 0, -8192].map(I2F14::from_bits), 12));
    /// assert_eq!(f32::magnify([1e-9, 0.0, 0.0]), ([1e-9, 0.0, 0.0], 0));
    /// ```
    fn magnify(v: [Self; 3]) -> ([Self; 3], u32) {
        (v, 0)
    }

    /// The squared length, in f16 times 64 squared, so that the square of a light's radius stays a normal number.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// let (x, half) = (f16::from_f32(1.0 / 64.0), I2F14::lit("0.5"));
    /// assert_eq!(f16::square([x, f16::ZERO, f16::ZERO]), f16::ONE);
    /// assert_eq!(I2F14::square([half, half, I2F14::ZERO]), 1 << 27);
    /// ```
    fn square(v: [Self; 3]) -> Self::Wide;

    /// The square of a constant length, as [`Real::square`] would give it.
    ///
    /// ```
    /// use sunglint::{DistantSphere, Real, SUN, half::f16};
    ///
    /// // The Sun's, which f16 could not hold unscaled but as a subnormal number.
    /// assert_eq!(f16::square_of(SUN.sin()), DistantSphere::<f16>::new(&SUN).sin_square());
    /// ```
    fn square_of(length: f64) -> Self::Wide;

    /// Whether `square`, taken of a vector magnified by `2^exponent`, is at most `limit`.
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// // 1/4 is the square of a vector magnified by 2, whose own is 1/16.
    /// let [quarter, sixteenth] = [1 << 26, 1 << 24];
    /// assert!(I2F14::within(quarter, 1, sixteenth) && !I2F14::within(quarter, 0, sixteenth));
    /// ```
    fn within(square: Self::Wide, exponent: u32, limit: Self::Wide) -> bool;

    /// `l - versine l + s length / |s|`, the direction that lies `length` beside `l` on the side of `s`.
    ///
    /// `square` is [`Real::square`] of `s` and greater than zero; fixed point rounds once.
    ///
    /// ```
    /// use sunglint::Real;
    ///
    /// // A disc of sine 0.6 and cosine 0.8 about the z axis: its rim towards x.
    /// let side = [0.25, 0.0, 0.0];
    /// let rim = f32::rim([0.0, 0.0, 1.0], 0.2, side, f32::square(side), 0.6);
    /// assert_eq!(rim, [0.6, 0.0, 0.8]);
    /// ```
    fn rim(l: [Self; 3], versine: Self::Wide, s: [Self; 3], square: Self::Wide, length: Self::Wide) -> [Self; 3];

    /// `v` at unit length; zero where `v` is zero or not finite.
    ///
    /// ```
    /// use sunglint::{Real, fixed::types::I2F14};
    ///
    /// // Four steps of Q14 are enough to tell a direction.
    /// assert_eq!(I2F14::normalize([3, 0, 4].map(I2F14::from_bits)), [9830, 0, 13_107].map(I2F14::from_bits));
    /// ```
    fn normalize(v: [Self; 3]) -> [Self; 3];

    /// [`cap`](crate::specular::cap): by its formula, or by code for the format that is faster and within the same
    /// budget.
    ///
    /// ```
    /// use sunglint::raw::SUN_Q14;
    /// use sunglint::{Real, cap, fixed::types::I2F14};
    ///
    /// let [l, r] = [[0, 0, 16_384], [9830, 0, 13_107]].map(|v| v.map(I2F14::from_bits));
    /// assert_eq!(I2F14::cap(l, r, &SUN_Q14), cap(l, r, &SUN_Q14));
    /// ```
    #[inline]
    fn cap(l: [Self; 3], r: [Self; 3], light: &DistantSphere<Self>) -> [Self; 3] {
        nearest(l, r, light)
    }

    /// The half vector of `l` and `v` as the normal `n` sees it; see [`Halfway`].
    ///
    /// ```
    /// use sunglint::Real;
    ///
    /// // The camera straight above, the light 36.9 degrees beside it: `h` leans by half of that, whose squared sine is 0.1.
    /// let n = [0.0, 0.0, 1.0];
    /// let half = f64::halfway(n, [0.6, 0.0, 0.8], n, 2.0, true);
    /// assert!((half.v_dot_h_square - 0.9).abs() < 1e-15 && (half.tilt - 0.1 * 4.0).abs() < 1e-15);
    /// assert!((half.in_plane - half.tilt).abs() < 1e-15);
    /// ```
    fn halfway(n: [Self; 3], l: [Self; 3], v: [Self; 3], gain: Self::Scalar, in_plane: bool) -> Halfway<Self::Scalar>;
}

/// How far a half vector `h` of `l` and `v` leans from the normal `n`, in units of a highlight's width.
///
/// Floats take the tilt from `n - h`, which is exact where the two are close, fixed point from `n x (l + v)` and `n.(l
/// - v)`, which are exact everywhere. Where `l = -v`, all of it is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Halfway<S> {
    /// `(v.h)^2`, which is `|l + v|^2 / 4`.
    pub v_dot_h_square: S,
    /// `(1 - (n.h)^2) gain^2`, at most [`WIDE_TILT`], in f16 [`MOST_TILT`].
    pub tilt: S,
    /// The part of that along `l - v`; half of it where `l = v`, when every direction is as good. Zero where it is not
    /// asked for, which spares a root and a division.
    pub in_plane: S,
}

/// Limit of a tilt in f16, and in any format whose greatest number is below [`WIDE_TILT`]: farther out than 173 widths.
pub const MOST_TILT: f64 = 30_000.0;

/// Limit of a tilt in all other formats: more than the narrowest highlight that has a width needs.
pub const WIDE_TILT: f64 = 1e12;

/// [`MOST_TILT`] in every format.
pub(crate) const TILT_LIMIT: Constant = Constant::new(MOST_TILT);

/// The greatest tilt that a format has room for.
#[inline]
pub(crate) fn most_tilt<S: Scalar>() -> S {
    const WIDE: Constant = Constant::new(WIDE_TILT);
    let wide = S::constant(WIDE);
    // f16 makes it infinite.
    if wide <= S::MAX { wide } else { S::constant(TILT_LIMIT) }
}
