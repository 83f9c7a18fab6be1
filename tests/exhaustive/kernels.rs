//! The list of kernels, each with its inputs, its judge and its bound.

use ::fixed::types::{I2F14, I2F30, I16F16};
use half::f16;
use micromath::F32;
use sunglint::normalization::{
    inverse_size_factor_q30, size_factor_q30, solid_angle_q30, sun_radius_at_q16, versine_q30, white_radiance_q30,
};
use sunglint::oracle::planck::Law;
use sunglint::raw::{normalize_q14, reciprocal_root_q16, relative_to_peak_frequency_q16, relative_to_peak_q16};
use sunglint::real::Scaled;
use sunglint::trial::found::worse;
use sunglint::trial::quantity::Quantity;
use sunglint::trial::{Format, mantissa};
use sunglint::{DistantSphere, LightError, Scalar};

use crate::{floats, integers};

/// A kernel of one argument, or of two short ones, by the bits of its input.
pub struct Kernel {
    pub name: &'static str,
    pub format: &'static str,
    /// The first and the last bits.
    pub inputs: [u64; 2],
    /// What errors are counted in.
    pub unit: &'static str,
    pub bound: f64,
    /// NaN for an answer or an error that is plainly wrong.
    pub error: Box<dyn Fn(u64) -> f64 + Sync>,
}

/// Every pattern of 32 bits, and of 16.
const ALL: [u64; 2] = [0, u32::MAX as u64];
const ALL_16: [u64; 2] = [0, u16::MAX as u64];

/// 2^32 in f64.
const TWO_32: f64 = 4_294_967_296.0;

