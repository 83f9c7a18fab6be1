//! `table <folder of fresh counts and linked functions> <committed table>`: puts what has been counted and linked on
//! all cores together and compares it with the committed table; with `SUNGLINT_RECORD=1` it writes that instead.

mod elf;
mod line;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use line::{Key, Line};

/// In the order of the table's columns.
const TARGETS: [&str; 3] = ["thumbv6m-none-eabi", "thumbv7m-none-eabi", "thumbv7em-none-eabihf"];

const HEADER: &str = "function,format,by,case,inputs,\
    m0_median,m0_worst,m0_stack,m0_text,m0_rodata,\
    m3_median,m3_worst,m3_stack,m3_text,m3_rodata,\
    m4_median,m4_worst,m4_stack,m4_text,m4_rodata,note";

/// What the smallest image may take on the smallest core.
const FLASH: u32 = 1024;

fn main() -> ExitCode {
    let [fresh, committed] = [1, 2].map(|index| PathBuf::from(std::env::args().nth(index).expect("two paths")));
    let lines = measured(&fresh);
    let table = std::fs::read_to_string(&committed).expect("the committed table");
    for target in TARGETS {
        let [text, rodata] = elf::bytes(&fresh.join(target).join("flash.elf"));
        println!("{target}: cap_q14 and normalize_q14 together {text} + {rodata} bytes");
        if target == TARGETS[0] && text + rodata >= FLASH {
            eprintln!("which has to be below {FLASH}");
            return ExitCode::FAILURE;
        }
    }
    if std::env::var("SUNGLINT_RECORD").is_ok_and(|value| value == "1") {
        let text: Vec<_> = lines.iter().map(|line| format!("{line}\n")).collect();
        std::fs::write(&committed, format!("{HEADER}\n{}", text.concat())).expect("the table can be written");
        println!("{} lines written", lines.len());
        return ExitCode::SUCCESS;
    }
    let complaints = compare(&lines, &table);
    complaints.iter().for_each(|complaint| eprintln!("{complaint}"));
    if complaints.is_empty() {
        println!("{} lines as committed", lines.len());
        return ExitCode::SUCCESS;
    }
    eprintln!("{} figures differ: SUNGLINT_RECORD=1 tests/firmware/run writes the table anew", complaints.len());
    ExitCode::FAILURE
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

/// What is missing, new, or off by more than 2 % and by more than 1.
fn compare(lines: &[Line], table: &str) -> Vec<String> {
    let mut committed: HashMap<Key, Line> = HashMap::new();
    let mut complaints = Vec::new();
    if table.lines().next() != Some(HEADER) {
        complaints.push("the table has other columns".to_owned());
    }
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

    const COUNTED: &str = "cap,f32,sunglint,any,256,100,200,300,400,0,100,200,300,400,0,100,200,300,400,0,";

    fn complaints(committed: &str) -> usize {
        compare(&[line::committed(COUNTED).unwrap()], &format!("{HEADER}\n{committed}\n")).len()
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
