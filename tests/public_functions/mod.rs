//! The public functions of the core, found by reading its source.
#![allow(dead_code)] // Each test reads its own part of this.

use std::fs;
use std::path::{Path, PathBuf};

/// Not for use on a target.
const STUDY: [&str; 3] = ["oracle", "trial", "bin"];

pub struct Function {
    /// `Type::name` of methods, `Trait::name` of a public trait's, `module::name` of functions.
    pub name: String,
    /// The module by which it is called.
    pub module: String,
    /// The comments and attributes right before it.
    pub documentation: Vec<String>,
}

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

pub fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            files.extend(sources(&entry));
        } else if entry.extension().is_some_and(|extension| extension == "rs") {
            files.push(entry);
        }
    }
    files
}

/// All of them, each once.
pub fn public_functions() -> Vec<Function> {
    let core = sources(&root().join("src")).into_iter().filter(|file| !STUDY.contains(&module(file).as_str()));
    let mut functions: Vec<_> = core.flat_map(|file| of_file(&file)).collect();
    functions.sort_by(|a, b| a.name.cmp(&b.name));
    functions
}

/// The first part of a source's path.
pub fn module(file: &Path) -> String {
    let inside = file.strip_prefix(root().join("src")).unwrap();
    Path::new(inside.iter().next().unwrap()).file_stem().unwrap().to_str().unwrap().to_owned()
}

fn identifier(text: &str) -> &str {
    text.split(|letter: char| !letter.is_alphanumeric() && letter != '_').next().unwrap()
}

/// What follows a list of generic parameters, if one comes first.
pub fn after_generics(text: &str) -> &str {
    if !text.starts_with('<') {
        return text;
    }
    let mut depth = 0;
    for (place, letter) in text.char_indices() {
        depth += i32::from(letter == '<') - i32::from(letter == '>');
        if depth == 0 {
            return &text[place + 1..];
        }
    }
    panic!("{text} has no end")
}

/// What follows `pub`, up to `fn`, of a function that C calls as well.
fn after_public(code: &str) -> Option<&str> {
    let code = code.strip_prefix("pub ")?;
    let code = code.strip_prefix("const ").unwrap_or(code);
    Some(code.strip_prefix("extern \"C\" ").unwrap_or(code))
}

fn of_file(file: &Path) -> Vec<Function> {
    let mut functions = Vec::new();
    // Indentation, owner, and whether all that it has is public.
    let mut block: Option<(usize, String, bool)> = None;
    let mut documentation = Vec::new();
    for line in fs::read_to_string(file).unwrap().lines() {
        let code = line.trim_start();
        if code.starts_with("///") || code.starts_with("#[") {
            documentation.push(code.to_owned());
            continue;
        }
        let documentation = std::mem::take(&mut documentation);
        let depth = line.len() - code.len();
        if let Some(rest) =
            code.strip_prefix("impl").filter(|rest| rest.starts_with(['<', ' ']) && !rest.ends_with('}'))
        {
            block = Some((depth, identifier(after_generics(rest).trim_start()).to_owned(), false));
        } else if let Some(rest) = code.strip_prefix("pub trait ").filter(|rest| !rest.ends_with('}')) {
            block = Some((depth, identifier(rest).to_owned(), true));
        } else if code == "}" && block.as_ref().is_some_and(|(start, ..)| *start == depth) {
            block = None;
        }
        let of_trait = Some(code).filter(|_| block.as_ref().is_some_and(|(start, _, all)| *all && *start + 4 == depth));
        if let Some(rest) = after_public(code).or(of_trait).and_then(|code| code.strip_prefix("fn ")) {
            let owner = block.as_ref().map_or_else(|| module(file), |(_, owner, _)| owner.clone());
            let name = format!("{owner}::{}", identifier(rest));
            functions.push(Function { name, module: module(file), documentation });
        }
    }
    functions
}
