//! What the tests measure with: arithmetic in 192 bits, errors in units of the last place, and samples.
#![allow(dead_code, unused_imports)] // Every test file uses its own part of this.

pub mod lights;

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use oorandom::Rand64;
use sunglint::Float;
pub use sunglint::trial::found::{worse, worst};

pub type Big = FBig<HalfEven, 2>;

const PRECISION: usize = 192;

/// Exact; every operation on it rounds to 192 bits.
pub fn big(value: f64) -> Big {
    Big::try_from(value).unwrap().with_precision(PRECISION).value()
}

/// `bits / 2^fraction`, exact.
pub fn fixed(bits: i128, fraction: u32) -> Big {
    Big::from(bits).with_precision(PRECISION).value() >> fraction as isize
}

pub fn pi() -> Big {
    Big::pi(PRECISION)
}

pub fn square(value: &Big) -> Big {
    value * value
}

/// Cosine of an angle of at most 90 degrees from its sine.
pub fn cosine(sine: &Big) -> Big {
    (big(1.0) - square(sine)).sqrt()
}

/// `1 - cos` of an angle of at most 90 degrees from its sine.
pub fn versine(sine: &Big) -> Big {
    square(sine) / (big(1.0) + cosine(sine))
}

/// Distance from `truth` in units of `2^exponent`.
pub fn distance(computed: &Big, truth: &Big, exponent: i32) -> f64 {
    ((computed - truth) >> exponent as isize).to_f64().value().abs()
}

/// Distance from `truth` in units of the last place that the format has there.
pub fn ulps<T: Float>(computed: T, truth: &Big) -> f64 {
    distance(&big(computed.exact()), truth, last_place::<T>(truth))
}

/// Distance from `truth` in units of the last place of a fixed-point format.
pub fn lsbs(bits: i128, fraction: u32, truth: &Big) -> f64 {
    distance(&fixed(bits, fraction), truth, -(fraction as i32))
}

/// Exponent of the format's last place at `truth`.
pub fn last_place<T: Float>(truth: &Big) -> i32 {
    let (digits, least) = match T::FORMAT {
        "f64" => (53, -1074),
        "f16" => (11, -24),
        _ => (24, -149),
    };
    let size = truth.to_f64().value().abs();
    if size == 0.0 { least } else { least.max(libm::ilogb(size) + 1 - digits) }
}

/// Holds a bound, and holds it to be no looser than four times what occurs.
pub fn assert_tight(name: &str, worst: f64, bound: f64) {
    println!("{name}: worst {worst:.4e}, bound {bound:.4e}");
    assert!(worst <= bound, "{name}: {worst} is above {bound}");
    assert!(worst >= bound / 4.0, "{name}: {bound} is far above {worst}");
}

/// `count` numbers from `least` to `most`, evenly spread logarithms, ends included; then as many random ones of
/// either spread.
pub fn spread(count: u32, least: f64, most: f64) -> impl Iterator<Item = f64> {
    let mut source = Rand64::new(u128::from(count));
    let logarithmic = move |part: f64| (least * (most / least).powf(part)).clamp(least, most);
    let even = (0..=count).map(move |i| logarithmic(f64::from(i) / f64::from(count)));
    let random = (0..count).map(move |i| match source.rand_float() {
        part if i % 2 == 0 => logarithmic(part),
        part => least + (most - least) * part,
    });
    even.chain(random)
}

/// Ratios of all sizes in Q30 bits: both ends, the least ones, and from 1e-6 to 1.
pub fn ratios_q30(count: u32) -> impl Iterator<Item = i32> {
    let bits = spread(count, 1e-6, 1.0).map(|ratio| (ratio * f64::from(1 << 30)) as i32);
    (0..=16).chain([1073, 1074, (1 << 30) - 1, 1 << 30]).chain(bits)
}
