//! Light normalisation: how bright must a light of a given size be?
//!
//! | quantity | formula | float formats | fixed point |
//! |---|---|---|---|
//! | versine | `w = x^2 / (1 + sqrt(1 - x^2))` | [`versine`] | [`versine_q30`], U16F48 |
//! | solid angle, sr | `2 pi w` | [`solid_angle`] | [`solid_angle_q30`], U16F48 |
//! | UsdLux sizeFactor, sr | 1, `pi x^2`, `pi (2 - sin^2)` | [`size_factor`] | [`size_factor_q30`], U16F48 |
//! | its reciprocal | | [`inverse_size_factor`] | [`inverse_size_factor_q30`], U52F12 |
//! | radiance | `intensity / sizeFactor` | [`radiance`] | [`radiance_q12`], U52F12 |
//! | small sphere's radiance | `E = (d/R)^2` | [`white_radiance`] | [`white_radiance_q30`], U52F12 |
//! | radius that looks like the Sun | `d` times the Sun's ratio | [`sun_radius_at`] | [`sun_radius_at_q16`], I16F16 |
//!
//! `x` is radius over distance. The functions here take it in the format and stay in the format's own arithmetic;
//! they cover lights up to half the sky. [`DistantLight`] has the same quantities in f64, also in constants, for
//! every angle up to 360 degrees and so with sizeFactor's third branch.
//!
//! Error, over every ratio that f32, f16 and I2F30 have (`tests/exhaustive.rs`; f64 against 192 bits in
//! `tests/normalization.rs`): at most 0.51 units in the last place in f64, f32 and micromath, 0.76 where the answer is
//! subnormal, and 0.8 in f16; 6 in f64 for a [`DistantLight`]; 0.51 units of the last place in fixed point, but 1 for
//! [`DistantLight::size_factor_q48`] and [`DistantLight::solid_angle_q48`], 2 for
//! [`DistantLight::inverse_size_factor_q12`]. The fixed-point formats have 64 bits because no 32-bit format covers
//! sizeFactor from `x = 1e-6` (3.1e-12) to 1 (pi): U16F48 is 0.06 % coarse at the small end, U52F12 0.08 % at the
//! other.

use core::f64::consts::PI;

use crate::light::{ASTRONOMICAL_UNIT_KM, DistantLight, LightError, SOLAR_RADIUS_KM};
use crate::pair::Pair;
use crate::real::{Float, Real};

/// The Sun's radius over its distance from Earth, from the figures of [`SUN`](crate::SUN).
const SUN_RATIO: f64 = SOLAR_RADIUS_KM / ASTRONOMICAL_UNIT_KM;

/// What that lacks of 6 957 000 / 1 495 978 707.
const SUN_RATIO_REST: f64 = -7.436082772989386e-19;

impl DistantLight {
    /// Solid angle in steradians: `2 pi w`, from 0 to `4 pi`. Within 6 units in the last place.
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// use sunglint::{DistantLight, SUN};
    ///
    /// assert!((SUN.solid_angle() - 6.7943e-5).abs() < 1e-9);
    /// assert_eq!(DistantLight::from_angle(360.0).unwrap().solid_angle(), 4.0 * PI);
    /// ```
    pub const fn solid_angle(&self) -> f64 {
        2.0 * PI * self.versine()
    }

    /// UsdLux `sizeFactor` in steradians: 1 for a point at infinity, `pi sin^2` up to half the sky, `pi (2 - sin^2)`
    /// beyond.
    ///
    /// Radiance times this is the illuminance of a plane that faces the light; beyond half the sky counting both
    /// sides of the plane. Within 6 units in the last place.
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// use sunglint::DistantLight;
    ///
    /// let of = |angle| DistantLight::from_angle(angle).unwrap().size_factor();
    /// // It jumps at 0, and goes on rising beyond half the sky.
    /// assert_eq!([of(0.0), of(180.0), of(360.0)], [1.0, PI, 2.0 * PI]);
    /// ```
    pub const fn size_factor(&self) -> f64 {
        let projected = PI * self.sin() * self.sin();
        // Not asked of the versine, which underflows before the sine is zero.
        if self.sin() == 0.0 && self.cos() > 0.0 {
            1.0
        } else if self.cos() >= 0.0 {
            projected
        } else {
            2.0 * PI - projected
        }
    }

