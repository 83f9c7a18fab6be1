//! Black bodies: every law in every format against an oracle that is itself held to 192 bits, the laws that integrate
//! and displace Planck's, and the ways in which the plain formula fails.

mod exact;

use std::f64::consts::PI;

use exact::{Big, assert_tight, big, distance, last_place, pi, spread, worse, worst};
use half::f16;
use micromath::F32;
use sunglint::blackbody::{
    BOLTZMANN, PLANCK, SECOND_RADIATION, SPEED_OF_LIGHT, STEFAN_BOLTZMANN, SUN_TEMPERATURE, WIEN_FREQUENCY,
    WIEN_WAVELENGTH, WideRange, peak_frequency, peak_wavelength, radiance_per_frequency, radiance_per_wavelength,
    radiant_exitance, relative_to_peak, relative_to_peak_frequency, tint, total_radiance,
};
use sunglint::oracle::planck::Law;
use sunglint::raw::{relative_to_peak_frequency_q16, relative_to_peak_q16, tint_q16};
use sunglint::real::Scaled;
use sunglint::trial::blackbody::{
    ABSOLUTE, DOMAIN, RELATIVE, SPAN, SPECTRAL, TINT, absolute_error, error_at, relative, relative_error, spectral,
    spectral_error, tint_error,
};
use sunglint::trial::{Format, Found, Visitor};
use sunglint::{Real, SUN, Scalar};

const COUNT: usize = 20_000;

#[derive(Clone, Copy, Debug)]
enum Kernel {
    Relative(Law),
    Absolute(Law),
    Tint,
}

impl Kernel {
    const ALL: [Self; 5] = [
        Self::Relative(Law::Wavelength),
        Self::Relative(Law::Frequency),
        Self::Absolute(Law::Wavelength),
        Self::Absolute(Law::Frequency),
        Self::Tint,
    ];

    fn budget(self, format: Format) -> f64 {
        match self {
            Self::Relative(law) => RELATIVE[law as usize][format as usize],
            Self::Absolute(law) => ABSOLUTE[law as usize][format as usize],
            Self::Tint => TINT[format as usize],
        }
    }
}

struct Trial {
    kernel: Kernel,
    seed: u64,
    count: usize,
}

impl Visitor for Trial {
    type Output = Found;

    fn visit<T: Real>(self) -> Found {
        match self.kernel {
            Kernel::Relative(law) => relative_error::<T>(law, self.seed, self.count),
            Kernel::Absolute(law) => absolute_error::<T>(law, self.seed, self.count),
            Kernel::Tint => tint_error::<T>(self.seed, self.count),
        }
    }
}

fn spectral_errors(law: Law, seed: u64, count: usize) -> [Found; 4] {
    [
        spectral_error::<f64>(law, seed, count),
        spectral_error::<f32>(law, seed, count),
        spectral_error::<F32>(law, seed, count),
        spectral_error::<Scaled>(law, seed, count),
    ]
}

#[test]
fn every_kernel_keeps_its_budget_in_every_format() {
    for kernel in Kernel::ALL {
        for format in Format::ALL {
            let found = format.visit(Trial { kernel, seed: 1, count: COUNT });
            assert_tight(&format!("{kernel:?} in {}", format.name()), found.max, kernel.budget(format));
        }
    }
}

#[test]
fn the_laws_in_si_units_keep_their_budgets() {
    for law in Law::ALL {
        for (index, found) in spectral_errors(law, 1, COUNT).into_iter().enumerate() {
            assert_tight(&format!("{law:?} in SI, scalar {index}"), found.max, SPECTRAL[law as usize][index]);
        }
    }
}

