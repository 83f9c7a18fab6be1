//! Emulated words against the types that some of them are: every operation, every method, bit for bit.

use fixed::types::{I2F14, I2F30, I16F16};
use half::f16;
use oorandom::Rand64;
use sunglint::trial::emulated::{FixedPoint, FlushingF16, Narrow, Word};
use sunglint::trial::formula;
use sunglint::trial::gloss::{self, CASES};
use sunglint::trial::lights::BUDGETED;
use sunglint::trial::{Constants, Method, Shading, Visitor, input};
use sunglint::{DistantLight, Float, Real, Scalar, cap, reflect};

type Half = Narrow<11, 5, false>;
type Single = Narrow<24, 8, false>;

/// Random pairs that every operation is tried on.
const PAIRS: usize = 10_000_000;

/// Significands of `digits` digits, less the hidden one, where roundings go wrong: beside the ends, beside the middle,
/// and those whose products and quotients lie beside a tie.
fn significands(digits: u32) -> Vec<u64> {
    let end = 1_u64 << (digits - 1);
    let thirds = [end / 3, end / 3 + 1, 2 * end / 3, 2 * end / 3 + 1];
    let roots = [0.414_213_562, 0.732_050_808].map(|root| (root * end as f64) as u64);
    let mut all = vec![0, 1, 2, 3, end / 2 - 1, end / 2, end / 2 + 1, end - 3, end - 2, end - 1];
    all.extend(thirds);
    all.extend(roots.into_iter().flat_map(|root| [root, root + 1]));
    all
}

/// Raw bits of a float: every exponent with each of [`significands`], of either sign.
fn hard_bits(digits: u32, exponent: u32) -> Vec<u64> {
    let exponents = (0..1_u64 << exponent).map(|bits| bits << (digits - 1));
    let sizes = exponents.flat_map(|high| significands(digits).into_iter().map(move |low| high | low));
    sizes.flat_map(|size| [size, size | 1 << (digits - 1 + exponent)]).collect()
}

/// The same bits but for those of a NaN.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// Sum, difference, product and quotient in two formats.
fn assert_same_operations<A: Scalar, B: Scalar>(x: A, y: A) {
    let [a, b] = [x, y].map(A::exact);
    let [u, v] = [a, b].map(B::nearest);
    let expected = [x + y, x - y, x * y, x / y].map(A::exact);
    let found = [u + v, u - v, u * v, u / v].map(B::exact);
    for (place, (expected, found)) in expected.into_iter().zip(found).enumerate() {
        assert!(same(expected, found), "{a:e} {} {b:e}: {found:e}, not {expected:e}", ["+", "-", "*", "/"][place]);
    }
}

fn assert_same_constants<A: Float, B: Float>() {
    let of_a = [A::STEEP, A::SAFE_SQUARE, A::PI, A::TWICE_PI, A::INVERSE_PI].map(|pair| pair.map(A::exact));
    let of_b = [B::STEEP, B::SAFE_SQUARE, B::PI, B::TWICE_PI, B::INVERSE_PI].map(|pair| pair.map(B::exact));
    assert_eq!(of_a, of_b);
    let of_a = [A::SCALE, A::TINY, A::SPLITTER, A::ONE, A::ZERO, A::MAX].map(A::exact);
    let of_b = [B::SCALE, B::TINY, B::SPLITTER, B::ONE, B::ZERO, B::MAX].map(B::exact);
    assert_eq!(of_a, of_b);
    assert_eq!(A::NEAR_ONE, B::NEAR_ONE);
}

#[test]
fn constants_are_those_of_f16_and_f32() {
    assert_same_constants::<f16, Half>();
    assert_same_constants::<f32, Single>();
}

/// Roots, hypotenuses, comparisons and fractions of 1 of every f16.
#[test]
fn all_numbers_of_f16() {
    for bits in 0..=u16::MAX {
        let value = f16::from_bits(bits);
        let narrow = Half::nearest(value.to_f64());
        assert!(same(narrow.exact(), value.to_f64()), "{value:e}");
        assert!(same(narrow.root().exact(), value.root().to_f64()), "{value:e}");
        assert_eq!(narrow.to_q31(), value.to_q31(), "{value:e}");
        let fraction = u32::from(bits) * 65_537;
        assert_eq!(Half::from_q31(fraction).exact(), f16::from_q31(fraction).to_f64());
        for other in [0, 1, 0x3ff, 0x400, 0x3c00, 0x7bff, 0x7c00, 0xbc00].map(f16::from_bits) {
            let narrow_other = Half::nearest(other.to_f64());
            assert_eq!(narrow.partial_cmp(&narrow_other), value.partial_cmp(&other));
            let [found, expected] =
                [Half::hypotenuse(narrow, narrow_other).exact(), f16::hypotenuse(value, other).to_f64()];
            assert!(same(found, expected), "{value:e}, {other:e}");
        }
    }
}

