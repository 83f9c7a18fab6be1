//! Lines of the table, and of what one core counts.

use std::fmt;

use crate::committed::{self, is_off};

/// Names of a core's figures.
const FIGURES: [&str; 5] = ["median", "worst", "stack", "text", "rodata"];

const CORES: [&str; 3] = ["M0+", "M3", "M4F"];

/// What a line is of.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Key {
    function: String,
    format: String,
    by: String,
    case: String,
    inputs: u32,
}

/// A line of the table.
pub struct Line {
    pub key: Key,
    /// Median, worst, stack, text and rodata on each core; none where it fails.
    pub costs: [Option<[u32; 5]>; 3],
    pub note: String,
}

/// The key, median, worst and stack, and the note if any, of a line that a core has printed.
pub fn count(text: &str) -> Option<(Key, Option<[u32; 3]>, &str)> {
    let columns: Vec<_> = text.split(',').collect();
    let (counts, note) = match columns.len() {
        8 => (&columns[5..], ""),
        9 => (&columns[5..8], columns[8]),
        _ => return None,
    };
    Some((key(&columns)?, numbers(counts)?, note))
}

fn key(columns: &[&str]) -> Option<Key> {
    let [function, format, by, case] = [0, 1, 2, 3].map(|index| columns[index].to_owned());
    Some(Key { function, format, by, case, inputs: columns[4].parse().ok()? })
}

/// So many numbers, or as many empty columns.
fn numbers<const N: usize>(columns: &[&str]) -> Option<Option<[u32; N]>> {
    if columns.iter().all(|column| column.is_empty()) {
        return Some(None);
    }
    let numbers: Result<Vec<_>, _> = columns.iter().map(|column| column.parse()).collect();
    Some(Some(numbers.ok()?.try_into().ok()?))
}

impl Key {
    /// The linked file.
    pub fn file(&self) -> String {
        format!("{}:{}:{}.elf", self.function, self.format, self.by).replace('/', ":")
    }
}

impl Line {
    pub fn new(key: Key) -> Self {
        Self { key, costs: [None; 3], note: String::new() }
    }

    /// Adds what a core has to say, once.
    pub fn add(&mut self, note: &str) {
        if !note.is_empty() && !self.note.contains(note) {
            let separator = if self.note.is_empty() { "" } else { "; " };
            self.note += &format!("{separator}{note}");
        }
    }
}

impl committed::Line for Line {
    const HEADER: &str = "function,format,by,case,inputs,\
        m0_median,m0_worst,m0_stack,m0_text,m0_rodata,\
        m3_median,m3_worst,m3_stack,m3_text,m3_rodata,\
        m4_median,m4_worst,m4_stack,m4_text,m4_rodata,note";

    fn key(&self) -> String {
        format!("{},{}", self.key, self.key.inputs)
    }

    fn parse(text: &str) -> Option<Self> {
        let columns: Vec<_> = text.split(',').collect();
        if columns.len() != 21 {
            return None;
        }
        let mut costs = [None; 3];
        for (core, cost) in costs.iter_mut().enumerate() {
            *cost = numbers(&columns[5 + 5 * core..10 + 5 * core])?;
        }
        Some(Line { key: key(&columns)?, costs, note: columns[20].to_owned() })
    }

    /// Figures that are off from those `before` by more than 2 % and by more than 1.
    fn against(&self, before: &Self) -> Vec<String> {
        let mut complaints = Vec::new();
        for (core, name) in CORES.into_iter().enumerate() {
            let (now, was) = match (self.costs[core], before.costs[core]) {
                (Some(now), Some(was)) => (now, was),
                (None, None) => continue,
                (now, _) => {
                    let verb = if now.is_some() { "has no figures in the table" } else { "gives no figures any more" };
                    complaints.push(format!("{} on {name} {verb}", self.key));
                    continue;
                }
            };
            for (figure, (now, was)) in FIGURES.into_iter().zip(now.into_iter().zip(was)) {
                if is_off(now, was, 1) {
                    complaints.push(format!("{} on {name}: {figure} {now}, in the table {was}", self.key));
                }
            }
        }
        if self.note != before.note {
            complaints.push(format!("{}: noted {:?}, in the table {:?}", self.key, self.note, before.note));
        }
        complaints
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{},{},{},{}", self.function, self.format, self.by, self.case)
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{},{}", self.key, self.key.inputs)?;
        for cost in self.costs {
            match cost {
                Some(figures) => figures.iter().try_for_each(|figure| write!(f, ",{figure}"))?,
                None => f.write_str(",,,,,")?,
            }
        }
        write!(f, ",{}", self.note)
    }
}
