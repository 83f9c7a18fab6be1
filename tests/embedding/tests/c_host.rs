//! C on this machine: the same results as from Rust.

use std::fs;
use std::process::Command;

use embedding::library::{library, root, succeed};
use embedding::program::{HASHES, Program, expected, sources};
use embedding::tools::found;

const FOLDER: &str = env!("CARGO_TARGET_TMPDIR");

fn compiler() -> bool {
    found("gcc", "apt-get install -y gcc")
}

/// What a program prints that is linked with the library.
fn printed(name: &str, sources: &[&str], options: &[&str]) -> String {
    let program = Program { name, sources, options }.build("gcc", FOLDER, &library(None));
    succeed(&mut Command::new(program))
}

#[test]
fn results_are_those_of_rust() {
    if compiler() {
        assert_eq!(printed("host", &[&HASHES[..], &["host.c"]].concat(), &[]), expected());
    }
}

/// One lane of one call, of 4096 that the group makes.
#[test]
fn a_step_in_one_lane_is_found() {
    if !compiler() {
        return;
    }
    let sources = [&HASHES[..], &["planted.c", "host.c"]].concat();
    let planted = printed("planted", &sources, &["-Dsunglint_cap_q14=planted_cap_q14"]);
    let expected = expected();
    let differ: Vec<&str> = planted
        .lines()
        .zip(expected.lines())
        .filter(|(a, b)| a != b)
        .filter_map(|(a, _)| a.split(' ').next())
        .collect();
    assert_eq!(differ, ["directions_q14"], "{planted}");
}

#[test]
fn every_function_of_the_header_is_hashed() {
    let header = fs::read_to_string(root().join("src/capi/sunglint.h")).unwrap();
    let functions: Vec<&str> =
        header.split('(').filter_map(|text| text.rsplit([' ', '*']).next()).filter(|name| is_function(name)).collect();
    assert!(functions.len() > 40, "{functions:?}");
    let hashed: String = HASHES.map(|file| fs::read_to_string(sources().join(file)).unwrap()).concat();
    for function in functions {
        assert!(hashed.contains(&format!("{function}(")), "no hash has {function}");
    }
}

fn is_function(name: &str) -> bool {
    name.strip_prefix("sunglint_").is_some_and(|rest| rest.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'))
}
