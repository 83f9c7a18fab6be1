//! The README's tables are the tables of budgets, and what the tests' own says of tests is so.

use std::f64::consts::FRAC_PI_2;

use sunglint::trial::judge::DISC_LOST;
use sunglint::trial::{Format, Method, Shading, Visitor, budget, gloss, input, judge};
use sunglint::{Real, SUN};

const METHODS: [Method; 4] = [Method::Cap, Method::Factored, Method::Disc, Method::Epic];

const README: &str = include_str!("../README.md");

/// What is in the crate, and what proves it.
const PROOF: &str = include_str!("README.md");

/// The cells of the row of `format` in the first table of `text` that has one.
fn row(text: &str, format: Format) -> Vec<String> {
    let start = format!("| {} |", format.name());
    let line = text.lines().map(|line| line.trim_start_matches("//! ")).find(|line| line.starts_with(&start));
    line.unwrap_or_else(|| panic!("no row for {}", format.name()))
        .split('|')
        .map(|cell| cell.trim().to_owned())
        .collect()
}

#[test]
fn errors_are_the_budgets_that_are_asserted() {
    for format in Format::ALL {
        let cells = row(README.split("## Which method in which format?").nth(1).unwrap(), format);
        for (index, method) in METHODS.into_iter().enumerate() {
            let cell = &cells[2 + 2 * index];
            let shown =
                cell.split(',').next().and_then(|figure| figure.parse::<f64>().ok().filter(|figure| !figure.is_nan()));
            assert_eq!(shown, budget::maximum(method, format, 0), "{} in {}", method.name(), format.name());
            let lost = cell.contains("disc lost");
            assert_eq!(lost, loses_the_disc(method, format), "{} in {}", method.name(), format.name());
        }
    }
}

/// The figures of the first row in the documentation of directions that starts so.
fn documented(start: &str) -> [Option<f64>; 7] {
    let start = format!("/// | {start} |");
    let line = include_str!("../src/specular.rs").lines().find(|line| line.starts_with(&start)).unwrap();
    let cells: Vec<&str> = line.split('|').map(str::trim).collect();
    std::array::from_fn(|index| cells[2 + index].parse().ok())
}

#[test]
fn errors_in_the_documentation_are_the_budgets_too() {
    let formats = include_str!("../src/lib.rs");
    for format in Format::ALL {
        let shown = |start: &str| documented(start)[format as usize];
        let cap = budget::maximum(Method::Cap, format, 0);
        assert_eq!(row(formats, format)[4].trim_end_matches(" rad").parse().ok(), cap, "{}", format.name());
        assert_eq!(shown("worst"), cap, "{}", format.name());
        assert_eq!(shown("the Sun"), budget::maximum(Method::Factored, format, 0), "{}", format.name());
        let widest = budget::of_any_light(Method::Factored, format, FRAC_PI_2);
        assert_eq!(shown("up to half the sky"), widest, "{}", format.name());
        let normalized = budget::normalize(format).map(Some);
        assert_eq!([shown("direction, rad"), shown("length")], normalized, "{}", format.name());
    }
}

#[test]
fn errors_in_the_documentation_of_raw_bits_are_the_budgets_too() {
    let mut documentation = include_str!("../src/raw.rs").lines();
    for (format, places) in [(Format::I2F14, "Q14"), (Format::I2F30, "Q30")] {
        for method in [Method::Cap, Method::Factored, Method::Disc] {
            let start = format!("/// [`{0}`](specular::{0}) in {places}", method.name());
            let line = documentation.find(|line| line.starts_with(&start)).unwrap();
            let figure = line.split("at the Sun ").nth(1).and_then(|rest| rest.split(" rad").next());
            assert_eq!(figure.unwrap().parse().ok(), budget::maximum(method, format, 0), "{line}");
        }
    }
}

/// Whether the study says so of the Sun from Earth.
fn loses_the_disc(method: Method, format: Format) -> bool {
    format.visit(Lost { method })
}

struct Lost {
    method: Method,
}

impl Visitor for Lost {
    type Output = bool;

    fn visit<T: Real>(self) -> bool {
        let pairs = input::random(1, 20_000, SUN.angular_radius());
        let judgement = judge::<T>(self.method, &SUN, pairs, 1e-3);
        judgement.undirected < judgement.samples && judgement.disc_lost >= DISC_LOST
    }
}

/// What is under a heading of the proof.
fn section(heading: &str) -> &'static str {
    PROOF.split(heading).nth(1).and_then(|rest| rest.split("\n## ").next()).unwrap()
}

