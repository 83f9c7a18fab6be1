//! The header for C is what its Rust sources say. `SUNGLINT_RECORD=1` writes it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use cbindgen::{Config, DocumentationStyle, Language, RenameRule, Style};
use embedding::library::root;
use embedding::tools::found;
use sunglint::capi::{self, ConeQ14, ConeQ30, PixelQ14};
use sunglint::raw::{SUN_Q14, SUN_Q30};

const ABOUT: &str = "\
/*
 * sunglint: light a surface by the Sun, or by any distant sphere, in fixed point.
 *
 * Vectors are Q14 (16384 is 1) or Q30 (1073741824 is 1) and, where a unit vector is asked for, of length 1 give or take
 * a rounding; up to 1.16 nothing overflows, and longer ones give some finite answer. Quantities of light are unsigned
 * Q16 (65536 is 1), those of Lambert's law beside Q30 vectors Q32; what is at most 1 is Q30, and relative illuminance
 * in the scale of a dot product, Q28 or Q60. Bounds of errors are against exact arithmetic on the same arguments.
 *
 * No argument does harm, as long as pointers are NULL or valid; NULL has the answer that is documented. What may be
 * refused comes beside a status, SUNGLINT_OK being 0. Nothing allocates, keeps a state, sets errno or calls the C
 * library's mathematics; all functions may be called from threads and interrupts at once.
 *
 * C99 or C++11. Made of src/capi by tests/embedding/tests/header.rs, which checks it; do not edit.
 */";

fn committed() -> PathBuf {
    root().join("src/capi/sunglint.h")
}

/// The sources, in the order in which the header has them.
fn sources() -> Vec<PathBuf> {
    let names = [
        "../plain",
        "opaque",
        "status",
        "directions",
        "diffuse",
        "sampling",
        "radiometry",
        "blackbody",
        "pixel",
        "soft",
    ];
    names.iter().map(|name| root().join(format!("src/capi/{name}.rs"))).collect()
}

/// `SphereQ14Made` is `sunglint_sphere_q14_made_t`; without the last letter a type would have the name of the function
/// that makes it, which C has no room for.
fn c_name(rust: &str) -> String {
    let snake: String = rust
        .chars()
        .flat_map(|letter| [letter.is_uppercase().then_some('_'), Some(letter.to_ascii_lowercase())])
        .flatten()
        .collect();
    format!("sunglint{snake}_t")
}

/// The names of public types in a source.
fn types(source: &str) -> Vec<&str> {
    let kinds = ["pub struct ", "pub enum ", "pub type "];
    source
        .lines()
        .filter_map(|line| kinds.iter().find_map(|kind| line.strip_prefix(kind)))
        .map(|rest| rest.split(|letter: char| !letter.is_alphanumeric()).next().unwrap())
        .collect()
}

fn config() -> Config {
    let mut config = Config {
        language: Language::C,
        header: Some(ABOUT.to_owned()),
        include_guard: Some("SUNGLINT_H".to_owned()),
        no_includes: true,
        sys_includes: vec!["stdbool.h".to_owned(), "stdint.h".to_owned()],
        after_includes: Some(suns()),
        cpp_compat: true,
        style: Style::Type,
        documentation_style: DocumentationStyle::Doxy,
        line_length: 120,
        tab_width: 4,
        ..Config::default()
    };
    config.enumeration.rename_variants = RenameRule::QualifiedScreamingSnakeCase;
    for file in sources() {
        let source = fs::read_to_string(file).unwrap();
        config.export.rename.extend(types(&source).into_iter().map(|name| (name.to_owned(), c_name(name))));
    }
    config
}

/// The constants of the Sun, as initialisers.
fn suns() -> String {
    let (narrow, wide) = (SUN_Q14, SUN_Q30);
    let q14 = [narrow.sin(), narrow.sin_square(), narrow.cos(), narrow.versine()].map(|bits| bits.to_string());
    let q30 = [wide.sin(), wide.sin_square(), wide.cos(), wide.versine()].map(|bits| format!("INT64_C({bits})"));
    format!(
        "
/** The Sun from Earth, for a constant in flash: `static const sunglint_sphere_q14_t sun = SUNGLINT_SUN_Q14;` */
#define SUNGLINT_SUN_Q14 {{{}}}

/** The Sun from Earth for Q30 vectors. */
#define SUNGLINT_SUN_Q30 \\
    {{{}}}",
        q14.join(", "),
        q30.join(", ")
    )
}

fn generated() -> String {
    let builder = sources().into_iter().fold(cbindgen::Builder::new(), |builder, file| builder.with_src(file));
    let mut bytes = Vec::new();
    builder.with_config(config()).generate().unwrap().write(&mut bytes);
    let header = String::from_utf8(bytes).unwrap().replace("SUNGLINT_STATUS_T_", "SUNGLINT_");
    short_comments(&with_words(header))
}

