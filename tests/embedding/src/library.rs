//! The library for C, by the README's one command.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The project's folder.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("this crate is in the project")
}

/// Builds the library for `target`, or for the host, unless it is there; gives its path.
pub fn library(target: Option<&str>) -> PathBuf {
    let out = root().join("target/embedding");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root()).args(["rustc", "--locked", "--quiet", "--lib", "--crate-type", "staticlib"]);
    cargo.args(["--profile", "embedded", "--no-default-features", "--features", "capi"]);
    cargo.args(target.iter().flat_map(|&target| ["--target", target]));
    cargo.arg("--target-dir").arg(&out).args(["--", "--cfg", "freestanding"]);
    // Flags that the tests are compiled with are not the library's.
    cargo.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    succeed(&mut cargo);
    out.join(target.unwrap_or_default()).join("embedded/libsunglint.a")
}

/// Runs a command that has to succeed; gives what it printed.
pub fn succeed(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let [printed, complaints] = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    assert!(output.status.success(), "{command:?}: {}\n{printed}{complaints}", output.status);
    printed
}
