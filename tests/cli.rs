//! The host tool as its user runs it: exit codes, messages, files.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::Duration;

fn sunglint(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sunglint"));
    command.args(arguments);
    command
}

fn output(arguments: &[&str]) -> Output {
    sunglint(arguments).output().expect("the tool runs")
}

/// What a command prints that ends well.
fn printed(arguments: &[&str]) -> String {
    let Output { status, stdout, stderr } = output(arguments);
    let message = String::from_utf8_lossy(&stderr).into_owned();
    assert_eq!(status.code(), Some(0), "{arguments:?}: {message}");
    String::from_utf8(stdout).expect("text")
}

/// The message of a command that ends with a wrong command line.
fn refused(arguments: &[&str]) -> String {
    let Output { status, stdout, stderr } = output(arguments);
    let message = String::from_utf8(stderr).expect("text");
    assert_eq!((status.code(), stdout.len()), (Some(2), 0), "{arguments:?}: {message}");
    assert!(message.starts_with("error: ") && !message.contains("panicked"), "{arguments:?}: {message}");
    message
}

/// A command as `sunglint worst` prints it, without the name of the tool.
fn words(command: &str) -> Vec<String> {
    let parts = command.trim().split('\'').enumerate();
    let words = parts.flat_map(|(place, part)| match place % 2 {
        0 => part.split_whitespace().map(str::to_owned).collect(),
        _ => vec![part.to_owned()],
    });
    words.skip(1).collect()
}

/// A study that takes a moment.
const SMALL: [&str; 7] = ["--quick", "--method", "cap", "--method", "karis", "--format", "I2F14"];

fn small(out: &Path, seed: &str) -> String {
    let out = out.to_str().expect("text");
    let light = ["--ratio", "0.01", "--alpha", "0.1", "--seed", seed, "--quiet", "--out", out];
    printed(&[&SMALL[..], &light].concat())
}

#[test]
fn wrong_command_lines_name_the_value_and_what_is_allowed() {
    for (arguments, said) in [
        (&["--method", "cup"][..], "disc_ggx dir"),
        (&["worst", "--format", "f8"], "I16F16"),
        (&["--light", "venus"], "Sun from Mars"),
        (&["worst", "--light", "venus"], "'venus'"),
        (&["--ratio", "1.5"], "radius over distance is 1.5, allowed is 0 to 1"),
        (&["worst", "--angle", "-1"], "angle is -1 degrees, allowed is 0 to 360"),
        (&["--alpha", "2"], "alpha is 2, allowed is 0 or 0.0005 to 1"),
        (&["--angle", "200", "--alpha", "0.1"], "angle 200"),
        (&["--ratio", "0.1", "--angle", "1"], "cannot be used with"),
        (&["repro", "cap", "f16", "--l", "0 0 10000", "--r", "0 0 0"], "allowed is 0 to ffff"),
        (&["repro", "cap", "f16", "--l", "0 0", "--r", "0 0 0"], "--l has 2 numbers, allowed is 3"),
        (&["repro", "tint", "f16", "--l", "0 0 0"], "tint"),
        (&["wurst"], "wurst"),
        (&["--seed", "minus"], "minus"),
    ] {
        let message = refused(arguments);
        assert!(message.contains(said), "{arguments:?}: {message}");
    }
}

#[test]
fn every_help_says_what_there_is() {
    let all = printed(&["--help"]);
    assert!(all.contains("Exit codes: 0 done, 1 a file could not be written, 2 wrong command line, 130"), "{all}");
    for command in ["chart", "worst", "repro", "render", "sweep", "preset", "snippet", "list"] {
        assert!(all.contains(&format!("  {command} ")), "{command}");
        let help = printed(&[command, "--help"]);
        assert!(help.contains(&format!("Usage: sunglint {command}")), "{help}");
        assert!(help.lines().all(|line| line.chars().count() <= 100), "{help}");
    }
}

