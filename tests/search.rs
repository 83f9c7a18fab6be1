//! The worst directions that a search has found: each still gives its error, and its budget is tied to it.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Instant, SystemTime};
use std::{fs, thread};

use sunglint::Real;
use sunglint::trial::aim::{Candidate, Cell, Lit};
use sunglint::trial::search::{Effort, Outcome, Peak, Search, may_be_unit};
use sunglint::trial::worst::{TABLE, recorded};
use sunglint::trial::{Format, Visitor};

fn name(cell: &Cell) -> String {
    format!("{} in {}, {}", cell.aim.name(), cell.format.name(), cell.place.name())
}

/// The error of a cell at an input.
struct Error {
    cell: Cell,
    at: Candidate,
}

impl Visitor for Error {
    type Output = Option<f64>;

    fn visit<T: Real>(self) -> Option<f64> {
        let lit = Lit::<T>::of(self.cell.place.light(self.at.size));
        self.cell.aim.error(self.cell.format, &lit, &self.at)
    }
}

#[test]
fn every_cell_has_one_record() {
    let cells: Vec<Cell> = recorded().map(|record| record.cell).collect();
    assert_eq!(cells.len(), TABLE.lines().count() - 1, "a line says nothing");
    assert_eq!(cells, Cell::all().collect::<Vec<_>>());
}

#[test]
fn every_recorded_input_gives_its_error() {
    for record in recorded() {
        let name = name(&record.cell);
        let [l, r] = [record.at.pair.l, record.at.pair.r];
        assert!(may_be_unit(record.cell.format, l) && may_be_unit(record.cell.format, r), "{name}: no unit vectors");
        let error = record.cell.format.visit(Error { cell: record.cell, at: record.at }).expect(&name);
        assert!((error / record.error - 1.0).abs() < 1e-3, "{name}: {error:e}, recorded is {:e}", record.error);
    }
}

/// 1.12 times the worst, rounded up to two digits.
fn budget_of(worst: f64) -> f64 {
    let unit = 10_f64.powi((1.12 * worst).log10().floor() as i32 - 1);
    let text = format!("{:.1e}", (1.12 * worst / unit).ceil() * unit);
    text.parse().unwrap()
}

#[test]
fn every_budget_is_twelve_hundredths_above_its_worst() {
    for record in recorded() {
        assert_eq!(record.cell.budget(), Some(budget_of(record.error)), "{}: {:e}", name(&record.cell), record.error);
    }
}

#[test]
fn a_short_search_stays_within_the_budgets() {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap().as_nanos() as u64;
    for cell in Cell::all() {
        let found = cell.format.visit(Search { cell, effort: Effort::SHORT, seed: now }).peak;
        let budget = cell.budget().unwrap();
        assert!(found.error <= budget, "{}: {:e} is above {budget:e} at {:?}", name(&cell), found.error, found.at);
    }
}

fn line(cell: &Cell, Outcome { peak: Peak { error, at }, judged }: &Outcome) -> String {
    let lanes = at.pair.l.into_iter().chain(at.pair.r).map(|lane| format!(",{:x}", cell.format.bits(lane)));
    let (aim, format, place) = (cell.aim.name(), cell.format.name(), cell.place.name());
    format!("{aim},{format},{place},{:x}{},{error:.5e},{judged}\n", at.size.to_bits(), lanes.collect::<String>())
}

/// Where the table of the worst is from: begins with what is recorded there, and writes what it finds beside it. Fails
/// where that is above a budget. `SUNGLINT_CELL` picks the cells whose name contains it, `SUNGLINT_SEED` another seed.
#[test]
#[ignore = "four minutes on two cores: cargo test --release --test search -- --ignored --nocapture"]
fn the_full_search_finds_nothing_above_the_budgets() {
    let cells: Vec<Cell> = Cell::all().collect();
    let only = std::env::var("SUNGLINT_CELL").unwrap_or_default();
    let chosen: Vec<usize> = (0..cells.len()).filter(|&index| name(&cells[index]).contains(&only)).collect();
    let seed = std::env::var("SUNGLINT_SEED").map_or(1, |seed| seed.parse().expect("SUNGLINT_SEED is a whole number"));
    let before: Vec<_> = recorded().collect();
    let (next, found) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()));
    let start = Instant::now();
    let work = || {
        while let Some(&index) = chosen.get(next.fetch_add(1, Ordering::Relaxed)) {
            let cell = cells[index];
            let outcome = cell.format.visit(Search { cell, effort: Effort::FULL, seed });
            let old = before.iter().find(|record| record.cell == cell).map(|record| record.error);
            let (seconds, count) = (start.elapsed().as_secs(), found.lock().unwrap().len());
            println!(
                "{seconds} s, {count} of {}: {}: {:.3e}, recorded {old:?}, budget {:?}",
                chosen.len(),
                name(&cell),
                outcome.peak.error,
                cell.budget()
            );
            found.lock().unwrap().insert(index, (outcome, old));
        }
    };
    thread::scope(|scope| {
        (0..thread::available_parallelism().map_or(2, usize::from)).for_each(|_| drop(scope.spawn(work)))
    });
    let found = found.into_inner().unwrap();
    let mut table = String::from("aim,format,place,size,l0,l1,l2,r0,r1,r2,error,judged\n");
    for (index, (outcome, _)) in &found {
        table.write_str(&line(&cells[*index], outcome)).unwrap();
    }
    let path = concat!(env!("CARGO_TARGET_TMPDIR"), "/directions.csv");
    fs::write(path, table).unwrap();
    println!("{path} is the table of src/trial/worst/ now");
    let is_above = |(index, (outcome, _)): &(&usize, &(Outcome, _))| {
        cells[**index].budget().is_none_or(|budget| outcome.peak.error > budget)
    };
    let above = found.iter().filter(is_above);
    assert_eq!(above.count(), 0, "cells with worse than their budget");
}

/// The formats' bits and values, on which the records stand.
#[test]
fn bits_and_values_of_formats_agree() {
    for format in Format::ALL {
        for value in [0.0, 0.5, -0.625, 1.0, -1.0] {
            assert_eq!(format.value(format.bits(value)), value, "{}", format.name());
        }
    }
}
