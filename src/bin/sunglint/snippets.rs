//! The recommended methods as source code of other languages.

use clap::Args;

use crate::failure::Failure;

/// A language that a snippet is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Language {
    /// OpenGL's and Vulkan's.
    Glsl,
    /// Direct3D's.
    Hlsl,
    /// WebGPU's.
    Wgsl,
    /// The benchmark language of numerical tools.
    Fpcore,
}

/// Source code of a method.
#[derive(Clone, Copy, Debug)]
pub struct Snippet {
    /// Name of the method.
    pub method: &'static str,
    /// Its language.
    pub language: Language,
    /// Name of the file in `OUT/snippets`.
    pub file: &'static str,
    /// The code.
    pub source: &'static str,
}

/// All of them.
pub const ALL: &[Snippet] = &[];

/// `sunglint snippet`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Name of the method
    #[arg(default_value = "cap")]
    pub method: String,
    /// Its language
    #[arg(long, value_enum, default_value = "glsl")]
    pub language: Language,
}

/// The command: prints the source.
pub fn run(_arguments: &Arguments) -> Result<(), Failure> {
    Ok(())
}
