//! Integers with an exponent against 192 bits: every operation over random and hard operands, and every conversion.

mod exact;

use exact::{Big, assert_tight, big, distance, worst};
use oorandom::Rand64;
use sunglint::Scalar;
use sunglint::real::{Constant, Scaled};

const COUNT: usize = 200_000;

/// Mantissas where rounding, carrying and the table of roots change their mind.
const MANTISSAS: [i64; 12] = [
    1 << 30,
    (1 << 30) + 1,
    (1 << 30) + (1 << 24) - 1,
    (1 << 30) + (1 << 24),
    0x5555_5555,
    0x5a82_7999,
    0x5a82_799a,
    0x6000_0000,
    0x7aaa_aaab,
    0x7fff_fffd,
    0x7fff_fffe,
    0x7fff_ffff,
];

/// Exponents about the widths at which one operand of a sum is cut or lost.
const EXPONENTS: [i32; 18] = [-60, -35, -34, -33, -32, -31, -30, -2, -1, 0, 1, 2, 30, 31, 32, 33, 34, 61];

fn hard() -> impl Iterator<Item = Scaled> + Clone {
    MANTISSAS.into_iter().flat_map(|mantissa| {
        EXPONENTS
            .into_iter()
            .flat_map(move |exponent| [mantissa, -mantissa].map(|mantissa| Scaled::from_bits(mantissa, exponent - 31)))
    })
}

fn random(source: &mut Rand64) -> Scaled {
    let mantissa = source.rand_range(1 << 30..1 << 31) as i64;
    let sign = if source.rand_u64() & 1 == 0 { 1 } else { -1 };
    Scaled::from_bits(sign * mantissa, source.rand_range(0..80) as i32 - 71)
}

fn random_pairs() -> impl Iterator<Item = [Scaled; 2]> {
    let mut source = Rand64::new(1);
    (0..COUNT).map(move |_| [random(&mut source), random(&mut source)])
}

/// Differences that leave few digits, of numbers a few last places apart and across a power of two.
fn neighbours() -> impl Iterator<Item = [Scaled; 2]> {
    let mut source = Rand64::new(2);
    (0..COUNT / 10).map(move |_| {
        let mantissa = source.rand_range(1 << 30..1 << 31) as i64;
        let step = source.rand_range(0..9) as i64 - 4;
        let (a, b) = (Scaled::from_bits(mantissa, -31), Scaled::from_bits(mantissa + step, -31));
        if step & 1 == 0 { [a, b] } else { [a, Scaled::from_bits(mantissa / 2 + step, -30)] }
    })
}

fn pairs() -> impl Iterator<Item = [Scaled; 2]> {
    hard().flat_map(|a| hard().map(move |b| [a, b])).chain(neighbours()).chain(random_pairs())
}

fn truth(value: Scaled) -> Big {
    big(value.exact())
}

/// Distance in units of the last of 31 digits.
fn places(computed: Scaled, truth: &Big) -> f64 {
    let size = truth.to_f64().value();
    let last = if size == 0.0 { -1074 } else { libm::ilogb(size) + 1 - 31 };
    distance(&big(computed.exact()), truth, last)
}

fn worst_of(compute: fn(Scaled, Scaled) -> Scaled, exact: fn(&Big, &Big) -> Big) -> f64 {
    worst(pairs().map(|[a, b]| places(compute(a, b), &exact(&truth(a), &truth(b)))))
}

#[test]
fn sums_are_rounded_to_nearest() {
    assert_tight("sum, last places", worst_of(|a, b| a + b, |a, b| a + b), 0.5);
    assert_tight("difference, last places", worst_of(|a, b| a - b, |a, b| a - b), 0.5);
}

#[test]
fn products_are_rounded_to_nearest() {
    assert_tight("product, last places", worst_of(|a, b| a * b, |a, b| a * b), 0.5);
}

#[test]
fn quotients() {
    assert_tight("quotient, last places", worst_of(|a, b| a / b, |a, b| a / b), 0.77);
}

#[test]
fn roots() {
    let numbers = hard().chain(random_pairs().flatten()).filter(|a| *a > Scaled::ZERO);
    assert_tight("root, last places", worst(numbers.map(|a| places(a.root(), &truth(a).sqrt()))), 0.77);
}

