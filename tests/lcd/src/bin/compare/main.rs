//! `compare <folder of what the firmware gave> <folder of what is committed>`: whether every core has drawn the host's
//! frames and taken the committed instructions, and whether the README's picture is of those frames. With
//! `SUNGLINT_RECORD=1` it writes figures and picture instead.

#[path = "../../../../firmware/src/table/elf.rs"]
mod elf;
mod figures;
mod frames;
mod picture;
#[cfg(test)]
mod readme;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use figures::Figure;

/// What the README is to show.
const PICTURE: &str = "ball.png";

/// What the README is to quote.
const FIGURES: &str = "figures.csv";

/// Targets, and the cores they stand for.
const CORES: [(&str, &str); 3] =
    [("thumbv6m-none-eabi", "M0+"), ("thumbv7m-none-eabi", "M3"), ("thumbv7em-none-eabihf", "M4F")];

fn main() -> ExitCode {
    let [fresh, committed] = [1, 2].map(|index| PathBuf::from(std::env::args().nth(index).expect("two paths")));
    let mut complaints: Vec<String> =
        CORES.into_iter().filter_map(|(target, core)| drawn(&fresh, target, core)).collect();
    let counts = CORES.into_iter().flat_map(|(target, core)| counted(&fresh, target, core));
    let figures: Vec<Figure> = counts.chain([flash(&fresh)]).collect();
    let (table, picture) = (committed.join(FIGURES), committed.join(PICTURE));
    if std::env::var("SUNGLINT_RECORD").is_ok_and(|value| value == "1") {
        std::fs::write(&table, figures::text(&figures)).expect("the table can be written");
        std::fs::write(&picture, picture::encoded()).expect("the picture can be written");
        println!("{FIGURES} and {PICTURE} written");
    } else {
        let table = std::fs::read_to_string(&table).expect("the committed table");
        complaints.extend(figures::compare(&figures, &table));
        if picture::decoded(&std::fs::read(&picture).expect("the committed picture")) != Some(picture::strip()) {
            complaints.push(format!("{PICTURE} is not of the host's frames"));
        }
    }
    complaints.iter().for_each(|complaint| eprintln!("{complaint}"));
    if complaints.is_empty() {
        println!("frames as on the host on {} cores, {} figures as committed", CORES.len(), figures.len());
        return ExitCode::SUCCESS;
    }
    eprintln!("SUNGLINT_RECORD=1 tests/lcd/run writes figures and picture anew");
    ExitCode::FAILURE
}

/// What is wrong with the frames of a core.
fn drawn(fresh: &Path, target: &str, core: &str) -> Option<String> {
    let bytes = std::fs::read(fresh.join(target).join("frames.rgb565")).expect("the frames of a target");
    frames::difference(&bytes, &frames::host()).map(|difference| format!("{core}: {difference}"))
}

/// What was counted on a core.
fn counted(fresh: &Path, target: &str, core: &str) -> Vec<Figure> {
    let counts = std::fs::read_to_string(fresh.join(target).join("counts.csv")).expect("the counts of a target");
    counts.lines().flat_map(|line| figures::counted(core, line)).collect()
}

/// Bytes of the whole image that needs no buffer, on the smallest core.
fn flash(fresh: &Path) -> Figure {
    let value = elf::bytes(&fresh.join("panel")).iter().sum();
    Figure { ball: "I2F14 PixelQ14".to_owned(), core: CORES[0].1.to_owned(), measure: "flash", value }
}
