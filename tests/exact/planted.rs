//! Formats with an error planted into them, for showing that what judges a format would see it.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Sub};

use sunglint::real::{Constant, Halfway};
use sunglint::trial::Format;
use sunglint::{Float, Real, Scalar};

/// The format of a type by its name.
pub fn format<T: Real>() -> Format {
    Format::ALL.into_iter().find(|format| format.name() == T::NAME).unwrap()
}

/// A format whose unit vectors (with `SUMS` its differences and its single lanes too) are off by `STEPS` steps of the
/// format in their first lane, and its light levels by as many of their last places: in fixed point of the coarser of a
/// level's step and the last of 31 digits.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Off<T, const STEPS: u8, const SUMS: bool = false>(pub T);

fn bare<T: Real, const STEPS: u8, const SUMS: bool>(v: [Off<T, STEPS, SUMS>; 3]) -> [T; 3] {
    v.map(|lane| lane.0)
}

fn off<T: Real, const STEPS: u8, const SUMS: bool>([x, y, z]: [T; 3]) -> [Off<T, STEPS, SUMS>; 3] {
    let step = T::from_f64(f64::from(STEPS) * format::<T>().step());
    [T::add(x, step), y, z].map(Off)
}

impl<T: Real, const STEPS: u8, const SUMS: bool> Real for Off<T, STEPS, SUMS> {
    type Wide = T::Wide;
    type Scalar = T::Scalar;
    type Level = T::Level;

    const NAME: &'static str = T::NAME;
    const ZERO: Self = Self(T::ZERO);
    const WIDE_ZERO: T::Wide = T::WIDE_ZERO;
    const WIDE_ONE: T::Wide = T::WIDE_ONE;
    const WIDE_MAX: T::Wide = T::WIDE_MAX;
    const STEEP: [T::Wide; 2] = T::STEEP;

    fn from_f64(value: f64) -> Self {
        Self(T::from_f64(value))
    }

    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }

    fn wide(value: f64) -> T::Wide {
        T::wide(value)
    }

    fn add(a: Self, b: Self) -> Self {
        Self(T::add(a.0, b.0))
    }

    fn sub(a: Self, b: Self) -> Self {
        Self(T::sub(a.0, b.0))
    }

    fn scalar(wide: T::Wide) -> T::Scalar {
        T::scalar(wide)
    }

    fn narrow(scalar: T::Scalar) -> T::Wide {
        T::narrow(scalar)
    }

    fn of_lane(lane: Self) -> T::Scalar {
        T::of_lane(lane.0)
    }

    fn lane(scalar: T::Scalar) -> Self {
        let step = f64::from(STEPS) * format::<T>().step();
        Self(if SUMS { T::add(T::lane(scalar), T::from_f64(step)) } else { T::lane(scalar) })
    }

    fn level(scalar: T::Scalar) -> T::Level {
        let exact = scalar.exact();
        let unit = match format::<T>() {
            Format::I2F14 | Format::I16F16 => (1.0_f64 / 65_536.0).max(exact / f64::from(1 << 30)),
            Format::I2F30 => exact / f64::from(1 << 30),
            float => float.ulp(exact),
        };
        let off = if exact > 0.0 { T::Scalar::nearest(exact + f64::from(STEPS) * unit) } else { scalar };
        T::level(if STEPS == 0 { scalar } else { off })
    }

    fn of_level(level: T::Level) -> T::Scalar {
        T::of_level(level)
    }

    fn dot(a: [Self; 3], b: [Self; 3]) -> T::Wide {
        T::dot(bare(a), bare(b))
    }

    fn twice(a: T::Wide) -> T::Wide {
        T::twice(a)
    }

    fn diff(a: T::Wide, x: [Self; 3], b: T::Wide, y: [Self; 3]) -> [Self; 3] {
        let v = T::diff(a, bare(x), b, bare(y));
        if SUMS { off(v) } else { v.map(Self) }
    }

    fn magnify(v: [Self; 3]) -> ([Self; 3], u32) {
        let (v, exponent) = T::magnify(bare(v));
        (v.map(Self), exponent)
    }

    fn square(v: [Self; 3]) -> T::Wide {
        T::square(bare(v))
    }

    fn square_of(length: f64) -> T::Wide {
        T::square_of(length)
    }

    fn within(square: T::Wide, exponent: u32, limit: T::Wide) -> bool {
        T::within(square, exponent, limit)
    }

    fn rim(l: [Self; 3], versine: T::Wide, s: [Self; 3], square: T::Wide, length: T::Wide) -> [Self; 3] {
        off(T::rim(bare(l), versine, bare(s), square, length))
    }

    fn normalize(v: [Self; 3]) -> [Self; 3] {
        off(T::normalize(bare(v)))
    }

    fn halfway(n: [Self; 3], l: [Self; 3], v: [Self; 3], gain: T::Scalar, in_plane: bool) -> Halfway<T::Scalar> {
        T::halfway(bare(n), bare(l), bare(v), gain, in_plane)
    }
}

