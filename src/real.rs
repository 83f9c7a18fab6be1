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
    fn from_f64(value: f64) -> Self;

    /// The exact value, for oracles and tables.
    fn to_f64(self) -> f64;

    /// The nearest wide value; saturates like [`Real::from_f64`].
    fn wide(value: f64) -> Self::Wide;

    /// `a + b`, saturating in fixed point.
    fn add(a: Self, b: Self) -> Self;

    /// `a - b`, saturating in fixed point.
    fn sub(a: Self, b: Self) -> Self;

    /// A scalar of products as a number of wide range; exact but for the rounding of 60 bits to 31.
    fn scalar(wide: Self::Wide) -> Self::Scalar;

    /// The nearest scalar of products; saturates.
    fn narrow(scalar: Self::Scalar) -> Self::Wide;

    /// The lane as a number of wide range; exact.
    fn of_lane(lane: Self) -> Self::Scalar;

    /// The nearest lane; saturates.
    fn lane(scalar: Self::Scalar) -> Self;

    /// The nearest level; saturates at zero and at the greatest finite one. NaN is zero.
    fn level(scalar: Self::Scalar) -> Self::Level;

    /// The level as a number of wide range; exact but for the rounding of 64 bits to 31.
    fn of_level(level: Self::Level) -> Self::Scalar;

    /// The dot product, exact in fixed point.
    fn dot(a: [Self; 3], b: [Self; 3]) -> Self::Wide;

    /// `2 a`, wrapping in fixed point.
    fn twice(a: Self::Wide) -> Self::Wide;

    /// `a x - b y` lane by lane; fixed point rounds once, after I2F30's scalars have been rounded to Q31.
    fn diff(a: Self::Wide, x: [Self; 3], b: Self::Wide, y: [Self; 3]) -> [Self; 3];

    /// `v` times a power of two, exactly, so that what is subtracted from `v` next is rounded relative to its size;
    /// and the exponent. Floats do so by themselves, hence the default of no magnification.
    fn magnify(v: [Self; 3]) -> ([Self; 3], u32) {
        (v, 0)
    }

    /// The squared length, in f16 times 64 squared, so that the square of a light's radius stays a normal number.
    fn square(v: [Self; 3]) -> Self::Wide;

    /// The square of a constant length, as [`Real::square`] would give it.
    fn square_of(length: f64) -> Self::Wide;

    /// Whether `square`, taken of a vector magnified by `2^exponent`, is at most `limit`.
    fn within(square: Self::Wide, exponent: u32, limit: Self::Wide) -> bool;

    /// `l - versine l + s length / |s|`, the direction that lies `length` beside `l` on the side of `s`.
    ///
    /// `square` is [`Real::square`] of `s` and greater than zero; fixed point rounds once.
    fn rim(l: [Self; 3], versine: Self::Wide, s: [Self; 3], square: Self::Wide, length: Self::Wide) -> [Self; 3];

    /// `v` at unit length; zero where `v` is zero or not finite.
    fn normalize(v: [Self; 3]) -> [Self; 3];

    /// [`cap`](crate::specular::cap): by its formula, or by code for the format that is faster and within the same
    /// budget.
    #[inline]
    fn cap(l: [Self; 3], r: [Self; 3], light: &DistantSphere<Self>) -> [Self; 3] {
        nearest(l, r, light)
    }

    /// The half vector of `l` and `v` as the normal `n` sees it; see [`Halfway`].
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
