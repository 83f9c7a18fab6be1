//! The recommended methods as source code of other languages.

mod sources;

use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};

use crate::failure::Failure;
use crate::print;

pub use sources::{ALL, Language, Snippet};

impl Language {
    /// Name, as people write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Glsl => "GLSL",
            Self::Hlsl => "HLSL",
            Self::Wgsl => "WGSL",
            Self::Fpcore => "FPCore",
        }
    }

    /// Name on the command line.
    pub fn key(self) -> &'static str {
        match self {
            Self::Glsl => "glsl",
            Self::Hlsl => "hlsl",
            Self::Wgsl => "wgsl",
            Self::Fpcore => "fpcore",
        }
    }
}

impl ValueEnum for Language {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Glsl, Self::Hlsl, Self::Wgsl, Self::Fpcore]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.key()))
    }
}

/// `sunglint snippet`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Name of the method: cap, cap_half (for f16), 'disc_ggx dir', karis
    #[arg(default_value = "cap")]
    pub method: String,
    /// Its language
    #[arg(long, value_enum, ignore_case = true, default_value = "glsl")]
    pub language: Language,
}

/// The command: prints the source.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let snippet = find(&arguments.method, arguments.language)?;
    print(snippet.source.trim_end());
    Ok(())
}

/// The snippet of a method, whose name may be in any case and have an underscore in place of the blank.
fn find(method: &str, language: Language) -> Result<&'static Snippet, Failure> {
    let plain = |name: &str| name.replace(' ', "_").to_lowercase();
    let mut there = ALL.iter().filter(|snippet| plain(snippet.method) == plain(method)).peekable();
    if there.peek().is_none() {
        let message = format!("there is no snippet of '{method}'; there are: {}", methods().join(", "));
        return Err(Failure::Usage(message));
    }
    there.clone().find(|snippet| snippet.language == language).ok_or_else(|| {
        let languages: Vec<_> = there.map(|snippet| snippet.language.key()).collect();
        let asked = language.key();
        Failure::Usage(format!("there is no '{method}' in {asked}; it is there in: {}", languages.join(", ")))
    })
}

/// The names of the methods, each once.
pub fn methods() -> Vec<&'static str> {
    let mut names: Vec<_> = ALL.iter().map(|snippet| snippet.method).collect();
    names.dedup();
    names
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn a_snippet_is_found_by_its_method_and_language() {
        for snippet in ALL {
            let found = find(snippet.method, snippet.language).expect("it is there");
            assert_eq!(found.file, snippet.file);
        }
        assert_eq!(find("Disc_GGX_dir", Language::Wgsl).expect("by its other name").file, "disc_ggx_dir.wgsl");
    }

    #[test]
    fn what_there_is_not_is_refused_with_what_there_is() {
        let message = find("epic", Language::Glsl).expect_err("not recommended").to_string();
        assert!(message.contains("'epic'") && message.contains("cap, cap_half, disc_ggx dir, karis"), "{message}");
        let failure = find("cap_half", Language::Fpcore).expect_err("f32 only");
        assert_eq!(failure.code(), 2);
        assert!(failure.to_string().ends_with("glsl, hlsl, wgsl"), "{failure}");
    }

    #[test]
    fn files_are_one_of_a_kind_and_end_in_their_language() {
        let files: HashSet<_> = ALL.iter().map(|snippet| snippet.file).collect();
        assert_eq!(files.len(), ALL.len());
        for Snippet { file, language, .. } in ALL {
            assert_eq!(file.rsplit_once('.').map(|parts| parts.1), Some(language.key()), "{file}");
        }
    }

    #[test]
    fn every_snippet_says_where_it_is_from_and_its_licence() {
        let line = concat!("sunglint ", env!("CARGO_PKG_VERSION"), ", ", env!("CARGO_PKG_LICENSE"));
        for Snippet { file, source, .. } in ALL {
            assert!(source.contains(line), "{file}: no '{line}'");
            assert!(source.ends_with('\n') && !source.contains('\t') && source.is_ascii(), "{file}");
            assert!(source.lines().all(|line| line.len() <= 120), "{file}");
        }
    }
}
