//! The errors of the light quantities of one argument, in units of each format's last place.

use fixed::types::I2F30;
use indicatif::ProgressBar;
use sunglint::Float;
use sunglint::trial::Format;
use sunglint::trial::quantity::Quantity;

use crate::options::Options;
use crate::result::QuantityRow;

/// Steps of the progress bar: a quantity in three float formats and in fixed point.
pub fn steps(options: &Options) -> usize {
    wanted(options).len() * FLOATS.iter().filter(|format| options.wants_format(**format)).count()
        + wanted(options).len() * usize::from(wants_fixed(options))
}

/// Those that judge against f64: f64 itself is held against 192 bits in the tests.
const FLOATS: [Format; 3] = [Format::F32, Format::Micromath, Format::F16];

fn wanted(options: &Options) -> Vec<Quantity> {
    Quantity::ALL.into_iter().filter(|quantity| options.wants_method(quantity.name())).collect()
}

/// Whether any fixed point is wanted; a quantity has one format for all of them.
fn wants_fixed(options: &Options) -> bool {
    [Format::I2F14, Format::I2F30, Format::I16F16].into_iter().any(|format| options.wants_format(format))
}

/// Ratios from 1e-6 to 1, evenly spread over their logarithms.
fn ratios(options: &Options) -> impl Iterator<Item = f64> {
    let count = if options.quick { 20_000 } else { 200_000 };
    (0..=count).map(move |index| 10_f64.powf(-6.0 * f64::from(index) / f64::from(count)))
}

/// All quantities in all formats.
pub fn measure(options: &Options, progress: &ProgressBar) -> Vec<QuantityRow> {
    progress.set_message("light quantities");
    wanted(options).into_iter().flat_map(|quantity| rows(quantity, options, progress)).collect()
}

fn rows(quantity: Quantity, options: &Options, progress: &ProgressBar) -> Vec<QuantityRow> {
    let formats = FLOATS.into_iter().filter(|format| options.wants_format(*format)).map(Some);
    let formats = formats.chain(wants_fixed(options).then_some(None));
    let row = |format| {
        let row = match format {
            Some(Format::F16) => in_float::<half::f16>(quantity, Format::F16, options),
            Some(Format::Micromath) => in_float::<micromath::F32>(quantity, Format::Micromath, options),
            Some(_) => in_float::<f32>(quantity, Format::F32, options),
            None => in_fixed(quantity, options),
        };
        progress.inc(1);
        row
    };
    formats.map(row).collect()
}

fn in_float<T: Float>(quantity: Quantity, format: Format, options: &Options) -> QuantityRow {
    let mut row = empty(quantity, format.name(), "ULP");
    for ratio in ratios(options).map(T::nearest) {
        let truth = quantity.truth(ratio.exact());
        let error = quantity.in_float(ratio).map(|value| (value.exact() - truth).abs() / format.ulp(truth));
        add(&mut row, ratio.exact(), error.ok());
    }
    row
}

fn in_fixed(quantity: Quantity, options: &Options) -> QuantityRow {
    let mut row = empty(quantity, "", "LSB");
    for ratio in ratios(options).map(I2F30::from_num) {
        let value = ratio.to_num::<f64>();
        let answer = quantity.in_fixed(ratio);
        row.format = answer.map_or(row.format, |answer| answer.format.to_owned());
        add(&mut row, value, answer.map(|answer| (answer.value - quantity.truth(value)).abs() / answer.lsb).ok());
    }
    row
}

fn empty(quantity: Quantity, format: &str, unit: &str) -> QuantityRow {
    QuantityRow {
        quantity: quantity.name().to_owned(),
        format: format.to_owned(),
        unit: unit.to_owned(),
        error_max: 0.0,
        worst_input: 0.0,
        samples: 0,
        refused: 0,
    }
}

fn add(row: &mut QuantityRow, input: f64, error: Option<f64>) {
    row.samples += 1;
    // An answer that is not a number is as wrong as can be.
    let error = error.map(|error| if error.is_nan() { f64::INFINITY } else { error });
    match error {
        None => row.refused += 1,
        Some(error) if error > row.error_max => (row.error_max, row.worst_input) = (error, input),
        Some(_) => {}
    }
}
