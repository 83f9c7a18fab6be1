//! f64 arithmetic that runs at compile time, so that a light given by literals is a constant.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Degrees to radians.
const RADIANS: f64 = PI / 180.0;

/// Pi/2 less its nearest f64.
const FRAC_PI_2_LOW: f64 = 6.123_233_995_736_766e-17;

/// The square root, correctly rounded, of a positive normal number; 0 for anything else.
pub(crate) const fn sqrt(x: f64) -> f64 {
    if !(x >= f64::MIN_POSITIVE && x <= f64::MAX) {
        return 0.0;
    }
    let bits = x.to_bits();
    let exponent = (bits >> 52) as i64 - 1023;
    let odd = exponent & 1;
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    // 54 bits of root: the last one says which way to round. It is never a tie, since no odd number's square is
    // divisible by 2^54.
    let root = ((mantissa as u128) << (54 + odd)).isqrt() as u64;
    let scale = f64::from_bits(((exponent - odd) / 2 + 1023 - 52) as u64 * (1 << 52));
    root.div_ceil(2) as f64 * scale
}

/// Sine of an angle in degrees from 0 to 180; zero at both ends.
pub(crate) const fn sin_degrees(angle: f64) -> f64 {
    // Folding in degrees is exact.
    let acute = if angle > 90.0 { 180.0 - angle } else { angle };
    if acute > 45.0 { cos_octant((90.0 - acute) * RADIANS) } else { sin_octant(acute * RADIANS) }
}

/// Cosine of an angle in degrees from 0 to 180; zero at 90.
pub(crate) const fn cos_degrees(angle: f64) -> f64 {
    let folded = if angle > 90.0 { angle - 90.0 } else { 90.0 - angle };
    let cos = sin_degrees(folded);
    if angle > 90.0 { -cos } else { cos }
}

/// Sine of an angle in radians from 0 to pi.
pub(crate) const fn sin(angle: f64) -> f64 {
    // What is left of the angle once the f64 nearest to pi/2, and what that one lacks, are taken off.
    let rest = (angle - FRAC_PI_2) - FRAC_PI_2_LOW;
    if rest < -FRAC_PI_4 {
        sin_octant(angle)
    } else if rest <= FRAC_PI_4 {
        cos_octant(rest)
    } else {
        sin_octant((PI - angle) + 2.0 * FRAC_PI_2_LOW)
    }
}

/// Cosine of an angle in radians from 0 to pi.
pub(crate) const fn cos(angle: f64) -> f64 {
    let rest = (angle - FRAC_PI_2) - FRAC_PI_2_LOW;
    if rest < -FRAC_PI_4 {
        cos_octant(angle)
    } else if rest <= FRAC_PI_4 {
        -sin_octant(rest)
    } else {
        -cos_octant(PI - angle)
    }
}

/// Sine for 0 to pi/4 by its series; the first term left out is below 1e-19 of the sum.
const fn sin_octant(t: f64) -> f64 {
    let u = t * t;
    let tail = 1.0 - u / 272.0 * (1.0 - u / 342.0);
    let tail = 1.0 - u / 110.0 * (1.0 - u / 156.0 * (1.0 - u / 210.0 * tail));
    t - t * (u / 6.0 * (1.0 - u / 20.0 * (1.0 - u / 42.0 * (1.0 - u / 72.0 * tail))))
}

/// Cosine for 0 to pi/4 by its series; the first term left out is below 1e-19.
const fn cos_octant(t: f64) -> f64 {
    let u = t * t;
    let tail = 1.0 - u / 182.0 * (1.0 - u / 240.0 * (1.0 - u / 306.0));
    let tail = 1.0 - u / 56.0 * (1.0 - u / 90.0 * (1.0 - u / 132.0 * tail));
    1.0 - u / 2.0 * (1.0 - u / 12.0 * (1.0 - u / 30.0 * tail))
}

/// The nearest multiple of `2^-fraction` as an integer, halves upwards; saturates at 63 bits.
#[cfg(feature = "fixed")]
pub(crate) const fn to_fixed(value: f64, fraction: u32) -> i64 {
    let scaled = value * (1_u64 << fraction) as f64;
    let whole = scaled as i64;
    // `as` cuts towards zero, so the remainder has the sign of the value.
    let rest = scaled - whole as f64;
    whole.saturating_add((rest >= 0.5) as i64 - (rest < -0.5) as i64)
}

#[cfg(test)]
mod tests {
    use super::{cos, cos_degrees, sin, sin_degrees, sqrt, to_fixed};

    #[test]
    fn root_is_correctly_rounded() {
        let mut x = 1e-300_f64;
        while x < 1e300 {
            assert_eq!(sqrt(x), x.sqrt(), "{x}");
            x *= 1.37;
        }
        assert_eq!([sqrt(0.0), sqrt(-1.0), sqrt(f64::NAN), sqrt(1.0)], [0.0, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn sine_and_cosine_are_within_two_last_places() {
        for step in 0..=180_000 {
            let degrees = f64::from(step) / 1000.0;
            let radians = degrees * core::f64::consts::PI / 180.0;
            // Three roundings of the argument in radians cost the absolute part; tests/light.rs has the tight bound.
            let allowed = |truth: f64| 2.0 * f64::EPSILON * truth.abs() + 7e-16;
            assert!((sin(radians) - radians.sin()).abs() <= 2.0 * f64::EPSILON * radians.sin(), "{degrees}");
            assert!((cos(radians) - radians.cos()).abs() <= 2.0 * f64::EPSILON * radians.cos().abs(), "{degrees}");
            assert!((sin_degrees(degrees) - radians.sin()).abs() <= allowed(radians.sin()), "{degrees}");
            assert!((cos_degrees(degrees) - radians.cos()).abs() <= allowed(radians.cos()), "{degrees}");
        }
        assert_eq!([sin_degrees(180.0), cos_degrees(90.0), cos_degrees(180.0)], [0.0, 0.0, -1.0]);
    }

    #[test]
    fn fixed_rounds_to_nearest_and_saturates() {
        assert_eq!([to_fixed(0.3, 2), to_fixed(0.375, 2), to_fixed(-0.3, 2)], [1, 2, -1]);
        assert_eq!([to_fixed(1e30, 60), to_fixed(-1e30, 60), to_fixed(f64::NAN, 60)], [i64::MAX, i64::MIN, 0]);
    }
}
