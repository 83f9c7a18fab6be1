//! Light normalisation in integers: ratios in I2F30, answers in 64 bits.

use fixed::types::{I2F30, I16F16, U16F48, U20F12, U52F12};

use super::SUN_RATIO;
use crate::constant;
use crate::light::{DistantLight, LightError};

/// Pi in Q61.
const PI_Q61: u128 = 0x6487_ED51_10B4_611A;

/// 1/pi in Q64.
const INVERSE_PI_Q64: u128 = 0x517C_C1B7_2722_0A95;

/// Sine, squared sine, cosine and versine of a sphere's angular radius in Q60.
pub(crate) struct Q60 {
    pub(crate) sin: u64,
    pub(crate) sin_square: u64,
    pub(crate) cos: u64,
    pub(crate) versine: u64,
}

impl Q60 {
    /// From radius over distance; the squared sine is exact, cosine and versine are within 0.75 of the last place.
    pub(crate) fn of(ratio: I2F30) -> Result<Self, LightError> {
        let bits = ratio.to_bits();
        if !(0..=1 << 30).contains(&bits) {
            return Err(LightError::RatioQ30(bits));
        }
        let ratio = bits as u64;
        let sin_square = ratio * ratio;
        // In Q62, so that two more bits are there to round.
        let cos = (u128::from((1 << 60) - sin_square) << 64).isqrt();
        let versine = quotient(u128::from(sin_square) << 62, (1_u128 << 62) + cos) as u64;
        Ok(Self { sin: ratio << 30, sin_square, cos: round(cos, 2), versine })
    }
}

/// `bits / 2^shift`, to nearest.
fn round(bits: u128, shift: u32) -> u64 {
    (bits.wrapping_add(1 << (shift - 1)) >> shift) as u64
}

/// `dividend / divisor`, to nearest; 0 for a divisor of 0.
fn quotient(dividend: u128, divisor: u128) -> u128 {
    dividend.saturating_add(divisor / 2).checked_div(divisor).unwrap_or(0)
}

fn q12(bits: u128) -> Result<U52F12, LightError> {
    u64::try_from(bits).map(U52F12::from_bits).map_err(|_| LightError::Overflow("U52F12"))
}

/// `w = 1 - cos(theta)` of a sphere of radius over distance `ratio`. Within 0.51 LSB (2^-48).
///
/// ```
/// use sunglint::fixed::types::I2F30;
/// use sunglint::normalization::versine_q30;
///
/// // 1 - 0.8, in Q48.
/// let versine = versine_q30(I2F30::lit("0.6")).unwrap();
/// assert!((versine.to_bits() as f64 / 2_f64.powi(48) - 0.2).abs() < 1e-9);
/// // At the Sun's ratio it keeps 32 bits.
/// assert_eq!(versine_q30(I2F30::from_bits(4_993_401)).unwrap().to_bits(), 3_043_724_165);
/// ```
///
/// # Errors
/// [`LightError::RatioQ30`] where `ratio` is out of 0 to 1.
pub fn versine_q30(ratio: I2F30) -> Result<U16F48, LightError> {
    Ok(U16F48::from_bits(round(Q60::of(ratio)?.versine.into(), 12)))
}

/// Solid angle `2 pi w` in steradians. Within 0.51 LSB (2^-48).
///
/// ```
/// use sunglint::SUN;
/// use sunglint::fixed::types::I2F30;
/// use sunglint::normalization::solid_angle_q30;
///
/// let sun = solid_angle_q30(I2F30::from_num(SUN.sin())).unwrap();
/// assert!((sun.to_num::<f64>() / SUN.solid_angle() - 1.0).abs() < 2e-7); // half a step of the ratio, twice
/// ```
///
/// # Errors
/// [`LightError::RatioQ30`] where `ratio` is out of 0 to 1.
pub fn solid_angle_q30(ratio: I2F30) -> Result<U16F48, LightError> {
    // Q60 times twice Q61, which is Q120 of 2 pi w.
    Ok(U16F48::from_bits(round(u128::from(Q60::of(ratio)?.versine) * PI_Q61, 72)))
}

