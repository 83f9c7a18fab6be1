//! A committed table beside what has been measured now.

use std::collections::HashMap;
use std::fmt::Display;
use std::path::Path;
use std::process::ExitCode;

/// A line of such a table, which is displayed as it is committed.
pub trait Line: Display + Sized {
    /// Names of the columns.
    const HEADER: &str;

    /// What tells it from the others.
    fn key(&self) -> String;

    /// A line as it is committed.
    fn parse(text: &str) -> Option<Self>;

    /// What is off from the figures `before`.
    fn against(&self, before: &Self) -> Vec<String>;
}

/// Compares the lines with the committed table; with `SUNGLINT_RECORD=1` writes that instead. `what` they are is said.
pub fn settle<L: Line>(lines: &[L], committed: &Path, what: &str) -> ExitCode {
    if is_recorded() {
        let text: Vec<_> = lines.iter().map(|line| format!("{line}\n")).collect();
        std::fs::write(committed, format!("{}\n{}", L::HEADER, text.concat())).expect("the table can be written");
        println!("{} {what} written", lines.len());
        return ExitCode::SUCCESS;
    }
    let complaints = compare(lines, &std::fs::read_to_string(committed).unwrap_or_default());
    complaints.iter().for_each(|complaint| eprintln!("{complaint}"));
    if complaints.is_empty() {
        println!("{} {what} as committed", lines.len());
        return ExitCode::SUCCESS;
    }
    eprintln!("{} figures differ: SUNGLINT_RECORD=1 tests/firmware/run writes the table anew", complaints.len());
    ExitCode::FAILURE
}

/// Whether the table is written anew.
pub fn is_recorded() -> bool {
    std::env::var("SUNGLINT_RECORD").is_ok_and(|value| value == "1")
}

/// What is missing, new or off.
pub fn compare<L: Line>(lines: &[L], table: &str) -> Vec<String> {
    let mut committed: HashMap<String, L> = HashMap::new();
    let mut complaints = Vec::new();
    if table.lines().next() != Some(L::HEADER) {
        complaints.push("the table has other columns".to_owned());
    }
    for text in table.lines().skip(1) {
        match L::parse(text) {
            Some(line) => drop(committed.insert(line.key(), line)),
            None => complaints.push(format!("not a line: {text}")),
        }
    }
    for line in lines {
        match committed.remove(&line.key()) {
            Some(before) => complaints.extend(line.against(&before)),
            None => complaints.push(format!("{} is new", line.key())),
        }
    }
    complaints.extend(committed.keys().map(|key| format!("{key} is missing")));
    complaints
}

/// Whether a figure is off by more than 2 % and by more than `least`.
pub fn is_off(now: u32, was: u32, least: u32) -> bool {
    let off = now.abs_diff(was);
    off > least && u64::from(off) * 50 > u64::from(was)
}
