//! Programs in C, from the sources in `c`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::hashes::GROUPS;
use crate::library::{root, succeed};

/// What computes the hashes, on a host and on a chip.
pub const HASHES: [&str; 6] = ["hashes.c", "directions.c", "quantities.c", "sampling.c", "pixel.c", "soft.c"];

/// What programs have to be compiled without a word with.
const STRICT: [&str; 8] = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"];

/// A program's name, its sources in `c` and the compiler's further arguments, for the linker among them.
pub struct Program<'a> {
    /// What the file is to be called.
    pub name: &'a str,
    /// Files in `c`.
    pub sources: &'a [&'a str],
    /// Arguments before the sources.
    pub options: &'a [&'a str],
}

/// The folder of the sources in C.
pub fn sources() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("c")
}

impl Program<'_> {
    /// Compiles the program into `folder` and links it with `library`; gives its path.
    pub fn build(&self, compiler: &str, folder: &str, library: &Path) -> PathBuf {
        let program = Path::new(folder).join(self.name);
        let mut command = Command::new(compiler);
        command.current_dir(sources()).args(STRICT).arg("-I").arg(root().join("src/capi")).args(self.options);
        command.args(self.sources).arg(library).arg("-o").arg(&program);
        succeed(&mut command);
        program
    }
}

/// What a program is to print: a line for every group.
pub fn expected() -> String {
    GROUPS.iter().map(|(name, hash)| format!("{name} {:#010x}\n", hash())).collect()
}
