//! The quantities in integers: the ratio is any 32 bits, whatever the format that was drawn.

use fixed::types::{I2F30, I16F16, U16F48, U20F12};

use super::{Broken, Case, Judge, yes};
use crate::light::LightError;
use crate::normalization::{radiance_q12, sun_radius_at_q16};
use crate::trial::draw::Draw;
use crate::trial::quantity::{FixedPoint, Quantity};

/// Units of the last place, of which the truth's own rounding takes up to 0.75: `tests/exhaustive.rs` has 0.5.
const FAITHFUL: f64 = 1.25;

const ONE: i32 = 1 << 30;

pub(super) fn claims(case: &Case, draw: &mut Draw<'_>, judge: Judge<'_>) -> Result<(), Broken> {
    let bits = match draw.byte() & 3 {
        0 => draw.bits() as i32,
        1 => draw.one_of([0, 1, 9, 10, 16, 17, ONE, ONE + 1, ONE - 1, -1, i32::MIN, i32::MAX]),
        2 => (draw.logarithmic(1.0, f64::from(ONE))) as i32,
        _ => ONE - draw.logarithmic(1.0, 1e6) as i32,
    };
    let mut case = *case;
    case.inputs[0] = bits.into();
    for quantity in Quantity::ALL {
        quantity_claims(&case, quantity, bits, judge)?;
    }
    radiance_claims(&case, draw, judge)?;
    sun_radius_claims(&case, draw.bits() as i32, judge)
}

fn quantity_claims(case: &Case, quantity: Quantity, bits: i32, judge: Judge<'_>) -> Result<(), Broken> {
    let of = |bits: i32| quantity.in_fixed(I2F30::from_bits(bits));
    let answer = of(bits);
    if !(0..=ONE).contains(&bits) {
        return judge(case, ("bits out of 0 to 2^30 are refused", yes(answer == Err(LightError::RatioQ30(bits))), 0.0));
    }
    let ratio = f64::from(bits) / f64::from(ONE);
    let truth = quantity.truth(ratio);
    match answer {
        Ok(FixedPoint { value, lsb, .. }) => {
            // Where 64 bits are more than f64's 53, in units of what those are good for.
            let unit = lsb.max(3.0 * truth * f64::EPSILON);
            judge(case, (quantity.name(), (value - truth).abs() / unit, FAITHFUL))?;
        }
        Err(error) => {
            let over = error == LightError::Overflow("U52F12") && truth > 4.503_599_627_370_495e15;
            judge(case, ("overflows only where 64 bits end", yes(over), 0.0))?;
        }
    }
    // Zero is a point, whose sizeFactor is 1.
    if (1..ONE).contains(&bits) {
        let rising = !matches!(quantity, Quantity::InverseSizeFactor | Quantity::WhiteRadiance);
        let [now, then] = [bits, bits + 1].map(|bits| of(bits).map_or(f64::MAX, |answer| answer.value));
        judge(case, ("has no step the other way", yes(if rising { now <= then } else { now >= then }), 0.0))?;
    }
    Ok(())
}

/// `intensity / sizeFactor` of any bits is the nearest, exactly.
fn radiance_claims(case: &Case, draw: &mut Draw<'_>, judge: Judge<'_>) -> Result<(), Broken> {
    let lower = draw.byte() & 63;
    let (intensity, divisor) = (draw.bits() as u32, draw.bits() >> lower);
    let answer = radiance_q12(U20F12::from_bits(intensity), U16F48::from_bits(divisor));
    let (dividend, divisor) = (u128::from(intensity) << 48, u128::from(divisor));
    let near = match answer {
        Ok(answer) => (u128::from(answer.to_bits()) * divisor).abs_diff(dividend) * 2 <= divisor,
        Err(error) => {
            error == LightError::Overflow("U52F12") && (divisor == 0 || dividend / divisor >= u128::from(u64::MAX))
        }
    };
    judge(case, ("radiance is the nearest quotient", yes(near), 0.0))
}

fn sun_radius_claims(case: &Case, bits: i32, judge: Judge<'_>) -> Result<(), Broken> {
    match sun_radius_at_q16(I16F16::from_bits(bits)) {
        Ok(radius) => {
            let off = i128::from(radius.to_bits()) * 1_495_978_707 - i128::from(bits) * 6_957_000;
            judge(case, ("the Sun's radius in Q16", (off as f64 / 1_495_978_707.0).abs(), 0.51))
        }
        Err(error) => {
            let refused = bits <= 0 && error == LightError::DistanceBits(bits);
            judge(case, ("no distance is refused", yes(refused), 0.0))
        }
    }
}