/// Where the budgets come from.
#[test]
#[ignore = "ten seconds in release: cargo test --release --test blackbody -- --ignored --nocapture"]
fn budgets_are_a_little_more_than_the_worst_of_300_000_inputs() {
    let mut stale = 0;
    let mut compare = |what: String, worst: f64, budget: f64| {
        println!("{what}: {:.3e}, is {budget:e}", 1.12 * worst);
        // Two digits, rounded up.
        stale += u32::from(!(budget / 1.11..=budget).contains(&(1.12 * worst)));
    };
    for kernel in Kernel::ALL {
        for format in Format::ALL {
            let found = [1, 2, 3].map(|seed| format.visit(Trial { kernel, seed, count: 100_000 }).max);
            compare(format!("{kernel:?} in {}", format.name()), worst(found.into_iter()), kernel.budget(format));
        }
    }
    for law in Law::ALL {
        let found = [1, 2, 3].map(|seed| spectral_errors(law, seed, 100_000).map(|found| found.max));
        for (index, budget) in SPECTRAL[law as usize].into_iter().enumerate() {
            compare(format!("{law:?} in SI, {index}"), worst(found.iter().map(|maxima| maxima[index])), budget);
        }
    }
    assert_eq!(stale, 0);
}

/// Every positive finite f16.
#[test]
fn all_of_f16() {
    for law in Law::ALL {
        let [least, most] = SPAN[law as usize];
        let (mut relative, mut absolute) = (0.0_f64, 0.0_f64);
        for ratio in (1..=f16::MAX.to_bits()).map(f16::from_bits) {
            let [error, truth] = error_at(law, ratio);
            let error = error.abs();
            absolute = worse(absolute, error);
            assert!(error.is_finite(), "{ratio}");
            if (least..=most).contains(&ratio.to_f64()) {
                relative = worse(relative, error / truth);
            }
        }
        assert_tight("relative, all of f16", relative, RELATIVE[law as usize][Format::F16 as usize]);
        assert_tight("absolute, all of f16", absolute, ABSOLUTE[law as usize][Format::F16 as usize]);
    }
}

/// The ends of what f16 holds as normal numbers, as the documentation has them.
#[test]
fn relative_laws_are_normal_in_f16_between_their_ends() {
    let least = f16::MIN_POSITIVE.to_f64();
    for (law, [first, last]) in [(Law::Wavelength, [0.224, 25.5]), (Law::Frequency, [3.3e-3, 6.4])] {
        for (ratio, inward) in [(first, 1.01), (last, 1.0 / 1.01)] {
            assert!(law.relative(ratio / inward) < least && law.relative(ratio * inward) > least, "{law:?} {ratio}");
        }
    }
}

fn power(base: &Big, exponent: u32) -> Big {
    (0..exponent).fold(big(1.0), |product, _| product * base)
}

/// The constants of 2019, which are decimal.
struct Si {
    planck: Big,
    light: Big,
    boltzmann: Big,
}

fn si() -> Si {
    let ten = |exponent| power(&big(10.0), exponent);
    Si { planck: big(662_607_015.0) / ten(42), light: big(299_792_458.0), boltzmann: big(1_380_649.0) / ten(29) }
}

/// The root of `a = n (1 - exp(-a))` by iteration, each of which gains a digit and more.
fn peak(law: Law) -> Big {
    let n = match law {
        Law::Wavelength => 5.0,
        Law::Frequency => 3.0,
    };
    (0..200).fold(big(n), |a, _| big(-n) * (-a).exp_m1())
}

/// The law in SI units, and its exponent.
fn spectral_truth(law: Law, at: f64, temperature: f64) -> [Big; 2] {
    let Si { planck, light, boltzmann } = si();
    let (at, heat) = (big(at), boltzmann * big(temperature));
    let two = big(2.0);
    match law {
        Law::Wavelength => {
            let exponent = &planck * &light / (&at * heat);
            [two * planck * power(&light, 2) / power(&at, 5) / exponent.exp_m1(), exponent]
        }
        Law::Frequency => {
            let exponent = &planck * &at / heat;
            [two * planck * power(&at, 3) / power(&light, 2) / exponent.exp_m1(), exponent]
        }
    }
}

fn relative_distance(computed: f64, truth: &Big) -> f64 {
    ((big(computed) - truth) / truth).to_f64().value().abs()
}