/// A float format whose roots and quotients are off by `PLACES` of their last places.
#[derive(Clone, Copy, Debug)]
pub struct Rough<T, const PLACES: u8>(pub T);

fn rough<T: Float + Real, const PLACES: u8>(value: T) -> Rough<T, PLACES> {
    let exact = Scalar::exact(value);
    let off = exact + f64::from(PLACES) * format::<T>().ulp(exact);
    Rough(if exact != 0.0 && exact.is_finite() && PLACES > 0 { T::nearest(off) } else { value })
}

const fn pair<T: Copy, const PLACES: u8>([a, b]: [T; 2]) -> [Rough<T, PLACES>; 2] {
    [Rough(a), Rough(b)]
}

impl<T: PartialEq, const PLACES: u8> PartialEq for Rough<T, PLACES> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl<T: PartialOrd, const PLACES: u8> PartialOrd for Rough<T, PLACES> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl<T: Add<Output = T>, const PLACES: u8> Add for Rough<T, PLACES> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl<T: Sub<Output = T>, const PLACES: u8> Sub for Rough<T, PLACES> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl<T: Mul<Output = T>, const PLACES: u8> Mul for Rough<T, PLACES> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl<T: Float + Real, const PLACES: u8> Div for Rough<T, PLACES> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        rough(self.0 / other.0)
    }
}

impl<T: Float + Real, const PLACES: u8> Scalar for Rough<T, PLACES> {
    const ZERO: Self = Self(<T as Scalar>::ZERO);
    const ONE: Self = Self(<T as Scalar>::ONE);
    const MAX: Self = Self(<T as Scalar>::MAX);
    const NEAR_ONE: Option<[sunglint::real::Constant; 2]> = T::NEAR_ONE;

    fn nearest(value: f64) -> Self {
        Self(T::nearest(value))
    }

    fn exact(self) -> f64 {
        Scalar::exact(self.0)
    }

    fn constant(constant: Constant) -> Self {
        Self(T::constant(constant))
    }

    fn root(self) -> Self {
        rough(self.0.root())
    }

    fn hypotenuse(a: Self, b: Self) -> Self {
        rough(T::hypotenuse(a.0, b.0))
    }

    fn from_q31(bits: u32) -> Self {
        Self(T::from_q31(bits))
    }

    fn to_q31(self) -> u32 {
        self.0.to_q31()
    }
}

impl<T: Float + Real, const PLACES: u8> Float for Rough<T, PLACES> {
    const FORMAT: &'static str = T::FORMAT;
    const STEEP: [Self; 2] = pair(<T as Float>::STEEP);
    const SCALE: Self = Self(T::SCALE);
    const TINY: Self = Self(T::TINY);
    const SAFE_SQUARE: [Self; 2] = pair(T::SAFE_SQUARE);
    const SPLITTER: Self = Self(T::SPLITTER);
    const PI: [Self; 2] = pair(T::PI);
    const TWICE_PI: [Self; 2] = pair(T::TWICE_PI);
    const INVERSE_PI: [Self; 2] = pair(T::INVERSE_PI);

    fn over_root(length: Self, square: Self) -> Self {
        rough(T::over_root(length.0, square.0))
    }
}
