//! The README's table of what calls cost on a microcontroller is made of the table of counts and of the errors that
//! tests hold; where it is not, the test prints the lines to put there.

use std::collections::HashMap;

use sunglint::trial::chip::{Core, Row, rows};
use sunglint::trial::{Format, Method, Shading, budget, gloss};

const README: &str = include_str!("../README.md");

/// Name in the README; function, format and author in the table of counts.
const SHOWN: [[&str; 4]; 31] = [
    ["`cap`", "cap", "I2F14", "sunglint"],
    ["the same by the formula that all formats share", "cap", "I2F14", "formula"],
    ["`cap`", "cap", "I2F30", "sunglint"],
    ["the same by the formula", "cap", "I2F30", "formula"],
    ["`cap`", "cap", "I16F16", "sunglint"],
    ["`soft::cap`", "cap", "f32", "sunglint soft"],
    ["`cap`", "cap", "f32", "sunglint"],
    ["the same by hand over libm 0.2.16", "cap", "f32", "libm 0.2.16"],
    ["the same over micromath 2.1.0", "cap", "f32", "micromath 2.1.0"],
    ["`cap`", "cap", "f16", "sunglint"],
    ["`cap`", "cap", "f64", "sunglint"],
    ["`factored`", "factored", "I2F14", "sunglint"],
    ["`factored`", "factored", "I2F30", "sunglint"],
    ["`normalize`", "normalize", "I2F14", "sunglint"],
    ["`fixed` 1.31.0, its operators and root", "normalize", "I2F14", "fixed 1.31.0"],
    ["`normalize`", "normalize", "I2F30", "sunglint"],
    ["`fixed` 1.31.0, its operators and root", "normalize", "I2F30", "fixed 1.31.0"],
    ["`soft::normalize`", "normalize", "f32", "sunglint soft"],
    ["the same over libm 0.2.16", "normalize", "f32", "libm 0.2.16"],
    ["the same over micromath 2.1.0", "normalize", "f32", "micromath 2.1.0"],
    ["1/root of a mantissa", "reciprocal root", "Q31", "sunglint"],
    ["`reciprocal_root_q16`", "reciprocal root", "U16F16", "sunglint"],
    ["`fixed` 1.31.0, its root and `recip`", "reciprocal root", "U16F16", "fixed 1.31.0"],
    ["`soft::reciprocal_root`", "reciprocal root", "f32", "sunglint soft"],
    ["the same over libm 0.2.16", "reciprocal root", "f32", "libm 0.2.16"],
    ["root by cordic 0.1.5, which does not return from 16384 on", "root", "I16F16", "cordic 0.1.5"],
    ["lit pixel, `PixelQ14`", "pixel disc_ggx", "I2F14", "PixelQ14"],
    ["lit pixel, `DiscGgx`", "pixel disc_ggx", "I2F14", "sunglint"],
    ["lit pixel, `DiscGgx`", "pixel disc_ggx", "f32", "sunglint"],
    ["lit pixel, `ConeGgx`", "pixel cone_ggx", "I2F14", "sunglint"],
    ["lit pixel, `ConeGgx`", "pixel cone_ggx", "f32", "sunglint"],
];

/// What peers are off by, as `tests/peers` holds it: by function, format and author.
fn peers() -> HashMap<[&'static str; 3], String> {
    let line = |line: &'static str| {
        let [function, format, by, error, unit, ..] = line.split(',').collect::<Vec<_>>()[..] else { panic!("{line}") };
        ([function, format, by], figure(error.parse().unwrap(), unit))
    };
    include_str!("../src/trial/chip/peers.csv").lines().skip(1).map(line).collect()
}

/// Two digits, or three where they tell.
fn figure(error: f64, unit: &str) -> String {
    match unit {
        "ULP" if error < 10.0 => format!("{error:.4}").trim_end_matches('0').to_owned() + " ULP",
        "ULP" => format!("{error:.0} ULP"),
        unit => format!("{error:.1e} {unit}"),
    }
}

