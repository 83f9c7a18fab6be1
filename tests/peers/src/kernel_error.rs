//! Worst errors of the peers' kernels against f64, as the CSV that stands beside the counts of their instructions.

use core::f64::consts::{PI, TAU};

use fixed::types::{I2F14, I2F30, I3F29, I16F16, U16F16};
use sunglint::oracle::angle_between;
use sunglint::trial::chip::peers::Peer;
use sunglint::trial::{Found, Method, input};
use sunglint::{Real, SUN};

use crate::kernels::f32::{self as floats, Libm, Micromath, Roots};
use crate::kernels::fixed::Number;
use crate::kernels::{CORDIC, FIXED, IDSP, LIBM, MICROMATH, cordic, fixed as operators, idsp};
use crate::vector_error;

/// Names of the columns.
pub const HEADER: &str = "function,format,by,error,unit,how,note";

/// Numbers of 32 bits are tried at this stride, a prime, which makes 70 million of them.
const STRIDE: usize = 61;

/// The same for what takes microseconds a call.
const SLOW_STRIDE: usize = 4001;

/// Below this, 1 in Q16, where steps count most, all of them are.
const BELOW_ONE: u32 = 1 << 16;

/// Random vectors.
const SAMPLES: usize = 200_000;

/// From here on the root of `cordic` never returns.
pub const CORDIC_HANGS: f64 = 16384.0;

/// A line of the CSV.
pub fn line(Peer { function, format, by, error, unit, how, note }: &Peer) -> String {
    format!("{function},{format},{by},{error:.3e},{unit},{how},{note}")
}

const RANDOM: &str = "200 000 random";
const LEVELS: &str = "all below 1; every 61st";
const EVERY_4001ST: &str = "every 4001st";

/// All of them.
pub fn rows() -> Vec<Peer> {
    let approximate = "by the exponent's bits: lengths are off by up to 3.4 %";
    let root = |format, by, error, how, note| Peer { function: "root", format, by, error, unit: "ULP", how, note };
    let turn =
        |format, by, error, how, note| Peer { function: "sin_cos", format, by, error, unit: "absolute", how, note };
    of_floats::<Libm>(LIBM, "")
        .into_iter()
        .chain(of_floats::<Micromath>(MICROMATH, approximate))
        .chain(of_fixed::<I2F14>("wraps from a length of 1.41 on"))
        .chain(of_fixed::<I2F30>("wraps from a length of 1.41 on"))
        .chain(of_fixed::<I16F16>("wraps from a length of 181 on"))
        .chain([
            root("U16F16", FIXED, level_root(1.0, operators::root), LEVELS, "floors"),
            Peer { function: "reciprocal root", ..root("U16F16", FIXED, level_reciprocal(), LEVELS, "of 2^-16 on") },
            root(
                "I16F16",
                CORDIC,
                cordic_root(),
                "all below 1; every 4001st",
                "below 16384: from there on it never returns",
            ),
            turn("I3F29", CORDIC, cordic_turn(), EVERY_4001ST, "of radians from -pi to pi"),
            turn("Q31", IDSP, idsp_turn(), "every 61st", "of a turn"),
        ])
        .collect()
}

fn of_floats<R: Roots>(by: &'static str, note: &'static str) -> Vec<Peer> {
    let row = |function, error, unit, how| Peer { function, format: "f32", by, error, unit, how, note };
    let [normalize] = vector_error::normalize([&|v| floats::normalize::<R>(&v)]);
    let direction = |method, call: fn(&floats::Ray) -> [f32; 3]| {
        let [error] = vector_error::direction(method, [&|l, r| call(&[l, r])]);
        error
    };
    const ALL: &str = "all from 1 to 4";
    vec![
        row("factored", direction(Method::Factored, floats::factored::<R>), "rad", RANDOM),
        row("cap", direction(Method::Cap, floats::cap::<R>), "rad", RANDOM),
        row("normalize", normalize, "rad", RANDOM),
        row("root", float_error(floats::root::<R>, f64::sqrt), "ULP", ALL),
        row("reciprocal root", float_error(floats::reciprocal_root::<R>, |x| 1.0 / x.sqrt()), "ULP", ALL),
    ]
}

