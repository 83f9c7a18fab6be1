//! The table of what calls cost on microcontrollers is whole, and the inputs are what its cases say. That its figures
//! are right is for `tests/firmware/run` to say, which counts anew.

use std::collections::HashSet;

use sunglint::trial::chip::peers::{self, Peer};
use sunglint::trial::chip::{Case, Core, Cost, INPUTS, Pixel, RUSTC, Row, TABLE, numbers, pairs, pixels, rows};
use sunglint::trial::{Constants, Format, Method, Shading, Visitor};
use sunglint::{Real, SUN, cap, reflect};

const CASES: [&str; 3] = ["inside", "outside", "any"];

fn row(function: &str, format: &str, by: &str, case: &str) -> Option<Row> {
    rows().find(|row| (row.function, row.format, row.by, row.case) == (function, format, by, case))
}

#[test]
fn every_line_says_something_and_only_once() {
    assert_eq!(rows().count(), TABLE.lines().count() - 1);
    assert!(TABLE.lines().all(|line| line.split(',').count() == 21));
    let keys: HashSet<_> = rows().map(|row| (row.function, row.format, row.by, row.case)).collect();
    assert_eq!(keys.len(), rows().count());
}

#[test]
fn figures_can_be() {
    for row in rows() {
        let name = format!("{} {} {} {}", row.function, row.format, row.by, row.case);
        assert!(CASES.contains(&row.case) && row.inputs as usize >= INPUTS, "{name}");
        for Cost { median, worst, stack, text, rodata } in row.costs.into_iter().flatten() {
            // A call and a return; a line of code takes two or four bytes.
            assert!(2 < median && median <= worst && worst < 10_000_000, "{name}");
            assert!(stack % 4 == 0 && stack < 16 * 1024, "{name}");
            assert!((4..100_000).contains(&text) && text % 2 == 0 && rodata < 10_000, "{name}");
        }
        let whole = row.costs.iter().all(Option::is_some);
        assert!(whole || !row.note.is_empty(), "{name} does not say what is missing");
    }
}

#[test]
fn bytes_are_of_functions_not_of_cases() {
    for row in rows() {
        for other in
            rows().filter(|other| (other.function, other.format, other.by) == (row.function, row.format, row.by))
        {
            let bytes = |row: &Row| row.costs.map(|cost| cost.map(|cost| (cost.text, cost.rodata)));
            assert_eq!(bytes(&row), bytes(&other), "{} {}", row.function, row.format);
        }
    }
}

#[test]
fn nothing_of_this_crate_is_missing() {
    let mut expected = Vec::new();
    for format in Format::ALL {
        for case in Case::ALL {
            expected.extend(Method::ALL.map(|method| (method.name(), format.name(), case.name())));
            expected.extend(Shading::ALL.map(|shading| (shading.name(), format.name(), case.name())));
            let pixels = ["pixel cone_ggx", "pixel disc_ggx", "pixel disc_ggx dir", "pixel karis"];
            expected.extend(pixels.map(|pixel| (pixel, format.name(), case.name())));
        }
        let others = [
            "dot",
            "reflect",
            "normalize",
            "root",
            "basis",
            "sin_cos",
            "Cone::direction",
            "relative_illuminance",
            "lambert",
        ];
        expected.extend(others.map(|function| (function, format.name(), "any")));
    }
    expected.extend(["f64", "f32", "micromath", "f16", "Q31"].map(|format| ("reciprocal root", format, "any")));
    for (function, format, case) in expected {
        let row = row(function, format, "sunglint", case);
        assert!(
            row.is_some_and(|row| Core::ALL.iter().all(|&core| row.on(core).is_some())),
            "{function} {format} {case}"
        );
    }
    for function in ["reflect", "normalize", "root", "reciprocal root"] {
        assert!(row(function, "f32", "sunglint soft", "any").is_some(), "{function}");
    }
    assert!(row("reciprocal root", "U16F16", "sunglint", "any").is_some());
    for case in Case::ALL.map(Case::name) {
        assert!(row("cap", "f32", "sunglint soft", case).is_some(), "{case}");
        assert!(row("pixel disc_ggx", "I2F14", "PixelQ14", case).is_some(), "{case}");
    }
    for format in ["I2F14", "I2F30"] {
        assert!(Case::ALL.iter().all(|case| row("cap", format, "formula", case.name()).is_some()), "{format}");
    }
}

#[test]
fn peers_are_judged_and_counted() {
    assert_eq!(peers::rows().count(), peers::TABLE.lines().count() - 1);
    assert!(peers::TABLE.lines().all(|line| line.split(',').count() == 7));
    for Peer { function, format, by, error, unit, how, .. } in peers::rows() {
        let name = format!("{function} {format} {by}");
        assert!(error > 0.0 && error.is_finite() && ["rad", "ULP", "absolute"].contains(&unit), "{name}");
        assert!(!how.is_empty(), "{name}");
        assert!(rows().any(|row| (row.function, row.format, row.by) == (function, format, by)), "{name}");
    }
    // Names of peers end in versions.
    for row in rows().filter(|row| row.by.contains('.')) {
        let judged = |peer: Peer| (peer.function, peer.format, peer.by) == (row.function, row.format, row.by);
        assert!(peers::rows().any(judged), "{} {} {}", row.function, row.format, row.by);
    }
}

/// What a core has in hardware shows.
#[test]
fn cores_differ_as_they_should() {
    let median =
        |format: &str, core: Core| row("normalize", format, "sunglint", "any").unwrap().on(core).unwrap().median;
    assert!(4 * median("f32", Core::M4) < median("f32", Core::M3) && median("f32", Core::M3) < median("f32", Core::M0));
    assert!(median("I2F30", Core::M3) < median("I2F30", Core::M0));
    let [m3, m4] = [Core::M3, Core::M4].map(|core| median("f64", core));
    assert!(m3.abs_diff(m4) * 10 < m3, "no core has hardware for f64");
}

#[test]
fn the_compiler_is_named() {
    assert!(RUSTC.split('.').count() == 3 && RUSTC.split('.').all(|part| part.parse::<u32>().is_ok()), "{RUSTC}");
}

struct Disc(Case);

impl Visitor for Disc {
    type Output = usize;

    /// How many answers are the mirror ray.
    fn visit<T: Real>(self) -> usize {
        let light = Constants::<T>::of(&SUN).sphere;
        let answers = pairs(self.0).map(|pair| [pair.l.map(T::from_f64), pair.r.map(T::from_f64)]);
        answers.filter(|&[l, r]| cap(l, r, &light) == r).count()
    }
}

#[test]
fn inputs_are_in_every_format_where_the_case_says() {
    for format in Format::ALL {
        assert_eq!(format.visit(Disc(Case::Inside)), INPUTS, "{}", format.name());
        assert_eq!(format.visit(Disc(Case::Outside)), 0, "{}", format.name());
    }
}

#[test]
fn pixels_are_lit_and_see_what_the_case_says() {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    for case in Case::ALL {
        assert_eq!(pixels(case).count(), INPUTS);
        for Pixel { n, v, l } in pixels(case) {
            assert!(dot(n, v) > 0.25 && dot(n, l) > 0.05);
            let turn = sunglint::oracle::angle_between(l, reflect(n, v)) / SUN.angular_radius();
            assert!(if case == Case::Inside { turn < 0.81 } else { turn > 1.24 }, "{turn}");
        }
    }
}

#[test]
fn numbers_are_parts_of_one() {
    assert_eq!(numbers().count(), INPUTS);
    assert!(numbers().flatten().all(|number| (0.0..1.0).contains(&number)));
}
