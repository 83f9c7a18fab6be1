//! That nothing of the core panics is shown by linking `tests/no_panic`, see `.ci/run`; here is that nothing is left
//! out of it.

use std::fs;
use std::path::{Path, PathBuf};

/// Not for use on a target.
const STUDY: [&str; 3] = ["oracle", "trial", "bin"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn sources(folder: &Path) -> Vec<PathBuf> {
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

/// The first part of a source's path: the module by which its functions are called.
fn module(file: &Path) -> String {
    let inside = file.strip_prefix(root().join("src")).unwrap();
    Path::new(inside.iter().next().unwrap()).file_stem().unwrap().to_str().unwrap().to_owned()
}

fn identifier(text: &str) -> &str {
    text.split(|letter: char| !letter.is_alphanumeric() && letter != '_').next().unwrap()
}

/// What follows a list of generic parameters, if one comes first.
fn after_generics(text: &str) -> &str {
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

/// `Type::name` of methods, `Trait::name` of a public trait's, `module::name` of functions.
fn public_functions(file: &Path) -> Vec<String> {
    let mut names = Vec::new();
    // Indentation, owner, and whether all that it has is public.
    let mut block: Option<(usize, String, bool)> = None;
    for line in fs::read_to_string(file).unwrap().lines() {
        let code = line.trim_start();
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
        let bare = |code| {
            ["const ", "extern \"C\" "].iter().fold(code, |code: &str, word| code.strip_prefix(word).unwrap_or(code))
        };
        let public = code.strip_prefix("pub ").map(bare);
        let of_trait = Some(code).filter(|_| block.as_ref().is_some_and(|(start, _, all)| *all && *start + 4 == depth));
        if let Some(rest) = public.or(of_trait).and_then(|code| code.strip_prefix("fn ")) {
            let owner = block.as_ref().map_or_else(|| module(file), |(_, owner, _)| owner.clone());
            names.push(format!("{owner}::{}", identifier(rest)));
        }
    }
    names
}

/// Code in which `Type::<T>::name` and `<T as Trait>::name` are `Type::name` and `Trait::name`.
fn without_generics(code: &str) -> String {
    let mut plain = String::new();
    let mut rest = code;
    while let Some(place) = rest.find("::<") {
        plain.push_str(&rest[..place]);
        rest = after_generics(&rest[place + 2..]);
    }
    (plain + rest).replace(">::", "::")
}

/// Whether `name` is in `code` and not a part of a longer name.
fn names(code: &str, name: &str) -> bool {
    let part = |letter: Option<char>| letter.is_some_and(|letter| letter.is_alphanumeric() || letter == '_');
    code.match_indices(name)
        .any(|(place, _)| !part(code[..place].chars().next_back()) && !part(code[place + name.len()..].chars().next()))
}

#[test]
fn the_images_call_every_public_function() {
    let image: String = sources(&root().join("tests/no_panic/src"))
        .iter()
        .map(|file| fs::read_to_string(file).unwrap())
        .map(|code| without_generics(&code))
        .collect();
    let core = sources(&root().join("src")).into_iter().filter(|file| !STUDY.contains(&module(file).as_str()));
    let mut public: Vec<_> = core.flat_map(|file| public_functions(&file)).collect();
    public.sort();
    public.dedup();
    println!("{} public functions", public.len());
    for known in [
        "specular::cap",
        "raw::shade_q14",
        "Real::rim",
        "Scaled::to_bits",
        "Scene::push",
        "highlight::karis_q30",
        "capi::sunglint_cap_q14",
    ] {
        assert!(public.iter().any(|name| name == known), "{known} was not found in the source");
    }
    let missing: Vec<_> = public.into_iter().filter(|name| !names(&image, name)).collect();
    assert!(missing.is_empty(), "tests/no_panic does not call {missing:#?}");
}

#[test]
fn a_function_that_is_not_called_is_missed() {
    let code =
        without_generics("keep((Scene::<T, 2, H<U>>::with_highlight(s), <T as Real>::dot(a, b), raw::cap_q14(l)))");
    assert!(names(&code, "Scene::with_highlight") && names(&code, "Real::dot") && names(&code, "raw::cap_q14"));
    assert!(!names(&code, "Scene::with") && !names(&code, "raw::cap") && !names(&code, "aw::cap_q14"));
}

/// An `unsafe` in the core would make every other promise here worthless. Only the names of the functions for C are an
/// unsafe attribute.
#[test]
fn the_core_forbids_unsafe_code() {
    let lib = fs::read_to_string(root().join("src/lib.rs")).unwrap();
    for line in [r#"#![cfg_attr(not(feature = "capi"), forbid(unsafe_code))]"#, "#![deny(unsafe_code)]"] {
        assert!(lib.lines().any(|code| code == line), "{line}");
    }
    for file in sources(&root().join("src")) {
        let code = fs::read_to_string(&file).unwrap();
        let allowed = if module(&file) == "capi" {
            code.matches("#[unsafe(no_mangle)]\npub extern \"C\" fn ").count()
        } else {
            0
        };
        let found =
            code.lines().filter(|line| !line.trim_start().starts_with("//")).filter(|line| names(line, "unsafe"));
        assert_eq!(found.count(), allowed, "{}", file.display());
    }
    assert_eq!(lib.matches("#[allow(unsafe_code)]\npub mod capi;").count(), lib.matches("allow(unsafe_code)").count());
}

/// The one exemption of the images: `half` rounds up by adding 1 to an f16's bits, from f32 and from f64. These are all
/// sums that it can form, and tests have overflow checks.
#[test]
fn half_rounds_up_without_an_overflow() {
    use half::f16;
    // Every sign, exponent, ten digits that an f16 keeps and the one that it rounds by; below, all are set.
    let mut of_single = (0..=u32::MAX >> 12).map(|kept| f16::from_f32_const(f32::from_bits((kept << 12) | 0xfff)));
    let mut of_double =
        (0..=u64::MAX >> 41).map(|kept| f16::from_f64_const(f64::from_bits((kept << 41) | 0x1ff_ffff_ffff)));
    let greatest = |halves: &mut dyn Iterator<Item = f16>| halves.filter(|half| !half.is_nan()).map(f16::to_bits).max();
    let infinity = Some(f16::NEG_INFINITY.to_bits());
    assert_eq!(greatest(&mut of_single), infinity);
    assert_eq!(greatest(&mut of_double), infinity);
}