    /// Radiance of a light that is normalised to give `intensity` as illuminance, whatever its size: `intensity /
    /// sizeFactor`.
    ///
    /// ```
    /// use sunglint::{LightError, SUN};
    ///
    /// // Noon: 100 000 lx from so small a disc take 1.47e9 cd/m^2.
    /// assert!((SUN.radiance(100_000.0).unwrap() / 1.4718e9 - 1.0).abs() < 1e-4);
    /// assert_eq!(SUN.radiance(-1.0), Err(LightError::Intensity(-1.0)));
    /// ```
    ///
    /// # Errors
    /// [`LightError::Intensity`] where `intensity` is negative, NaN or infinite; [`LightError::Overflow`] where the
    /// answer is infinite.
    pub const fn radiance(&self, intensity: f64) -> Result<f64, LightError> {
        if !(intensity >= 0.0 && intensity <= f64::MAX) {
            return Err(LightError::Intensity(intensity));
        }
        // A sizeFactor that has underflowed would make this 0 / 0.
        let radiance = if intensity == 0.0 { 0.0 } else { intensity / self.size_factor() };
        if radiance <= f64::MAX { Ok(radiance) } else { Err(LightError::Overflow("f64")) }
    }

    /// Radiance `E = (d/R)^2` with which a small sphere makes a white surface that faces it exactly white.
    ///
    /// ```
    /// use sunglint::{DistantLight, LightError, SUN};
    ///
    /// assert!((SUN.white_radiance().unwrap() - 46_238.8).abs() < 0.1);
    /// let point = DistantLight::from_ratio(0.0).unwrap();
    /// assert_eq!(point.white_radiance(), Err(LightError::Overflow("f64")));
    /// ```
    ///
    /// # Errors
    /// [`LightError::Overflow`] where that is infinite, as for a point.
    pub const fn white_radiance(&self) -> Result<f64, LightError> {
        let inverse = self.distance() / self.radius();
        let radiance = inverse * inverse;
        if radiance <= f64::MAX { Ok(radiance) } else { Err(LightError::Overflow("f64")) }
    }
}

/// `w = 1 - cos(theta) = x^2 / (1 + sqrt(1 - x^2))`, which nothing is subtracted in that cancels.
///
/// ```
/// use sunglint::normalization::versine;
///
/// assert_eq!(versine(1e-4_f32).unwrap(), 5e-9);
/// // Out of the cosine it is lost.
/// assert_eq!(1.0 - (1.0 - 1e-8_f32).sqrt(), 0.0);
/// ```
///
/// # Errors
/// [`LightError::Ratio`] where `ratio` is NaN or out of 0 to 1.
pub fn versine<T: Float>(ratio: T) -> Result<T, LightError> {
    let ratio = checked(ratio)?;
    Ok(versine_of(ratio, [T::WIDE_ONE, T::WIDE_ZERO]))
}

/// Solid angle `2 pi w` in steradians.
///
/// ```
/// use core::f32::consts::TAU;
/// use sunglint::LightError;
/// use sunglint::normalization::solid_angle;
///
/// assert_eq!(solid_angle(1.0), Ok(TAU)); // half the sky
/// assert_eq!(solid_angle(1.5_f32), Err(LightError::Ratio(1.5)));
/// ```
///
/// # Errors
/// [`LightError::Ratio`] where `ratio` is NaN or out of 0 to 1.
pub fn solid_angle<T: Float>(ratio: T) -> Result<T, LightError> {
    let ratio = checked(ratio)?;
    Ok(versine_of(ratio, T::TWICE_PI))
}

