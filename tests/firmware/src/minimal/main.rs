//! `minimal <folder of targets> <committed table> <target>...`: measures the least firmware in each format, runs it,
//! and compares with the committed table; with `SUNGLINT_RECORD=1` it writes that instead.

#[path = "../table/elf.rs"]
mod elf;
mod image;
mod inputs;
mod line;
mod pixels;
mod ram;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread;

use image::{Cost, IMAGES};
use line::{CORES, HEADER, Line};

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let [folder, committed] = [(); 2].map(|()| PathBuf::from(arguments.next().expect("two paths and targets")));
    let targets: Vec<String> = arguments.collect();
    let lines = measured(&folder, &targets);
    let table = std::fs::read_to_string(&committed).unwrap_or_default();
    if std::env::var("SUNGLINT_RECORD").is_ok_and(|value| value == "1") {
        assert_eq!(targets.len(), CORES.len(), "the table is of all cores");
        let text: Vec<_> = lines.iter().map(|line| format!("{line}\n")).collect();
        std::fs::write(&committed, format!("{HEADER}\n{}", text.concat())).expect("the table can be written");
        println!("{} lines of minimal firmware written", lines.len());
        return ExitCode::SUCCESS;
    }
    let complaints = compare(&lines, &table);
    complaints.iter().for_each(|complaint| eprintln!("{complaint}"));
    if complaints.is_empty() {
        println!("{} lines of minimal firmware as committed; none has variables, none panics", lines.len());
        return ExitCode::SUCCESS;
    }
    eprintln!("{} figures differ: SUNGLINT_RECORD=1 tests/firmware/run writes the table anew", complaints.len());
    ExitCode::FAILURE
}

/// All images on all targets, a thread for each target.
fn measured(folder: &Path, targets: &[String]) -> Vec<Line> {
    let measure = |target: &str| -> Vec<Cost> { IMAGES.iter().map(|image| image.measure(folder, target)).collect() };
    let costs: Vec<Vec<Cost>> = thread::scope(|scope| {
        let threads: Vec<_> = targets.iter().map(|target| scope.spawn(|| measure(target))).collect();
        threads.into_iter().map(|thread| thread.join().expect("the reason is above")).collect()
    });
    let line = |(index, image): (usize, &image::Image)| {
        let mut line = Line { key: image.key(), costs: [None; CORES.len()] };
        line.costs.iter_mut().zip(&costs).for_each(|(cost, of_target)| *cost = Some(of_target[index]));
        line
    };
    IMAGES.iter().enumerate().map(line).collect()
}

/// What is missing, new or off.
fn compare(lines: &[Line], table: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    if table.lines().next() != Some(HEADER) {
        complaints.push("the table of minimal firmware has other columns".to_owned());
    }
    let mut committed: HashMap<String, Line> = HashMap::new();
    for text in table.lines().skip(1) {
        match line::committed(text) {
            Some(line) => drop(committed.insert(line.key.clone(), line)),
            None => complaints.push(format!("not a line: {text}")),
        }
    }
    for line in lines {
        match committed.remove(&line.key) {
            Some(before) => complaints.extend(line.against(&before)),
            None => complaints.push(format!("{} is new", line.key)),
        }
    }
    complaints.extend(committed.keys().map(|key| format!("{key} is missing")));
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    const MEASURED: &str = "cap,I2F14,sunglint,1000,100,200,1000,100,200,1000,100,200,1000,100,200";

    fn complaints(committed: &str) -> usize {
        compare(&[line::committed(MEASURED).unwrap()], &format!("{HEADER}\n{committed}\n")).len()
    }

    #[test]
    fn the_same_passes_and_so_does_a_little_more() {
        assert_eq!(complaints(MEASURED), 0);
        assert_eq!(complaints(&MEASURED.replace("1000,100", "1020,104")), 0);
    }

    #[test]
    fn each_figure_that_is_off_is_told() {
        assert_eq!(complaints(&MEASURED.replacen("1000", "1030", 1)), 1);
        assert_eq!(complaints(&MEASURED.replacen("200", "190", 4)), 4);
    }

    #[test]
    fn rows_missing_and_new_are_told() {
        assert_eq!(complaints(""), 2);
        assert_eq!(complaints(&MEASURED.replace("cap", "disc")), 2);
        assert_eq!(complaints(&MEASURED.replacen("1000,100,200", ",,", 1)), 1);
    }
}
