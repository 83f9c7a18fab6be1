//! What the tests of the snippets need: the snippets as modules of naga, a machine that runs them with the arithmetic
//! that a test asks for, and one that runs FPCore.

pub mod fpcore;
pub mod machine;
pub mod program;
mod value;

#[path = "../../../src/bin/sunglint/snippets/sources.rs"]
pub mod sources;

pub use machine::Arithmetic;
pub use program::Program;
pub use value::Value;

use sources::{ALL, Language};

/// The source of a file that is given away.
///
/// # Panics
/// Where there is no such file.
pub fn source(file: &str) -> &'static str {
    let found = ALL.iter().find(|snippet| snippet.file == file);
    found.unwrap_or_else(|| panic!("no snippet {file}")).source
}

/// HLSL with the words that differ written as in GLSL.
pub fn hlsl_as_glsl(source: &str) -> String {
    const WORDS: [(&str, &str); 4] =
        [("min16float", "float"), ("float3", "vec3"), ("rsqrt", "inversesqrt"), ("min16float3", "vec3")];
    let word = |word: &str| WORDS.iter().find(|(hlsl, _)| *hlsl == word).map_or(word, |(_, glsl)| glsl).to_owned();
    words(source).into_iter().map(|piece| word(&piece)).collect()
}

/// GLSL without precisions, which naga does not read at a function's arguments; glslang reads the source whole.
pub fn without_precision(source: &str) -> String {
    words(source).into_iter().filter(|word| word != "mediump").collect()
}

/// Code without comments, precisions and layout, to tell whether two sources are the same.
pub fn bare(source: &str) -> Vec<String> {
    let code: String = source.lines().map(|line| line.split("//").next().unwrap_or("").to_owned() + "\n").collect();
    let said = |word: &String| !word.trim().is_empty() && word != "mediump";
    words(&code).into_iter().filter(said).collect()
}

/// A source cut where names begin and end.
fn words(source: &str) -> Vec<String> {
    let in_name = |letter: char| letter.is_alphanumeric() || letter == '_';
    let mut words: Vec<String> = Vec::new();
    let mut before = None;
    for letter in source.chars() {
        match words.last_mut() {
            Some(word) if before == Some(true) && in_name(letter) => word.push(letter),
            _ => words.push(letter.to_string()),
        }
        before = Some(in_name(letter));
    }
    words
}

/// The snippets of one language.
pub fn of(language: Language) -> impl Iterator<Item = &'static sources::Snippet> {
    ALL.iter().filter(move |snippet| snippet.language == language)
}
