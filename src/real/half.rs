//! `half::f16`: every operation rounded to 11 bits, as the hardware does.

use half::f16;

use super::float::{INVERSE_PI, PI, TWICE_PI};
use super::{Constant, Float, STEEP_COSINE, Scalar};

/// [`Float::SCALE`], for constants.
pub(crate) const SQUARE_SCALE: f64 = 64.0;

const fn pair([value, low]: [f64; 2]) -> [f16; 2] {
    let high = nearest(value);
    [high, nearest((value - high.to_f64_const()) + low)]
}

impl Scalar for f16 {
    const ZERO: Self = f16::from_f32_const(0.0);

    const ONE: Self = f16::from_f32_const(1.0);

    const MAX: Self = f16::MAX;

    #[inline]
    fn nearest(value: f64) -> Self {
        nearest(value)
    }

    #[inline]
    fn exact(self) -> f64 {
        f64::from(self)
    }

    #[inline]
    fn constant(constant: Constant) -> Self {
        nearest(constant.value())
    }

    #[inline]
    fn root(self) -> Self {
        f16::from_f32(libm::sqrtf(f32::from(self)))
    }

    #[inline]
    fn from_q31(bits: u32) -> Self {
        f16::from_f32(f32::from_q31(bits))
    }

    #[inline]
    fn to_q31(self) -> u32 {
        f32::from(self).to_q31()
    }
}

impl Float for f16 {
    const FORMAT: &'static str = "f16";

    const STEEP: [Self; 2] = [nearest(-STEEP_COSINE), nearest(STEEP_COSINE)];

    // The Sun's x^2 = 2.2e-5 is below f16's smallest normal number, which hardware may flush to zero; (64 x)^2 is not.
    const SCALE: Self = nearest(SQUARE_SCALE);

    const TINY: Self = nearest(0.125);

    const SAFE_SQUARE: [Self; 2] = [nearest(0.0625), nearest(1024.0)];

    const SPLITTER: Self = nearest(65.0);

    const PI: [Self; 2] = pair(PI);

    const TWICE_PI: [Self; 2] = pair(TWICE_PI);

    const INVERSE_PI: [Self; 2] = pair(INVERSE_PI);

    #[inline]
    fn over_root(length: Self, square: Self) -> Self {
        length / square.root()
    }
}

/// The nearest f16, ties to even.
///
/// `f16::from_f64` rounds twice on hardware that has only f32 conversions, and its fallback drops low bits.
#[inline]
pub(crate) const fn nearest(value: f64) -> f16 {
    // Adding 1.5 * 2^28 leaves 2^-24 as the last bit, which is the step of f16's subnormals.
    const SUBNORMAL: f64 = 402_653_184.0;
    if value > -6.103515625e-5 && value < 6.103515625e-5 {
        return f16::from_f64_const((value + SUBNORMAL) - SUBNORMAL);
    }
    if value.is_nan() {
        return f16::NAN;
    }
    let bits = value.to_bits();
    let odd = (bits >> 42) & 1;
    // A mantissa that rounds up past its end carries into the exponent, as it should.
    let rounded = bits + ((1 << 41) - 1) + odd;
    f16::from_f64_const(f64::from_bits(rounded & !((1 << 42) - 1)))
}
