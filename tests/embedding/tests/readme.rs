//! The README's sections for embedders, done as they say: files saved and commands run, in an empty folder.

use std::fs;
use std::path::Path;
use std::process::Command;

use embedding::library::root;
use embedding::tools;

/// What a section asks for, in its order.
enum Step {
    Save { path: String, text: String },
    Run(String),
    Shows(String),
}

/// The lines of a section, without its title.
fn section(title: &str) -> Vec<String> {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let title = format!("## {title}");
    let lines = readme.lines().skip_while(|line| *line != title).skip(1);
    lines.take_while(|line| !line.starts_with("## ")).map(str::to_owned).collect()
}

/// The path that a line before a file gives: between back quotes, with a colon at the end.
fn path_of(line: &str) -> Option<String> {
    let (_, path) = line.strip_suffix("`:")?.rsplit_once('`')?;
    Some(path.to_owned())
}

/// Files come after a line that names them; of the other blocks, commands are tagged console and what they print text.
fn steps(lines: &[String]) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut place = 0;
    while place < lines.len() {
        let Some(tag) = lines[place].strip_prefix("```") else {
            place += 1;
            continue;
        };
        let body: Vec<&str> = lines[place + 1..].iter().map(String::as_str).take_while(|line| *line != "```").collect();
        let before = lines[..place].iter().rev().find(|line| !line.is_empty());
        let text = format!("{}\n", body.join("\n"));
        match (before.and_then(|line| path_of(line)), tag) {
            (Some(path), _) => steps.push(Step::Save { path, text }),
            (None, "console") => steps.push(Step::Run(text)),
            (None, "text") => steps.push(Step::Shows(text)),
            (None, _) => panic!("a block that is neither a file nor a command: {text}"),
        }
        place += body.len() + 2;
    }
    steps
}

fn runs(folder: &Path, commands: &str) -> String {
    let mut bash = Command::new("bash");
    bash.args(["-euo", "pipefail", "-c", commands]).current_dir(folder).env("SUNGLINT", root());
    // What cargo says to tests is not for what they start.
    let output = bash.env_remove("CARGO_TARGET_DIR").env_remove("RUSTUP_TOOLCHAIN").output().unwrap();
    assert!(output.status.success(), "{commands}\n{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// `built` is where what the section builds may have been built before.
fn works(title: &str, built: Option<&str>) {
    let folder = tempfile::tempdir().unwrap();
    if let Some(built) = built {
        std::os::unix::fs::symlink(root().join(built), folder.path().join("target")).unwrap();
    }
    let steps = steps(&section(title));
    assert!(steps.iter().any(|step| matches!(step, Step::Run(_))), "{title} has no command");
    let mut shown = String::new();
    let mut compared = 0;
    for step in steps {
        match step {
            Step::Save { path, text } => {
                let path = folder.path().join(path);
                fs::create_dir_all(path.parent().unwrap()).unwrap();
                fs::write(path, text).unwrap();
            }
            Step::Run(commands) => shown = runs(folder.path(), &commands),
            Step::Shows(text) => {
                assert_eq!(shown, text, "{title}");
                compared += 1;
            }
        }
    }
    assert!(compared > 0, "{title} shows nothing");
}

#[test]
fn from_c() {
    let gcc = tools::found("gcc", "apt-get install -y gcc");
    if gcc && tools::found("arm-none-eabi-gcc", "apt-get install -y gcc-arm-none-eabi") {
        works("From C", Some("target/embedding"));
    }
}

#[test]
fn on_a_small_lcd() {
    works("On a small LCD", None);
}

#[test]
fn web_assembly() {
    if tools::found("node", "apt-get install -y nodejs") {
        works("WebAssembly", None);
    }
}
