//! Every snippet is what its language wants: by naga, and by glslang where that is installed.

use std::fs;
use std::path::Path;
use std::process::Command;

use naga::back::{glsl, hlsl};
use naga::proc::BoundsCheckPolicies;
use naga::{Module, ShaderStage};
use shaders::program::whole;
use shaders::sources::{Language, Snippet};
use shaders::{Program, bare, hlsl_as_glsl, of, source, without_precision};

fn stem(snippet: &Snippet) -> &str {
    snippet.file.split('.').next().unwrap_or_default()
}

fn program(language: Language, functions: &str, stem: &str) -> Result<Program, String> {
    let source = whole(language, functions, stem);
    if language == Language::Wgsl { Program::wgsl(&source) } else { Program::glsl(&without_precision(&source)) }
}

fn names(module: &Module) -> Vec<String> {
    let mut names: Vec<_> = module.functions.iter().filter_map(|(_, function)| function.name.clone()).collect();
    names.retain(|name| name != "main");
    names.sort();
    names
}

#[test]
fn wgsl_and_glsl_are_parsed_and_validated_and_have_the_same_functions() {
    for (wgsl, glsl) in of(Language::Wgsl).zip(of(Language::Glsl)) {
        assert_eq!(stem(wgsl), stem(glsl));
        let [wgsl, glsl] = [wgsl, glsl].map(|snippet| {
            let program = program(snippet.language, snippet.source, stem(snippet));
            names(&program.unwrap_or_else(|error| panic!("{}: {error}", snippet.file)).module)
        });
        assert_eq!(wgsl, glsl);
        assert!(!wgsl.is_empty());
    }
}

/// A check that finds nothing wrong anywhere would be worth nothing.
#[test]
fn what_is_wrong_is_found() {
    let wrong = [
        (Language::Wgsl, "cap", source("cap.wgsl").replace("dot(s, s)", "dot(s, x)")),
        (Language::Wgsl, "cap", source("cap.wgsl").replacen("return", "let y =", 1)),
        (Language::Glsl, "cap", source("cap.glsl").replace("inversesqrt", "rsqrt")),
        (Language::Glsl, "karis", source("karis.glsl").replace("vec3 lean(", "vec3 leans(")),
    ];
    for (language, stem, source) in wrong {
        assert!(program(language, &source, stem).is_err(), "{source}");
    }
}

#[test]
fn wgsl_is_translated_to_hlsl_and_glsl() {
    for snippet in of(Language::Wgsl) {
        let program = program(Language::Wgsl, snippet.source, stem(snippet)).expect("valid");
        let hlsl = to_hlsl(&program).unwrap_or_else(|error| panic!("{}: {error}", snippet.file));
        assert!(names(&program.module).iter().all(|name| hlsl.contains(name.as_str())), "{hlsl}");
        let glsl = to_glsl(&program);
        if stem(snippet) == "cap_half" {
            assert!(glsl.is_err(), "naga can write f16 in GLSL now: hold it to that");
        } else {
            let glsl = glsl.unwrap_or_else(|error| panic!("{}: {error}", snippet.file));
            assert!(names(&program.module).iter().all(|name| glsl.contains(name.as_str())), "{glsl}");
        }
    }
}

fn to_hlsl(program: &Program) -> Result<String, String> {
    let mut text = String::new();
    let options = hlsl::Options { shader_model: hlsl::ShaderModel::V6_2, ..hlsl::Options::default() };
    let pipeline = hlsl::PipelineOptions { entry_point: Some((ShaderStage::Fragment, "main".to_owned())) };
    let mut writer = hlsl::Writer::new(&mut text, &options, &pipeline);
    writer.write(&program.module, &program.info, None).map_err(|error| error.to_string())?;
    Ok(text)
}

fn to_glsl(program: &Program) -> Result<String, String> {
    let mut text = String::new();
    let options = glsl::Options { version: glsl::Version::Desktop(450), ..glsl::Options::default() };
    let pipeline =
        glsl::PipelineOptions { shader_stage: ShaderStage::Fragment, entry_point: "main".to_owned(), multiview: None };
    let policies = BoundsCheckPolicies::default();
    let writer = glsl::Writer::new(&mut text, &program.module, &program.info, &options, &pipeline, policies);
    writer.map_err(|error| error.to_string())?.write().map_err(|error| error.to_string())?;
    Ok(text)
}

/// naga reads no HLSL. It is GLSL, which is parsed and run, but for its words.
#[test]
fn hlsl_is_glsl_in_other_words() {
    for (hlsl, glsl) in of(Language::Hlsl).zip(of(Language::Glsl)) {
        assert_eq!(bare(&hlsl_as_glsl(hlsl.source)), bare(glsl.source), "{}", hlsl.file);
        assert_ne!(bare(hlsl.source), bare(glsl.source), "{} has words of its own", hlsl.file);
        let program = program(Language::Glsl, &hlsl_as_glsl(hlsl.source), stem(hlsl));
        assert!(program.is_ok(), "{}: {}", hlsl.file, program.err().unwrap_or_default());
    }
}

const GLSLANG: &str = "glslangValidator";

/// Whether glslang takes the source; its message where it does not.
fn glslang(folder: &Path, language: Language, source: &str) -> Result<(), String> {
    let file = folder.join(if language == Language::Hlsl { "shader.hlsl" } else { "shader.frag" });
    fs::write(&file, source).expect("a file");
    let mut command = Command::new(GLSLANG);
    command.args(["-V", "-S", "frag", "-e", "main", "-o"]).arg(folder.join("shader.spv"));
    if language == Language::Hlsl {
        command.arg("-D");
    }
    let output = command.arg(&file).output().expect("glslang runs");
    if output.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&output.stdout).into_owned()) }
}

#[test]
fn glslang_takes_glsl_hlsl_and_what_naga_makes_of_wgsl() {
    if Command::new(GLSLANG).arg("--version").output().is_err() {
        let missing = "glslangValidator: apt-get install glslang-tools";
        assert!(std::env::var("CI").as_deref() != Ok("true"), "{missing}");
        eprintln!("LEFT OUT: {missing}");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let takes = |language, source: &str| glslang(folder.path(), language, source);
    for language in [Language::Glsl, Language::Hlsl] {
        for snippet in of(language) {
            let source = whole(language, snippet.source, stem(snippet));
            takes(language, &source).unwrap_or_else(|error| panic!("{}: {error}", snippet.file));
            if language == Language::Glsl {
                let embedded = source.replace("#version 450", "#version 310 es\nprecision highp float;");
                takes(language, &embedded).unwrap_or_else(|error| panic!("{} in GLSL ES: {error}", snippet.file));
            }
        }
    }
    for snippet in of(Language::Wgsl).filter(|snippet| stem(snippet) != "cap_half") {
        let program = program(Language::Wgsl, snippet.source, stem(snippet)).expect("valid");
        let hlsl = to_hlsl(&program).expect("HLSL");
        takes(Language::Hlsl, &hlsl).unwrap_or_else(|error| panic!("{} in HLSL: {error}", snippet.file));
        let glsl = to_glsl(&program).expect("GLSL");
        takes(Language::Glsl, &glsl).unwrap_or_else(|error| panic!("{} in GLSL: {error}", snippet.file));
    }
    let wrong = whole(Language::Hlsl, &source("cap.hlsl").replace("rsqrt", "inversesqrt"), "cap");
    assert!(takes(Language::Hlsl, &wrong).is_err(), "GLSL's word in HLSL");
}
