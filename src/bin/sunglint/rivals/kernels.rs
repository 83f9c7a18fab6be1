//! Building blocks by other code than a format always runs.

use indicatif::ProgressBar;
use sunglint::soft;
use sunglint::trial::chip::peers;
use sunglint::trial::{Format, Found};

use crate::author::SOFT;
use crate::kernel::{Kernel, vectors};
use crate::kernels;
use crate::options::Options;
use crate::result::KernelRow;

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    soft(options).len()
}

/// Those of f32 in integers that were asked for.
fn soft(options: &Options) -> Vec<Kernel> {
    let wanted = |kernel: &Kernel| options.wants_method(kernel.name()) && options.wants_format(Format::F32);
    [Kernel::Normalize, Kernel::Reflect].into_iter().filter(wanted).collect()
}

/// The errors of building blocks of `rows` by f32 in integers and by peers.
pub fn errors(rows: &[KernelRow], options: &Options, progress: &ProgressBar) -> Vec<KernelRow> {
    let (seed, count) = (options.seed, kernels::pairs(options));
    progress.set_message(format!("building blocks by {SOFT}"));
    let soft = soft(options).into_iter().filter_map(|kernel| {
        progress.inc(1);
        match kernel {
            Kernel::Normalize => of_soft(rows, kernel, &vectors::normalize_errors_of(soft::normalize, seed, count)),
            _ => of_soft(rows, kernel, &vectors::reflect_errors_of(soft::reflect, seed, count)),
        }
    });
    soft.chain(peers::rows().filter_map(|peer| of_peer(rows, &peer))).collect()
}

/// The row of a format's own code, with the error of f32 in integers.
fn of_soft<const INPUTS: usize>(rows: &[KernelRow], kernel: Kernel, found: &Found<INPUTS>) -> Option<KernelRow> {
    let own = rows.iter().find(|row| row.kernel == kernel.name() && row.format == Format::F32.name())?;
    Some(kernels::with_errors(KernelRow { by: SOFT, ..own.clone() }, kernel.measured(found)))
}

/// What the crate `tests/peers` has found, where the study has that building block.
fn of_peer(rows: &[KernelRow], peer: &peers::Peer) -> Option<KernelRow> {
    let own = rows.iter().find(|row| row.kernel == peer.function && row.unit == peer.unit)?;
    Some(KernelRow {
        by: peer.by,
        format: peer.format.to_owned(),
        cost: f64::NAN,
        cost_low: f64::NAN,
        cost_high: f64::NAN,
        error_max: peer.error,
        error_rms: f64::NAN,
        samples: 0,
        worst_input: String::new(),
        ..own.clone()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::author::is_peer;
    use crate::sample;

    #[test]
    fn integers_keep_the_bounds_of_their_documentation_and_peers_have_but_a_worst_error() {
        let options = Options::parse_from(["sunglint", "--quick"]);
        let reflect = KernelRow { kernel: "reflect".to_owned(), ..sample::kernel("f32", 1.0) };
        let rows = errors(&[sample::kernel("f32", 1.0), reflect], &options, &ProgressBar::hidden());
        let of_soft: Vec<_> = rows.iter().filter(|row| row.by == SOFT).collect();
        // An angle is at most the length of its three lanes' errors.
        for (row, bound) in of_soft.iter().zip([5.0e-8, 6.1e-8 * 3_f64.sqrt()]) {
            assert!((bound / 4.0..bound).contains(&row.error_max), "{} {:e}", row.kernel, row.error_max);
        }
        let peers = rows.iter().filter(|row| is_peer(row.by));
        assert_eq!((of_soft.len(), peers.clone().count()), (2, 5), "normalize by three, in three formats of one");
        assert!(peers.into_iter().all(|row| row.error_rms.is_nan() && row.error_max < 1e-3 && row.cost.is_nan()));
    }
}
