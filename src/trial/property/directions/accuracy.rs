//! Answers are finite and within their budgets of the truth.

use super::{Broken, Given};
use crate::oracle;
use crate::real::Real;
use crate::trial::aim::Aim;
use crate::trial::budget;
use crate::trial::method::Method;
use crate::trial::search::may_be_unit;

pub(super) fn hold<T: Real>(given: &Given<T>) -> Result<(), Broken> {
    let case = &given.case;
    for &method in given.methods() {
        let answer = given.answer(method);
        case.holds("an answer is finite", answer.into_iter().all(f64::is_finite))?;
        if let (Some(error), Some(budget)) = (given.error(Aim::Direction(method), 0.0), given.budget(method)) {
            case.at_most(within(method), error, budget)?;
        }
    }
    if given.is_sphere() && given.lit.light.distance() == 1.0 {
        let same = given.answer(Method::Epic) == given.answer(Method::Factored);
        case.holds("epic at distance 1 is factored", same)?;
    }
    if let (Some(error), Some(budget)) = (given.error(Aim::Reflect, 0.0), budget::reflect(case.format)) {
        case.at_most("reflect keeps its budget", error, budget)?;
    }
    cap(given)
}

fn within(method: Method) -> &'static str {
    match method {
        Method::Epic => "epic keeps its budget",
        Method::Factored => "factored keeps its budget",
        Method::Disc => "disc keeps its budget",
        Method::Cap => "cap keeps its budget",
    }
}

/// Inside the disc the answer is `r` itself, outside it lies on the rim; nowhere does it turn too far.
fn cap<T: Real>(given: &Given<T>) -> Result<(), Broken> {
    let (case, theta) = (&given.case, given.theta());
    let Some(budget) = given.budget(Method::Cap) else { return Ok(()) };
    let (angle, answer) = (given.turn(given.pair.r), given.answer(Method::Cap));
    let turn = given.turn(answer);
    if angle < theta - budget {
        case.holds("cap inside the disc is r", answer == given.pair.r)?;
    }
    if angle > theta && given.defined(Method::Cap) {
        case.at_most("cap outside the disc is on the rim", libm::fabs(turn - theta), budget)?;
    }
    case.at_most("cap turns no further than to r", turn, angle + budget)?;
    let beyond = if given.defined(Method::Cap) { 0.0 } else { budget::cap_beyond_the_rim(case.format) };
    case.at_most("cap turns no further than to the rim", turn, theta + budget + beyond * libm::sin(theta))?;
    let length = budget::cap_length(case.format, theta);
    // In f64 what is drawn may be a last place shorter or longer than any vector of length 1 is once it is rounded.
    let error = given
        .error(Aim::CapLength, 0.0)
        .filter(|_| may_be_unit(case.format, given.pair.l) && may_be_unit(case.format, given.pair.r));
    if let Some(error) = error {
        case.at_most("cap has length 1", error, length)?;
    }
    // Towards r, not away: the answer is no farther from r than l is.
    case.at_most("cap turns towards r", oracle::angle_between(answer, given.pair.r), angle + budget)
}

/// `normalize` of a vector of some length.
pub(super) fn normalized<T: Real>(given: &Given<T>, length: f64) -> Result<(), Broken> {
    let [direction, size] = budget::normalize(given.case.format);
    let found = |aim| given.error(aim, length).unwrap_or(f64::INFINITY);
    given.case.at_most("normalize keeps the direction", found(Aim::Normalize), direction)?;
    given.case.at_most("normalize gives length 1", found(Aim::NormalizeLength), size)
}
