//! Construction from raw bits: every function of sunglint::raw and of the formats on any bits at all.

mod any;
mod layer;
mod lengths;
mod quantities;
mod range;
mod same;
mod scaled;

use fixed::types::{I2F14, I2F30};

use super::Broken;
use crate::trial::draw::Draw;
use crate::trial::format::Format;

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    match draw.byte() % 8 {
        0 => same::hold::<I2F14>(draw),
        1 => same::hold::<I2F30>(draw),
        2 => range::hold::<I2F14>(draw),
        3 => range::hold::<I2F30>(draw),
        4 => quantities::hold(draw),
        5 => scaled::hold(draw),
        6 => lengths::hold(draw),
        _ => {
            let format = draw.format();
            format.visit(any::AnyBits { format, draw })
        }
    }
}

/// Three lanes by their raw bits: any, a direction, one of up to 1.16 times the length, or ends of the range.
fn lanes(draw: &mut Draw<'_>, format: Format) -> [f64; 3] {
    let end = 1_u64 << (format.width() - 1);
    match draw.byte() % 4 {
        0 => [(); 3].map(|()| format.value(draw.bits())),
        1 => draw.direction(),
        2 => {
            let length = draw.between(0.0, 1.16);
            draw.direction().map(|lane| lane * length)
        }
        _ => [(); 3]
            .map(|()| format.value(draw.one_of([0, 1, end - 1, end, end + 1, end * 2 - 1, end / 2, end / 2 * 3]))),
    }
}

/// A number of 32 bits: any, a small one, an end of the range of Q30 or one beside it.
fn word(draw: &mut Draw<'_>) -> u32 {
    let bits = draw.bits() as u32;
    match bits & 3 {
        0 => [0, 1, 1 << 30, (1 << 30) + 1, u32::MAX, 1 << 31, (1 << 31) - 1, 536_871][(bits >> 2) as usize % 8],
        1 => bits >> ((bits >> 2) & 31),
        _ => bits >> 2,
    }
}
