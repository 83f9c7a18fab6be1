//! `minimal <folder of targets> <committed table> <target>...`: measures the least firmware in each format, runs it,
//! and compares with the committed table; with `SUNGLINT_RECORD=1` it writes that instead.

#[path = "../committed.rs"]
mod committed;
#[path = "../table/elf.rs"]
mod elf;
mod image;
mod inputs;
mod line;
mod pixels;
mod ram;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread;

use image::{Cost, IMAGES};
use line::{CORES, Line};

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let [folder, table] = [(); 2].map(|()| PathBuf::from(arguments.next().expect("two paths and targets")));
    let targets: Vec<String> = arguments.collect();
    let lines = measured(&folder, &targets);
    assert!(!committed::is_recorded() || targets.len() == CORES.len(), "the table is of all cores");
    committed::settle(&lines, &table, "lines of minimal firmware, without variables and panics,")
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

#[cfg(test)]
mod tests {
    use super::*;
    use committed::{Line as _, compare};

    const MEASURED: &str = "cap,I2F14,sunglint,1000,100,200,1000,100,200,1000,100,200,1000,100,200";

    fn complaints(committed: &str) -> usize {
        compare(&[Line::parse(MEASURED).unwrap()], &format!("{}\n{committed}\n", Line::HEADER)).len()
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