/// UsdLux `sizeFactor` of a sphere, in steradians: 1 for 0, else `pi x^2`. Within 0.51 LSB (2^-48).
///
/// ```
/// use core::f64::consts::PI;
/// use sunglint::fixed::types::{I2F30, U16F48};
/// use sunglint::normalization::size_factor_q30;
///
/// assert_eq!(size_factor_q30(I2F30::ONE), Ok(U16F48::from_num(PI)));
/// assert_eq!(size_factor_q30(I2F30::ZERO), Ok(U16F48::ONE));
/// ```
///
/// # Errors
/// [`LightError::RatioQ30`] where `ratio` is out of 0 to 1.
pub fn size_factor_q30(ratio: I2F30) -> Result<U16F48, LightError> {
    let square = Q60::of(ratio)?.sin_square;
    Ok(if square == 0 { U16F48::ONE } else { U16F48::from_bits(round(u128::from(square) * PI_Q61, 73)) })
}

/// `1 / sizeFactor`: 1 for 0, else `1 / (pi x^2)`. Within 0.51 LSB (2^-12).
///
/// ```
/// use sunglint::LightError;
/// use sunglint::fixed::types::I2F30;
/// use sunglint::normalization::inverse_size_factor_q30;
///
/// // The Sun: radiance is 14 718 times the illuminance.
/// let inverse = inverse_size_factor_q30(I2F30::from_bits(4_993_401)).unwrap();
/// assert_eq!(inverse.to_num::<u64>(), 14_718);
/// assert_eq!(inverse_size_factor_q30(I2F30::from_bits(9)), Err(LightError::Overflow("U52F12")));
/// ```
///
/// # Errors
/// [`LightError::RatioQ30`] where `ratio` is out of 0 to 1; [`LightError::Overflow`] where the answer is `2^52` or
/// more, that is below `8.5e-9`.
pub fn inverse_size_factor_q30(ratio: I2F30) -> Result<U52F12, LightError> {
    let square = Q60::of(ratio)?.sin_square;
    // 1/pi in Q72 over a Q60 is Q12.
    if square == 0 { Ok(U52F12::ONE) } else { q12(quotient(INVERSE_PI_Q64 << 8, square.into())) }
}

/// Radiance of a light that is normalised to give `intensity` as illuminance: `intensity / size_factor`. Within 0.51
/// LSB (2^-12) of the quotient of its arguments. Takes sizeFactor so that it serves lights of every angle, see
/// [`DistantLight::size_factor_q48`].
///
/// ```
/// use sunglint::SUN;
/// use sunglint::fixed::types::{U16F48, U20F12};
/// use sunglint::normalization::radiance_q12;
///
/// const SIZE: U16F48 = SUN.size_factor_q48();
/// // 100 000 lx of sunlight, in cd/m^2.
/// let radiance = radiance_q12(U20F12::from_num(100_000), SIZE).unwrap();
/// assert_eq!(radiance.to_num::<u64>(), 1_471_827_606);
/// ```
///
/// # Errors
/// [`LightError::Overflow`] where the answer is `2^52` or more, or sizeFactor is 0.
pub fn radiance_q12(intensity: U20F12, size_factor: U16F48) -> Result<U52F12, LightError> {
    let divisor = u128::from(size_factor.to_bits());
    if divisor == 0 {
        return Err(LightError::Overflow("U52F12"));
    }
    q12(quotient(u128::from(intensity.to_bits()) << 48, divisor))
}

/// Radiance `E = (d/R)^2` with which a small sphere makes a white surface that faces it exactly white. Within 0.51 LSB
/// (2^-12).
///
/// ```
/// use sunglint::fixed::types::{I2F30, U52F12};
/// use sunglint::normalization::white_radiance_q30;
///
/// assert_eq!(white_radiance_q30(I2F30::lit("0.5")), Ok(U52F12::from_num(4)));
/// assert!(white_radiance_q30(I2F30::ZERO).is_err());
/// ```
///
/// # Errors
/// [`LightError::RatioQ30`] where `ratio` is out of 0 to 1; [`LightError::Overflow`] where the answer is `2^52` or
/// more, that is below `1.5e-8`.
pub fn white_radiance_q30(ratio: I2F30) -> Result<U52F12, LightError> {
    let square = Q60::of(ratio)?.sin_square;
    if square == 0 { Err(LightError::Overflow("U52F12")) } else { q12(quotient(1 << 72, square.into())) }
}

