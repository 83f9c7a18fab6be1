//! The catalogue of failures of black bodies: the plain formula fails with the figure stated, this crate's does not;
//! and what no black body can be is dark.

mod exact;

use exact::worst;
use half::f16;
use micromath::F32;
use sunglint::Scalar;
use sunglint::blackbody::{
    BOLTZMANN, PLANCK, SPEED_OF_LIGHT, WideRange, peak_frequency, peak_wavelength, radiance_per_frequency,
    radiance_per_wavelength, radiant_exitance, relative_to_peak, relative_to_peak_frequency, tint, total_radiance,
};
use sunglint::oracle::planck::Law;
use sunglint::real::Scaled;
use sunglint::trial::Format;
use sunglint::trial::blackbody::{RELATIVE, SPECTRAL};

/// The formula as it stands, in f32.
fn plain_f32(wavelength: f32, temperature: f32) -> f32 {
    let (h, c, k) = (PLANCK as f32, SPEED_OF_LIGHT as f32, BOLTZMANN as f32);
    2.0 * h * c * c / wavelength.powi(5) / ((h * c / (wavelength * k * temperature)).exp() - 1.0)
}

fn relative_to_truth(value: f32, wavelength: f32, temperature: f32) -> f64 {
    f64::from(value) / Law::Wavelength.radiance(wavelength.into(), temperature.into()) - 1.0
}

/// An exponent of 99.7: the exponential overflows f32, and the plain formula says 0 where the answer is 7e-22.
#[test]
fn f32_at_25_nanometres_the_plain_exponential_overflows() {
    let (wavelength, sun) = (2.5e-8, 5772.0);
    assert_eq!(plain_f32(wavelength, sun), 0.0);
    let ours = radiance_per_wavelength(wavelength, sun);
    let error = relative_to_truth(ours, wavelength, sun);
    println!("{ours:e}, relative error {error:e}");
    assert!(ours > 0.0 && error.abs() < 100.7 * SPECTRAL[0][1]);
}

/// 5 nanometres: `lambda^5` is a subnormal number and the exponential infinite; 0.1 nanometres: 0 times infinity.
#[test]
fn f32_at_a_tenth_of_a_nanometre_the_plain_formula_is_nan() {
    let plain = |wavelength: f32| wavelength.powi(-5) * (1.0 / (1.4388e-2 / (wavelength * 5772.0)).exp_m1());
    assert!(plain(1e-10).is_nan());
    assert_eq!(radiance_per_wavelength(1e-10_f32, 5772.0), 0.0);
}

/// An exponent of 2.5e-6 is 21 steps of f32 above 1: what is left of the exponential is off by up to half a step.
#[test]
fn f32_at_one_metre_the_plain_difference_is_two_per_cent_wrong() {
    let worst_of = |law: fn(f32, f32) -> f32| {
        let wavelengths = (0..2000).map(|step| 0.9 + 1e-4 * step as f32);
        worst(wavelengths.map(|wavelength| relative_to_truth(law(wavelength, 5772.0), wavelength, 5772.0).abs()))
    };
    let [plain, ours] = [plain_f32, radiance_per_wavelength::<f32>].map(worst_of);
    println!("plain {plain:e}, ours {ours:e}");
    assert!((0.02..0.03).contains(&plain), "{plain}");
    assert!(ours < SPECTRAL[0][1], "{ours}");
}

/// In f16 the plain relative form overflows below a ratio of 0.45, whose answer is 0.1.
#[test]
fn f16_the_plain_relative_form_overflows() {
    let plain = |ratio: f16| {
        let power = ratio * ratio * ratio * ratio * ratio;
        let exponential = f16::from_f32((f16::from_f32(4.965_114) / ratio).to_f32().exp());
        f16::from_f32(142.325) / power / (exponential - f16::ONE)
    };
    let ratio = f16::from_f32(0.4);
    let truth = Law::Wavelength.relative(ratio.to_f64());
    assert_eq!(plain(ratio), f16::ZERO);
    let ours = relative_to_peak(ratio).to_f64();
    println!("{truth}: {ours}");
    assert!((ours / truth - 1.0).abs() < 2.0 * RELATIVE[0][Format::F16 as usize]);
}

/// Temperatures, wavelengths and ratios that are none, and the ends of the range.
#[test]
fn what_cannot_be_is_dark() {
    fn check<S: WideRange>() {
        let [good, infinity] = [1.0, f64::INFINITY].map(S::nearest);
        for bad in [0.0, -1.0, f64::NAN].map(S::nearest) {
            for law in [radiance_per_wavelength::<S>, radiance_per_frequency::<S>] {
                assert_eq!([law(good, bad), law(bad, good)], [S::ZERO; 2]);
            }
            for law in [radiant_exitance::<S>, total_radiance, peak_wavelength, peak_frequency] {
                assert_eq!(law(bad), S::ZERO);
            }
        }
        let ends = [1e-45, 1e-38, 1e-20, 1e-10, 1.0, 1e10, 1e20, 1e38].map(S::nearest);
        for at in ends.into_iter().chain([infinity, S::MAX]) {
            for temperature in ends.into_iter().chain([infinity, S::MAX]) {
                for law in [radiance_per_wavelength::<S>, radiance_per_frequency::<S>] {
                    let answer = law(at, temperature);
                    assert!(answer >= S::ZERO && answer <= S::MAX, "{at:?} {temperature:?} {answer:?}");
                }
            }
        }
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    check::<Scaled>();
}

#[test]
fn ratios_and_tints_that_cannot_be_are_dark() {
    fn check<S: Scalar>() {
        let [one, most] = [S::ONE, S::MAX];
        for bad in [0.0, -1.0, f64::NAN].map(S::nearest) {
            assert_eq!([relative_to_peak(bad), relative_to_peak_frequency(bad)], [S::ZERO; 2]);
            assert_eq!(tint(bad, [one; 3]), [S::ZERO; 3]);
            assert_eq!(tint(one, [one, bad, one]), [S::ZERO; 3]);
        }
        for ratio in [S::nearest(6e-8), most, S::nearest(f64::INFINITY)] {
            for answer in [relative_to_peak(ratio), relative_to_peak_frequency(ratio)] {
                assert!(answer >= S::ZERO && answer < S::nearest(1e-4), "{ratio:?} {answer:?}");
            }
        }
        for temperature in [S::nearest(1e-4), one, S::nearest(6e4), most] {
            let levels = tint(temperature, [0.611, 0.549, 0.464].map(S::nearest));
            assert!(levels.into_iter().all(|level| level >= S::ZERO && level <= one), "{temperature:?} {levels:?}");
        }
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    check::<f16>();
    check::<Scaled>();
}
