//! Points that fill a square evenly, however many are taken.

use crate::real::{Real, Scalar};

/// `2^32` over the plastic number, 1.324 717 957, and over its square: odd, so that they come round to 0 only after
/// `2^32` steps.
const STEPS: [u32; 2] = [3_242_174_889, 2_447_445_413];

/// `count` points of the sequence R2, in `[0, 1)` squared, from its `first` on.
///
/// The point `i` is `(1/2 + i / g, 1/2 + i / g^2)` modulo 1, `g` being the plastic number, in integers modulo `2^32`,
/// then rounded into the format (what rounds up to 1 is 0, where the square closes). Any run of the sequence is as even
/// as any other: to give every pixel points of its own, let pixel `k` begin at `k` times the count, wrapping.
///
/// The sequence comes round after `2^32` points. Source: Roberts, "The unreasonable effectiveness of quasirandom
/// sequences" (2018).
///
/// ```
/// let [[x, y]] = sunglint::sampling::points::<f64>(1, 1).collect::<Vec<_>>()[..] else { panic!() };
/// assert!((x - 0.254_877_666).abs() < 1e-9 && (y - 0.069_840_290).abs() < 1e-9);
/// ```
#[inline]
pub fn points<T: Real>(first: u32, count: u32) -> impl Iterator<Item = [T; 2]> {
    let place =
        move |index: u32, step: u32| fraction((1_u32 << 31).wrapping_add(first.wrapping_add(index).wrapping_mul(step)));
    let [across, up] = STEPS;
    (0..count).map(move |index| [place(index, across), place(index, up)])
}

/// `bits / 2^32`; 0 where that rounds to 1.
#[inline]
fn fraction<T: Real>(bits: u32) -> T {
    let lane = T::lane(T::Scalar::from_q31(bits >> 1));
    if T::of_lane(lane) < T::Scalar::ONE { lane } else { T::ZERO }
}