/// The worst of all inputs, as `tests/exhaustive` holds it.
fn proved(name: &str, format: &str) -> String {
    let start = format!("{name};{format};");
    let line = include_str!("../src/trial/worst/kernels.csv")
        .lines()
        .find(|line| line.starts_with(&start))
        .unwrap_or_else(|| panic!("no {start}"));
    figure(line.split(';').nth(4).unwrap().parse().unwrap(), "ULP")
}

fn error([function, format, by]: [&'static str; 3], peers: &HashMap<[&'static str; 3], String>) -> String {
    if let Some(error) = peers.get(&[function, format, by]) {
        return error.clone();
    }
    let named = Format::ALL.into_iter().find(|one| one.name() == format);
    let method = Method::ALL.into_iter().find(|method| method.name() == function);
    let radians = |error: f64| format!("{error:.1e} rad");
    match (function, by) {
        ("cap", "sunglint soft") => radians(budget::SOFT_CAP[0]),
        ("normalize", "sunglint soft") => radians(budget::SOFT_NORMALIZE),
        ("cap", "formula") => String::new(),
        ("reciprocal root" | "root", "sunglint soft") => {
            proved(&format!("soft::{}", function.replace(' ', "_")), format)
        }
        ("reciprocal root", _) if format == "Q31" => proved("reciprocal_root", format),
        ("reciprocal root", _) => proved("reciprocal_root_q16", format),
        ("normalize", _) => radians(budget::normalize(named.unwrap())[0]),
        ("pixel disc_ggx", "PixelQ14") => share(gloss::PIXEL_Q14[1][1]),
        ("pixel disc_ggx", _) => share(gloss::MEANS[gloss::family(Shading::DiscGgx)][1][named.unwrap() as usize]),
        ("pixel cone_ggx", _) => share(gloss::MEANS[gloss::family(Shading::ConeGgx)][1][named.unwrap() as usize]),
        _ => radians(budget::maximum(method.unwrap(), named.unwrap(), 0).unwrap()),
    }
}

/// Root mean square of a whole pixel's relative error.
fn share(error: f64) -> String {
    format!("{error:.1e} rms")
}

/// The line of a function, from its rows for each case.
fn line([name, function, format, by]: [&'static str; 4], peers: &HashMap<[&'static str; 3], String>) -> String {
    let of =
        |case: &str| rows().find(|row| (row.function, row.format, row.by, row.case) == (function, format, by, case));
    let (whole, inside) = (of("any").or(of("outside")), of("inside"));
    let whole: Row = whole.unwrap_or_else(|| panic!("no row of {function} in {format} by {by}"));
    let counts = Core::ALL.map(|core| {
        let median = |row: Row| row.on(core).map_or("-".to_owned(), |cost| cost.median.to_string());
        match inside.map(median) {
            Some(inside) if inside != median(whole) => format!("{} / {inside}", median(whole)),
            _ => median(whole),
        }
    });
    let [m0, m3, m4] = counts;
    let cost = whole.on(Core::M0).unwrap();
    let stack = inside.and_then(|row| row.on(Core::M0)).map_or(cost.stack, |inside| cost.stack.max(inside.stack));
    let error = error([function, format, by], peers);
    format!("| {name} | {format} | {error} | {m0} | {m3} | {m4} | {} + {} | {stack} |", cost.text, cost.rodata)
}

#[test]
fn counts_in_the_readme_are_those_of_the_table() {
    let peers = peers();
    let expected: Vec<String> = SHOWN.into_iter().map(|shown| line(shown, &peers)).collect();
    let section = README.split("## On the chip").nth(1).and_then(|rest| rest.split("\n## ").next()).unwrap_or_default();
    let table: Vec<&str> = section.lines().filter(|line| line.starts_with("| ")).skip(1).collect();
    if table.len() < expected.len() || table[..expected.len()] != expected {
        panic!("the README's table should be\n{}", expected.join("\n"));
    }
}