/// The nearest number to f64's on, halfway between and beside halfway between those of f16.
#[test]
fn conversions_are_those_of_f16() {
    for bits in 0..0x7c00_u16 {
        let [low, high] = [bits, bits + 1].map(|bits| f16::from_bits(bits).to_f64());
        let halfway = if high.is_finite() { (low + high) / 2.0 } else { 65_520.0 };
        for value in [low, low.next_up(), halfway.next_down(), halfway, halfway.next_up(), high.next_down(), 1e300] {
            assert_eq!(Half::nearest(value).exact(), f16::nearest(value).to_f64(), "{value:e}");
            assert_eq!(Half::nearest(-value).exact(), f16::nearest(-value).to_f64(), "{value:e}");
        }
    }
}

#[test]
fn operations_are_those_of_f16() {
    let hard: Vec<_> = hard_bits(11, 5).into_iter().map(|bits| f16::from_bits(bits as u16)).collect();
    for &a in &hard {
        hard.iter().for_each(|&b| assert_same_operations::<f16, Half>(a, b));
    }
    let mut source = Rand64::new(1);
    for _ in 0..PAIRS {
        let bits = source.rand_u64();
        let [a, b] = [bits, bits >> 16].map(|bits| f16::from_bits(bits as u16));
        assert_same_operations::<f16, Half>(a, b);
    }
}

#[test]
fn operations_are_those_of_f32() {
    let hard: Vec<_> = hard_bits(24, 8).into_iter().map(|bits| f32::from_bits(bits as u32)).collect();
    let mut source = Rand64::new(2);
    let one_of = |source: &mut Rand64| hard[source.rand_range(0..hard.len() as u64) as usize];
    for _ in 0..PAIRS / 2 {
        let (a, b) = (one_of(&mut source), one_of(&mut source));
        assert_same_operations::<f32, Single>(a, b);
    }
    for _ in 0..PAIRS {
        let bits = source.rand_u64();
        let [a, b] = [bits, bits >> 32].map(|bits| f32::from_bits(bits as u32));
        assert_same_operations::<f32, Single>(a, b);
        let narrow = Single::nearest(a.exact());
        assert!(same(narrow.root().exact(), a.root().exact()), "{a:e}");
        assert_eq!(narrow.to_q31(), a.to_q31());
        assert_eq!(Single::from_q31(bits as u32).exact(), f64::from(f32::from_q31(bits as u32)));
    }
    // Near 1 and near each other, where sums cancel and quotients lie beside 1.
    for _ in 0..PAIRS / 2 {
        let bits = source.rand_u64();
        let beside = |bits: u64| f32::from_bits(0x3f80_0000_u32.wrapping_add(bits as u32 >> 8));
        assert_same_operations::<f32, Single>(beside(bits), beside(bits >> 32));
    }
}

/// The nearest number of `digits` digits in the range of f16 or f32, by the standard library's rounding to integers;
/// below the least normal one zero where `flushing`.
fn nearest_by_rule(value: f64, digits: i32, exponent: u32, flushing: bool) -> f64 {
    let most = (1 << (exponent - 1)) - 1;
    let least = 1 - most;
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let place = (libm::ilogb(value).max(least) - digits + 1) as f64;
    let rounded = (value / place.exp2()).round_ties_even() * place.exp2();
    if rounded.abs() >= f64::from(most + 1).exp2() {
        f64::INFINITY.copysign(value)
    } else if flushing && rounded.abs() < f64::from(least).exp2() {
        0.0_f64.copysign(value)
    } else {
        rounded
    }
}