#[test]
fn quotients_and_roots_of_powers_of_two_are_exact() {
    for a in hard() {
        for power in EXPONENTS {
            let two = Scaled::from_bits(1, power);
            let shifted = Scaled::nearest(libm::scalbn(a.exact(), -power));
            assert_eq!([a / two, a / (Scaled::ZERO - two)], [shifted, Scaled::ZERO - shifted]);
        }
    }
    for half in EXPONENTS {
        assert_eq!(Scaled::from_bits(1, 2 * half).root(), Scaled::from_bits(1, half));
    }
}

/// Differences of neighbours have few digits, all of them.
#[test]
fn what_cancels_is_exact() {
    for [a, b] in neighbours() {
        assert_eq!(truth(a - b), truth(a) - truth(b), "{a:?} {b:?}");
    }
}

#[test]
fn order_is_that_of_the_values() {
    for [a, b] in pairs().chain(hard().map(|a| [a, Scaled::ZERO])).chain(hard().map(|a| [a, a])) {
        assert_eq!(a.partial_cmp(&b), truth(a).partial_cmp(&truth(b)), "{a:?} {b:?}");
        assert_eq!(a == b, truth(a) == truth(b), "{a:?} {b:?}");
    }
}

/// Division by zero, roots of what is negative, and sums with what is far below.
#[test]
fn zero_and_max_have_the_documented_answers() {
    let [zero, max] = [Scaled::ZERO, Scaled::MAX];
    let lowest = zero - max;
    assert_eq!([zero / zero, zero * max, zero.root(), lowest.root(), max - max, zero / max], [zero; 6]);
    assert!(max > Scaled::nearest(f64::MAX) && lowest < Scaled::nearest(f64::MIN));
    for a in hard() {
        let end = if a > zero { max } else { lowest };
        assert_eq!(a / zero, end);
        assert_eq!([a + zero, zero + a, a - zero, zero - (zero - a)], [a; 4]);
        assert_eq!([a * zero, zero * a, zero / a, a - a], [zero; 4]);
        assert_eq!(max + a, max);
        assert!(max > a && lowest < a);
        assert_eq!(a.root() > zero, a > zero);
    }
    // Seven squarings deep, there and back.
    let mut far = max;
    for _ in 0..7 {
        far = far * far;
    }
    assert!(far > max && Scaled::ONE / far < Scaled::nearest(5e-324) && Scaled::ONE / far * far > Scaled::nearest(0.9));
}

/// Nearest to `value 2^fraction`, halves upwards, as an exact integer of f64.
fn rounded(value: Scaled, fraction: u32) -> f64 {
    (libm::scalbn(value.exact(), fraction as i32) + 0.5).floor()
}

#[test]
fn integers_are_the_nearest_and_saturate() {
    for value in hard().chain(random_pairs().flatten()).chain([Scaled::ZERO]) {
        for fraction in [0, 1, 14, 16, 28, 30, 32, 60, 63] {
            // A value of 31 digits that is as large as 2^53 is an integer; below, f64 holds the half exactly.
            let truth = rounded(value, fraction);
            assert_eq!(value.to_bits(fraction), truth as i64, "{value:?} {fraction}");
            assert_eq!(value.to_unsigned(fraction), truth as u64, "{value:?} {fraction}");
        }
    }
    for (value, signed, unsigned) in
        [(Scaled::MAX, i64::MAX, u64::MAX), (Scaled::ZERO - Scaled::MAX, i64::MIN, 0), (Scaled::ZERO, 0, 0)]
    {
        assert_eq!([value.to_bits(0), value.to_bits(60)], [signed; 2]);
        assert_eq!([value.to_unsigned(0), value.to_unsigned(60)], [unsigned; 2]);
    }
    // Zero has an exponent too, and saturates nowhere.
    assert_eq!((Scaled::ZERO.to_bits(1 << 25), Scaled::ZERO.to_unsigned(1 << 25)), (0, 0));
}