/// Opaque types, which cbindgen cannot look into either and declares as themselves.
fn with_words(mut header: String) -> String {
    let sizes = [size_of::<ConeQ14>(), size_of::<ConeQ30>(), size_of::<PixelQ14>()];
    for (name, size) in ["ConeQ14", "ConeQ30", "PixelQ14"].map(c_name).into_iter().zip(sizes) {
        let itself = format!("typedef {name} {name};");
        assert_eq!(header.matches(&itself).count(), 1, "{name}");
        let words = format!("typedef struct {{\n    uint32_t opaque[{}];\n}} {name};", size / 4);
        header = header.replace(&itself, &words);
    }
    header
}

/// A comment of one line on one line.
fn short_comments(header: &str) -> String {
    let lines: Vec<_> = header.lines().collect();
    let mut short = String::new();
    let mut at = 0;
    while at < lines.len() {
        let margin = &lines[at][..lines[at].len() - lines[at].trim_start().len()];
        let text = lines.get(at + 1).and_then(|line| line.trim_start().strip_prefix("* "));
        let ends = lines.get(at + 2).is_some_and(|line| line.trim() == "*/");
        match text.filter(|_| lines[at].trim() == "/**" && ends) {
            Some(text) => {
                short.push_str(&format!("{margin}/** {text} */\n"));
                at += 3;
            }
            None => {
                short.push_str(&format!("{}\n", lines[at].trim_end()));
                at += 1;
            }
        }
    }
    short
}

#[test]
fn the_committed_header_is_that_of_the_sources() {
    let header = generated();
    if std::env::var_os("SUNGLINT_RECORD").is_some() {
        fs::write(committed(), &header).unwrap();
    }
    let committed = fs::read_to_string(committed()).unwrap_or_default();
    let other = header.lines().zip(committed.lines()).position(|(made, found)| made != found);
    assert!(header == committed, "src/capi/sunglint.h differs from line {other:?}: SUNGLINT_RECORD=1 writes it anew");
}

/// Size and alignment of a type as Rust has them, asserted in C.
fn layout<T>(rust: &str) -> String {
    let (name, size, align) = (c_name(rust), size_of::<T>(), align_of::<T>());
    format!(
        "typedef char size_of_{name}[sizeof({name}) == {size} ? 1 : -1];\n\
         struct align_of_{name} {{ char first; {name} second; }};\n\
         typedef char is_{name}[offsetof(struct align_of_{name}, second) == {align} ? 1 : -1];\n"
    )
}

/// Of every type that a function takes or gives.
fn layouts() -> String {
    [
        layout::<capi::VectorQ14>("VectorQ14"),
        layout::<capi::VectorQ30>("VectorQ30"),
        layout::<capi::VectorF32>("VectorF32"),
        layout::<capi::SphereQ14>("SphereQ14"),
        layout::<capi::SphereQ30>("SphereQ30"),
        layout::<capi::SphereQ14Made>("SphereQ14Made"),
        layout::<capi::SphereQ30Made>("SphereQ30Made"),
        layout::<capi::ConeQ14>("ConeQ14"),
        layout::<capi::ConeQ30>("ConeQ30"),
        layout::<capi::PointQ14>("PointQ14"),
        layout::<capi::PointQ30>("PointQ30"),
        layout::<capi::BasisQ14>("BasisQ14"),
        layout::<capi::BasisQ30>("BasisQ30"),
        layout::<capi::SoftShadow>("SoftShadow"),
        layout::<capi::ColourQ16>("ColourQ16"),
        layout::<capi::ColourQ30>("ColourQ30"),
        layout::<capi::MaterialQ30>("MaterialQ30"),
        layout::<capi::PixelQ14>("PixelQ14"),
        layout::<capi::PixelQ14Made>("PixelQ14Made"),
        layout::<capi::RadianceQ16Made>("RadianceQ16Made"),
        layout::<capi::Status>("Status"),
    ]
    .concat()
}

/// C99 and C++11, without a warning, and with the layouts of this machine, which are those of every 32-bit target.
#[test]
fn compilers_take_it() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let alone = folder.join("alone.c");
    fs::write(&alone, "#include \"sunglint.h\"\n").unwrap();
    let sizes = folder.join("layouts.c");
    let header = generated();
    fs::write(folder.join("sunglint.h"), &header).unwrap();
    let structs = header.lines().filter(|line| line.starts_with("} sunglint_")).count();
    let asserted = layouts();
    // The status is no struct.
    assert_eq!(asserted.matches("struct align_of_sunglint_").count(), 2 * (structs + 1));
    fs::write(&sizes, format!("#include \"sunglint.h\"\n#include <stddef.h>\n{asserted}")).unwrap();
    for (compiler, standard, language, package) in [
        ("gcc", "-std=c99", "c", "gcc"),
        ("g++", "-std=c++11", "c++", "g++"),
        ("arm-none-eabi-gcc", "-std=c99", "c", "gcc-arm-none-eabi"),
    ] {
        if !found(compiler, &format!("apt-get install -y {package}")) {
            continue;
        }
        let mut command = Command::new(compiler);
        command.args(["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", standard, "-x", language]);
        let output = command.args([&alone, &sizes]).output().unwrap();
        assert!(output.status.success(), "{compiler}: {}", String::from_utf8_lossy(&output.stderr));
    }
}
