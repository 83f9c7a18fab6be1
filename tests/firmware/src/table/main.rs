//! `table <folder of fresh counts and linked functions> <committed table>`: puts what has been counted and linked on
//! all cores together and compares it with the committed table; with `SUNGLINT_RECORD=1` it writes that instead.

#[path = "../committed.rs"]
mod committed;
mod elf;
mod line;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use line::{Key, Line};

/// In the order of the table's columns.
const TARGETS: [&str; 3] = ["thumbv6m-none-eabi", "thumbv7m-none-eabi", "thumbv7em-none-eabihf"];

/// What the smallest image may take on the smallest core.
const FLASH: u32 = 1024;

fn main() -> ExitCode {
    let [fresh, table] = [1, 2].map(|index| PathBuf::from(std::env::args().nth(index).expect("two paths")));
    let lines = measured(&fresh);
    for target in TARGETS {
        let [text, rodata] = elf::bytes(&fresh.join(target).join("flash.elf"));
        println!("{target}: cap_q14 and normalize_q14 together {text} + {rodata} bytes");
        if target == TARGETS[0] && text + rodata >= FLASH {
            eprintln!("which has to be below {FLASH}");
            return ExitCode::FAILURE;
        }
    }
    committed::settle(&lines, &table, "lines")
}

/// The lines of all cores as one, in the order of the first.
fn measured(fresh: &Path) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    let mut places: HashMap<Key, usize> = HashMap::new();
    for (core, target) in TARGETS.into_iter().enumerate() {
        let counts = std::fs::read_to_string(fresh.join(format!("{target}.csv"))).expect("the counts of a target");
        for text in counts.lines() {
            let (key, count, note) = line::count(text).unwrap_or_else(|| panic!("{target}: not a count: {text}"));
            let place = *places.entry(key.clone()).or_insert_with(|| {
                lines.push(Line::new(key.clone()));
                lines.len() - 1
            });
            let line = &mut lines[place];
            if let Some([median, worst, stack]) = count {
                let [text, rodata] = elf::bytes(&fresh.join(target).join(key.file()));
                line.costs[core] = Some([median, worst, stack, text, rodata]);
            }
            line.add(note);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use committed::{Line as _, compare};

    const COUNTED: &str = "cap,f32,sunglint,any,256,100,200,300,400,0,100,200,300,400,0,100,200,300,400,0,";

    fn complaints(committed: &str) -> usize {
        compare(&[Line::parse(COUNTED).unwrap()], &format!("{}\n{committed}\n", Line::HEADER)).len()
    }

    #[test]
    fn the_same_passes_and_so_does_a_little_more() {
        assert_eq!(complaints(COUNTED), 0);
        assert_eq!(complaints(&COUNTED.replace("400,0,100,", "408,1,102,")), 0);
    }

    #[test]
    fn each_figure_that_is_off_is_told() {
        assert_eq!(complaints(&COUNTED.replacen("100", "103", 1)), 1);
        assert_eq!(complaints(&COUNTED.replacen("200", "190", 1)), 1);
        assert_eq!(complaints(&COUNTED.replacen("300", "310", 2)), 2);
        assert_eq!(complaints(&COUNTED.replacen("400,0", "410,2", 3)), 6);
    }

    #[test]
    fn rows_missing_and_new_are_told() {
        assert_eq!(complaints(""), 2);
        assert_eq!(complaints(&COUNTED.replace("any", "inside")), 2);
        assert_eq!(complaints(&format!("{COUNTED}\n{}", COUNTED.replace("cap", "disc"))), 1);
        assert_eq!(complaints(&COUNTED.replace("100,200,300,400,0,", ",,,,,")), 3);
    }
}