/// UsdLux `sizeFactor` of a sphere, in steradians: 1 for `x = 0`, else `pi x^2`.
///
/// ```
/// use core::f32::consts::PI;
/// use sunglint::normalization::size_factor;
///
/// assert_eq!(size_factor(1.0), Ok(PI));
/// // A point is not divided by its size.
/// assert_eq!(size_factor(0.0_f32), Ok(1.0));
/// ```
///
/// # Errors
/// [`LightError::Ratio`] where `ratio` is NaN or out of 0 to 1.
pub fn size_factor<T: Float>(ratio: T) -> Result<T, LightError> {
    let ratio = checked(ratio)?;
    if ratio == T::WIDE_ZERO {
        return Ok(T::WIDE_ONE);
    }
    let (square, scale) = scaled_square(ratio);
    Ok(square.times(Pair::constant(T::PI)).rounded() / (scale * scale))
}

/// `1 / sizeFactor`: 1 for `x = 0`, else `1 / (pi x^2)`.
///
/// ```
/// use sunglint::LightError;
/// use sunglint::half::f16;
/// use sunglint::normalization::inverse_size_factor;
///
/// assert_eq!(inverse_size_factor(0.05_f32), Ok(127.323_95));
/// assert_eq!(inverse_size_factor(f16::from_f32(0.002)), Err(LightError::Overflow("f16")));
/// ```
///
/// # Errors
/// [`LightError::Ratio`] where `ratio` is NaN or out of 0 to 1; [`LightError::Overflow`] where the answer is
/// infinite, in f16 up to `x = 2.203e-3`.
pub fn inverse_size_factor<T: Float>(ratio: T) -> Result<T, LightError> {
    let ratio = checked(ratio)?;
    if ratio == T::WIDE_ZERO {
        return Ok(T::WIDE_ONE);
    }
    inverse(Pair::constant(T::INVERSE_PI), T::WIDE_ONE, ratio)
}

/// Radiance of a sphere that is normalised to give `intensity` as illuminance: `intensity / (pi x^2)`; `intensity`
/// for `x = 0`.
///
/// Within the bound of the others for ratios from 1e-27 and all intensities in f32, for ratios from 1/2048 and
/// intensities from 0.001 in f16; below, squares and quotients lose digits.
///
/// ```
/// use sunglint::normalization::radiance;
///
/// // A lamp of ratio 0.05 that gives 500 lx: 63 662 cd/m^2.
/// assert!((radiance(500.0, 0.05_f32).unwrap() - 63_662.0).abs() < 0.1);
/// assert_eq!(radiance(500.0, 0.0_f32), Ok(500.0));
/// ```
///
/// # Errors
/// [`LightError::Ratio`] where `ratio` is NaN or out of 0 to 1; [`LightError::Intensity`] where `intensity` is
/// negative, NaN or infinite; [`LightError::Overflow`] where the answer is infinite, in f16 from 65 520 on.
pub fn radiance<T: Float>(intensity: T, ratio: T) -> Result<T, LightError> {
    let ratio = checked(ratio)?;
    let zero = T::WIDE_ZERO;
    let allowed = intensity >= zero && intensity <= T::MAX;
    if !allowed {
        return Err(LightError::Intensity(intensity.exact()));
    }
    if ratio == zero || intensity == zero {
        return Ok(intensity);
    }
    let lift = scale(intensity);
    inverse(Pair { high: intensity * lift, low: zero }.over(Pair::constant(T::PI)), lift, ratio)
}

/// Radiance `E = (d/R)^2` with which a small sphere makes a white surface that faces it exactly white.
///
/// ```
/// use sunglint::LightError;
/// use sunglint::half::f16;
/// use sunglint::normalization::white_radiance;
///
/// // The Sun fits into f16 as seen from Earth, not from Mars.
/// assert_eq!(white_radiance(f16::from_f32(4.650_47e-3)), Ok(f16::from_f32(46_240.0)));
/// assert_eq!(white_radiance(f16::from_f32(3.0521e-3)), Err(LightError::Overflow("f16")));
/// ```
///
/// # Errors
/// [`LightError::Ratio`] where `ratio` is NaN or out of 0 to 1; [`LightError::Overflow`] where the answer is
/// infinite: for 0, and in f16 up to 1/256.
pub fn white_radiance<T: Float>(ratio: T) -> Result<T, LightError> {
    let ratio = checked(ratio)?;
    if ratio == T::WIDE_ZERO {
        return Err(LightError::Overflow(T::FORMAT));
    }
    inverse(Pair::constant([T::WIDE_ONE, T::WIDE_ZERO]), T::WIDE_ONE, ratio)
}