/// Operations of a word on its own numbers against that rule.
fn assert_rule<const DIGITS: u32, const EXPONENT: u32, const FLUSHING: bool>() {
    let hard = hard_bits(DIGITS, EXPONENT);
    let [highest, cut] = [EXPONENT + DIGITS, DIGITS - 1];
    let number = |bits: u64| {
        let (sign, size) = (bits >> (highest - 1) & 1, bits & ((1 << (highest - 1)) - 1));
        let bias = 1023 - ((1 << (EXPONENT - 1)) - 1);
        let (power, low) = (size >> cut, size & ((1 << cut) - 1));
        let value = match power {
            0 => low as f64 * f64::from(2 - (1 << (EXPONENT - 1)) - cut as i32).exp2(),
            power if power == (1 << EXPONENT) - 1 => f64::INFINITY,
            power => f64::from_bits((power + bias) << 52 | low << (52 - cut)),
        };
        let flushed = FLUSHING && power == 0;
        if flushed {
            0.0
        } else if sign == 1 {
            -value
        } else {
            value
        }
    };
    let mut source = Rand64::new(3);
    for round in 0..PAIRS / 10 {
        let any = |source: &mut Rand64| match round % 2 {
            0 => source.rand_u64(),
            _ => hard[source.rand_range(0..hard.len() as u64) as usize],
        };
        let [a, b] = [number(any(&mut source)), number(any(&mut source))];
        let [u, v] = [a, b].map(<Narrow<DIGITS, EXPONENT, FLUSHING>>::nearest);
        assert_eq!([u, v].map(Scalar::exact), [a, b]);
        let rule = |value| nearest_by_rule(value, DIGITS as i32, EXPONENT, FLUSHING);
        let found = [u + v, u - v, u * v, u / v, u.root()].map(Scalar::exact);
        let expected = [a + b, a - b, a * b, a / b, a.sqrt()].map(rule);
        for (place, (found, expected)) in found.into_iter().zip(expected).enumerate() {
            assert!(same(found, expected), "{a:e}, {b:e}, operation {place}: {found:e}, not {expected:e}");
        }
    }
}

#[test]
fn other_words_round_by_the_rule() {
    assert_rule::<8, 8, false>();
    assert_rule::<8, 5, false>();
    assert_rule::<14, 5, false>();
    assert_rule::<18, 8, false>();
    assert_rule::<23, 8, false>();
}

#[test]
fn flushing_words_have_no_subnormal_numbers() {
    assert_rule::<11, 5, true>();
    assert_rule::<24, 8, true>();
    assert_rule::<8, 8, true>();
    assert_eq!(FlushingF16::nearest(6.1e-5).exact(), 0.0);
    assert_eq!(Half::nearest(6.1e-5).exact(), 1023.0 / 16_777_216.0);
}

/// Lights of the budgets and two beyond half the sky.
fn lights() -> Vec<DistantLight> {
    let wide = [270.0, 360.0].map(|angle| DistantLight::from_angle(angle).unwrap());
    BUDGETED.into_iter().map(|light| light.light).chain(wide).collect()
}

/// Every direction method in two formats, on random pairs and hard ones.
fn assert_same_directions<A: Real, B: Real>(methods: &[Method]) {
    for light in lights() {
        let theta = light.angular_radius();
        let (of_a, of_b) = (Constants::<A>::of(&light), Constants::<B>::of(&light));
        for pair in input::random(5, 20_000, theta).chain(input::hard(theta)) {
            let [l, r] = [pair.l, pair.r].map(|v| v.map(A::from_f64));
            let [m, s] = [l, r].map(|v| v.map(|lane| B::from_f64(lane.to_f64())));
            for method in methods {
                let expected = method.direction(l, r, &of_a).map(A::to_f64);
                let found = method.direction(m, s, &of_b).map(B::to_f64);
                let all = expected.into_iter().zip(found).all(|(expected, found)| same(expected, found));
                assert!(all, "{} at {l:?}, {r:?}: {found:?}, not {expected:?}", method.name());
            }
        }
    }
}

/// Highlight methods in two formats: the sum of all errors, the worst and its input, on whole pixels.
fn assert_same_pixels<A: Real, B: Real>(methods: &[Shading], count: usize) {
    for case in CASES {
        for &shading in methods {
            let expected = gloss::arithmetic::<A>(shading, &case, case.pixels(5, count));
            let found = gloss::arithmetic::<B>(shading, &case, case.pixels(5, count));
            let [a, b] = [expected, found].map(|found| (found.max.to_bits(), found.rms().to_bits(), found.worst));
            assert_eq!(a, b, "{}, {}", case.name, shading.name());
        }
    }
}

