//! `micromath::F32`: single precision whose root is a bit trick and two Newton steps.

use micromath::F32;

use super::Float;

impl Float for F32 {
    const FORMAT: &'static str = "micromath";

    const ZERO: Self = F32(0.0);

    const ONE: Self = F32(1.0);

    const MAX: Self = F32::MAX;

    const STEEP: [Self; 2] = [F32(-0.714), F32(0.714)];

    const SPLITTER: f64 = 4097.0;

    #[inline]
    fn nearest(value: f64) -> Self {
        F32(value as f32)
    }

    #[inline]
    fn exact(self) -> f64 {
        f64::from(self.0)
    }

    #[inline]
    fn over_root(length: Self, square: Self) -> Self {
        length * reciprocal_root(square)
    }

    #[inline]
    fn root(self) -> Self {
        self * reciprocal_root(self)
    }
}

/// `invsqrt` alone is up to 3.4 % off; two Newton steps bring that under 6e-6 without a division.
#[inline]
fn reciprocal_root(square: F32) -> F32 {
    // A NaN with its sign set makes invsqrt overflow its integer subtraction.
    let positive = F32(f32::from_bits(square.0.to_bits() & 0x7fff_ffff));
    let half = positive * F32(0.5);
    let step = |y: F32| y * (F32(1.5) - half * y * y);
    step(step(positive.invsqrt()))
}