fn places(computed: f64, truth: &Big) -> f64 {
    distance(&big(computed), truth, last_place::<f64>(truth))
}

#[test]
fn the_relative_laws_in_f64_and_their_oracle_against_192_bits() {
    for law in Law::ALL {
        let [least, most] = SPAN[law as usize];
        let peak = peak(law);
        let errors = spread(300, least, most).map(|ratio| {
            let truth = match law {
                Law::Wavelength => peak.exp_m1() / (&peak / big(ratio)).exp_m1() / power(&big(ratio), 5),
                Law::Frequency => peak.exp_m1() / (&peak * big(ratio)).exp_m1() * power(&big(ratio), 3),
            };
            [relative(law, ratio), law.relative(ratio)].map(|value| relative_distance(value, &truth))
        });
        let errors: Vec<_> = errors.collect();
        assert_tight("f64", worst(errors.iter().map(|error| error[0])), RELATIVE[law as usize][0]);
        assert_tight("oracle", worst(errors.iter().map(|error| error[1])), 7e-16);
    }
}

#[test]
fn the_laws_in_si_units_in_f64_and_their_oracle_against_192_bits() {
    for law in Law::ALL {
        let [least, most] = DOMAIN[law as usize];
        let mut errors = vec![];
        for temperature in [10.0, 300.0, SUN_TEMPERATURE, 1e6] {
            for at in spread(100, least, most) {
                let [truth, exponent] = spectral_truth(law, at, temperature);
                let size = truth.to_f64().value();
                if size > f64::from(f32::MIN_POSITIVE) && size < f64::from(f32::MAX) {
                    let bound = 1.0 + exponent.to_f64().value();
                    errors.push(
                        [spectral(law, at, temperature), law.radiance(at, temperature)]
                            .map(|value| relative_distance(value, &truth) / bound),
                    );
                }
            }
        }
        assert_tight("f64", worst(errors.iter().map(|error| error[0])), SPECTRAL[law as usize][0]);
        assert_tight("oracle", worst(errors.iter().map(|error| error[1])), 9e-16);
    }
}

#[test]
fn constants_are_the_nearest_of_their_definitions() {
    let Si { planck, light, boltzmann } = si();
    let second = &planck * &light / &boltzmann;
    let sigma = big(2.0) * power(&pi(), 5) * power(&boltzmann, 4) / (big(15.0) * power(&planck, 3) * power(&light, 2));
    let constants = [
        (SECOND_RADIATION, second.clone()),
        (STEFAN_BOLTZMANN, sigma),
        (WIEN_WAVELENGTH, second / peak(Law::Wavelength)),
        (WIEN_FREQUENCY, peak(Law::Frequency) * &boltzmann / &planck),
        (PLANCK, planck),
        (SPEED_OF_LIGHT, light),
        (BOLTZMANN, boltzmann),
    ];
    for (constant, truth) in constants {
        assert!(places(constant, &truth) <= 0.5, "{constant:e}");
    }
}

/// Worst relative error of the laws without a spectrum.
fn total_error<S: WideRange>() -> f64 {
    let truths = |temperature: f64| {
        let fourth = STEFAN_BOLTZMANN * temperature.powi(4);
        [fourth, fourth / PI, WIEN_WAVELENGTH / temperature, WIEN_FREQUENCY * temperature]
    };
    worst(spread(2000, 1.0, 1e6).flat_map(|temperature| {
        let temperature = S::nearest(temperature);
        let laws = [radiant_exitance, total_radiance, peak_wavelength, peak_frequency];
        let truths = truths(temperature.exact());
        (0..4).map(|i| (laws[i](temperature).exact() / truths[i] - 1.0).abs()).collect::<Vec<_>>()
    }))
}

#[test]
fn totals_and_peaks_are_right_to_the_last_places() {
    assert_tight("f64", total_error::<f64>(), 8e-16);
    assert_tight("f32", total_error::<f32>(), 3e-7);
    assert_tight("micromath", total_error::<F32>(), 3e-7);
    assert_tight("Scaled", total_error::<Scaled>(), 3e-9);
}

