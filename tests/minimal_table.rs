//! The README's tables of minimal firmware, and of what to take on which chip, are made of what `tests/firmware/run`
//! has measured and of the budgets; where they are not, the test prints the lines to put there.

use sunglint::trial::chip::{Core, rows};
use sunglint::trial::{Format, Method, budget};

const README: &str = include_str!("../README.md");

const MINIMAL: &str = include_str!("../src/trial/chip/minimal.csv");

/// Columns of the table before those of cores.
const KEY: usize = 3;

/// A firmware's code and tables, and its stack, on a core: M0+, M3, M4F, riscv32imc.
#[derive(Clone, Copy)]
struct Needs {
    flash: u32,
    stack: u32,
}

fn needs(function: &str, format: &str, by: &str, core: usize) -> Option<Needs> {
    let start = format!("{function},{format},{by},");
    let line = MINIMAL.lines().find(|line| line.starts_with(&start))?;
    let columns: Vec<u32> = line.split(',').skip(KEY).map(|column| column.parse().unwrap()).collect();
    let [text, rodata, stack] = columns[3 * core..3 * core + 3] else { panic!("{line}") };
    Some(Needs { flash: text + rodata, stack })
}

/// Name in the README, format and author.
const FORMATS: [[&str; 3]; 10] = [
    ["none of this crate", "", ""],
    ["I2F14", "I2F14", "sunglint"],
    ["I2F14, `PixelQ14`", "I2F14", "PixelQ14"],
    ["I2F30", "I2F30", "sunglint"],
    ["I16F16", "I16F16", "sunglint"],
    ["f32 by `soft`", "f32", "sunglint soft"],
    ["f32", "f32", "sunglint"],
    ["micromath", "micromath", "sunglint"],
    ["f16", "f16", "sunglint"],
    ["f64", "f64", "sunglint"],
];

/// On the M0+.
fn formats() -> Vec<String> {
    let columns = |needs: Option<Needs>| needs.map_or(" | ".to_owned(), |it| format!("{} | {}", it.flash, it.stack));
    let line = |[name, format, by]: [&str; 3]| {
        let of = |function| match format {
            "" => needs("nothing", "I2F14", "sunglint", 0).filter(|_| function == "cap"),
            _ => needs(function, format, by, 0),
        };
        format!("| {name} | {} | {} |", columns(of("cap")), columns(of("pixel disc_ggx")))
    };
    FORMATS.into_iter().map(line).collect()
}

/// The beginning of a line.
struct Advice {
    chips: &'static str,
    take: &'static str,
    /// Whose error it is, where arithmetic is what it is here.
    format: Option<Format>,
    /// Of those measured.
    core: Option<usize>,
}

const fn advice(chips: &'static str, take: &'static str, format: Option<Format>, core: Option<usize>) -> Advice {
    Advice { chips, take, format, core }
}

const CHIPS: [Advice; 9] = [
    advice("Cortex-M0, M0+ (RP2040)", "I2F14", Some(Format::I2F14), Some(0)),
    advice("the same, finer", "I2F30", Some(Format::I2F30), Some(0)),
    advice("Cortex-M3 (STM32F1)", "I2F30", Some(Format::I2F30), Some(1)),
    advice("Cortex-M4F (STM32F4, nRF52)", "f32", Some(Format::F32), Some(2)),
    advice("riscv32imc (ESP32-C3)", "I2F14", Some(Format::I2F14), Some(3)),
    advice("ARM7TDMI (GBA)", "I2F14", Some(Format::I2F14), None),
    advice("Cortex-M33 (RP2350), M7", "f32", Some(Format::F32), None),
    advice("phone GPU, mediump", "`cap_half`", None, None),
    advice("desktop, WebAssembly", "f32", Some(Format::F32), None),
];

/// Up to what the README says of the reason.
fn chips() -> Vec<String> {
    let line = |Advice { chips, take, format, core }: &Advice| {
        let error = format.map(|format| format!("{:.1e}", budget::maximum(Method::Cap, format, 0).unwrap()));
        let counted = format.zip(core.and_then(|core| Core::ALL.get(core).copied()));
        let instructions = counted.map(|(format, core)| instructions(format, core).to_string());
        let measured = format.zip(*core).and_then(|(format, core)| needs("cap", format.name(), "sunglint", core));
        let flash = measured.map(|needs| needs.flash.to_string());
        let [error, instructions, flash] = [error, instructions, flash].map(Option::unwrap_or_default);
        format!("| {chips} | {take} | {error} | {instructions} | {flash} | ")
    };
    CHIPS.iter().map(line).collect()
}

/// Median of `cap` outside the disc.
fn instructions(format: Format, core: Core) -> u32 {
    let row = rows()
        .find(|row| (row.function, row.format, row.by, row.case) == ("cap", format.name(), "sunglint", "outside"))
        .unwrap();
    row.on(core).unwrap().median
}

/// Lines of the section's tables, those of names and rules left out.
fn tables() -> Vec<&'static str> {
    let section = README.split("## What it takes").nth(1).and_then(|rest| rest.split("\n## ").next());
    let names = ["| format |", "| chip |", "|-"];
    let line = |line: &&str| line.starts_with('|') && !names.iter().any(|name| line.starts_with(name));
    section.expect("a section What it takes").lines().filter(line).collect()
}

#[test]
fn the_tables_in_the_readme_are_as_measured() {
    let expected: Vec<String> = formats().into_iter().chain(chips()).collect();
    let tables = tables();
    let same = tables.len() == expected.len() && tables.iter().zip(&expected).all(|(line, own)| line.starts_with(own));
    assert!(same, "the README's tables should begin so:\n{}", expected.join("\n"));
}

#[test]
fn reasons_are_as_measured() {
    let flash = |format: Format, core| needs("cap", format.name(), "sunglint", core).unwrap().flash;
    let of_instructions = instructions(Format::F32, Core::M0) / instructions(Format::I2F14, Core::M0);
    let fewer = instructions(Format::I2F30, Core::M3) - instructions(Format::I2F14, Core::M3);
    let smaller = flash(Format::I2F30, 1) - flash(Format::I2F14, 1);
    let reasons = [
        format!("a {of_instructions}th of f32's instructions"),
        format!("{fewer} instructions and {smaller} bytes more than I2F14"),
        format!("I2F30 takes {}", instructions(Format::I2F30, Core::M4)),
        format!("I2F30 is {} bytes, f32 by software {}", flash(Format::I2F30, 3), flash(Format::F32, 3)),
    ];
    let missing: Vec<_> = reasons.into_iter().filter(|reason| !README.contains(reason)).collect();
    assert!(missing.is_empty(), "the README should say {missing:#?}");
}

#[test]
fn every_image_is_measured_on_every_core() {
    let columns = MINIMAL.lines().map(|line| line.split(',').filter(|column| !column.is_empty()).count());
    assert!(columns.clone().all(|columns| columns == KEY + 3 * 4));
    assert_eq!(columns.count(), 18);
}