/// Units of the last place of the exact value, for all numbers from 1 to 4, which are those of all exponents.
fn float_error(call: fn(&f32) -> f32, truth: fn(f64) -> f64) -> f64 {
    let error = |bits| {
        let x = f32::from_bits(bits);
        let exact = truth(x.into());
        (f64::from(call(&x)) - exact).abs() / (exact.log2().floor() - 23.0).exp2()
    };
    (1_f32.to_bits()..4_f32.to_bits()).map(error).fold(0.0, f64::max)
}

fn of_fixed<T: Real + Number>(note: &'static str) -> Vec<Peer> {
    let row = |function, error, unit| Peer { function, format: T::NAME, by: FIXED, error, unit, how: RANDOM, note };
    let (mut normalize, mut dot) = (Found::<3>::new(), Found::<3>::new());
    let one = T::from_f64(1.0).to_f64();
    // The step of the format, which is that of the dot product by `*`.
    let step =
        (2..40).map(|bits| (-f64::from(bits)).exp2()).find(|&step| T::from_f64(step / 2.0).to_f64() != step / 2.0);
    let step = step.unwrap_or(one);
    for (index, pair) in input::random(1, SAMPLES, SUN.angular_radius()).enumerate() {
        let length = 0.1 + (index % 1000) as f64 / 1000.0;
        let v = pair.r.map(|lane| T::from_f64(length * lane));
        let exact = v.map(T::to_f64);
        normalize.add(angle_between(operators::normalize(&v).map(T::to_f64), exact), exact);
        let [a, b] = [pair.l, pair.r].map(|v| v.map(T::from_f64));
        let truth: f64 = a.iter().zip(b).map(|(a, b)| a.to_f64() * b.to_f64()).sum();
        dot.add((operators::dot(&[a, b]).to_f64() - truth).abs() / step, exact);
    }
    vec![row("dot", dot.max, "ULP"), row("normalize", normalize.max, "rad")]
}

/// The root of `fixed`, in steps of U16F16.
fn level_root(from: f64, call: fn(&U16F16) -> U16F16) -> f64 {
    level_error(from as u32, call, f64::sqrt)
}

fn level_reciprocal() -> f64 {
    level_error(1, operators::reciprocal_root, |x| 1.0 / x.sqrt())
}

fn level_error(from: u32, call: fn(&U16F16) -> U16F16, truth: fn(f64) -> f64) -> f64 {
    let error = |bits| {
        let x = U16F16::from_bits(bits);
        (call(&x).to_num::<f64>() - truth(x.to_num())).abs() * 65536.0
    };
    (from..BELOW_ONE).chain((BELOW_ONE..=u32::MAX).step_by(STRIDE)).map(error).fold(0.0, f64::max)
}

fn cordic_root() -> f64 {
    let error = |bits| {
        let x = I16F16::from_bits(bits);
        (cordic::root(&x).to_num::<f64>() - x.to_num::<f64>().sqrt()).abs() * 65536.0
    };
    let below_one = BELOW_ONE as i32;
    let others = (below_one..(CORDIC_HANGS * 65536.0) as i32).step_by(SLOW_STRIDE);
    (1..below_one).chain(others).map(error).fold(0.0, f64::max)
}

fn cordic_turn() -> f64 {
    let end = (PI * f64::from(1 << 29)) as i32;
    let error = |bits| {
        let angle = I3F29::from_bits(bits);
        worst_of(cordic::sin_cos(&angle).map(|value| value.to_num()), angle.to_num())
    };
    (-end..=end).step_by(SLOW_STRIDE).map(error).fold(0.0, f64::max)
}

fn idsp_turn() -> f64 {
    let error = |turn| {
        let sin_cos = idsp::sin_cos(&turn).map(|value| f64::from(value) / 2_147_483_648.0);
        worst_of(sin_cos, TAU * f64::from(turn) / 4_294_967_296.0)
    };
    (i32::MIN..=i32::MAX).step_by(STRIDE).map(error).fold(0.0, f64::max)
}

fn worst_of([sine, cosine]: [f64; 2], angle: f64) -> f64 {
    (sine - angle.sin()).abs().max((cosine - angle.cos()).abs())
}
