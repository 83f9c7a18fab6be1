//! Errors and costs of the building blocks in every format.

use indicatif::ProgressBar;
use sunglint::Real;
use sunglint::trial::{Format, Light, Visitor, lights};

use crate::author::OURS;
use crate::bound;
use crate::clock::{self, Contender};
use crate::directions;
use crate::kernel::{Kernel, Measured};
use crate::options::Options;
use crate::result::KernelRow;
use crate::workers;

/// Random pairs that an input's errors are taken of, and with `--quick`.
const PAIRS: [usize; 2] = [100_000, 10_000];

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    rows(options) + rounds(options)
}

/// How many rows there are.
pub fn rows(options: &Options) -> usize {
    of_all(options).len()
}

/// How often every contender has its turn.
fn rounds(options: &Options) -> usize {
    if options.quick { 17 } else { 81 }
}

/// How many pairs.
pub fn pairs(options: &Options) -> usize {
    PAIRS[usize::from(options.quick)]
}

/// The building blocks and formats that were asked for, in the order of the rows.
fn of_all(options: &Options) -> Vec<(Kernel, Format)> {
    let of_all = Kernel::ALL.into_iter().flat_map(|kernel| Format::ALL.map(|format| (kernel, format)));
    of_all.filter(|(kernel, format)| options.wants_method(kernel.name()) && options.wants_format(*format)).collect()
}

/// The errors of all kernels in all formats, on all cores.
pub fn errors(options: &Options, progress: &ProgressBar) -> Vec<KernelRow> {
    let contenders: Vec<_> =
        of_all(options).into_iter().map(|(kernel, format)| Judge { kernel, format, options }).collect();
    workers::map(&contenders, progress, |&contender| {
        progress.set_message(format!("{} in {}", contender.kernel.name(), contender.format.name()));
        contender.format.visit(contender)
    })
}

/// Adds the costs to `rows`, which are those of [`errors`].
pub fn add_costs(rows: &mut [KernelRow], options: &Options, progress: &ProgressBar) {
    progress.set_message("timing, building blocks");
    let of_all = of_all(options).into_iter();
    let contenders: Vec<_> = of_all.map(|(kernel, format)| format.visit(Calls { kernel })).collect();
    let [sun, ..]: [Light; 5] = lights::STUDY;
    let costs = clock::costs(&contenders, &directions::baseline(&sun), rounds(options), progress);
    for (row, cost) in rows.iter_mut().zip(costs) {
        (row.cost, row.cost_low, row.cost_high) = cost.figures();
    }
}

struct Calls {
    kernel: Kernel,
}

impl Visitor for Calls {
    type Output = Contender;

    fn visit<T: Real>(self) -> Contender {
        self.kernel.calls::<T>()
    }
}

#[derive(Clone, Copy)]
struct Judge<'a> {
    kernel: Kernel,
    format: Format,
    options: &'a Options,
}

impl Visitor for Judge<'_> {
    type Output = KernelRow;

    fn visit<T: Real>(self) -> KernelRow {
        let measured = self.kernel.errors::<T>(self.options.seed, pairs(self.options));
        let row = KernelRow {
            group: self.kernel.group().name().to_owned(),
            kernel: self.kernel.name().to_owned(),
            unit: self.kernel.unit().to_owned(),
            format: self.format.name().to_owned(),
            by: OURS,
            cost: f64::NAN,
            cost_low: f64::NAN,
            cost_high: f64::NAN,
            ..KernelRow::default()
        };
        bound::of_kernel(with_errors(row, measured), self.format, self.options)
    }
}

/// `row` with what was measured, which is its bound.
pub fn with_errors(row: KernelRow, Measured { max, rms, samples, worst, p99, bias }: Measured) -> KernelRow {
    KernelRow {
        error_max: max,
        error_rms: rms,
        samples,
        worst_input: worst,
        error_p99: p99,
        error_bias: bias,
        bound_max: max,
        bound_samples: samples,
        ..row
    }
}