/// Radius of a sphere at `distance` that looks as large as the Sun, in the distance's unit: `distance` times 695 700
/// / 149 597 870.7.
///
/// ```
/// use sunglint::normalization::sun_radius_at;
///
/// // A ball for a sun a kilometre away is 9.3 m across.
/// assert_eq!(sun_radius_at(1000.0_f32), Ok(4.650_467_4));
/// ```
///
/// # Errors
/// [`LightError::Distance`] where `distance` is not positive and finite.
pub fn sun_radius_at<T: Float>(distance: T) -> Result<T, LightError> {
    let zero = T::WIDE_ZERO;
    let allowed = distance > zero && distance <= T::MAX;
    if !allowed {
        return Err(LightError::Distance(distance.exact()));
    }
    let high = T::nearest(SUN_RATIO);
    let low = T::nearest((SUN_RATIO - high.exact()) + SUN_RATIO_REST);
    let scale = scale(distance);
    let scaled = distance * scale;
    let product = Pair::product(scaled, high);
    Ok((product.high + (product.low + scaled * low)) / scale)
}

/// A power of two by which a number is multiplied before products are taken: small ones, so that those have all their
/// digits, and great ones, since no factor may be next to the format's end.
fn scale<T: Float>(value: T) -> T {
    if value < T::TINY {
        T::WIDE_ONE / (T::TINY * T::TINY)
    } else if value > T::WIDE_ONE / T::TINY {
        T::TINY
    } else {
        T::WIDE_ONE
    }
}

/// `(s x)^2` and the scale `s`, which keeps the squares of small ratios from being subnormal.
fn scaled_square<T: Float>(ratio: T) -> (Pair<T>, T) {
    let scale = scale(ratio);
    (Pair::product(ratio * scale, ratio * scale), scale)
}

/// `factor w`.
fn versine_of<T: Float>(ratio: T, factor: [T; 2]) -> T {
    let (square, scale) = scaled_square(ratio);
    let cos = cosine(ratio);
    let one_plus_cos = Pair::sum(T::WIDE_ONE, cos.high);
    let divisor = Pair { high: one_plus_cos.high, low: one_plus_cos.low + cos.low };
    square.over(divisor).times(Pair::constant(factor)).rounded() / (scale * scale)
}

/// `sqrt((1 - x)(1 + x))`.
pub(crate) fn cosine<T: Float>(ratio: T) -> Pair<T> {
    let [zero, one] = [T::WIDE_ZERO, T::WIDE_ONE];
    Pair::sum(one, zero - ratio).times(Pair::sum(one, ratio)).root()
}

/// `dividend / lift / x^2`.
fn inverse<T: Float>(dividend: Pair<T>, lift: T, ratio: T) -> Result<T, LightError> {
    let (square, scale) = scaled_square(ratio);
    // Of the two, the quotient that is the nearer to 1.
    let before = if dividend.high < square.high { scale } else { T::WIDE_ONE };
    let quotient = dividend.scaled(before).over(square).rounded() * (scale / before) * (scale / lift);
    if quotient <= T::MAX { Ok(quotient) } else { Err(LightError::Overflow(T::FORMAT)) }
}

fn checked<T: Float>(ratio: T) -> Result<T, LightError> {
    let allowed = ratio >= T::WIDE_ZERO && ratio <= T::WIDE_ONE;
    if allowed { Ok(ratio) } else { Err(LightError::Ratio(ratio.exact())) }
}

#[cfg(feature = "fixed")]
mod fixed_point;
#[cfg(feature = "fixed")]
pub(crate) use fixed_point::Q60;
#[cfg(feature = "fixed")]
pub use fixed_point::{
    inverse_size_factor_q30, radiance_q12, size_factor_q30, solid_angle_q30, sun_radius_at_q16, versine_q30,
    white_radiance_q30,
};
