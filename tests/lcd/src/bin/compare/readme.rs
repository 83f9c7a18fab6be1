//! The README has the file and the figures that are here.

use crate::{CORES, figures};

const README: &str = include_str!("../../../../../README.md");

const FIGURES: &str = include_str!("../../../figures.csv");

/// What the rows of the section's table are of.
const ROWS: [(&str, &str); 3] = [
    ("I2F14, `PixelQ14`", "I2F14 PixelQ14"),
    ("f32, `Scene` with `DiscGgx`", "f32 Scene"),
    ("f32, by hand", "f32 by hand"),
];

fn section() -> &'static str {
    let section = README.split("\n## On a small LCD\n").nth(1).expect("the README has a section of the LCD");
    section.split("\n## ").next().unwrap()
}

/// The fenced block of a file.
fn block(path: &str) -> &'static str {
    let after = section().split(&format!("`{path}`:\n")).nth(1).unwrap_or_else(|| panic!("no {path} in the README"));
    let fenced = after.split_once("```rust,ignore\n").expect("a block of Rust").1;
    &fenced[..fenced.find("\n```").expect("the block's end") + 1]
}

#[test]
fn its_ball_is_what_the_firmware_draws() {
    assert_eq!(block("src/ball.rs"), include_str!("../../ball.rs"));
}

#[test]
fn its_table_is_what_was_counted() {
    for (name, ball) in ROWS {
        let value = |core, measure| figures::value(FIGURES, ball, core, measure).unwrap();
        let pixels = CORES.map(|(_, core)| value(core, "pixel").to_string()).join(" | ");
        let frames = CORES.map(|(_, core)| millions(value(core, "frame"))).join(" | ");
        let row = format!("| {name} | {pixels} | {frames} | {} |", value("M0+", "stack"));
        assert!(section().contains(&row), "{row}");
    }
    let frames = ROWS.map(|(_, ball)| seconds(figures::value(FIGURES, ball, "M0+", "frame").unwrap()));
    let [fixed, scene, by_hand] = frames;
    let sentence = format!("draws a frame in {fixed} s in I2F14, in {scene} s and {by_hand} s in f32");
    assert!(section().contains(&sentence), "{sentence}");
    let flash = figures::value(FIGURES, "I2F14 PixelQ14", "M0+", "flash").unwrap();
    assert!(section().contains(&format!("{flash} bytes of flash")), "{flash}");
    let pixels = figures::value(FIGURES, "I2F14 PixelQ14", "M0+", "pixels").unwrap();
    assert!(section().contains(&format!("(the mean of {pixels})")), "{pixels}");
}

/// Millions, to the first digit after the point.
fn millions(value: u32) -> String {
    format!("{:.1}", f64::from(value) / 1e6)
}

/// At 48 MHz with a cycle and a half an instruction, to a tenth.
fn seconds(instructions: u32) -> String {
    format!("{:.1}", f64::from(instructions) * 1.5 / 48e6)
}
