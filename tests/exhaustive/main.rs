//! Every kernel of one argument over every input that its format has, those of two short arguments over all pairs, and
//! the worst cases that were found.
//!
//! `cargo test` tries the recorded worst inputs again. All inputs, half an hour on two cores: `cargo test --release
//! --test exhaustive -- --ignored --nocapture --test-threads 1`; `SUNGLINT_RECORD=1` prints lines for
//! `src/trial/worst/kernels.csv` (the day is to be put in place of the time taken) and does not ask for those that are
//! there.

#[path = "../exact/mod.rs"]
mod exact;
mod floats;
mod integers;
mod kernels;
mod run;

use kernels::Kernel;
use run::Worst;
use sunglint::trial::worst::kernels::{Proof, TABLE, proofs};

/// To four digits.
fn digits(error: f64) -> String {
    format!("{error:.3e}")
}

fn count(kernel: &Kernel) -> u64 {
    kernel.inputs[1] - kernel.inputs[0] + 1
}

fn line(kernel: &Kernel, worst: Worst) -> String {
    let Kernel { name, format, unit, bound, .. } = kernel;
    format!("{name};{format};{};{:#x};{:.6};{bound};{unit}", count(kernel), worst.bits, worst.error)
}

/// Tries all inputs of all formats of a kernel; finds what is recorded.
fn prove(name: &str) {
    let kernels: Vec<_> = kernels::all().into_iter().filter(|kernel| kernel.name == name).collect();
    assert!(!kernels.is_empty(), "{name}");
    for kernel in &kernels {
        let start = std::time::Instant::now();
        let worst = run::worst(&format!("{name} in {}", kernel.format), kernel.inputs, &*kernel.error);
        println!("{};{:.1} s", line(kernel, worst), start.elapsed().as_secs_f64());
        if std::env::var_os("SUNGLINT_RECORD").is_some() {
            continue;
        }
        assert!(worst.error <= kernel.bound && worst.error >= kernel.bound / 4.0, "{worst:x?}");
        let record = proofs().find(|record| record.kernel == name && record.format == kernel.format).unwrap();
        assert_eq!([count(kernel), worst.bits], [record.inputs, record.bits], "{name} in {}", kernel.format);
        assert_eq!(digits(worst.error), digits(record.error), "{name} in {}", kernel.format);
    }
}

#[test]
fn recorded_worst_cases_are_as_recorded_and_bounds_are_tight() {
    let kernels = kernels::all();
    let named = |name: &str, format: &str| proofs().find(|record| record.kernel == name && record.format == format);
    for kernel in &kernels {
        let record = named(kernel.name, kernel.format).unwrap_or_else(|| panic!("{} {}", kernel.name, kernel.format));
        let error = (kernel.error)(record.bits).abs();
        assert_eq!(digits(error), digits(record.error), "{} in {}", kernel.name, kernel.format);
        assert!(error <= kernel.bound && error >= kernel.bound / 4.0, "{} in {}: {error}", kernel.name, kernel.format);
        assert_eq!(
            (record.bound, record.inputs),
            (kernel.bound, count(kernel)),
            "{} in {}",
            kernel.name,
            kernel.format
        );
    }
    assert_eq!([proofs().count(), TABLE.lines().count() - 1], [kernels.len(); 2]);
}

/// A spread of inputs, of which none may be worse than the recorded one.
#[test]
fn no_input_of_a_spread_is_worse_than_the_recorded() {
    let kernels = kernels::all();
    for Proof { kernel: name, format, error: worst, .. } in proofs() {
        let is_of = |kernel: &&Kernel| kernel.name == name && kernel.format == format;
        let kernel = kernels.iter().find(is_of).unwrap_or_else(|| panic!("{name} {format}"));
        let [first, last] = kernel.inputs;
        let step = ((last - first) / 50_000) | 1;
        for bits in (first..=last).step_by(step as usize).chain([last]) {
            let error = (kernel.error)(bits).abs();
            assert!(error <= worst + 1e-6, "{name} in {format}: {error} at {bits:#x}");
        }
    }
}

/// Each name of the list has its test below.
macro_rules! proofs {
    ($($test:ident: $name:literal;)*) => {
        $(
            #[test]
            #[ignore = "every input: cargo test --release --test exhaustive -- --ignored --nocapture --test-threads 1"]
            fn $test() {
                prove($name);
            }
        )*

        #[test]
        fn every_kernel_has_its_proof() {
            let proved = [$($name),*];
            for kernel in kernels::all() {
                assert!(proved.contains(&kernel.name), "{}", kernel.name);
            }
        }
    };
}

proofs! {
    reciprocal_root: "reciprocal_root";
    fraction_of_reciprocal_root: "fraction_of_reciprocal_root";
    fraction_of_reciprocal: "fraction_of_reciprocal";
    reciprocal: "reciprocal";
    quotient: "quotient, any dividend";
    root: "root";
    soft_root: "soft::root";
    soft_reciprocal_root: "soft::reciprocal_root";
    reciprocal_root_q16: "reciprocal_root_q16";
    versine: "versine";
    solid_angle: "solid_angle";
    size_factor: "size_factor";
    inverse_size_factor: "inverse_size_factor";
    white_radiance: "white_radiance";
    from_ratio: "from_ratio";
    from_ratio_q30: "from_ratio_q30";
    sun_radius_at: "sun_radius_at";
    sun_radius_at_q16: "sun_radius_at_q16";
    sin_cos: "sin_cos";
    relative_to_peak: "relative_to_peak";
    relative_to_peak_q16: "relative_to_peak_q16";
    relative_to_peak_frequency: "relative_to_peak_frequency";
    relative_to_peak_frequency_q16: "relative_to_peak_frequency_q16";
    karis: "karis";
    exact_rp: "exact_rp";
    radiance: "radiance, from 0.001 and 1/2048";
    normalize: "normalize_q14, (x, y, 0)";
}
