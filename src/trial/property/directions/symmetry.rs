//! Mirror images, exchanged axes, and the sign of the mirror direction.

use super::{Broken, Given};
use crate::oracle;
use crate::real::Real;
use crate::trial::format::Format;
use crate::trial::input::Pair;
use crate::trial::method::Method;

pub(super) fn hold<T: Real>(given: &Given<T>, choice: u8) -> Result<(), Broken> {
    even(given)?;
    // Halves are rounded upwards in fixed point, so that a sign counts; sums of floats hang on their order.
    let fixed = matches!(given.case.format, Format::I2F14 | Format::I2F30 | Format::I16F16);
    let mirror = |v: [f64; 3]| [0, 1, 2].map(|i| if choice & (1 << i) == 0 { v[i] } else { -v[i] });
    under(given, "the mirror image of a case has the mirror image for its answer", !fixed, mirror)?;
    let order = ORDERS[usize::from(choice >> 3) % ORDERS.len()];
    let exchange = |v: [f64; 3]| order.map(|lane| v[lane]);
    under(given, "a case with its axes exchanged has the same answer, exchanged", fixed, exchange)
}

/// The sign of `r` does not matter to `factored`. Where its cosine has more than 31 bits, halves of them are rounded
/// upwards.
fn even<T: Real>(given: &Given<T>) -> Result<(), Broken> {
    if !given.is_sphere() {
        return Ok(());
    }
    let negative = given.with(given.pair.r.map(|lane| -lane));
    let [one, other] = [given, &negative].map(|given| given.answer(Method::Factored));
    if !matches!(given.case.format, Format::I2F30 | Format::I16F16) {
        given.case.holds("factored is even in r", one == other)
    } else if given.defined(Method::Factored) {
        let apart = oracle::angle_between(one, other);
        given.case.at_most("factored is even in r", apart, given.twice(Method::Factored))
    } else {
        Ok(())
    }
}

const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// Compares the answer to what a symmetry makes of the question with what it makes of the answer.
fn under<T: Real>(
    given: &Given<T>,
    property: &'static str,
    exact: bool,
    symmetry: impl Fn([f64; 3]) -> [f64; 3],
) -> Result<(), Broken> {
    let image = Given { pair: Pair { l: symmetry(given.pair.l), r: symmetry(given.pair.r) }, ..*given };
    for &method in given.methods() {
        let (found, expected) = (image.answer(method), symmetry(given.answer(method)));
        if exact {
            given.case.holds(property, found == expected)?;
        } else if given.defined(method) {
            given.case.at_most(property, oracle::angle_between(found, expected), given.twice(method))?;
        }
    }
    Ok(())
}
