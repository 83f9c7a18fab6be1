//! Float formats: one implementation of the seam for all of them.

use super::{Constant, HALF, Halfway, Real, STEEP_COSINE, Scalar, at_most, most_tilt};
use crate::vec3::{each, zip};

/// A floating-point format: ordinary arithmetic, rounded at every step, and a reciprocal root.
///
/// Implemented for `f64`, `f32`, `micromath::F32` and `half::f16`; a study may add its own.
pub trait Float: Scalar {
    /// Name of the format.
    const FORMAT: &'static str;

    /// See [`Real::STEEP`].
    const STEEP: [Self; 2];

    /// A power of two by which lengths are scaled before they are squared, so that the square of a light's radius
    /// stays a normal number. 1 where the format's exponent is wide enough.
    const SCALE: Self;

    /// A power of two. Radius over distance is divided by its square where it is below it, before it is squared, so
    /// that no digit of the square is lost to underflow, and neither overflow where the answer does not.
    const TINY: Self;

    /// Squared lengths that have lost nothing to overflow or underflow: [`Real::normalize`] rescales beyond them.
    const SAFE_SQUARE: [Self; 2];

    /// `2^s + 1`, `s` being half of the significand's digits, rounded up: cuts a number into two halves (Veltkamp).
    const SPLITTER: Self;

    /// Pi and what it lacks: together twice the format's digits.
    const PI: [Self; 2];

    /// Twice [`Float::PI`].
    const TWICE_PI: [Self; 2];

    /// 1/pi and what it lacks.
    const INVERSE_PI: [Self; 2];

    /// `length / sqrt(square)` for a positive `square`: two roundings, in micromath within 6e-6.
    ///
    /// ```
    /// use sunglint::Float;
    ///
    /// assert_eq!(Float::over_root(3.0, 4.0_f64), 1.5);
    /// let one = sunglint::micromath::F32(1.0);
    /// assert!((Float::over_root(one, one).0 - 1.0).abs() < 6e-6);
    /// ```
    fn over_root(length: Self, square: Self) -> Self;
}

/// Pi, as its nearest f64 and what that lacks.
pub(crate) const PI: [f64; 2] = [core::f64::consts::PI, 1.224_646_799_147_353_2e-16];

/// Twice that.
pub(crate) const TWICE_PI: [f64; 2] = [core::f64::consts::TAU, 2.449_293_598_294_706_4e-16];

/// One over pi.
pub(crate) const INVERSE_PI: [f64; 2] = [core::f64::consts::FRAC_1_PI, -1.967_867_667_518_248_6e-17];

/// 1 in Q31.
const Q31: f32 = 2_147_483_648.0;

/// A constant as its nearest f32 and what that lacks.
pub(crate) const fn pair_f32([value, low]: [f64; 2]) -> [f32; 2] {
    let high = value as f32;
    [high, ((value - high as f64) + low) as f32]
}

/// The root of f32, correctly rounded: libm's has an instruction for it on some machines.
#[cfg(not(any(target_arch = "arm", target_arch = "riscv32")))]
#[inline(always)]
fn root(x: f32) -> f32 {
    libm::sqrtf(x)
}

/// The root of f32, correctly rounded, hence the same bits.
#[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
#[inline]
fn root(x: f32) -> f32 {
    f32::from_bits(crate::root::single::root(x.to_bits()))
}

impl Scalar for f64 {
    const ZERO: Self = 0.0;

    const ONE: Self = 1.0;

    const MAX: Self = f64::MAX;

    const NEAR_ONE: Option<[Constant; 2]> =
        Some(Constant::either_way((1_u128 << 127) as f64 * (1_u128 << 127) as f64 * (1_u128 << 127) as f64));

    #[inline(always)]
    fn nearest(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn exact(self) -> f64 {
        self
    }

    #[inline(always)]
    fn constant(constant: Constant) -> Self {
        constant.value()
    }

    #[inline]
    fn root(self) -> Self {
        libm::sqrt(self)
    }

    #[inline]
    fn hypotenuse(a: Self, b: Self) -> Self {
        (a * a + b * b).root()
    }

    #[inline]
    fn from_q31(bits: u32) -> Self {
        f64::from(bits) / Q31 as f64
    }

    #[inline]
    fn to_q31(self) -> u32 {
        (self * Q31 as f64) as u32
    }
}

impl Float for f64 {
    const FORMAT: &'static str = "f64";

    const STEEP: [Self; 2] = [-STEEP_COSINE, STEEP_COSINE];

    const SCALE: Self = 1.0;

    // 2^-100
    const TINY: Self = 7.888_609_052_210_118e-31;

    const SAFE_SQUARE: [Self; 2] = [1e-30, 1e30];

    const SPLITTER: Self = 134_217_729.0;

    const PI: [Self; 2] = PI;

    const TWICE_PI: [Self; 2] = TWICE_PI;

    const INVERSE_PI: [Self; 2] = INVERSE_PI;

    #[inline]
    fn over_root(length: Self, square: Self) -> Self {
        length / libm::sqrt(square)
    }
}

impl Scalar for f32 {
    const ZERO: Self = 0.0;

    const ONE: Self = 1.0;

    const MAX: Self = f32::MAX;

    const NEAR_ONE: Option<[Constant; 2]> = Some(Constant::either_way((1_u128 << 64) as f64));

    #[inline(always)]
    fn nearest(value: f64) -> Self {
        value as f32
    }

    #[inline(always)]
    fn exact(self) -> f64 {
        f64::from(self)
    }

    #[inline(always)]
    fn constant(constant: Constant) -> Self {
        constant.value() as f32
    }