/// Every system has a function that exists and a test that exists.
#[test]
fn every_system_names_its_function_and_its_test() {
    let table = section("## What is in it, and what proves it");
    let rows: Vec<Vec<&str>> = table
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| system"))
        .map(|line| line.split('|').map(str::trim).collect())
        .collect();
    assert!(rows.len() > 30, "{}", rows.len());
    let code =
        ["src", "src/highlight", "src/sampling", "src/radiometry", "src/blackbody", "src/oracle"].map(sources).concat();
    for row in rows {
        for function in row[2].split(", ").map(|name| name.trim_matches('`')) {
            let declared = ["fn ", "struct ", "enum "].iter().any(|kind| {
                let head = format!("{kind}{function}");
                let ends = |text: &str| !text.starts_with(|next: char| next.is_alphanumeric() || next == '_');
                code.split(&head).skip(1).any(ends)
            });
            assert!(declared, "{function} is nowhere");
        }
        assert_is_a_test(row[3]);
    }
}

/// Holds that what a cell names, "`file`: `test`", is a test that is run.
fn assert_is_a_test(cell: &str) {
    let (file, test) = cell.split_once(": ").unwrap_or_else(|| panic!("{cell} names no test"));
    let path = format!("{}/tests/{}", env!("CARGO_MANIFEST_DIR"), file.trim_matches('`'));
    let code = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let name = test.split(',').next().unwrap().trim_matches('`');
    let head = format!("#[test]\nfn {name}()");
    assert!(code.contains(&head), "{test} is not in {path}");
}

/// Every failure on record has a test that exists, and every test of the catalogues is on record.
#[test]
fn every_failure_on_record_names_its_test() {
    let rows = section("## Failures on record")
        .lines()
        .filter(|line| line.starts_with("| ") && !line.contains("| test in `tests/` |"));
    let cells: Vec<&str> = rows.map(|line| line.trim_end_matches(" |").rsplit(" | ").next().unwrap()).collect();
    assert!(README.contains(&format!("the {} failures on record", cells.len())), "{}", cells.len());
    cells.iter().for_each(|cell| assert_is_a_test(cell));
    for file in ["failures.rs", "light_failures.rs"] {
        let path = format!("{}/tests/{file}", env!("CARGO_MANIFEST_DIR"));
        let code = std::fs::read_to_string(&path).unwrap();
        let names = code.split("#[test]\nfn ").skip(1).map(|rest| rest.split('(').next().unwrap());
        for name in names {
            assert!(cells.contains(&format!("`{file}`: `{name}`").as_str()), "{name} is not on record");
        }
    }
}

/// All Rust files of a folder, one after the other.
fn sources(folder: &str) -> String {
    let entries = std::fs::read_dir(format!("{}/{folder}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let paths =
        entries.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|end| end == "rs"));
    paths.map(|path| std::fs::read_to_string(path).unwrap()).collect()
}

/// The arithmetic of whole pixels is what `tests/gloss.rs` asserts.
#[test]
fn errors_of_pixels_are_the_budgets_that_are_asserted() {
    let section = README.split("## A lit pixel").nth(1).unwrap();
    let family = gloss::family(Shading::ConeGgx);
    for (case, means) in gloss::CASES.iter().zip(gloss::MEANS[family]) {
        let start = format!("| {} |", case.name);
        let line = section.lines().find(|line| line.starts_with(&start)).unwrap_or_else(|| panic!("no row {start}"));
        // The last column is the model's.
        let cells: Vec<f64> = line.split('|').skip(2).take(7).filter_map(|cell| cell.trim().parse().ok()).collect();
        assert_eq!(cells, means, "{}", case.name);
    }
}

/// So are the figures in the documentation of the default highlight.
#[test]
fn errors_of_the_cone_in_its_documentation_are_the_budgets_too() {
    let code = include_str!("../src/highlight/cone.rs").replace("\n///", "");
    let text = code.split("Root mean square error of a whole pixel").nth(1).unwrap();
    let (polish, varnish) = text.split_once(';').unwrap();
    let means = gloss::MEANS[gloss::family(Shading::ConeGgx)];
    for (text, means) in [(polish, means[0]), (varnish, means[1])] {
        for format in [Format::F32, Format::F16, Format::I2F14, Format::I2F30] {
            let after = text.split(&format!("{} ", format.name())).nth(1).unwrap();
            let figure: String =
                after.chars().take_while(|next| next.is_ascii_digit() || ".e-".contains(*next)).collect();
            let figure = figure.trim_end_matches('.').parse().ok();
            assert_eq!(figure, Some(means[format as usize]), "{}: {after:.20}", format.name());
        }
    }
}
