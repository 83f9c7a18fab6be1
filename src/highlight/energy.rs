//! How bright is a highlight that has been widened to the size of the light? Factors that keep its energy.
//!
//! `alpha` is the GGX width (perceptual roughness squared), `x` radius over distance, `theta` the angular radius.

use core::f64::consts::FRAC_PI_2;

use crate::light::LightError;
use crate::real::{Float, Real};

/// Karis's factor `(alpha / alpha')^2` with `alpha' = sat(alpha + x / 2)`; 1 for `alpha = x = 0`.
///
/// The quotient is squared, not the widths: alpha squared is zero in narrow formats. Within 4 ULP in the float formats
/// (`tests/highlight.rs`). In f16 answers below 6e-5 are subnormal.
///
/// # Errors
/// [`LightError::Alpha`] and [`LightError::Ratio`] where an argument is NaN or out of 0 to 1.
///
/// ```
/// use sunglint::LightError;
/// use sunglint::highlight::karis;
///
/// // The Sun widens the highlight of a varnish of alpha 0.01 by a quarter, so that a third of its peak has to go.
/// assert!((karis(0.01_f32, 0.00465)? - 0.6583).abs() < 1e-4);
/// assert_eq!(karis(0.5_f32, 0.0)?, 1.0);
/// assert_eq!(karis(0.5_f32, 1.5), Err(LightError::Ratio(1.5)));
/// # Ok::<(), LightError>(())
/// ```
pub fn karis<T: Float>(alpha: T, ratio: T) -> Result<T, LightError> {
    let alpha = checked(alpha)?;
    let allowed = ratio >= T::WIDE_ZERO && ratio <= T::WIDE_ONE;
    if !allowed {
        return Err(LightError::Ratio(ratio.exact()));
    }
    // Twice the widths, since half of a small ratio may have digits that f16 cannot hold.
    let (width, two) = (alpha + alpha, T::WIDE_ONE + T::WIDE_ONE);
    let sum = width + ratio;
    let widened = if sum > two { two } else { sum };
    if widened == T::WIDE_ZERO {
        return Ok(T::WIDE_ONE);
    }
    let quotient = width / widened;
    Ok(quotient * quotient)
}

/// The exact small-angle energy of the representative point's highlight, inverted: `1 / (1 + (pi/2) t + t^2)` with
/// `t = theta / (2 alpha)`; 1 for `theta = 0`, else 0 for `alpha = 0`.
///
/// Within 4 ULP in the float formats (`tests/highlight.rs`). In f16 answers below 6e-5 are subnormal.
///
/// # Errors
/// [`LightError::Alpha`] where `alpha` is NaN or out of 0 to 1; [`LightError::SphereAngularRadius`] where `theta` is
/// NaN or out of 0 to pi/2.
///
/// ```
/// use sunglint::LightError;
/// use sunglint::half::f16;
/// use sunglint::highlight::exact_rp;
///
/// // t = 1: 1 / (2 + pi/2).
/// let [alpha, theta] = [0.125, 0.25].map(f16::from_f32);
/// assert!((exact_rp(alpha, theta)?.to_f32() - 0.280_05).abs() < 5e-4);
/// assert_eq!(exact_rp(alpha, f16::NEG_ONE), Err(LightError::SphereAngularRadius(-1.0)));
/// # Ok::<(), LightError>(())
/// ```
pub fn exact_rp<T: Float>(alpha: T, theta: T) -> Result<T, LightError> {
    let (zero, one, right) = (T::WIDE_ZERO, T::WIDE_ONE, T::nearest(FRAC_PI_2));
    let alpha = checked(alpha)?;
    if !(theta >= zero && theta <= right) {
        return Err(LightError::SphereAngularRadius(theta.exact()));
    }
    if theta == zero {
        return Ok(one);
    }
    let width = alpha + alpha;
    // Of t and 1 / t the one that is at most 1, so that no square overflows.
    if theta <= width {
        let t = theta / width;
        Ok(one / (one + t * (right + t)))
    } else {
        let inverse = width / theta;
        Ok(inverse * (inverse / (one + inverse * (right + inverse))))
    }
}

