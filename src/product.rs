//! Products and quotients of many factors that no step leaves the format's range of, in f16 above all.

use crate::real::Scalar;

/// The product of `above` over the product of `below`, one rounding a factor.
///
/// What has been multiplied so far is kept near 1: while it is greater than 1, the factors that lower it come first.
/// So an intermediate overflows or underflows only where the answer, or a factor by itself, does.
#[inline]
pub(crate) fn quotient<S: Scalar, const N: usize, const M: usize>(above: [S; N], below: [S; M]) -> S {
    let factors = |raises: bool| {
        let above = above.iter().filter(move |&&factor| (factor > S::ONE) == raises).map(|&factor| (factor, true));
        let below = below.iter().filter(move |&&factor| (factor > S::ONE) != raises).map(|&factor| (factor, false));
        above.chain(below)
    };
    let (mut raising, mut lowering) = (factors(true), factors(false));
    let mut product = S::ONE;
    loop {
        let next = if product > S::ONE {
            lowering.next().or_else(|| raising.next())
        } else {
            raising.next().or_else(|| lowering.next())
        };
        product = match next {
            Some((factor, true)) => product * factor,
            Some((factor, false)) => product / factor,
            None => return product,
        };
    }
}

/// `value`, or the greatest finite number where it is above that; zero for NaN and what is negative.
#[inline]
pub(crate) fn saturated<S: Scalar>(value: S) -> S {
    if value > S::MAX {
        S::MAX
    } else if value > S::ZERO {
        value
    } else {
        S::ZERO
    }
}
