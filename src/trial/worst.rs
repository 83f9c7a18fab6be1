//! The worst inputs that [`search`](super::search) has found, as raw bits: what the budgets of directions are tied to.

pub mod kernels;

use super::aim::{Aim, Candidate, Cell, Place};
use super::format::Format;
use super::input::Pair;
use super::method::Method;

/// One line for each cell: aim, format, place, the size as an f64 in hexadecimal bits, the six lanes of `l` and `r` in
/// bits of the format, the error, how many inputs were judged.
pub const TABLE: &str = include_str!("worst/directions.csv");

/// A cell and its worst input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record {
    /// The cell.
    pub cell: Cell,
    /// The input.
    pub at: Candidate,
    /// The error as recorded, to six digits.
    pub error: f64,
    /// How many inputs the search judged.
    pub judged: u64,
}

/// All records. A line that says nothing is left out, which `tests/search.rs` notices.
pub fn recorded() -> impl Iterator<Item = Record> {
    TABLE.lines().skip(1).filter_map(record)
}

/// The worst input of a method under a budgeted light, for tests that try only a few others.
pub fn under(method: Method, format: Format, light: usize) -> impl Iterator<Item = Pair> {
    let cell = Cell { aim: Aim::Direction(method), format, place: Place::Light(light) };
    recorded().filter(move |record| record.cell == cell).map(|record| record.at.pair)
}

fn record(line: &str) -> Option<Record> {
    let mut columns = line.split(',');
    let mut next = || columns.next();
    let (aim, format, place) = (next()?, next()?, next()?);
    let cell = cell(aim, format, place)?;
    let size = f64::from_bits(u64::from_str_radix(next()?, 16).ok()?);
    let mut lanes = [0.0; 6];
    for lane in &mut lanes {
        *lane = cell.format.value(u64::from_str_radix(next()?, 16).ok()?);
    }
    let [a, b, c, d, e, f] = lanes;
    let (error, judged) = (next()?.parse().ok()?, next()?.parse().ok()?);
    Some(Record { cell, at: Candidate { size, pair: Pair { l: [a, b, c], r: [d, e, f] } }, error, judged })
}

fn cell(aim: &str, format: &str, place: &str) -> Option<Cell> {
    let aim = Aim::ALL.into_iter().find(|one| one.name() == aim)?;
    let format = Format::named(format)?;
    let place = aim.places(format).find(|one| one.name() == place)?;
    Some(Cell { aim, format, place })
}
