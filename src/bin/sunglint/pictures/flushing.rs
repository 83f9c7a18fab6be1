//! f16 on hardware that flushes subnormals to zero.

use std::num::FpCategory;
use std::ops::{Add, Div, Mul, Sub};

use half::f16;
use sunglint::real::Constant;
use sunglint::{Float, Scalar};

/// f16 whose every operation flushes subnormal arguments and results; `SCALED` with this crate's scale for squares.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Flushing<const SCALED: bool>(f16);

fn flush<const SCALED: bool>(value: f16) -> Flushing<SCALED> {
    Flushing(if value.classify() == FpCategory::Subnormal { f16::ZERO } else { value })
}

const fn pair<const SCALED: bool>([a, b]: [f16; 2]) -> [Flushing<SCALED>; 2] {
    [Flushing(a), Flushing(b)]
}

impl<const SCALED: bool> Add for Flushing<SCALED> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        flush(self.0 + other.0)
    }
}

impl<const SCALED: bool> Sub for Flushing<SCALED> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        flush(self.0 - other.0)
    }
}

impl<const SCALED: bool> Mul for Flushing<SCALED> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        flush(self.0 * other.0)
    }
}

impl<const SCALED: bool> Div for Flushing<SCALED> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        flush(self.0 / other.0)
    }
}

impl<const SCALED: bool> Scalar for Flushing<SCALED> {
    const ZERO: Self = Self(<f16 as Scalar>::ZERO);
    const ONE: Self = Self(<f16 as Scalar>::ONE);
    const MAX: Self = Self(<f16 as Scalar>::MAX);
    const NEAR_ONE: Option<[Constant; 2]> = f16::NEAR_ONE;

    fn nearest(value: f64) -> Self {
        flush(f16::nearest(value))
    }

    fn exact(self) -> f64 {
        self.0.exact()
    }

    fn constant(constant: Constant) -> Self {
        Self::nearest(constant.value())
    }

    fn root(self) -> Self {
        flush(self.0.root())
    }

    fn from_q31(bits: u32) -> Self {
        flush(f16::from_q31(bits))
    }

    fn to_q31(self) -> u32 {
        self.0.to_q31()
    }
}

impl<const SCALED: bool> Float for Flushing<SCALED> {
    const FORMAT: &'static str = "flushing f16";
    const STEEP: [Self; 2] = pair(<f16 as Float>::STEEP);
    const SCALE: Self = Self(if SCALED { <f16 as Float>::SCALE } else { <f16 as Scalar>::ONE });
    const TINY: Self = Self(if SCALED { <f16 as Float>::TINY } else { <f16 as Scalar>::ONE });
    const SAFE_SQUARE: [Self; 2] = pair(<f16 as Float>::SAFE_SQUARE);
    const SPLITTER: Self = Self(<f16 as Float>::SPLITTER);
    const PI: [Self; 2] = pair(<f16 as Float>::PI);
    const TWICE_PI: [Self; 2] = pair(<f16 as Float>::TWICE_PI);
    const INVERSE_PI: [Self; 2] = pair(<f16 as Float>::INVERSE_PI);

    fn over_root(length: Self, square: Self) -> Self {
        flush(f16::over_root(length.0, square.0))
    }
}
