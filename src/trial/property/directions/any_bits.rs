//! Lanes that make no unit vectors: NaN, infinities, the ends of the range, anything.

use super::{Broken, Given};
use crate::real::Real;
use crate::specular::{cap, normalize, reflect};
use crate::trial::method::Method;

pub(super) fn hold<T: Real>(given: &Given<T>, raw: [f64; 6]) -> Result<(), Broken> {
    let case = &given.case;
    let [a, b, c, d, e, f] = raw.map(T::from_f64);
    let (wild, other) = ([a, b, c], [d, e, f]);
    let (l, r) = (given.pair.l.map(T::from_f64), given.pair.r.map(T::from_f64));
    for method in Method::ALL {
        // Only that they return.
        let _ = [(wild, other), (l, other), (wild, r)].map(|(l, r)| method.direction(l, r, &given.lit.constants));
    }
    let _ = [reflect(wild, other), reflect(l, other), reflect(wild, r)];
    let sphere = &given.lit.constants.sphere;
    case.holds("normalize of anything is finite", finite(normalize(wild)))?;
    case.holds("cap of anything is finite", finite(cap(wild, other, sphere)))?;
    case.holds("cap of any r is finite", finite(cap(l, other, sphere)))?;
    case.holds("cap of any l is finite", finite(cap(wild, r, sphere)))?;
    if !finite(wild) {
        case.holds("normalize of what is not finite is zero", normalize(wild) == [T::ZERO; 3])?;
        case.holds("cap of an r that is not finite is l", cap(l, wild, sphere) == l)?;
        case.holds("cap of an l that is not finite is zero", cap(wild, r, sphere) == [T::ZERO; 3])?;
    }
    Ok(())
}

fn finite<T: Real>(v: [T; 3]) -> bool {
    v.into_iter().all(|lane| lane.to_f64().is_finite())
}