/// Simpson's rule over the logarithm.
fn integral(integrand: impl Fn(f64) -> f64, ends: [f64; 2]) -> f64 {
    const INTERVALS: i32 = 20_000;
    let [from, to] = ends.map(f64::ln);
    let step = (to - from) / f64::from(INTERVALS);
    let weight = |i| if i == 0 || i == INTERVALS { 1.0 } else { 2.0 + 2.0 * f64::from(i & 1) };
    let term = |i| (from + step * f64::from(i)).exp();
    (0..=INTERVALS).map(|i| weight(i) * term(i) * integrand(term(i))).sum::<f64>() * step / 3.0
}

/// The spectral laws, integrated, are Stefan and Boltzmann's; over wavelengths and over frequencies.
#[test]
fn the_integral_over_the_spectrum_is_the_fourth_power() {
    for temperature in [100.0, 2700.0, SUN_TEMPERATURE, 1e5] {
        let total = radiant_exitance(temperature);
        // What lies beyond falls with the third power of the wavelength: below 1e-14 of the whole.
        let by_wavelength = [1e-2, 1e5].map(|ratio| ratio * peak_wavelength(temperature));
        let by_wavelength = integral(|l| PI * radiance_per_wavelength(l, temperature), by_wavelength);
        let by_frequency = [1e-5, 1e2].map(|ratio| ratio * peak_frequency(temperature));
        let by_frequency = integral(|f| PI * radiance_per_frequency(f, temperature), by_frequency);
        let errors = [by_wavelength, by_frequency, PI * total_radiance(temperature)].map(|flux| flux / total - 1.0);
        println!("{temperature} K: {errors:?}");
        assert!(errors.into_iter().all(|error| error.abs() < 1e-13), "{errors:?}");
    }
}

/// The law is greatest where Wien's displacement has it, in both forms, and the relative forms are the same curve.
#[test]
fn the_peak_is_where_wien_has_it() {
    for temperature in [10.0, 300.0, SUN_TEMPERATURE, 1e6] {
        for (law, peak) in
            [(Law::Wavelength, peak_wavelength(temperature)), (Law::Frequency, peak_frequency(temperature))]
        {
            let top = spectral(law, peak, temperature);
            for ratio in [0.5, 0.99, 1.01, 2.0, 5.0] {
                let level = spectral(law, ratio * peak, temperature) / top;
                assert!(level < 1.0 && (level / relative(law, ratio) - 1.0).abs() < 5e-15, "{law:?} {ratio}");
            }
        }
    }
}

/// The Sun: the colour of its peak, its radiance, and the solar constant from its temperature and size alone.
#[test]
fn the_sun_gives_the_earth_1361_watts_a_square_metre() {
    assert_eq!(format!("{:.1}", 1e9 * peak_wavelength(SUN_TEMPERATURE)), "502.0");
    assert_eq!(format!("{:.3e}", total_radiance(SUN_TEMPERATURE)), "2.003e7");
    let irradiance = radiant_exitance(SUN_TEMPERATURE) * SUN.sin() * SUN.sin();
    assert_eq!(format!("{irradiance:.1}"), "1361.2");
    let by_size_factor = total_radiance(SUN_TEMPERATURE) * SUN.size_factor();
    assert!((by_size_factor / irradiance - 1.0).abs() < 1e-15);
    // In f32 and in integers too.
    let by = |exitance: f64| exitance * SUN.sin() * SUN.sin();
    assert_eq!(format!("{:.1}", by(radiant_exitance(5772.0_f32).into())), "1361.2");
    assert_eq!(format!("{:.1}", by(radiant_exitance(Scaled::nearest(5772.0)).exact())), "1361.2");
}