#[test]
fn a_list_has_everything_and_a_reader_may_leave() {
    let list = printed(&["list"]);
    for name in ["cap", "'cone_ggx shifted'", "Cone::direction", "size_factor", "I16F16", "Sun from Mars", "lamp 0.3"] {
        assert!(list.contains(name), "{name}");
    }
    let mut child = sunglint(&["list"]).stdout(Stdio::piped()).spawn().expect("the tool runs");
    drop(child.stdout.take());
    assert_eq!(child.wait().expect("an end").code(), Some(0));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disc_is_told() {
    let full = fs::File::create("/dev/full").expect("a device");
    let Output { status, stderr, .. } = sunglint(&["list"]).stdout(full).output().expect("the tool runs");
    assert_eq!(status.code(), Some(1));
    assert_eq!(String::from_utf8_lossy(&stderr), "sunglint: cannot write to standard output\n");
}

/// Each of these leaves out tables, charts and sections.
#[test]
fn filters_that_leave_little_still_make_a_page() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("text");
    for filters in [
        &["--method", "versine", "--format", "f64"][..],
        &["--method", "normalize", "--light", "mars"],
        &["--method", "cap", "--format", "f16", "--ratio", "0"],
        &["--method", "disc", "--format", "I2F30", "--angle", "360"],
        &["--method", "karis", "--format", "f32", "--alpha", "0"],
    ] {
        printed(&[&["--quick", "--quiet", "--out", out], filters].concat());
        let page = fs::read_to_string(folder.path().join("report.html")).expect("a page");
        assert!(page.contains(&format!("<code>sunglint --quick {}</code>", filters.join(" "))), "{filters:?}");
        for chart in ["chart.svg", "chips.svg", "pixels.svg"] {
            let chart = fs::read_to_string(folder.path().join(chart)).expect("a chart");
            assert!(chart.contains("<svg ") && !chart.contains("NaN\"") && !chart.contains("\"inf"), "{filters:?}");
        }
    }
}

#[test]
fn a_folder_that_is_a_file_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("in the way");
    fs::write(&file, "").expect("a file");
    let Output { status, stderr, .. } = output(&["--quick", "--out", file.to_str().expect("text")]);
    let message = String::from_utf8(stderr).expect("text");
    assert_eq!(status.code(), Some(1), "{message}");
    assert!(message.starts_with("sunglint: cannot write ") && message.contains("in the way"), "{message}");
}

#[test]
fn what_worst_prints_can_be_pasted() {
    let arguments = ["worst", "--quick", "--method", "cap", "--method", "cone_ggx", "--method", "basis"];
    let filters = ["--format", "f16", "--light", "sun"];
    let lines = printed(&[&arguments[..], &filters, &["--json"]].concat());
    let mut pasted = 0;
    for line in lines.lines() {
        let row: serde_json::Value = serde_json::from_str(line).expect("JSON");
        let command = words(row["repro"].as_str().expect("a command"));
        let command: Vec<_> = command.iter().map(String::as_str).collect();
        let error = row["error"].as_f64().expect("a number");
        let text = match row["subject"].as_str() {
            Some("building block") => printed(&[&command[..], &["--json"]].concat()),
            _ => printed(&command),
        };
        let shown = text.replace('"', " ");
        let figures = shown.split([' ', ':', ',', '\n']).filter_map(|word| word.parse::<f64>().ok());
        // What a search found is on record to six digits.
        assert!(figures.into_iter().any(|figure| (figure / error - 1.0).abs() < 5e-6), "{error} {text}");
        pasted += 1;
    }
    // Three lights, three cases, one building block.
    assert_eq!(pasted, 7, "{lines}");
    let table = printed(&[&arguments[..], &filters].concat());
    assert_eq!(table.lines().filter(|line| line.starts_with("  sunglint ")).count(), 7, "{table}");
}

/// The columns of a table but those of times, and the lines but those that measure a time.
fn without_times(table: &str) -> String {
    let times = ["cost", "latency", "empty", "frontier"];
    let mut lines = csv::ReaderBuilder::new().has_headers(false).from_reader(table.as_bytes());
    let lines: Vec<_> = lines.records().collect::<Result<_, _>>().expect("a table");
    let Some(head) = lines.first() else { return String::new() };
    let kept: Vec<_> = (0..head.len()).filter(|&place| !times.iter().any(|time| head[place].contains(time))).collect();
    let measure = head.iter().position(|name| name == "measure");
    let is_time =
        |line: &&csv::StringRecord| measure.is_some_and(|at| times.iter().any(|time| line[at].contains(time)));
    let line = |line: &csv::StringRecord| kept.iter().map(|&place| line[place].to_owned() + ";").collect::<String>();
    lines.iter().filter(|line| !is_time(line)).map(line).collect()
}

