//! The tables of errors in the documentation of single functions hold what the searches of `tests/figures.rs` do.

mod public_functions;

use std::collections::BTreeSet;

use public_functions::Function;
use sunglint::trial::property::figures::Row;
use sunglint::trial::property::{blackbody, radiometry, sampling};

const SAMPLING: &str = include_str!("../src/sampling.rs");
const BASIS: &str = include_str!("../src/sampling/basis.rs");
const TURN: &str = include_str!("../src/sampling/turn.rs");
const DIFFUSE: &str = include_str!("../src/diffuse.rs");
const PIXEL: &str = include_str!("../src/raw/pixel.rs");
const RELATIVE: &str = include_str!("../src/blackbody/relative.rs");

/// The figures of the first row of that name in a file's text after `heading`.
fn documented(text: &str, heading: &str, name: &str) -> Vec<f64> {
    let start = format!("/// | {name} | ");
    let after = text.split_once(heading).unwrap_or_else(|| panic!("nothing says {heading}")).1;
    let row = after.lines().find_map(|line| line.trim_start().strip_prefix(&start));
    let row = row.unwrap_or_else(|| panic!("{heading} has no row {name}"));
    row.trim_end_matches(" |").split(" | ").map(|figure| figure.parse().unwrap()).collect()
}

/// The greatest budgets of the rows from one name to another, in each format.
fn greatest(rows: &[Row], from: &str, to: &str) -> [f64; 7] {
    let place = |name| rows.iter().position(|row| row.0 == name).unwrap_or_else(|| panic!("no budget of {name}"));
    rows[place(from)..=place(to)]
        .iter()
        .fold([0.0; 7], |most, row| [0, 1, 2, 3, 4, 5, 6].map(|i| most[i].max(row.1[i])))
}

#[test]
fn directions_and_rims_of_discs() {
    let from = ["direction, below 0.001 rad", "rim, below 0.01 rad"];
    let ends = [
        ("0.01 rad, as the Sun", ["direction, below 0.01 rad", "rim, below 0.01 rad"]),
        ("0.5 rad", ["direction, below 0.5 rad", "rim, below 0.5 rad"]),
        ("half the sky", ["direction, up to half the sky", "rim, up to half the sky"]),
        ("the full sphere", ["direction, up to the full sphere", "rim, below 3.1406 rad"]),
    ];
    for (name, to) in ends {
        for (i, heading) in ["Worst error in radians", "Directions on the wrong side"].into_iter().enumerate() {
            let budgets = greatest(&sampling::BUDGETS, from[i], to[i]);
            assert_eq!(documented(SAMPLING, heading, name), budgets, "{heading}: {name}");
        }
    }
}

#[test]
fn lengths_basis_and_turn() {
    for (text, heading, name, budget) in [
        (SAMPLING, "Worst error", "any, the length's difference from 1", "length of a direction"),
        (BASIS, "Error", "worst", "basis"),
        (TURN, "Error", "worst", "sine and cosine of a turn"),
    ] {
        assert_eq!(documented(text, heading, name), greatest(&sampling::BUDGETS, budget, budget), "{budget}");
    }
}

#[test]
fn light_of_a_disc_that_sets() {
    for (name, end) in [("0.01, as the Sun's", "0.01"), ("0.5", "0.5"), ("1", "1")] {
        let [from, to] = ["0.001", end].map(|ratio| format!("relative illuminance, ratio to {ratio}"));
        let budgets = greatest(&radiometry::BUDGETS, &from, &to);
        assert_eq!(documented(DIFFUSE, "Worst relative error", name), budgets, "{name}");
    }
}

#[test]
fn black_bodies_relative_to_their_peak() {
    for (heading, law) in [("by wavelength over that", "wavelength"), ("by frequency over that", "frequency")] {
        for kind in ["relative", "absolute"] {
            let budget = format!("{law} over the peak's, {kind}");
            let [floats @ .., i2f14, i2f30, i16f16] = greatest(&blackbody::BUDGETS, &budget, &budget);
            let fixed = i2f14.max(i2f30).max(i16f16);
            assert_eq!(documented(RELATIVE, heading, kind), [&floats[..], &[fixed]].concat(), "{budget}");
        }
    }
}

/// Every error that the header for C states is stated in Rust, of what has the same name but for its format.
#[test]
fn errors_in_the_header_are_those_of_rust() {
    let functions = public_functions::public_functions();
    let figures = |function: &Function| -> BTreeSet<String> {
        function.documentation.iter().flat_map(|line| errors(line)).collect()
    };
    let mut compared = 0;
    for function in functions.iter().filter(|function| function.module == "capi") {
        let name = function.name.strip_prefix("capi::sunglint_").unwrap();
        let plain = ["_q14", "_q30", "_q16"].iter().fold(name, |name, end| name.trim_end_matches(end));
        let last = plain.rsplit('_').next().unwrap();
        let rust = functions.iter().filter(|other| other.module != "capi" && other.name.contains(last));
        let mut stated: BTreeSet<String> = rust.flat_map(figures).collect();
        if plain.starts_with("pixel") {
            // Of the type.
            stated.extend(errors(PIXEL));
        }
        for figure in figures(function) {
            assert!(stated.contains(&figure), "{name}: {figure} is none of {stated:?}");
            compared += 1;
        }
    }
    assert!(compared > 20, "{compared}");
}

/// The numbers of a text that are written as errors are, `1.7e-4`.
fn errors(text: &str) -> impl Iterator<Item = String> {
    let words = text.split([' ', ',', ';', ':', '|', '\n']).map(|word| word.trim_end_matches('.'));
    words.filter(|word| is_error(word)).map(str::to_owned)
}

fn is_error(word: &str) -> bool {
    word.split_once("e-").is_some_and(|(digits, power)| {
        digits.starts_with(|letter: char| letter.is_ascii_digit())
            && power.chars().all(|letter| letter.is_ascii_digit())
    })
}
