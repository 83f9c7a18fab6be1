//! Falling exponentials in every number of wide range: powers of two by comparison, and a short series.
//!
//! `e^-x = 2^-k e^-r`. `k` is found bit by bit, since a format need bring no conversion to integers, and each
//! subtraction is exact: `k 355/512` has nine digits, and is no less than half of what it is taken from (Cody and
//! Waite, 1980, split the logarithm so; Sterbenz, 1974). Then `e^-r - 1 = -2 r / (r coth(r / 2) + r)`, whose series is
//! even and alternates.

use crate::real::{Constant, Scalar};

/// Exponents from here on give zero: `e^-1024` is below every float.
const END: Constant = Constant::new(1024.0);

/// One bit of `k`.
struct Step {
    /// The logarithm of two as 355/512, times the bit.
    log: Constant,
    /// What that is too much, times the bit.
    excess: Constant,
    /// `2^-bit`, as two factors, so that f16 has both as normal numbers up to bit 16.
    shrink: [Constant; 2],
}

const LOG: f64 = 355.0 / 512.0;

/// 355/512 less the logarithm of two.
const EXCESS: f64 = 2.121_944_400_546_905_8e-4;

const STEPS: [Step; 11] =
    [step(10), step(9), step(8), step(7), step(6), step(5), step(4), step(3), step(2), step(1), UNIT];

const UNIT: Step =
    Step { log: Constant::new(LOG), excess: Constant::new(EXCESS), shrink: [Constant::new(0.5), Constant::new(1.0)] };

/// Half of the logarithm of two, and a little more.
const HALF_LOG: Constant = Constant::new(LOG / 2.0);

const fn step(bit: u32) -> Step {
    let weight = (1 << bit) as f64;
    let root = Constant::new(f64::from_bits((1023 - (1_u64 << (bit - 1))) << 52));
    Step { log: Constant::new(LOG * weight), excess: Constant::new(EXCESS * weight), shrink: [root, root] }
}

/// `r coth(r / 2) - 2` in powers of `r^2`: `2 B(2n) / (2n)!` by Bernoulli's numbers. The first left out is below 1e-17
/// of the sum for `r` up to 0.8.
const SERIES: [Constant; 10] = [
    Constant::new(1.0 / 6.0),
    Constant::new(-1.0 / 360.0),
    Constant::new(1.0 / 15_120.0),
    Constant::new(-1.0 / 604_800.0),
    Constant::new(1.0 / 23_950_080.0),
    Constant::new(-691.0 / 653_837_184_000.0),
    Constant::new(1.0 / 37_362_124_800.0),
    Constant::new(-3617.0 / 5_335_311_421_440_000.0),
    Constant::new(43_867.0 / 2_554_547_108_585_472_000.0),
    Constant::new(-174_611.0 / 401_428_831_349_145_600_000.0),
];

/// `value e^-x` for `x` from 0; zero for NaN and from 1024 on.
///
/// Falls from `value` step by step, so that no intermediate is below the answer.
#[inline]
pub(crate) fn shrunk<S: Scalar>(value: S, x: S) -> S {
    // False for NaN.
    let lasting = x < S::constant(END);
    if !lasting {
        return S::ZERO;
    }
    let (scaled, rest) = reduced(value, x);
    // Not the sum of two products, of which the lesser may be subnormal in f16 where the answer is not.
    scaled * (S::ONE + fall(rest))
}

/// `1 - e^-x` for `x` from 0, to full relative precision for small `x` too; 1 for NaN and from 1024 on.
#[inline]
pub(crate) fn complement<S: Scalar>(x: S) -> S {
    // False for NaN.
    let lasting = x < S::constant(END);
    if !lasting {
        return S::ONE;
    }
    let (power, rest) = reduced(S::ONE, x);
    (S::ONE - power) - power * fall(rest)
}

/// `value 2^-k` and `x - k log 2`, which is about -0.35 to 0.35, and up to 0.8 for the largest `x`.
#[inline]
fn reduced<S: Scalar>(value: S, x: S) -> (S, S) {
    let (mut value, mut rest, mut excess) = (value, x, S::ZERO);
    let mut take = |step: &Step, least: S| {
        if rest >= least {
            let [first, second] = step.shrink;
            value = value * S::constant(first) * S::constant(second);
            rest = rest - S::constant(step.log);
            excess = excess + S::constant(step.excess);
        }
    };
    STEPS.iter().for_each(|step| take(step, S::constant(step.log)));
    // To the nearest multiple.
    take(&UNIT, S::constant(HALF_LOG));
    (value, rest + excess)
}

/// `e^-r - 1` for `r` about 0. As many terms as the format can tell.
#[inline]
fn fall<S: Scalar>(r: S) -> S {
    let square = r * r;
    let (mut power, mut sum) = (S::ONE, S::ZERO);
    for coefficient in &SERIES {
        power = power * square;
        let next = sum + power * S::constant(*coefficient);
        if next == sum {
            break;
        }
        sum = next;
    }
    let two = S::ONE + S::ONE;
    S::ZERO - (r + r) / ((two + sum) + r)
}

#[cfg(test)]
mod tests {
    use super::{complement, shrunk};

    /// `2^1000`, so that the answers for all exponents up to 1024 are normal numbers.
    const GREAT: f64 = 1.071_508_607_186_267_3e301;

    /// From 0 to the last, and ever smaller ones.
    fn exponents() -> impl Iterator<Item = f64> {
        (0..200_000).map(|i| f64::from(i) * 0.005_119).chain((1..600).map(|i| 0.935_f64.powi(i)))
    }

    /// The greater; a NaN is the greatest of all.
    fn worse(most: f64, error: f64) -> f64 {
        if error <= most { most } else { error }
    }

    /// Relative, in units of `2^-52`.
    fn error(computed: f64, truth: f64) -> f64 {
        (computed / truth - 1.0).abs() / f64::EPSILON
    }

    #[test]
    fn every_step_and_every_term_is_right_to_the_last_places() {
        // The truth is a square, hence up to 1.6 units off itself.
        let half = |x: f64| (-x / 2.0).exp() * GREAT.sqrt();
        let shrunk = exponents().map(|x| error(shrunk(GREAT, x), half(x) * half(x))).fold(0.0, worse);
        let complement = exponents().map(|x| error(complement(x), -(-x).exp_m1())).fold(0.0, worse);
        assert!(shrunk < 3.4 && complement < 2.3, "{shrunk} {complement}");
        assert!(shrunk > 3.4 / 4.0 && complement > 2.3 / 4.0, "{shrunk} {complement}");
    }

    #[test]
    fn nothing_is_left_from_1024_on() {
        let last = 1024.0_f64.next_down();
        assert!(shrunk(GREAT, last) > 0.0 && complement(last) == 1.0);
        assert_eq!([1024.0, f64::INFINITY, f64::NAN].map(|x| [shrunk(GREAT, x), complement(x)]), [[0.0, 1.0]; 3]);
    }
}
