//! Every public function's documentation shows it at work. `cargo test --doc` runs what it shows; here is that none is
//! left out. The C functions' users read the header.

mod public_functions;

use public_functions::{Function, public_functions};

/// Code of the examples that are compiled and run, those of comments and of attributes alike.
fn example(documentation: &[String]) -> String {
    let mut code = String::new();
    // Of text and of code that is not run alike.
    let mut fence: Option<&str> = None;
    for line in documentation {
        let text = line.trim_start_matches("///").trim();
        match (text.strip_prefix("```"), fence) {
            (Some(language), None) => fence = Some(language),
            (Some(_), Some(_)) => fence = None,
            (None, Some("")) => code.extend([text, "\n"]),
            (None, _) => {}
        }
    }
    code
}

/// Whether `word` is in `code` and not a part of a longer one.
fn has(code: &str, word: &str) -> bool {
    code.split(|letter: char| !letter.is_alphanumeric() && letter != '_').any(|part| part == word)
}

/// Whether its example calls it and asserts something.
fn is_shown(function: &Function) -> bool {
    let code = example(&function.documentation);
    let name = function.name.rsplit("::").next().unwrap();
    has(&code, name) && ["assert", "assert_eq"].iter().any(|word| has(&code, word))
}

#[test]
fn every_public_function_has_an_example() {
    let functions: Vec<_> = public_functions().into_iter().filter(|function| function.module != "capi").collect();
    println!("{} public functions", functions.len());
    for known in ["specular::cap", "raw::shade_q14", "Real::rim", "Scaled::to_bits", "DistantSphere::from_ratio_q30"] {
        assert!(functions.iter().any(|function| function.name == known), "{known} was not found in the source");
    }
    let missing = functions.iter().filter(|function| !is_shown(function));
    let missing: Vec<_> = missing.map(|function| format!("{} in {}", function.name, function.module)).collect();
    assert!(missing.is_empty(), "{} without an example that asserts: {missing:#?}", missing.len());
}

#[test]
fn what_is_no_example_is_told() {
    let shown = |lines: &[&str]| {
        let documentation = lines.iter().map(|&line| line.to_owned()).collect();
        is_shown(&Function { name: "raw::cap_q14".to_owned(), module: "raw".to_owned(), documentation })
    };
    assert!(shown(&["/// Cap.", "/// ```", "/// assert_eq!(cap_q14(l), l);", "/// ```", "#[inline]"]));
    assert!(!shown(&["/// assert_eq!(cap_q14(l), l);"]));
    assert!(!shown(&["/// ```", "/// cap_q14(l);", "/// ```"]));
    assert!(!shown(&["/// ```", "/// assert_eq!(cap_q14s(l), l);", "/// ```"]));
    assert!(!shown(&["/// ```text", "/// assert_eq!(cap_q14(l), l);", "/// ```"]));
    assert!(!shown(&["/// ```text", "/// ```", "/// assert_eq!(cap_q14(l), l);"]));
}
