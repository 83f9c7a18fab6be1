//! Products and quotients of many factors that no step leaves the format's range of, in f16 above all.

use core::iter::repeat_n;

use crate::real::{Constant, Scalar};

const ONE: Constant = Constant::new(1.0);

/// The product of `above` over the product of `below`, one rounding a factor.
///
/// What has been multiplied so far is kept near 1: while it is greater than 1, the factors that lower it come first.
/// In floats, factors whose reciprocal may leave the range give up a power of two, which is a factor of its own. So an
/// intermediate overflows or underflows only where the answer does.
#[inline]
pub(crate) fn quotient<S: Scalar, const N: usize, const M: usize>(above: [S; N], below: [S; M]) -> S {
    let (mut risen, mut fallen) = (0_usize, 0_usize);
    let above = above.map(|factor| near(factor, &mut risen, &mut fallen));
    let below = below.map(|factor| near(factor, &mut fallen, &mut risen));
    let powers = |raises: bool| {
        let count = if raises { risen.saturating_sub(fallen) } else { fallen.saturating_sub(risen) };
        let [great, small] = S::NEAR_ONE.unwrap_or([ONE; 2]);
        repeat_n((S::constant(if raises { great } else { small }), true), count)
    };
    let factors = |raises: bool| {
        let above = above.iter().filter(move |&&factor| (factor > S::ONE) == raises).map(|&factor| (factor, true));
        let below = below.iter().filter(move |&&factor| (factor > S::ONE) != raises).map(|&factor| (factor, false));
        above.chain(below).chain(powers(raises))
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

/// A factor without the power that it gives up; counts that among those that are `risen`, or `fallen`.
#[inline]
fn near<S: Scalar>(factor: S, risen: &mut usize, fallen: &mut usize) -> S {
    let Some(ends) = S::NEAR_ONE else {
        return factor;
    };
    let [great, small] = ends.map(S::constant);
    if factor > great {
        *risen = risen.wrapping_add(1);
        factor * small
    } else if factor < small && factor > S::ZERO {
        *fallen = fallen.wrapping_add(1);
        factor * great
    } else {
        factor
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

#[cfg(all(test, feature = "half"))]
mod tests {
    use half::f16;

    use super::quotient;

    /// 1.5 / 60 000 would be subnormal, though the answer is 1.
    #[test]
    fn a_great_divisor_between_factors_costs_no_digits() {
        let number = f16::from_f32;
        assert_eq!(quotient([1.5, 40_000.0].map(number), [number(60_000.0)]), f16::ONE);
    }

    /// Neither a great factor alone nor a small one, which have no counterpart to give their power of two to.
    #[test]
    fn powers_that_are_given_up_come_back() {
        let number = f16::from_f32;
        assert_eq!(quotient([16_384.0, 0.5].map(number), [f16::ONE]), number(8192.0));
        assert_eq!(quotient([0.5_f32.powi(13), 4096.0].map(number), [f16::ONE]), number(0.5));
    }
}
