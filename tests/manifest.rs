//! What is said in more than one place is said alike: versions, and what crates.io accepts.

use std::fs;

fn text(file: &str) -> String {
    fs::read_to_string(format!("{}/{file}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// What follows `start` in a text, up to `end`.
fn after(text: &str, start: &str, end: &str) -> String {
    let rest = text.split(start).nth(1).unwrap_or_else(|| panic!("no {start:?}"));
    rest.split(end).next().unwrap().to_owned()
}

#[test]
fn the_oldest_rust_is_the_same_everywhere() {
    let promised = env!("CARGO_PKG_RUST_VERSION");
    assert_eq!(promised, after(&text("README.md"), "Both need Rust (", " or newer)"));
    let script = text(".ci/run");
    assert_eq!(format!("{promised}.0"), after(&script, "rustup toolchain install 1", " ").replacen(".", "1.", 1));
    for line in script.lines().filter(|line| line.contains("cargo +1")) {
        assert!(line.contains(&format!("cargo +{promised}.0 ")), "{line}");
    }
}

#[test]
fn the_oldest_fixed_is_the_one_that_is_tried() {
    let promised = after(&text("Cargo.toml"), "\nfixed = { version = \"", "\"");
    assert!(text(".ci/run").contains(&format!("{promised}.0")), "CI does not try fixed {promised}");
}

#[test]
fn the_changelog_begins_with_this_version() {
    let changelog = text("CHANGELOG.md");
    let newest = changelog.lines().filter_map(|line| line.strip_prefix("## [")).find(|line| *line != "Unreleased]");
    assert_eq!(newest.unwrap().split(']').next(), Some(env!("CARGO_PKG_VERSION")));
}

fn list(key: &str) -> Vec<String> {
    let items = after(&text("Cargo.toml"), &format!("\n{key} = ["), "]");
    items.split(',').map(|item| item.trim().trim_matches('"').to_owned()).collect()
}

/// Its rules: five of each, and keywords of at most 20 letters, digits, `_` and `-`.
#[test]
fn keywords_and_categories_are_accepted() {
    let (keywords, categories) = (list("keywords"), list("categories"));
    assert!(keywords.len() <= 5 && categories.len() <= 5);
    let allowed = |letter: char| letter.is_ascii_alphanumeric() || "_-".contains(letter);
    for keyword in keywords {
        assert!(keyword.len() <= 20 && keyword.chars().all(allowed), "{keyword}");
    }
}

/// What docs.rs shows and a test or a user asks for is a feature.
#[test]
fn the_features_of_the_documentation_are_there() {
    let manifest = text("Cargo.toml");
    let shown = after(&manifest, "[package.metadata.docs.rs]\nfeatures = [", "]");
    let features = after(&manifest, "\n[features]\n", "\n[dependencies]");
    for feature in shown.split(", ").map(|name| name.trim_matches('"')) {
        assert!(features.contains(&format!("\n{feature} = [")), "{feature}");
    }
}
