//! Float formats: one implementation of the seam for all of them.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Sub};

use super::Real;
use crate::vec3::{each, zip};

/// A floating-point format: ordinary arithmetic, rounded at every step, and a reciprocal root.
///
/// Implemented for `f64`, `f32`, `micromath::F32` and `half::f16`; a study may add its own.
pub trait Float:
    'static + Copy + PartialOrd + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Name of the format.
    const FORMAT: &'static str;

    /// 0.
    const ZERO: Self;

    /// 1.
    const ONE: Self;

    /// The greatest finite number.
    const MAX: Self;

    /// See [`Real::STEEP`].
    const STEEP: [Self; 2];

    /// A power of two by which lengths are scaled before they are squared, so that the square of a light's radius
    /// stays a normal number. 1 where the format's exponent is wide enough.
    const SCALE: f64 = 1.0;

    /// Squared lengths that have lost nothing to overflow or underflow: [`Real::normalize`] rescales beyond them.
    const SAFE_SQUARE: [f64; 2] = [1e-30, 1e30];

    /// `2^s + 1`, `s` being half of the significand's digits, rounded up: cuts a number into two halves (Veltkamp).
    const SPLITTER: f64;

    /// The nearest value of the format.
    fn nearest(value: f64) -> Self;

    /// The exact value.
    fn exact(self) -> f64;

    /// `length / sqrt(square)` for a positive `square`.
    fn over_root(length: Self, square: Self) -> Self;

    /// The square root; zero for zero, NaN or zero for negatives.
    fn root(self) -> Self;
}

impl Float for f64 {
    const FORMAT: &'static str = "f64";

    const ZERO: Self = 0.0;

    const ONE: Self = 1.0;

    const MAX: Self = f64::MAX;

    const STEEP: [Self; 2] = [-0.714, 0.714];

    const SPLITTER: f64 = 134_217_729.0;

    #[inline]
    fn nearest(value: f64) -> Self {
        value
    }

    #[inline]
    fn exact(self) -> f64 {
        self
    }

    #[inline]
    fn over_root(length: Self, square: Self) -> Self {
        length / libm::sqrt(square)
    }

    #[inline]
    fn root(self) -> Self {
        libm::sqrt(self)
    }
}

impl Float for f32 {
    const FORMAT: &'static str = "f32";

    const ZERO: Self = 0.0;

    const ONE: Self = 1.0;

    const MAX: Self = f32::MAX;

    const STEEP: [Self; 2] = [-0.714, 0.714];

    const SPLITTER: f64 = 4097.0;

    #[inline]
    fn nearest(value: f64) -> Self {
        value as f32
    }

    #[inline]
    fn exact(self) -> f64 {
        f64::from(self)
    }

    #[inline]
    fn over_root(length: Self, square: Self) -> Self {
        length / libm::sqrtf(square)
    }

    #[inline]
    fn root(self) -> Self {
        libm::sqrtf(self)
    }
}

impl<T: Float> Real for T {
    type Wide = T;

    const NAME: &'static str = T::FORMAT;

    const SQUARE_SCALE: f64 = T::SCALE;

    const ZERO: Self = <T as Float>::ZERO;

    const WIDE_ZERO: T = <T as Float>::ZERO;

    const WIDE_ONE: T = T::ONE;

    const WIDE_MAX: T = T::MAX;

    const STEEP: [T; 2] = <T as Float>::STEEP;

    #[inline]
    fn from_f64(value: f64) -> Self {
        T::nearest(value)
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.exact()
    }

    #[inline]
    fn wide(value: f64) -> T {
        T::nearest(value)
    }

    #[inline]
    fn add(a: Self, b: Self) -> Self {
        a + b
    }

    #[inline]
    fn sub(a: Self, b: Self) -> Self {
        a - b
    }

    #[inline]
    fn dot(a: [Self; 3], b: [Self; 3]) -> T {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    #[inline]
    fn twice(a: T) -> T {
        a + a
    }

    #[inline]
    fn diff(a: T, x: [Self; 3], b: T, y: [Self; 3]) -> [Self; 3] {
        zip(x, y, |x, y| a * x - b * y)
    }

    #[inline]
    fn square(v: [Self; 3]) -> T {
        let scaled = each(v, |lane| lane * T::nearest(T::SCALE));
        Self::dot(scaled, scaled)
    }

    #[inline]
    fn within(square: T, _exponent: u32, limit: T) -> bool {
        square <= limit
    }

    #[inline]
    fn rim(l: [Self; 3], versine: T, s: [Self; 3], square: T, length: T) -> [Self; 3] {
        let [least, _] = T::SAFE_SQUARE.map(T::nearest);
        let small = square < least;
        let s = if small { rescale(s).0 } else { s };
        let square = if small { Self::square(s) } else { square };
        let k = T::over_root(length * T::nearest(T::SCALE), square);
        // The small difference comes first, so that only the last sum rounds at the size of l.
        zip(l, s, |l, s| l + (k * s - versine * l))
    }

    #[inline]
    fn normalize(v: [Self; 3]) -> [Self; 3] {
        let square = Self::dot(v, v);
        let [least, most] = T::SAFE_SQUARE.map(T::nearest);
        let safe = square >= least && square <= most;
        let (v, square) = if safe { (v, square) } else { rescale(v) };
        if square <= T::WIDE_ZERO {
            return [T::WIDE_ZERO; 3];
        }
        let k = T::over_root(T::ONE, square);
        each(v, |lane| lane * k)
    }
}

/// `v` over its largest lane, and the square of that; zero where there is no such thing.
#[cold]
fn rescale<T: Float>(v: [T; 3]) -> ([T; 3], T) {
    let zero = T::WIDE_ZERO;
    let largest = v.into_iter().fold(zero, |most, lane| {
        let size = if lane < zero { zero - lane } else { lane };
        if size > most { size } else { most }
    });
    let usable = largest > zero && largest <= T::MAX;
    let v = if usable { each(v, |lane| lane / largest) } else { [zero; 3] };
    let square = T::dot(v, v);
    // Another lane may be NaN.
    if square >= zero { (v, square) } else { ([zero; 3], zero) }
}