#[test]
fn directions_are_those_of_f16() {
    assert_same_directions::<f16, Half>(&Method::ALL);
}

#[test]
fn directions_are_those_of_f32() {
    assert_same_directions::<f32, Single>(&Method::ALL);
}

#[test]
fn pixels_are_those_of_f16() {
    assert_same_pixels::<f16, Half>(&Shading::ALL, 500);
}

#[test]
fn pixels_are_those_of_f32() {
    assert_same_pixels::<f32, Single>(&Shading::ALL, 500);
}

/// The same number in another format, which holds it.
fn exactly<A: Real, B: Real>(v: [A; 3]) -> [B; 3] {
    v.map(|lane| B::from_f64(lane.to_f64()))
}

/// What two fixed-point formats do with vectors of any length, lane by lane and as wide scalars, of which `wide` and
/// `narrow` are one number in both.
fn assert_same_steps<A: Real<Wide: Into<i64>, Scalar = B::Scalar>, B: Real<Wide = i64>>(wide: impl Fn(i64) -> A::Wide) {
    let mut source = Rand64::new(7);
    let end = A::to_f64(A::from_f64(f64::MAX));
    assert_eq!([end, -2.0], [f64::MAX, f64::MIN].map(|value| B::from_f64(value).to_f64()));
    assert_eq!(
        [A::STEEP, [A::WIDE_ONE, A::WIDE_MAX]].map(|pair| pair.map(Into::into)),
        [B::STEEP, [B::WIDE_ONE, B::WIDE_MAX]]
    );
    for _ in 0..200_000 {
        let size = f64::from(1_u32 << source.rand_range(0..16)).recip();
        let mut any = || A::from_f64(size * (4.0 * source.rand_float() - 2.0));
        let (a, b) = ([any(), any(), any()], [any(), any(), any()]);
        let (u, v) = (exactly::<A, B>(a), exactly::<A, B>(b));
        let [dot, square] = [A::dot(a, b), A::square(a)];
        assert_eq!([dot, square].map(Into::into), [B::dot(u, v), B::square(u)]);
        assert_eq!(A::twice(dot).into(), B::twice(B::dot(u, v)));
        assert_eq!(exactly::<A, B>(A::diff(dot, a, A::WIDE_ONE, b)), B::diff(dot.into(), u, B::WIDE_ONE, v));
        let (large, exponent) = A::magnify(a);
        assert_eq!((exactly::<A, B>(large), exponent), B::magnify(u));
        let [add, sub] = [A::add(a[0], b[0]), A::sub(a[0], b[0])];
        assert_eq!([add, sub].map(A::to_f64), [B::add(u[0], v[0]), B::sub(u[0], v[0])].map(B::to_f64));
        let constant = 10.0 * source.rand_float() - 5.0;
        assert_eq!(A::wide(constant).into(), B::wide(constant));
        assert_eq!(A::square_of(constant).into(), B::square_of(constant));
        let limit = source.rand_u64() as i64 >> source.rand_range(0..64);
        let limit = A::WIDE_ONE.into() & limit | A::wide(0.01).into() & limit;
        let turns = source.rand_range(0..34) as u32;
        assert_eq!(A::within(square, turns, wide(limit)), B::within(square.into(), turns, limit));
        let scalar = A::scalar(dot);
        assert_eq!(scalar, B::scalar(dot.into()));
        assert_eq!(A::narrow(scalar).into(), B::narrow(scalar));
        let wider = A::Scalar::nearest(1e5 * constant);
        assert_eq!(A::narrow(wider).into(), B::narrow(wider));
        assert_eq!(A::lane(scalar).to_f64(), B::lane(scalar).to_f64());
        assert_eq!(A::of_lane(a[0]), B::of_lane(u[0]));
        for level in [scalar, wider, A::Scalar::nearest(1e12)] {
            assert_eq!(A::of_level(A::level(level)), B::of_level(B::level(level)));
        }
        if square.into() != 0 {
            let rim = A::rim(a, A::wide(0.01), b, A::square(b), A::wide(0.14));
            assert_eq!(exactly::<A, B>(rim), B::rim(u, B::wide(0.01), v, B::square(v), B::wide(0.14)));
        }
    }
}

