//! f16 on hardware that flushes subnormals to zero, as many phones' GPUs do. A format of the presets' own: those of
//! `trial::emulated` are of any width and slower.

use std::num::FpCategory;
use std::ops::{Add, Div, Mul, Sub};

use sunglint::half::f16;
use sunglint::real::Constant;
use sunglint::{Float, Scalar};

/// f16 whose every operation flushes subnormal results.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Flushing(f16);

fn flush(value: f16) -> Flushing {
    Flushing(if value.classify() == FpCategory::Subnormal { f16::ZERO } else { value })
}

const fn pair([a, b]: [f16; 2]) -> [Flushing; 2] {
    [Flushing(a), Flushing(b)]
}

impl Add for Flushing {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        flush(self.0 + other.0)
    }
}

impl Sub for Flushing {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        flush(self.0 - other.0)
    }
}

impl Mul for Flushing {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        flush(self.0 * other.0)
    }
}

impl Div for Flushing {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        flush(self.0 / other.0)
    }
}

impl Scalar for Flushing {
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

impl Float for Flushing {
    const FORMAT: &'static str = "flushing f16";
    const STEEP: [Self; 2] = pair(<f16 as Float>::STEEP);
    const SCALE: Self = Self(<f16 as Float>::SCALE);
    const TINY: Self = Self(<f16 as Float>::TINY);
    const SAFE_SQUARE: [Self; 2] = pair(<f16 as Float>::SAFE_SQUARE);
    const SPLITTER: Self = Self(<f16 as Float>::SPLITTER);
    const PI: [Self; 2] = pair(<f16 as Float>::PI);
    const TWICE_PI: [Self; 2] = pair(<f16 as Float>::TWICE_PI);
    const INVERSE_PI: [Self; 2] = pair(<f16 as Float>::INVERSE_PI);

    fn over_root(length: Self, square: Self) -> Self {
        flush(f16::over_root(length.0, square.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subnormals_are_flushed_and_normal_numbers_are_not() {
        let least = 1.0 / 16384.0;
        assert_eq!([least, least * 0.999, 1e-6].map(|value| Flushing::nearest(value).exact()), [least, 0.0, 0.0]);
        let small = Flushing::nearest(0.004);
        assert_eq!(((small * small).exact(), (small + small).exact()), (0.0, 2.0 * small.exact()));
    }
}
