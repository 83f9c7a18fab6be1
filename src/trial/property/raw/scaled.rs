//! [`Scaled`] from any bits and exponents, and back, against integers of 128 bits.

use crate::real::{Real, Scalar, Scaled};
use crate::trial::draw::Draw;
use crate::trial::format::Format;
use crate::trial::property::{Broken, Case};
use fixed::types::{I2F14, I2F30, I16F16};

/// Reads a case and says what it breaks.
pub(super) fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let bits = draw.bits() as i64 >> (draw.byte() % 64);
    let bits = draw.one_of([bits, bits, bits, i64::MIN, i64::MAX, -1, 1 << 31, (1 << 62) - 1]);
    let exponent = draw.bits() as i32 >> (draw.byte() % 32);
    let fraction = u32::from(draw.byte() % 64);
    let numbers = [bits as f64, exponent.into(), fraction.into(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let case = Case { format: Format::I2F30, inputs: numbers };
    construction(&case, bits, exponent)?;
    arithmetic(&case, draw, Scaled::from_bits(bits, exponent))?;
    // What the exponent leaves within 128 bits.
    let exponent = exponent % 64;
    integers(&case, bits, exponent, fraction)
}

/// To nearest, and of a normal mantissa.
fn construction(case: &Case, bits: i64, exponent: i32) -> Result<(), Broken> {
    let unsigned = bits.unsigned_abs();
    for (number, bits) in [
        (Scaled::from_bits(bits, exponent), i128::from(bits)),
        (Scaled::from_unsigned(unsigned, exponent), unsigned.into()),
    ] {
        let (mantissa, scale) = number.parts();
        if bits == 0 {
            case.holds("zero is zero", mantissa == 0 && number == Scaled::ZERO)?;
            continue;
        }
        case.holds("a mantissa is normal", (1 << 30..1_u32 << 31).contains(&mantissa.unsigned_abs()))?;
        let places = scale.wrapping_sub(31).wrapping_sub(exponent);
        case.holds("an exponent is the number's", (-30..=33).contains(&places))?;
        // In units of 2^-32 of the bits.
        let value = i128::from(mantissa) << (places + 32);
        let (error, half) = (value.abs_diff(bits << 32), 1_u128 << (places.max(-31) + 31));
        case.holds("from_bits is to nearest", error <= if places > 0 { half } else { 0 })?;
    }
    Ok(())
}

/// No bits panic, and the signs are right.
fn arithmetic(case: &Case, draw: &mut Draw<'_>, a: Scaled) -> Result<(), Broken> {
    let b = Scaled::from_bits(draw.bits() as i64, draw.bits() as i32 >> (draw.byte() % 32));
    let sign = |number: Scaled| number.parts().0.signum();
    case.holds("a product has the sign of its factors", sign(a * b) == sign(a) * sign(b))?;
    case.holds("a quotient has the sign of its parts", sign(a / b) == sign(a) * if sign(b) < 0 { -1 } else { 1 })?;
    let same = core::hint::black_box(a);
    case.holds("a difference from itself is zero", a - same == Scaled::ZERO && a <= same)?;
    case.holds("a root is not negative", sign(a.root()) == sign(a).max(0))?;
    core::hint::black_box((a + b, a - b, a < b, a.to_q31(), Scaled::hypotenuse(a, b), a.exact()));
    Ok(())
}

/// Nearest integers, which saturate; and levels, lanes and wide numbers by them.
fn integers(case: &Case, bits: i64, exponent: i32, fraction: u32) -> Result<(), Broken> {
    let number = Scaled::from_bits(bits, exponent);
    let (mantissa, scale) = number.parts();
    let nearest = |fraction: u32| {
        let places = 31 - fraction as i32 - scale;
        match places {
            1..=120 => ((i128::from(mantissa) >> (places - 1)) + 1) >> 1,
            -90..=0 => i128::from(mantissa) << -places,
            _ if places > 0 => 0,
            _ => i128::from(mantissa.signum()) * i128::MAX,
        }
    };
    let clamped = |fraction, least: i128, most: i128| nearest(fraction).clamp(least, most);
    let signed = clamped(fraction, i64::MIN.into(), i64::MAX.into());
    case.holds("to_bits is to nearest and saturates", i128::from(number.to_bits(fraction)) == signed)?;
    let unsigned = clamped(fraction, 0, u64::MAX.into());
    case.holds("to_unsigned is to nearest and saturates", i128::from(number.to_unsigned(fraction)) == unsigned)?;
    case.holds("to_q31 saturates", i128::from(number.to_q31()) == clamped(31, 0, u32::MAX.into()))?;
    let short = clamped(16, 0, u32::MAX.into());
    case.holds("a level of I2F14 saturates", i128::from(I2F14::level(number).to_bits()) == short)?;
    case.holds("a level of I16F16 saturates", i128::from(I16F16::level(number).to_bits()) == short)?;
    let long = clamped(32, 0, u64::MAX.into());
    case.holds("a level of I2F30 saturates", i128::from(I2F30::level(number).to_bits()) == long)?;
    let lane = clamped(14, i16::MIN.into(), i16::MAX.into());
    case.holds("a lane of I2F14 saturates", i128::from(I2F14::lane(number).to_bits()) == lane)?;
    let [fine, coarse] = [30, 16].map(|fraction| clamped(fraction, i32::MIN.into(), i32::MAX.into()));
    case.holds("a lane of I2F30 saturates", i128::from(I2F30::lane(number).to_bits()) == fine)?;
    case.holds("a lane of I16F16 saturates", i128::from(I16F16::lane(number).to_bits()) == coarse)?;
    let wide = clamped(28, i32::MIN.into(), i32::MAX.into());
    case.holds("a wide number of I2F14 saturates", i128::from(I2F14::narrow(number)) == wide)
}