#[test]
fn steps_are_those_of_i2f14() {
    assert_same_steps::<I2F14, FixedPoint<14>>(|wide| wide as i32);
}

#[test]
fn steps_are_those_of_i2f30() {
    assert_same_steps::<I2F30, FixedPoint<30>>(|wide| wide);
}

/// `cap` by the formula and `reflect` bit for bit; what ends with a unit vector within a step, since those formats make
/// it by hand, and within two where it is made of one as well.
fn assert_same_formulas<A: Real, B: Real>(step: f64) {
    for light in lights() {
        let theta = light.angular_radius();
        let (of_a, of_b) = (Constants::<A>::of(&light), Constants::<B>::of(&light));
        for pair in input::random(6, 20_000, theta).chain(input::hard(theta)) {
            let [l, r] = [pair.l, pair.r].map(|v| v.map(A::from_f64));
            let [m, s] = [exactly::<A, B>(l), exactly(r)];
            assert_eq!(exactly::<A, B>(formula::cap(l, r, &of_a.sphere)), cap(m, s, &of_b.sphere), "{l:?}, {r:?}");
            assert_eq!(exactly::<A, B>(reflect(l, r)), reflect(m, s), "{l:?}, {r:?}");
            for (method, steps) in [(Method::Factored, 1.0), (Method::Disc, 2.0), (Method::Epic, 1.0)] {
                let [a, b] =
                    [method.direction(l, r, &of_a).map(A::to_f64), method.direction(m, s, &of_b).map(B::to_f64)];
                let near = a.into_iter().zip(b).all(|(a, b)| (a - b).abs() <= steps * step);
                assert!(near, "{} at {l:?}, {r:?}: {b:?}, not {a:?}", method.name());
            }
        }
    }
}

#[test]
fn formulas_are_those_of_i2f14() {
    assert_same_formulas::<I2F14, FixedPoint<14>>(1.0 / 16_384.0);
}

#[test]
fn formulas_are_those_of_i2f30() {
    assert_same_formulas::<I2F30, FixedPoint<30>>(1.0 / 1_073_741_824.0);
}

/// I16F16 does nothing by hand, and unit vectors leave its integer bits empty.
#[test]
fn directions_are_those_of_i16f16() {
    assert_same_directions::<I16F16, FixedPoint<16>>(&[Method::Factored, Method::Disc, Method::Cap]);
}

#[test]
fn pixels_are_those_of_i16f16() {
    assert_same_pixels::<I16F16, FixedPoint<16>>(&Shading::ALL, 500);
}

/// Highlights that ask neither for `cap` nor for a unit vector.
const OVER_THE_DISC: [Shading; 3] = [Shading::DiscGgx, Shading::Directional, Shading::ConeGgx];

#[test]
fn pixels_are_those_of_i2f14() {
    assert_same_pixels::<I2F14, FixedPoint<14>>(&OVER_THE_DISC, 500);
}

#[test]
fn pixels_are_those_of_i2f30() {
    assert_same_pixels::<I2F30, FixedPoint<30>>(&OVER_THE_DISC, 500);
}

/// The step of the word that a type is, and its numbers: those beside 1.
struct Beside1(f64);

impl Visitor for Beside1 {
    type Output = [f64; 3];

    fn visit<T: Real>(self) -> [f64; 3] {
        let Self(step) = self;
        [1.0 - step, 1.0 - step / 2.0, 1.0 - 1.5 * step].map(|value| T::from_f64(value).to_f64())
    }
}

#[test]
fn every_word_has_a_type_with_its_step() {
    for word in Word::ALL {
        let step = word.step();
        let [beside, half, more] = word.visit(Beside1(step)).expect("a type");
        assert_eq!(beside, 1.0 - step, "{word}");
        assert!([1.0, beside].contains(&half) && [beside, beside - step].contains(&more), "{word}");
        if let Some(format) = word.format() {
            assert_eq!((step, word.width() as usize), (format.step(), format.width()), "{word}");
        }
    }
    assert_eq!(Word::Fixed { fraction: 31 }.visit(Beside1(0.1)), None);
    assert_eq!(Word::ALL.iter().filter(|word| word.format().is_some()).count(), 4);
}
