//! Instructions of a call on this machine, counted exactly by Valgrind, where that is installed.

use std::env;
use std::hint::black_box;
use std::io;
use std::process::Command;

use crate::clock::{Batch, Contender};
use crate::contest;

/// The argument with which this program calls itself: which contest, and which of [`batches`].
const COUNTED: &str = "--counted";

/// What is counted when.
#[inline(never)]
fn counted(batch: &Batch) {
    black_box(batch)();
}

/// Runs what a parent has asked for, if one has.
pub fn answered() -> bool {
    let arguments: Vec<_> = env::args().collect();
    let [_, flag, contest, batch] = arguments.as_slice() else {
        return false;
    };
    let numbers = (contest.parse::<usize>().ok(), batch.parse::<usize>().ok());
    let (COUNTED, (Some(index), Some(batch))) = (flag.as_str(), numbers) else {
        return false;
    };
    let Some(contest) = contest::ALL.get(index) else {
        return false;
    };
    let contest = contest();
    let batches = [&contest.own.call, &contest.own.empty, &contest.other.call, &contest.other.empty];
    counted(batches[batch]);
    true
}

/// Instructions of a call of sunglint and of the peer in the contest at `index`, the empty call's taken off.
///
/// # Errors
/// Where Valgrind is missing or does not say what it has counted.
pub fn instructions(index: usize, sides: [&Contender; 2]) -> io::Result<[f64; 2]> {
    let [own, other] = sides.map(|side| side.inputs as f64);
    let batch = |batch| collected(index, batch);
    Ok([(batch(0)? - batch(1)?) / own, (batch(2)? - batch(3)?) / other])
}

fn collected(contest: usize, batch: usize) -> io::Result<f64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=*callgrind*counted*"])
        .arg(env::current_exe()?)
        .args([COUNTED, &contest.to_string(), &batch.to_string()])
        .output()?;
    let said = String::from_utf8_lossy(&output.stderr);
    let count = said.lines().find_map(|line| line.split_once("Collected :"));
    let number = count.and_then(|(_, number)| number.trim().parse().ok());
    number.ok_or_else(|| io::Error::other(format!("no count in what Valgrind has said:\n{said}")))
}