/// Worst distance from integers of every length, in last places.
#[test]
fn integers_become_the_nearest_number() {
    let mut source = Rand64::new(3);
    let mut lengths = || (0..64).map(|length| source.rand_u64() >> length).collect::<Vec<_>>();
    let ends = [0, 1, i64::MAX as u64, i64::MIN as u64, u64::MAX, u64::MAX - 1, 0x7fff_ffff_8000_0000, 1 << 63 | 1];
    let all: Vec<u64> = (0..2000).flat_map(|_| lengths()).chain(ends).collect();
    let exactly = |bits: i128, exponent: i32| exact::fixed(bits, 0) << exponent as isize;
    let signed = all.iter().flat_map(|&bits| {
        let bits = bits as i64;
        [-60, 0, 7].map(|exponent| places(Scaled::from_bits(bits, exponent), &exactly(bits.into(), exponent)))
    });
    assert_tight("signed integers, last places", worst(signed), 0.5);
    let unsigned = all.iter().flat_map(|&bits| {
        [-60, 0, 7].map(|exponent| places(Scaled::from_unsigned(bits, exponent), &exactly(bits.into(), exponent)))
    });
    assert_tight("unsigned integers, last places", worst(unsigned), 0.5);
}

#[test]
fn floats_become_the_nearest_number() {
    let mut source = Rand64::new(4);
    let subnormals = [5e-324, 1e-323, 1.5e-310, f64::MIN_POSITIVE.next_down(), -5e-324, -1.5e-310];
    let others = [0.0, -0.0, 1.0, -1.0, f64::MIN_POSITIVE, f64::MAX, f64::MIN, 0.1, 2.0_f64.next_down()];
    let bits = (0..COUNT).map(|_| f64::from_bits(source.rand_u64())).filter(|value| value.is_finite());
    let errors = bits.chain(subnormals).chain(others).map(|value| {
        // Into the middle of f64's range, so that the answer's 31 digits are exact there.
        let shift = if value == 0.0 { 0 } else { libm::ilogb(value) };
        let middle = Scaled::new(value) / Scaled::from_bits(1, shift);
        places(middle, &(big(value) >> shift as isize))
    });
    assert_tight("f64, last places", worst(errors), 0.5);
    assert_eq!([f64::NAN, -f64::NAN, 0.0, -0.0].map(Scaled::new), [Scaled::ZERO; 4]);
    assert_eq!([f64::INFINITY, -f64::INFINITY].map(Scaled::new), [Scaled::MAX, Scaled::ZERO - Scaled::MAX]);
    assert_eq!(Scaled::constant(Constant::new(0.3)), Scaled::nearest(0.3));
}

/// Exponents that nothing makes are an answer too, with overflow checks on.
#[test]
fn no_exponent_panics() {
    let mut source = Rand64::new(5);
    let mut any = || Scaled::from_bits(source.rand_u64() as i64, source.rand_u64() as i32);
    for _ in 0..COUNT {
        let (a, b) = (any(), any());
        std::hint::black_box(([a + b, a - b, a * b, a / b, a.root()], a.partial_cmp(&b)));
        std::hint::black_box((a.to_bits(60), a.to_bits(0), a.to_unsigned(63), a.exact()));
    }
}

/// What judges the above would see one place more or less.
#[test]
fn an_error_of_one_place_is_seen() {
    fn off(value: Scaled, places: f64) -> Scaled {
        let exact = value.exact();
        let last = if exact == 0.0 { 0.0 } else { libm::scalbn(1.0, libm::ilogb(exact) + 1 - 31) };
        Scaled::nearest(exact + places * last)
    }
    for places in [-1.0, 1.0] {
        let sum = worst(pairs().map(|[a, b]| self::places(off(a + b, places), &(truth(a) + truth(b)))));
        let product = worst(pairs().map(|[a, b]| self::places(off(a * b, places), &(truth(a) * truth(b)))));
        let numbers = || hard().chain(random_pairs().flatten()).filter(|a| *a > Scaled::ZERO);
        let root = worst(numbers().map(|a| self::places(off(a.root(), places), &truth(a).sqrt())));
        let quotient = worst(pairs().map(|[a, b]| self::places(off(a / b, places), &(truth(a) / truth(b)))));
        println!("{places}: sum {sum:.2}, product {product:.2}, root {root:.2}, quotient {quotient:.2}");
        assert!(sum > 0.5 && product > 0.5 && root > 0.77 && quotient > 0.77);
    }
}