    #[inline]
    fn root(self) -> Self {
        root(self)
    }

    #[inline]
    fn hypotenuse(a: Self, b: Self) -> Self {
        (a * a + b * b).root()
    }

    #[inline]
    fn from_q31(bits: u32) -> Self {
        bits as f32 / Q31
    }

    #[inline]
    fn to_q31(self) -> u32 {
        (self * Q31) as u32
    }
}

impl Float for f32 {
    const FORMAT: &'static str = "f32";

    const STEEP: [Self; 2] = [-STEEP_COSINE as f32, STEEP_COSINE as f32];

    const SCALE: Self = 1.0;

    // 2^-30
    const TINY: Self = 9.313_226e-10;

    const SAFE_SQUARE: [Self; 2] = [1e-30, 1e30];

    const SPLITTER: Self = 4097.0;

    const PI: [Self; 2] = pair_f32(PI);

    const TWICE_PI: [Self; 2] = pair_f32(TWICE_PI);

    const INVERSE_PI: [Self; 2] = pair_f32(INVERSE_PI);

    #[inline]
    fn over_root(length: Self, square: Self) -> Self {
        length / root(square)
    }
}

impl<T: Float> Real for T {
    type Wide = T;

    type Scalar = T;

    type Level = T;

    const NAME: &'static str = T::FORMAT;

    const ZERO: Self = <T as Scalar>::ZERO;

    const WIDE_ZERO: T = <T as Scalar>::ZERO;

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

    #[inline(always)]
    fn scalar(wide: T) -> T {
        wide
    }

    #[inline(always)]
    fn narrow(scalar: T) -> T {
        scalar
    }

    #[inline(always)]
    fn of_lane(lane: Self) -> T {
        lane
    }

    #[inline(always)]
    fn lane(scalar: T) -> Self {
        scalar
    }

    #[inline]
    fn level(scalar: T) -> T {
        let positive = if scalar > T::WIDE_ZERO { scalar } else { T::WIDE_ZERO };
        if positive < T::MAX { positive } else { T::MAX }
    }

    #[inline(always)]
    fn of_level(level: T) -> T {
        level
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
        let scaled = each(v, |lane| lane * T::SCALE);
        Self::dot(scaled, scaled)
    }

    fn square_of(length: f64) -> T {
        let scaled = length * T::SCALE.exact();
        T::nearest(scaled * scaled)
    }

    #[inline]
    fn within(square: T, _exponent: u32, limit: T) -> bool {
        square <= limit
    }

    #[inline]
    fn rim(l: [Self; 3], versine: T, s: [Self; 3], square: T, length: T) -> [Self; 3] {
        let [least, _] = T::SAFE_SQUARE;
        let small = square < least;
        let s = if small { rescale(s).0 } else { s };
        let square = if small { Self::square(s) } else { square };
        let k = T::over_root(length * T::SCALE, square);
        // The small difference comes first, so that only the last sum rounds at the size of l.
        zip(l, s, |l, s| l + (k * s - versine * l))
    }

    #[inline]
    fn normalize(v: [Self; 3]) -> [Self; 3] {
        let square = Self::dot(v, v);
        let [least, most] = T::SAFE_SQUARE;
        let safe = square >= least && square <= most;
        let (v, square) = if safe { (v, square) } else { rescale(v) };
        if !safe && square <= T::WIDE_ZERO {
            return [T::WIDE_ZERO; 3];
        }
        let k = T::over_root(T::ONE, square);
        each(v, |lane| lane * k)
    }

    #[inline]
    fn halfway(n: [Self; 3], l: [Self; 3], v: [Self; 3], gain: T, in_plane: bool) -> Halfway<T> {
        let (zero, half) = (T::WIDE_ZERO, T::constant(HALF));
        let sum = zip(l, v, |l, v| (l + v) * half);
        let v_dot_h_square = Self::dot(sum, sum);
        let h = Self::normalize(sum);
        // The difference is exact where it is small; what of it is along h is the error of the lengths.
        let apart = zip(n, h, Self::sub);
        let radial = Self::dot(apart, h);
        let lean = each(zip(apart, h, |apart, h| apart - radial * h), |lane| lane * gain);
        let tilt = at_most(Self::dot(lean, lean), most_tilt());
        if !in_plane {
            return Halfway { v_dot_h_square, tilt, in_plane: zero };
        }
        let across = Self::normalize(zip(l, v, Self::sub));
        let along = Self::dot(lean, across);
        let in_plane = if Self::dot(across, across) > zero { at_most(along * along, tilt) } else { tilt * half };
        Halfway { v_dot_h_square, tilt, in_plane }
    }
}

/// `v` over its largest lane, and the square of that; zero where there is no such thing.
#[inline]
fn rescale<T: Float>(v: [T; 3]) -> ([T; 3], T) {
    let zero = T::WIDE_ZERO;
    let [x, y, z] = v;
    let largest = largest(x, y, z);
    let v = each(v, |lane| lane / largest);
    let square = T::dot(v, v);
    // NaN where the largest is zero or infinite, and where another lane is NaN.
    if square >= zero { (v, square) } else { ([zero; 3], zero) }
}

/// The size of the largest lane; zero where all are NaN.
///
/// Lanes by themselves, since an array would be handed over in memory, where the usual way would meet it.
#[cold]
fn largest<T: Float>(x: T, y: T, z: T) -> T {
    let zero = T::WIDE_ZERO;
    [x, y, z].into_iter().fold(zero, |most, lane| {
        let size = if lane < zero { zero - lane } else { lane };
        if size > most { size } else { most }
    })
}