/// The files below a folder, by their paths.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        let name = entry.file_name().into_string().expect("text");
        match entry.path().is_dir() {
            true => {
                found.extend(files(&entry.path()).into_iter().map(|(within, file)| (format!("{name}/{within}"), file)))
            }
            false => _ = found.insert(name, fs::read(entry.path()).expect("a file")),
        }
    }
    found
}

#[test]
fn the_same_seed_gives_the_same_files_but_for_times() {
    let folders = [(); 3].map(|()| tempfile::tempdir().expect("a folder"));
    let reports = [0, 1, 2].map(|place| small(folders[place].path(), ["7", "7", "8"][place]));
    let report = folders[0].path().join("report.html");
    assert_eq!(reports[0], format!("{}\n", report.display()), "quiet means the path alone");
    let page = fs::read_to_string(report).expect("a page");
    let command =
        "<code>sunglint --quick --method cap --method karis --format I2F14 --ratio 0.01 --alpha 0.1 --seed 7</code>";
    assert!(page.contains(command), "the command that does it again");
    let [one, same, other] = folders.each_ref().map(|folder| files(folder.path()));
    assert_eq!(one.keys().collect::<Vec<_>>(), same.keys().collect::<Vec<_>>());
    for (name, content) in &one {
        let text = |files: &BTreeMap<String, Vec<u8>>| String::from_utf8_lossy(&files[name]).into_owned();
        match name.rsplit('.').next() {
            Some("csv") => assert_eq!(without_times(&text(&one)), without_times(&text(&same)), "{name}"),
            // These show times.
            Some("svg" | "html" | "json") => {}
            _ => assert_eq!(Some(content), same.get(name), "{name}"),
        }
    }
    let rows = |files: &BTreeMap<String, Vec<u8>>| without_times(&String::from_utf8_lossy(&files["results.csv"]));
    assert!(rows(&one).contains("ratio 0.01;") && rows(&one) != rows(&other), "another seed");
}

/// Ctrl-C to a run: its exit code and last words.
#[cfg(unix)]
fn interrupt(child: std::process::Child) -> (Option<i32>, String) {
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill");
    assert!(sent.success());
    let Output { status, stderr, .. } = child.wait_with_output().expect("an end");
    let message = String::from_utf8_lossy(&stderr).lines().last().unwrap_or_default().to_owned();
    (status.code(), message)
}

#[cfg(unix)]
const INTERRUPTED: &str = "sunglint: interrupted; no file is half written";

#[cfg(unix)]
fn begun(arguments: &[&str]) -> std::process::Child {
    sunglint(arguments).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the tool runs")
}

#[cfg(unix)]
#[test]
fn ctrl_c_while_measuring_leaves_an_earlier_report_as_it_was_and_nothing_else() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("report.html"), "an earlier one").expect("a file");
    let before = files(folder.path());
    let child = begun(&["--out", folder.path().to_str().expect("text")]);
    thread::sleep(Duration::from_millis(500));
    assert_eq!(interrupt(child), (Some(130), INTERRUPTED.to_owned()));
    assert_eq!(files(folder.path()), before);
}

#[cfg(unix)]
#[test]
fn ctrl_c_while_writing_leaves_all_old_files_or_all_new_ones() {
    let folder = tempfile::tempdir().expect("a folder");
    small(folder.path(), "1");
    let before = files(folder.path());
    let out = folder.path().to_str().expect("text");
    let child = begun(&["--quick", "--method", "cap", "--method", "disc", "--quiet", "--out", out]);
    let staged = |entry: fs::DirEntry| entry.file_name().to_string_lossy().starts_with(".sunglint-");
    for _ in 0..20_000 {
        if fs::read_dir(folder.path()).expect("a folder").flatten().any(staged) {
            break;
        }
        thread::sleep(Duration::from_millis(1));
    }
    let (code, message) = interrupt(child);
    let after = files(folder.path());
    assert!(!after.keys().any(|name| name.starts_with('.')), "{:?}", after.keys());
    match code {
        Some(130) => assert!(message == INTERRUPTED && after == before, "{message}"),
        // It came too late.
        _ => assert!(code == Some(0) && after["report.html"] != before["report.html"], "{code:?} {message}"),
    }
}
