//! Tools that not every machine has.

use std::process::Command;

/// Whether the command `tool` is there. Where it is missing the test that asks says so and is left out, but fails where CI is
/// true.
pub fn found(tool: &str, how_to_get_it: &str) -> bool {
    let found = Command::new(tool).arg("--version").output().is_ok_and(|output| output.status.success());
    if !found {
        assert!(std::env::var("CI").as_deref() != Ok("true"), "{tool} is missing: {how_to_get_it}");
        eprintln!("LEFT OUT: {tool} is missing: {how_to_get_it}");
    }
    found
}