/// Radius of a sphere at `distance` that looks as large as the Sun, in the distance's unit. Within 0.51 LSB (2^-16).
///
/// ```
/// use sunglint::LightError;
/// use sunglint::fixed::types::I16F16;
/// use sunglint::normalization::sun_radius_at_q16;
///
/// // 4.6505 m at a kilometre.
/// assert_eq!(sun_radius_at_q16(I16F16::from_num(1000)), Ok(I16F16::from_bits(304_773)));
/// assert_eq!(sun_radius_at_q16(I16F16::ZERO), Err(LightError::DistanceBits(0)));
/// ```
///
/// # Errors
/// [`LightError::DistanceBits`] where `distance` is not positive.
pub fn sun_radius_at_q16(distance: I16F16) -> Result<I16F16, LightError> {
    const RATIO_Q38: i64 = constant::to_fixed(SUN_RATIO, 38);
    let bits = distance.to_bits();
    if bits <= 0 {
        return Err(LightError::DistanceBits(bits));
    }
    Ok(I16F16::from_bits(((i64::from(bits) * RATIO_Q38 + (1 << 37)) >> 38) as i32))
}

impl DistantLight {
    /// [`DistantLight::size_factor`] rounded to U16F48, for all angles, in constants too. Within 1 LSB (2^-48).
    ///
    /// ```
    /// use sunglint::SUN;
    /// use sunglint::fixed::types::U16F48;
    ///
    /// const SUN_SIZE: U16F48 = SUN.size_factor_q48();
    /// assert_eq!(SUN_SIZE.to_bits(), 19_124_181_079); // 6.7943e-5 sr
    /// ```
    pub const fn size_factor_q48(&self) -> U16F48 {
        U16F48::from_bits(constant::to_fixed(self.size_factor(), 48) as u64)
    }

    /// [`DistantLight::solid_angle`] rounded to U16F48, for all angles, in constants too. Within 1 LSB (2^-48).
    ///
    /// ```
    /// use sunglint::{DistantLight, SUN};
    ///
    /// // A disc is but little more than its projection: 5 parts in a million for the Sun.
    /// assert_eq!(SUN.solid_angle_q48().to_bits() - SUN.size_factor_q48().to_bits(), 103_400);
    /// // All of the sky is 4 pi.
    /// assert_eq!(DistantLight::from_angle(360.0).unwrap().solid_angle_q48().to_num::<f32>(), 12.566_371);
    /// ```
    pub const fn solid_angle_q48(&self) -> U16F48 {
        U16F48::from_bits(constant::to_fixed(self.solid_angle(), 48) as u64)
    }

    /// 1 over [`DistantLight::size_factor`] rounded to U52F12, for all angles, in constants too. Within 2 LSB (2^-12)
    /// from 1e-4 degrees, where f64 has hardly more digits.
    ///
    /// ```
    /// use sunglint::{DistantLight, LightError, SUN};
    ///
    /// assert_eq!(SUN.inverse_size_factor_q12().unwrap().to_num::<f32>(), 14_718.276);
    /// // A ten millionth of a degree is too small.
    /// let star = DistantLight::from_angle(1e-7).unwrap();
    /// assert_eq!(star.inverse_size_factor_q12(), Err(LightError::Overflow("U52F12")));
    /// ```
    ///
    /// # Errors
    /// [`LightError::Overflow`] where that is `2^51` or more.
    pub const fn inverse_size_factor_q12(&self) -> Result<U52F12, LightError> {
        let bits = constant::to_fixed(1.0 / self.size_factor(), 12);
        if bits == i64::MAX { Err(LightError::Overflow("U52F12")) } else { Ok(U52F12::from_bits(bits as u64)) }
    }
}