/// Cold is red and hot is blue, and the greatest level is 1.
#[test]
fn tints_turn_from_red_to_blue() {
    fn check<T: Real>() {
        let number = |value: f64| T::of_level(T::level(T::Scalar::nearest(value)));
        let tint = |kilokelvin: f64| tint(number(kilokelvin), [0.611, 0.549, 0.464].map(number)).map(Scalar::exact);
        let [ember, lamp, blue] = [0.8, 2.7, 12.0].map(tint);
        assert!(ember[0] == 1.0 && ember[1] < 0.1 && ember[2] < ember[1] && ember[2] > 0.0, "{ember:?}");
        assert!(lamp[0] == 1.0 && lamp[0] > lamp[1] && lamp[1] > lamp[2], "{lamp:?}");
        assert!(blue[2] == 1.0 && blue[2] > blue[1] && blue[1] > blue[0], "{blue:?}");
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    check::<f16>();
    check::<fixed::types::I2F14>();
    check::<fixed::types::I2F30>();
    check::<fixed::types::I16F16>();
}

/// The greatest level is 1 and no level is above: a number divided by itself was not 1, in fixed point.
#[test]
fn tints_have_a_level_of_exactly_one() {
    fn check<S: Scalar>() {
        let mut source = oorandom::Rand64::new(9);
        let mut next = |least: f64, most: f64| S::nearest(least * (most / least).powf(source.rand_float()));
        for _ in 0..COUNT {
            let (temperature, wavelengths) = (next(0.8, 40.0), [(); 3].map(|()| next(0.38, 0.78)));
            let levels = tint(temperature, wavelengths);
            assert!(levels.iter().all(|&level| level <= S::ONE), "{temperature:?} {wavelengths:?}: {levels:?}");
            assert!(levels.contains(&S::ONE), "{temperature:?} {wavelengths:?}: {levels:?}");
        }
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    check::<f16>();
    check::<Scaled>();
}

/// The raw entries are the generic functions on bits, within the last bits that they promise.
#[test]
fn raw_bits_are_the_generic_functions() {
    let mut source = oorandom::Rand64::new(7);
    let mut next = |least: f64, most: f64| (least * (most / least).powf(source.rand_float()) * 65_536.0) as u32;
    let value = |bits: u32| f64::from(bits) / 65_536.0;
    let lsbs = |bits: i32, truth: f64| (f64::from(bits) - truth * f64::from(1 << 30)).abs();
    let (mut laws, mut tints) = (0.0_f64, 0.0_f64);
    for _ in 0..COUNT {
        let ratio = next(1e-4, 6e4);
        let scaled = Scaled::from_unsigned(ratio.into(), -16);
        let [by_wavelength, by_frequency] = [relative_to_peak_q16(ratio), relative_to_peak_frequency_q16(ratio)];
        assert_eq!(i64::from(by_wavelength), relative_to_peak(scaled).to_bits(30).min(1 << 30));
        assert_eq!(i64::from(by_frequency), relative_to_peak_frequency(scaled).to_bits(30).min(1 << 30));
        laws = worse(laws, lsbs(by_wavelength, Law::Wavelength.relative(value(ratio))));
        laws = worse(laws, lsbs(by_frequency, Law::Frequency.relative(value(ratio))));
        let (temperature, wavelengths) = (next(0.8, 40.0), [0; 3].map(|_| next(0.38, 0.78)));
        let truth = wavelengths.map(|w| Law::Wavelength.radiance(1e-6 * value(w), 1000.0 * value(temperature)));
        let greatest = truth.into_iter().fold(0.0, f64::max);
        for (level, truth) in tint_q16(temperature, wavelengths).into_iter().zip(truth) {
            tints = worse(tints, lsbs(level, truth / greatest));
        }
    }
    assert_tight("relative laws, LSB of Q30", laws, 4.0);
    assert_tight("tint, LSB of Q30", tints, 12.0);
    assert_eq!(
        [relative_to_peak_q16(0), relative_to_peak_frequency_q16(0), relative_to_peak_frequency_q16(u32::MAX)],
        [0; 3]
    );
    assert_eq!([tint_q16(0, [1; 3]), tint_q16(1, [1, 0, 1])], [[0; 3]; 2]);
    assert_eq!(tint_q16(65_536, [40_000; 3]), [1 << 30; 3]);
}