fn kernel(
    [name, format, unit]: [&'static str; 3],
    inputs: [u64; 2],
    bound: f64,
    error: impl Fn(u64) -> f64 + Sync + 'static,
) -> Kernel {
    Kernel { name, format, inputs, unit, bound, error: Box::new(error) }
}

pub fn all() -> Vec<Kernel> {
    let lists = [mantissas(), roots(), quantities(), spheres(), sun_radii(), turns(), planck(), pairs()];
    lists.into_iter().flatten().collect()
}

/// Exact to 1e-6 of the last place: f64 has 21 digits more.
fn mantissas() -> Vec<Kernel> {
    let (least, half) = (1_u64 << 30, (1_u64 << 31) - 1);
    // What is one less than a whole, because that would not fit, stands for the whole.
    let held = |exact: f64| exact.min(TWO_32 - 1.0);
    let reciprocal = move |m: u64| {
        f64::from(mantissa::fraction_of_reciprocal(m as u32)) - held(TWO_32 * (TWO_32 / 2.0) / m as f64 - TWO_32)
    };
    vec![
        // On chips without products of 64 bits it is made of halves, and so are all that are made of the same parts.
        kernel(["reciprocal_root", "Q31", "ULP"], [least, ALL[1]], 0.573, |m| {
            let [words, halves] = mantissa::by_words_and_halves(m as u32);
            let exact = TWO_32 / 2.0 / ((m as f64 + 0.5) / TWO_32).sqrt();
            if words == halves { f64::from(mantissa::reciprocal_root(m as u32)) - exact } else { f64::NAN }
        }),
        kernel(["fraction_of_reciprocal_root", "Q32", "ULP"], [least, ALL[1]], 0.65, move |m| {
            let exact = TWO_32 / (m as f64 / TWO_32).sqrt() - TWO_32;
            f64::from(mantissa::fraction_of_reciprocal_root(m as u32)) - held(exact)
        }),
        kernel(["fraction_of_reciprocal", "Q32", "ULP"], [least, half], 0.54, reciprocal),
        kernel(["reciprocal", "Scaled", "ULP"], [least, half], 0.77, |m| {
            let quotient = Scaled::ONE / Scaled::from_bits(m as i64, -31);
            // From 1 to 2 the last place is 2^-30.
            quotient.to_unsigned(30) as f64 - TWO_32 / 2.0 * (TWO_32 / 4.0) / m as f64
        }),
        // Half a unit, and the reciprocal's error in units of the quotient, which are finest where that is just under a
        // power of two; no dividend can be worse.
        kernel(["quotient, any dividend", "Scaled", "ULP"], [least, half], 0.77, move |m| {
            0.5 + reciprocal(m).abs() * (m as f64 / TWO_32)
        }),
        // Every mantissa with an even exponent, then with an odd one.
        kernel(["root", "Scaled", "ULP"], [0, half], 0.77, |bits| {
            let (mantissa, odd) = ((bits | 1 << 30) & ((1 << 31) - 1), (bits >> 30) as i32);
            let root = Scaled::from_bits(mantissa as i64, odd - 31).root();
            let exact = (mantissa as f64 / TWO_32 * f64::from(2 << odd)).sqrt();
            let last = if exact < 1.0 { 31 } else { 30 };
            root.to_unsigned(last) as f64 - exact * f64::from(1_u32 << last)
        }),
    ]
}

fn roots() -> Vec<Kernel> {
    vec![
        kernel(["root", "f32", "ULP"], ALL, 0.51, floats::root::<f32>),
        kernel(["root", "f16", "ULP"], ALL_16, 0.51, floats::root::<f16>),
        kernel(["root", "micromath", "ULP"], ALL, 87.0, floats::root::<F32>),
        // Correctly rounded: the roots in f64 are nearer to the truth than that is to the middle between two f32.
        kernel(["soft::root", "f32", "ULP"], ALL, 0.5, floats::soft_root),
        kernel(["soft::reciprocal_root", "f32", "ULP"], ALL, 0.5, floats::soft_reciprocal_root),
        kernel(["reciprocal_root_q16", "U16F16", "ULP"], ALL, 0.5003, |bits| {
            let answer = reciprocal_root_q16(bits as u32);
            if bits == 0 {
                return if answer == u32::MAX { 0.0 } else { f64::NAN };
            }
            f64::from(answer) - f64::from(1 << 24) / (bits as f64).sqrt()
        }),
    ]
}

fn quantities() -> Vec<Kernel> {
    let mut kernels = vec![];
    for quantity in Quantity::ALL {
        let name = quantity.name();
        kernels.push(kernel([name, "f32", "ULP"], ALL, 0.76, move |bits| floats::quantity::<f32>(quantity, bits)));
        kernels.push(kernel([name, "f16", "ULP"], ALL_16, 0.8, move |bits| floats::quantity::<f16>(quantity, bits)));
        kernels.push(kernel([name, "I2F30", "LSB"], ALL, 0.51, move |bits| fixed_quantity(quantity, bits)));
    }
    kernels
}

fn fixed_quantity(quantity: Quantity, bits: u64) -> f64 {
    let ratio = I2F30::from_bits(bits as i32);
    let answer = match quantity {
        Quantity::Versine => versine_q30(ratio).map(|answer| integers::versine(bits, answer.to_bits(), 48)),
        Quantity::SolidAngle => solid_angle_q30(ratio).map(|answer| integers::solid_angle(bits, answer.to_bits())),
        Quantity::SizeFactor if bits == 0 => size_factor_q30(ratio).map(|answer| answer.to_num::<f64>() - 1.0),
        Quantity::SizeFactor => size_factor_q30(ratio).map(|answer| integers::size_factor(bits, answer.to_bits())),
        Quantity::InverseSizeFactor if bits == 0 => {
            inverse_size_factor_q30(ratio).map(|answer| answer.to_num::<f64>() - 1.0)
        }
        Quantity::InverseSizeFactor => {
            inverse_size_factor_q30(ratio).map(|answer| integers::inverse_size_factor(bits, answer.to_bits()))
        }
        Quantity::WhiteRadiance => {
            white_radiance_q30(ratio).map(|answer| integers::white_radiance(bits, answer.to_bits()))
        }
    };
    match answer {
        Ok(error) if bits <= 1 << 30 => error,
        Err(LightError::RatioQ30(held)) if bits > 1 << 30 && held == bits as i32 => 0.0,
        Err(LightError::Overflow("U52F12")) => {
            let least = if quantity == Quantity::WhiteRadiance { 16 } else { 9 };
            if bits <= least { 0.0 } else { f64::NAN }
        }
        _ => f64::NAN,
    }
}

fn spheres() -> Vec<Kernel> {
    vec![
        kernel(["from_ratio", "f32", "ULP"], ALL, 0.76, floats::sphere::<f32>),
        // The root, which is micromath's own, is in the versine; all else is f32's bit by bit.
        kernel(["from_ratio", "micromath", "ULP"], ALL, 0.76, floats::sphere::<F32>),
        kernel(["from_ratio", "f16", "ULP"], ALL_16, 0.8, floats::sphere::<f16>),
        kernel(["from_ratio_q30", "I2F14", "LSB"], ALL, 0.51, |bits| {
            let sphere = DistantSphere::<I2F14>::from_ratio_q30(I2F30::from_bits(bits as i32));
            sphere_error(bits, 28, sphere.map(|s| [s.sin(), s.sin_square(), s.cos(), s.versine()].map(i64::from)))
        }),
        kernel(["from_ratio_q30", "I2F30", "LSB"], ALL, 0.75, |bits| {
            let sphere = DistantSphere::<I2F30>::from_ratio_q30(I2F30::from_bits(bits as i32));
            sphere_error(bits, 60, sphere.map(|s| [s.sin(), s.sin_square(), s.cos(), s.versine()]))
        }),
        kernel(["from_ratio_q30", "I16F16", "LSB"], ALL, 0.51, |bits| {
            let sphere = DistantSphere::<I16F16>::from_ratio_q30(I2F30::from_bits(bits as i32));
            sphere_error(bits, 32, sphere.map(|s| [s.sin(), s.sin_square(), s.cos(), s.versine()]))
        }),
    ]
}

/// The greatest error of the four constants of a light.
fn sphere_error(bits: u64, fraction: u32, sphere: Result<[i64; 4], LightError>) -> f64 {
    match sphere {
        Ok(constants) if bits <= 1 << 30 => {
            let [sin, sin_square, cos, versine] = constants.map(|bits| bits as u64);
            let errors = [
                integers::rounded(bits << 30, sin, fraction),
                integers::rounded(bits * bits, sin_square, fraction),
                integers::cos(bits, cos, fraction),
                integers::versine(bits, versine, fraction),
            ];
            errors.into_iter().map(f64::abs).fold(0.0, worse)
        }
        Err(LightError::RatioQ30(held)) if bits > 1 << 30 && held == bits as i32 => 0.0,
        _ => f64::NAN,
    }
}

fn sun_radii() -> Vec<Kernel> {
    vec![
        kernel(["sun_radius_at", "f32", "ULP"], ALL, 0.76, floats::sun_radius::<f32>),
        kernel(["sun_radius_at", "f16", "ULP"], ALL_16, 0.8, floats::sun_radius::<f16>),
        kernel(["sun_radius_at_q16", "I16F16", "LSB"], ALL, 0.51, |bits| {
            match sun_radius_at_q16(I16F16::from_bits(bits as i32)) {
                Ok(radius) => {
                    let answer = i128::from(radius.to_bits()) * 1_495_978_707;
                    (answer - i128::from(bits) * 6_957_000) as f64 / 1_495_978_707.0
                }
                Err(LightError::DistanceBits(held)) if held == bits as i32 && held <= 0 => 0.0,
                Err(_) => f64::NAN,
            }
        }),
    ]
}

fn turns() -> Vec<Kernel> {
    let one = |format: Format| format.bits(1.0);
    let steps = |format: Format| format.step();
    let from_0_to_1 = |format: Format| [0, one(format)];
    vec![
        kernel(["sin_cos", "f32", "step"], from_0_to_1(Format::F32), 1.5, move |bits| {
            floats::turn(f32::from_bits(bits as u32), steps(Format::F32))
        }),
        kernel(["sin_cos", "f16", "step"], from_0_to_1(Format::F16), 1.5, move |bits| {
            floats::turn(f16::from_bits(bits as u16), steps(Format::F16))
        }),
        kernel(["sin_cos", "I2F14", "step"], from_0_to_1(Format::I2F14), 0.6, move |bits| {
            floats::turn(I2F14::from_bits(bits as i16), steps(Format::I2F14))
        }),
        kernel(["sin_cos", "I2F30", "step"], from_0_to_1(Format::I2F30), 1.0, move |bits| {
            floats::turn(I2F30::from_bits(bits as i32), steps(Format::I2F30))
        }),
        kernel(["sin_cos", "I16F16", "step"], from_0_to_1(Format::I16F16), 0.6, move |bits| {
            floats::turn(I16F16::from_bits(bits as i32), steps(Format::I16F16))
        }),
    ]
}

fn planck() -> Vec<Kernel> {
    let raw = |law: Law, bits: u64| {
        let (bits, exact) = (bits as u32, bits as f64 / 65_536.0);
        let answer = match law {
            Law::Wavelength => relative_to_peak_q16(bits),
            Law::Frequency => relative_to_peak_frequency_q16(bits),
        };
        let truth = if bits == 0 { 0.0 } else { floats::planck(law, exact) };
        f64::from(answer) - truth * f64::from(1 << 30)
    };
    let mut kernels = vec![];
    // From 2^-16 to 2^16: on either side the answers are too small for the absolute error to count, or it falls with
    // them.
    let span = [2.0_f32.powi(-16), 65_536.0].map(|ratio| u64::from(ratio.to_bits()));
    // Up to 1024: beyond, the laws are below 3e-2 of Q30's last bit.
    let last = (1 << 26) - 1;
    for (law, name, integer) in [
        (Law::Wavelength, "relative_to_peak", "relative_to_peak_q16"),
        (Law::Frequency, "relative_to_peak_frequency", "relative_to_peak_frequency_q16"),
    ] {
        kernels.push(kernel([name, "f32", "step"], span, 6.0, move |bits| floats::relative::<f32>(law, bits)));
        kernels.push(kernel([name, "f16", "step"], ALL_16, 6.0, move |bits| floats::relative::<f16>(law, bits)));
        kernels.push(kernel([integer, "Scaled", "LSB of Q30"], [0, last], 5.0, move |bits| raw(law, bits)));
    }
    kernels
}

/// Two arguments of 16 bits, the first in the high bits.
fn pairs() -> Vec<Kernel> {
    vec![
        kernel(["karis", "f16", "ULP"], ALL, 4.0, floats::karis_of),
        kernel(["exact_rp", "f16", "ULP"], ALL, 4.0, floats::exact_rp_of),
        kernel(["radiance, from 0.001 and 1/2048", "f16", "ULP"], ALL, 0.8, floats::radiance_of),
        kernel(["normalize_q14, (x, y, 0)", "I2F14", "LSB"], ALL, 0.78, |bits| {
            let [x, y] = [(bits >> 16) as i16, bits as i16];
            let [a, b, c] = normalize_q14([x, y, 0]);
            let [p, q] = [x, y].map(f64::from);
            let length = (p * p + q * q).sqrt();
            if length == 0.0 {
                return if [a, b, c] == [0; 3] { 0.0 } else { f64::NAN };
            }
            let off = |answer: i16, lane: f64| (f64::from(answer) - lane / length * 16_384.0).abs();
            if c == 0 { off(a, p).max(off(b, q)) } else { f64::NAN }
        }),
    ]
}
