//! What is known of the worst errors: by this run, by searches, and by trying every input.

use sunglint::trial::aim::{Aim, Cell, Place};
use sunglint::trial::worst::{self, Record};
use sunglint::trial::{Format, Light, Method, lights};

use crate::measure::bits;
use crate::repro;
use crate::result::{Bound, KernelRow, PixelRow, Row};

/// The worst of this run, or what a search has found for that method, format and light.
pub fn of_direction(row: Row, method: Method, format: Format, light: &Light) -> Row {
    let command = |l: &str, r: &str| repro::of_direction(light.name, method.name(), format.name(), [l, r]);
    let own = command(&row.worst_l, &row.worst_r);
    let Some(Record { at, error, judged, .. }) = searched(method, format, light) else {
        return Row { bound: Bound::Sampled, bound_max: row.error_max, bound_samples: row.samples, repro: own, ..row };
    };
    let [l, r] = [at.pair.l, at.pair.r].map(|v| bits(format, &v));
    Row {
        bound: Bound::Searched,
        bound_max: error.max(row.error_max),
        bound_samples: judged + row.samples,
        repro: if row.error_max > error { own } else { command(&l, &r) },
        ..row
    }
}

/// The record of a search, which is of the same light.
fn searched(method: Method, format: Format, light: &Light) -> Option<Record> {
    let place = lights::BUDGETED.iter().position(|budgeted| budgeted.light == light.light)?;
    let cell = Cell { aim: Aim::Direction(method), format, place: Place::Light(place) };
    worst::recorded().find(|record| record.cell == cell)
}

/// The worst of this run: lit pixels have too many inputs, and no search goes uphill in all of them.
pub fn of_pixel(row: PixelRow) -> PixelRow {
    let vectors = [&*row.worst_n, &*row.worst_v, &*row.worst_l];
    let repro = repro::of_pixel(&row.case, &row.method, &row.format, vectors);
    PixelRow { bound: Bound::Sampled, bound_max: row.error_max, bound_samples: row.samples, repro, ..row }
}

/// The worst of this run, of all inputs, or of a search.
pub fn of_kernel(row: KernelRow, format: Format, seed: u64) -> KernelRow {
    let repro = repro::of_kernel(&row.kernel, format.name(), seed);
    let (bound, known, samples) = proved(&row, format).or_else(|| normalized(&row, format)).unwrap_or((
        Bound::Sampled,
        row.error_max,
        row.samples,
    ));
    let samples = if bound == Bound::Searched { samples + row.samples } else { samples };
    KernelRow { bound, bound_max: known.max(row.error_max), bound_samples: samples, repro, ..row }
}

/// The worst of all inputs, where those and the error are the same as the study's: floats, which answer in the format
/// that they are asked in.
fn proved(row: &KernelRow, format: Format) -> Option<(Bound, f64, u64)> {
    let same = |proof: &worst::kernels::Proof| {
        [proof.kernel, proof.format, proof.unit] == [&*row.kernel, format.name(), "step"] && row.unit == "absolute"
    };
    let is_float = matches!(format, Format::F64 | Format::F32 | Format::Micromath | Format::F16);
    let proof = worst::kernels::proofs().find(same).filter(|_| is_float)?;
    Some((Bound::Exhaustive, proof.error * format.step(), proof.inputs))
}

/// What a search has found for vectors of any length that the format is budgeted for, the study's among them.
fn normalized(row: &KernelRow, format: Format) -> Option<(Bound, f64, u64)> {
    let of_aim = |record: &Record| {
        record.cell.aim == Aim::Normalize && record.cell.aim.name() == row.kernel && record.cell.format == format
    };
    worst::recorded().find(of_aim).map(|record| (Bound::Searched, record.error, record.judged))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn under(method: Method, light: usize, error: f64) -> Row {
        of_direction(sample::row(method.name(), "f32", 1.0, error), method, Format::F32, &lights::STUDY[light])
    }

    #[test]
    fn a_search_knows_of_worse_than_a_run() {
        let row = under(Method::Cap, 0, 1e-9);
        let record = searched(Method::Cap, Format::F32, &lights::STUDY[0]).expect("a record");
        assert_eq!(
            (row.bound, row.bound_max, row.bound_samples),
            (Bound::Searched, record.error, record.judged + 1000)
        );
        assert!(row.repro.contains(&bits(Format::F32, &record.at.pair.l)), "{}", row.repro);
        assert!(record.judged > 100_000, "{record:?}");
    }

    #[test]
    fn a_run_may_find_worse_than_the_search() {
        let row = under(Method::Cap, 0, 1.0);
        assert_eq!((row.bound, row.bound_max), (Bound::Searched, 1.0));
        assert!(row.repro.contains(&row.worst_l), "{}", row.repro);
    }

    #[test]
    fn what_was_not_searched_is_sampled() {
        // The Sun from Mars has no search of its own; `epic` has one under the Sun from Earth alone.
        for row in [under(Method::Cap, 1, 1e-7), under(Method::Epic, 4, 1e-7)] {
            assert_eq!((row.bound, row.bound_max, row.bound_samples), (Bound::Sampled, 1e-7, 1000));
        }
    }

    #[test]
    fn proofs_count_where_the_error_is_the_same() {
        let of = |kernel: &str, unit: &str, format: Format| {
            let row = KernelRow { kernel: kernel.to_owned(), unit: unit.to_owned(), ..sample::kernel("f32", 1e-9) };
            of_kernel(row, format, 7)
        };
        let sines = of("sin_cos", "absolute", Format::F32);
        assert_eq!((sines.bound, sines.bound_samples), (Bound::Exhaustive, 1_065_353_217));
        assert!((1.27..1.28).contains(&(sines.bound_max / Format::F32.step())), "{}", sines.bound_max);
        assert!(sines.repro.contains("sin_cos") && sines.repro.contains("--seed 7"), "{}", sines.repro);
        // Of the integers' sines the proof is about the lanes, of Planck's law about the absolute error.
        assert_eq!(of("sin_cos", "absolute", Format::I2F30).bound, Bound::Sampled);
        assert_eq!(of("relative_to_peak", "relative", Format::F32).bound, Bound::Sampled);
        let unit = of("normalize", "rad", Format::F32);
        assert_eq!(unit.bound, Bound::Searched);
        assert!(unit.bound_max > 6e-8 && unit.bound_samples > 1000);
    }
}
