//! The crate `cordic`.

use fixed::types::{I3F29, I16F16};

/// The square root. Never returns from 16384 on: it looks for a power of two whose square is greater, and that
/// overflows.
pub fn root(square: &I16F16) -> I16F16 {
    cordic::sqrt(*square)
}

/// Sine and cosine of an angle in radians.
pub fn sin_cos(angle: &I3F29) -> [I3F29; 2] {
    let (sine, cosine) = cordic::sin_cos(*angle);
    [sine, cosine]
}
