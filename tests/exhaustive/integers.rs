//! Errors of 64-bit answers, in their last places, to six digits and more: the residual of the defining equation is
//! exact in 128 bits, and f64 only divides it.

/// Ratio bits of 1.
const ONE: u64 = 1 << 30;

/// Pi in Q66, cut.
const PI_Q66: u128 = 0xc_90fd_aa22_168c_234c;

/// Twice pi in Q72, cut.
const TWICE_PI_Q72: u128 = 0x648_7ed5_110b_4611_a626;

/// `2^122 / pi`, cut.
const INVERSE_PI_Q122: u128 = 0x145_f306_dc9c_882a_53f8_4eaf_a3ea_69bb;

fn power(exponent: u32) -> f64 {
    f64::from_bits(u64::from(1023 + exponent) << 52)
}

/// `sqrt(1 - x^2)`.
fn cosine(ratio: u64) -> f64 {
    (((ONE * ONE) - ratio * ratio) as f64).sqrt() / power(30)
}

/// `numerator / 2^120 / sum` in units of `2^-fraction`; zero for `0 / 0`.
fn quotient(numerator: i128, sum: f64, fraction: u32) -> f64 {
    if numerator == 0 { 0.0 } else { numerator as f64 / power(120 - fraction) / sum }
}

/// `w (2 - w) = x^2`, hence `(true - w) (cos + (1 - w)) = x^2 - w (2 - w)`.
pub fn versine(ratio: u64, answer: u64, fraction: u32) -> f64 {
    let one = 1_i128 << fraction;
    let answer = i128::from(answer);
    let residual = (i128::from(ratio * ratio) << 60) - ((answer * (2 * one - answer)) << (120 - 2 * fraction));
    quotient(residual, cosine(ratio) + (one - answer) as f64 / power(fraction), fraction)
}

/// `(true - c) (true + c) = 1 - x^2 - c^2`.
pub fn cos(ratio: u64, answer: u64, fraction: u32) -> f64 {
    let square = (i128::from(answer) * i128::from(answer)) << (120 - 2 * fraction);
    let residual = (i128::from(ONE * ONE - ratio * ratio) << 60) - square;
    quotient(residual, cosine(ratio) + answer as f64 / power(fraction), fraction)
}

/// A number of Q60 against an answer of fewer bits.
pub fn rounded(exact: u64, answer: u64, fraction: u32) -> f64 {
    (i128::from(exact) - (i128::from(answer) << (60 - fraction))) as f64 / power(60 - fraction)
}

/// `2 pi w` in Q48, of a versine that is put right by its own residual.
pub fn solid_angle(ratio: u64, answer: u64) -> f64 {
    let sin = ratio as f64 / power(30);
    let near = (sin * sin / (1.0 + cosine(ratio)) * power(48)) as u64;
    let whole = (TWICE_PI_Q72 * u128::from(near)).wrapping_sub(u128::from(answer) << 72) as i128;
    whole as f64 / power(72) + 2.0 * std::f64::consts::PI * versine(ratio, near, 48)
}

/// `pi x^2` in Q48.
pub fn size_factor(ratio: u64, answer: u64) -> f64 {
    let residual = (PI_Q66 * u128::from(ratio * ratio)).wrapping_sub(u128::from(answer) << 78) as i128;
    residual as f64 / power(78)
}

/// `1 / (pi x^2)` in Q12.
pub fn inverse_size_factor(ratio: u64, answer: u64) -> f64 {
    let square = ratio * ratio;
    let residual = INVERSE_PI_Q122.wrapping_sub((u128::from(answer) * u128::from(square)) << 50) as i128;
    residual as f64 / power(50) / square as f64
}

/// `1 / x^2` in Q12.
pub fn white_radiance(ratio: u64, answer: u64) -> f64 {
    let square = u128::from(ratio * ratio);
    let residual = (1_u128 << 72).wrapping_sub(u128::from(answer) * square) as i128;
    residual as f64 / square as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{big, fixed, pi};

    #[test]
    fn constants_are_pi_cut() {
        let cut = |bits: u128, fraction: u32, exact: crate::exact::Big| {
            let below = (exact - fixed(bits as i128, fraction)) << fraction as isize;
            assert!((0.0..1.0).contains(&below.to_f64().value()));
        };
        cut(PI_Q66, 66, pi());
        cut(TWICE_PI_Q72, 72, big(2.0) * pi());
        cut(INVERSE_PI_Q122, 122, big(1.0) / pi());
    }
}
