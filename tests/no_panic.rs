//! That nothing of the core panics is shown by linking `tests/no_panic`, see `.ci/run`; here is that nothing is left
//! out of it.

mod public_functions;

use std::fs;

use public_functions::{after_generics, module, public_functions, root, sources};

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
    let mut public: Vec<_> = public_functions().into_iter().map(|function| function.name).collect();
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