fn checked<T: Float>(alpha: T) -> Result<T, LightError> {
    let allowed = alpha >= T::WIDE_ZERO && alpha <= T::WIDE_ONE;
    if allowed { Ok(alpha) } else { Err(LightError::Alpha(alpha.exact())) }
}

#[cfg(feature = "fixed")]
pub use fixed_point::{exact_rp_q30, karis_q30};

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::types::I2F30;

    use super::LightError;

    /// Pi in Q29.
    const PI_Q29: u128 = 1_686_629_713;

    /// [`karis`](super::karis) in integers, I2F30 in and out. Within 0.5 LSB.
    ///
    /// # Errors
    /// [`LightError::AlphaQ30`] and [`LightError::RatioQ30`] where an argument is out of 0 to 1.
    ///
    /// ```
    /// use sunglint::LightError;
    /// use sunglint::fixed::types::I2F30;
    /// use sunglint::highlight::karis_q30;
    ///
    /// // (alpha / (alpha + x/2))^2 of two numbers that binary has: (1/4 / (1/4 + 1/4))^2.
    /// let (alpha, ratio) = (I2F30::from_num(0.25), I2F30::from_num(0.5));
    /// assert_eq!(karis_q30(alpha, ratio), Ok(I2F30::from_num(0.25)));
    /// assert_eq!(karis_q30(alpha, -ratio), Err(LightError::RatioQ30(-(1 << 29))));
    /// ```
    pub fn karis_q30(alpha: I2F30, ratio: I2F30) -> Result<I2F30, LightError> {
        let alpha = unit(alpha).map_err(LightError::AlphaQ30)?;
        let ratio = unit(ratio).map_err(LightError::RatioQ30)?;
        // In Q31, so that half of the ratio is exact.
        let widened = (2 * alpha + ratio).min(1 << 31);
        Ok(fraction(4 * alpha * alpha, widened * widened))
    }

    /// [`exact_rp`](super::exact_rp) in integers, I2F30 in and out. Within 0.52 LSB.
    ///
    /// # Errors
    /// [`LightError::AlphaQ30`] where `alpha` is out of 0 to 1, [`LightError::AngularRadiusQ30`] where `theta` is
    /// negative or above pi/2.
    ///
    /// ```
    /// use sunglint::LightError;
    /// use sunglint::fixed::types::I2F30;
    /// use sunglint::highlight::exact_rp_q30;
    ///
    /// let (alpha, theta) = (I2F30::from_num(0.125), I2F30::from_num(0.25));
    /// let factor: f64 = exact_rp_q30(alpha, theta)?.to_num();
    /// assert!((factor - 1.0 / (2.0 + core::f64::consts::FRAC_PI_2)).abs() < 1e-9);
    /// assert_eq!(exact_rp_q30(alpha, I2F30::MAX), Err(LightError::AngularRadiusQ30(i32::MAX)));
    /// # Ok::<(), LightError>(())
    /// ```
    pub fn exact_rp_q30(alpha: I2F30, theta: I2F30) -> Result<I2F30, LightError> {
        let alpha = unit(alpha).map_err(LightError::AlphaQ30)?;
        let theta = match u128::try_from(theta.to_bits()) {
            Ok(theta) if theta <= PI_Q29 => theta,
            _ => return Err(LightError::AngularRadiusQ30(theta.to_bits())),
        };
        // Both sides of the fraction times 4 alpha^2, so that t, which may be in the hundreds, is never formed.
        let energy = 4 * alpha * alpha;
        Ok(fraction(energy << 29, (energy << 29) + PI_Q29 * alpha * theta + ((theta * theta) << 29)))
    }

    fn unit(value: I2F30) -> Result<u128, i32> {
        match value.to_bits() {
            bits @ 0..=0x4000_0000 => Ok(bits as u128),
            bits => Err(bits),
        }
    }

    /// `part / whole` in Q30, to nearest; 1 for 0 / 0.
    fn fraction(part: u128, whole: u128) -> I2F30 {
        let bits = ((part << 30) + whole / 2).checked_div(whole).unwrap_or(1 << 30);
        I2F30::from_bits(bits as i32)
    }
}
