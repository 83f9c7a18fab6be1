//! What two mirror directions have to do with each other: continuity and monotony.

use super::{Broken, Given};
use crate::oracle;
use crate::real::Real;
use crate::trial::method::Method;

pub(super) fn hold<T: Real>(given: &Given<T>, other: [f64; 3], choice: u8) -> Result<(), Broken> {
    monotonic(given, &given.with(other))?;
    let mut beside = given.pair.r;
    let lane = &mut beside[usize::from(choice) % 3];
    let format = given.case.format;
    let step = if choice & 64 == 0 { format.ulp(*lane) } else { format.step() };
    *lane = T::from_f64(if choice & 128 == 0 { *lane + step } else { *lane - step }).to_f64();
    continuous(given, &given.with(beside))
}

/// The turn from `l` does not fall as `r` moves away.
fn monotonic<T: Real>(one: &Given<T>, other: &Given<T>) -> Result<(), Broken> {
    if !one.defined(Method::Cap) || !other.defined(Method::Cap) {
        return Ok(());
    }
    let [(near, near_turn), (far, far_turn)] =
        [one, other].map(|given| (given.turn(given.pair.r), given.turn(given.answer(Method::Cap))));
    let fall = if near <= far { near_turn - far_turn } else { far_turn - near_turn };
    one.case.at_most("cap turns the further the farther r is", fall, one.twice(Method::Cap))
}

/// Two mirror directions a step apart have answers no farther apart than the exact ones, and the budgets: also where
/// one is inside the disc and the other outside.
fn continuous<T: Real>(one: &Given<T>, other: &Given<T>) -> Result<(), Broken> {
    if !one.defined(Method::Cap) || !other.defined(Method::Cap) {
        return Ok(());
    }
    let apart = oracle::angle_between(one.pair.r, other.pair.r);
    // On circles about l, half of the distance has the sine that half of the turn about l has, times the root of the
    // product of both circles' radii: so the exact answers are no farther apart than this.
    let theta = one.theta();
    let shrunk = |given: &Given<T>| {
        // Beside the opposite, where circles are narrow, an angle of almost pi has lost the digits.
        let beside = given.turn(given.pair.r.map(|lane| -lane));
        let inside = given.turn(given.pair.r) <= theta;
        if inside { 1.0 } else { libm::sin(theta) / libm::sin(beside) }
    };
    let widening = libm::sqrt((shrunk(one) * shrunk(other)).max(1.0));
    let exact = 2.0 * libm::asin((widening * libm::sin(apart / 2.0)).min(1.0));
    let jump = oracle::angle_between(one.answer(Method::Cap), other.answer(Method::Cap));
    one.case.at_most("cap is continuous", jump, exact + one.twice(Method::Cap))
}
