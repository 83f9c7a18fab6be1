//! The files of a run: tables, everything as JSON, charts and the report.

use std::error::Error;
use std::fmt;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;
use tempfile::{Builder, NamedTempFile};

use crate::columns::Column;
use crate::interrupt::Writing;
use crate::measurements::{self, Measurement};
use crate::result::Study;
use crate::{chart, chip_chart, columns, page, snippets};

/// Names of the tables that are written as CSV.
pub const TABLES: [&str; 12] = [
    "results.csv",
    "pixels.csv",
    "lobes.csv",
    "kernels.csv",
    "quantities.csv",
    "chip.csv",
    "anchors.csv",
    "curves.csv",
    "sweep.csv",
    "presets.csv",
    "measurements.csv",
    "columns.csv",
];

/// The JSON file: the study, and what its fields mean.
#[derive(Serialize)]
struct Everything<'a> {
    #[serde(flatten)]
    study: &'a Study,
    schema: &'a [Column],
}

/// A file or folder that could not be written, and why.
#[derive(Debug)]
pub struct WriteError {
    path: PathBuf,
    cause: Box<dyn Error + Send + Sync>,
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot write {}: {}", self.path.display(), self.cause)
    }
}

impl Error for WriteError {}

/// Makes the folder `out` if it is missing, and makes sure that files can be written to it. This
/// comes before the measurement, so that a wrong path does not cost the measurement.
pub fn prepare(out: &Path) -> Result<(), WriteError> {
    let at = |cause: io::Error| failure(out, cause);
    let _writing = Writing::begin().map_err(at)?;
    fs::create_dir_all(out).map_err(at)?;
    NamedTempFile::new_in(out).map(drop).map_err(at)
}

/// Writes every file of `study` into the folder `out`, and gives the path of the report.
///
/// All are written into a folder within `out` first, so that a full disc or Ctrl-C leaves `out` as it was. Then they
/// are renamed one after the other, the report last; only what fails or kills the process there leaves old files among
/// new.
pub fn write(study: &Study, out: &Path) -> Result<PathBuf, WriteError> {
    let at = |cause: io::Error| failure(out, cause);
    let writing = Writing::begin().map_err(at)?;
    let new = Builder::new().prefix(".sunglint-").tempdir_in(out).map_err(at)?;
    let report = write_into(study, new.path())?;
    let report_name = report.strip_prefix(new.path()).unwrap_or(&report);
    let mut names = files(new.path()).map_err(at)?;
    // Names with the report's last, others in the order of the alphabet.
    names.sort_by_key(|name| (name == report_name, name.clone()));
    writing.commit().map_err(at)?;
    for name in names {
        let path = out.join(&name);
        let moved =
            fs::create_dir_all(path.parent().unwrap_or(out)).and_then(|()| fs::rename(new.path().join(&name), &path));
        moved.map_err(|cause| failure(&path, cause))?;
    }
    Ok(out.join(report_name))
}

/// The files in `folder` and in the folders within, by their paths from there.
fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = PathBuf::from(entry.file_name());
        match entry.file_type()?.is_dir() {
            true => found.extend(files(&entry.path())?.iter().map(|within| name.join(within))),
            false => found.push(name),
        }
    }
    Ok(found)
}

/// The same, where a failure may leave some of them.
fn write_into(study: &Study, out: &Path) -> Result<PathBuf, WriteError> {
    for name in TABLES {
        let path = out.join(name);
        let text = text(name, study).map_err(|cause| failure(&path, cause))?;
        replace(&path, &text)?;
    }
    for picture in &study.pictures {
        beneath(out, "pictures", &format!("{}.png", picture.name), &picture.png)?;
    }
    for snippet in snippets::ALL {
        beneath(out, "snippets", snippet.file, snippet.source.as_bytes())?;
    }
    let json_path = out.join("results.json");
    let everything = Everything { study, schema: columns::all() };
    let json = serde_json::to_vec_pretty(&everything).map_err(|cause| failure(&json_path, cause))?;
    replace(&json_path, &json)?;
    replace(&out.join("chart.svg"), chart::both_errors(study).as_bytes())?;
    replace(&out.join("chips.svg"), chip_chart::of_cores(study).as_bytes())?;
    replace(&out.join("pixels.svg"), chart::first_pixels(study).as_bytes())?;
    let report = out.join("report.html");
    replace(&report, page::report(study).as_bytes())?;
    Ok(report)
}

fn failure(path: &Path, cause: impl Into<Box<dyn Error + Send + Sync>>) -> WriteError {
    WriteError { path: path.to_owned(), cause: cause.into() }
}

/// Writes a file into the folder `name` of `out`, which is made if it is missing.
fn beneath(out: &Path, name: &str, file: &str, content: &[u8]) -> Result<(), WriteError> {
    let folder = out.join(name);
    fs::create_dir_all(&folder).map_err(|cause| failure(&folder, cause))?;
    replace(&folder.join(file), content)
}

type Text = Result<Vec<u8>, Box<dyn Error + Send + Sync>>;

/// The text of the table of this name.
fn text(name: &str, study: &Study) -> Text {
    match name {
        "results.csv" => csv(name, &study.rows),
        "pixels.csv" => csv(name, &study.pixels),
        "lobes.csv" => csv(name, &study.lobes),
        "kernels.csv" => csv(name, &study.kernels),
        "quantities.csv" => csv(name, &study.quantities),
        "chip.csv" => csv(name, &study.chip),
        "anchors.csv" => csv(name, &study.anchors),
        "curves.csv" => csv(name, &study.curves),
        "sweep.csv" => csv(name, &study.sweep),
        "presets.csv" => csv(name, &study.presets),
        "measurements.csv" => csv(name, &figures(study)?),
        _ => csv(name, columns::all()),
    }
}

/// Every figure of the tables and of the rivals.
fn figures(study: &Study) -> Result<Vec<Measurement>, Box<dyn Error + Send + Sync>> {
    let rivals = &study.rivals;
    let mut tables = Vec::new();
    for (name, _) in measurements::SUBJECTS {
        tables.push((name, text(name, study)?));
    }
    tables.push(("results.csv", csv("results.csv", &rivals.directions)?));
    tables.push(("pixels.csv", csv("pixels.csv", &rivals.pixels)?));
    tables.push(("kernels.csv", csv("kernels.csv", &rivals.kernels)?));
    let mut figures = Vec::new();
    for (name, table) in tables {
        figures.extend(measurements::of(name, &table, study.seed)?);
    }
    Ok(figures)
}

/// One line for each row, under a line of names, which is there without rows too.
fn csv<R: Serialize>(name: &str, rows: &[R]) -> Text {
    let mut writer = csv::Writer::from_writer(Vec::new());
    if rows.is_empty() {
        writer.write_record(columns::of(name).map(|column| &column.column))?;
    }
    for row in rows {
        writer.serialize(row)?;
    }
    Ok(writer.into_inner().map_err(|error| error.into_error())?)
}

/// Writes `content` next to `path` and renames it, so that no reader meets half a file.
pub fn replace(path: &Path, content: &[u8]) -> Result<(), WriteError> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let written = || {
        let _writing = Writing::begin()?;
        let mut file = temporary(folder)?;
        file.write_all(content)?;
        file.persist(path).map(drop).map_err(|error| error.error)
    };
    written().map_err(|cause: io::Error| failure(path, cause))
}

/// A temporary file that others may read once it is renamed; by default only its owner may.
#[cfg(unix)]
fn temporary(folder: &Path) -> io::Result<NamedTempFile> {
    use std::os::unix::fs::PermissionsExt;
    let permissions = fs::Permissions::from_mode(0o666);
    Builder::new().permissions(permissions).tempfile_in(folder)
}

#[cfg(not(unix))]
fn temporary(folder: &Path) -> io::Result<NamedTempFile> {
    Builder::new().tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{frontier, sample};
    use std::collections::BTreeSet;

    fn study() -> Study {
        let mut failed = sample::row("epic", "f16", 0.5, f64::NAN);
        failed.failure = Some("NaN".to_owned());
        let rows = vec![
            failed,
            sample::row("factored", "f32", 1.0, 7e-8),
            sample::row("disc", "I2F14", 0.8, f64::INFINITY),
            sample::row("cap", "I16F16", 1.2, 0.0),
        ];
        let mut study = sample::whole_study(rows);
        frontier::mark(&mut study);
        study
    }

    fn written(name: &str) -> String {
        let folder = tempfile::tempdir().expect("a folder");
        write(&study(), folder.path()).expect("files");
        fs::read_to_string(folder.path().join(name)).expect("a file")
    }

    const OTHERS: [&str; 5] = ["results.json", "chart.svg", "chips.svg", "pixels.svg", "report.html"];

    fn files() -> impl Iterator<Item = &'static str> {
        TABLES.into_iter().chain(OTHERS)
    }

    #[test]
    fn a_csv_has_a_line_for_each_row_and_keeps_nan() {
        let study = study();
        let counts = [
            ("results.csv", study.rows.len()),
            ("pixels.csv", study.pixels.len()),
            ("lobes.csv", study.lobes.len()),
            ("kernels.csv", study.kernels.len()),
            ("quantities.csv", study.quantities.len()),
            ("chip.csv", study.chip.len()),
            ("columns.csv", columns::all().len()),
        ];
        for (name, count) in counts {
            assert_eq!(written(name).lines().count(), 1 + count, "{name}");
        }
        let text = written("results.csv");
        assert!(text.lines().nth(1).is_some_and(|line| line.contains(",NaN,")));
    }

    #[test]
    fn the_json_holds_the_whole_study() {
        let value: serde_json::Value = serde_json::from_str(&written("results.json")).expect("JSON");
        assert_eq!(value["rows"].as_array().map(Vec::len), Some(4));
        assert_eq!(value["quantities"][0]["unit"], "ULP");
        assert!(value["rows"][0]["error_max"].is_null());
        assert_eq!(value["pixels"][0]["method"], "karis");
        assert_eq!(value["lobes"].as_array().map(Vec::len), Some(6));
        assert_eq!(value["kernels"][0]["kernel"], "normalize");
        assert_eq!(value["chip"][0]["m0_median"], 2500);
        assert!(value["chip"][2]["m3_median"].is_null());
    }

    #[test]
    fn the_chart_drops_no_row() {
        let text = written("chart.svg");
        for row in study().rows {
            let title = format!("<title>{} in {}", row.method, row.format);
            assert!(text.matches(&title).count() >= 2, "{} in {}", row.method, row.format);
            assert!(text.contains(&format!(">{}", row.format)));
        }
        assert!(text.contains(">f16 NaN<"));
        assert!(!text.contains("\"inf") && !text.contains("\"NaN"), "no place");
    }

    #[test]
    fn the_pixel_chart_drops_no_row_and_names_the_lines() {
        let text = written("pixels.svg");
        for row in study().pixels {
            let title = format!("<title>{} in {}", row.method, row.format);
            assert!(text.contains(&title), "{title}");
            assert!(text.contains(&format!(">{}</text>", row.method)), "{} has no line", row.method);
        }
        assert!(text.contains(">f16 NaN<"));
        assert!(!text.contains("\"inf") && !text.contains("\"NaN"), "no place");
    }

    #[test]
    fn a_failing_peer_has_a_line_with_its_note() {
        let text = written("chip.csv");
        let peer = "root,U16F16,cordic 0.1.5,any,256,,,,,,,,,,,,,,,,,,,never returns";
        assert_eq!(text.lines().last(), Some(peer));
        assert!(text.contains("cap,f32,sunglint,outside,256,1e-7,rad,,4700,4750,100,900,192,2600,"), "{text}");
    }

    #[test]
    fn the_chart_of_cores_shows_each_and_what_has_been_counted() {
        let text = written("chips.svg");
        for (title, count) in [("Cortex-M0+<", 1), ("Cortex-M3<", 1), ("Cortex-M4F<", 1)] {
            assert_eq!(text.matches(&format!(">{title}")).count(), count, "{title}");
        }
        assert!(text.contains("<title>disc in I2F14"));
        assert!(!text.contains("\"inf") && !text.contains("\"NaN"), "no place");
    }

    #[test]
    fn rivals_stand_where_they_have_a_cost() {
        let [soft, peer] = ["sunglint soft", "libm 0.2.16"].map(|by| format!("<title>cap in f32 by {by}"));
        assert!(written("chips.svg").contains(&soft) && written("chips.svg").contains(">f32 soft<"));
        assert!(written("chips.svg").contains(&peer) && written("chips.svg").contains(">grey: a peer<"));
        assert!(!written("chart.svg").contains("in f32 by") && !written("chart.svg").contains("a peer"));
        assert!(written("pixels.svg").contains(">PixelQ14<"), "it has been timed");
        let value: serde_json::Value = serde_json::from_str(&written("results.json")).expect("JSON");
        assert_eq!(value["rivals"]["directions"][0]["by"], "sunglint soft");
        assert!(value["rows"][0].get("by").is_none() && !written("results.csv").contains("sunglint soft"));
    }

    #[test]
    fn the_report_loads_nothing() {
        let text = written("report.html").replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
        assert!(!text.contains("http://") && !text.contains("https://"));
        assert!(!text.contains(" src=") && !text.contains("@import"));
    }

    #[test]
    fn the_same_study_gives_the_same_files() {
        for name in files() {
            assert_eq!(written(name), written(name), "{name}");
        }
    }

    #[test]
    fn nothing_but_the_files_is_left() {
        let folder = tempfile::tempdir().expect("a folder");
        prepare(folder.path()).expect("a folder to write to");
        write(&study(), folder.path()).expect("files");
        let entries = |folder: PathBuf| {
            let names = fs::read_dir(folder).expect("entries").map(|entry| entry.expect("an entry").file_name());
            names.map(|name| name.into_string().expect("a name")).collect::<BTreeSet<_>>()
        };
        let pictures = study().pictures.first().map(|_| "pictures");
        let there = files().chain(["snippets"]).chain(pictures).map(str::to_owned).collect();
        assert_eq!(entries(folder.path().to_owned()), there);
        let snippets = snippets::ALL.iter().map(|snippet| snippet.file.to_owned()).collect();
        assert_eq!(entries(folder.path().join("snippets")), snippets);
    }

    #[test]
    fn an_error_names_the_path() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("in the way");
        fs::write(&file, "").expect("a file");
        let message = prepare(&file).expect_err("no folder").to_string();
        assert!(message.contains("in the way"), "{message}");
        let message = write(&study(), &file).expect_err("no folder").to_string();
        assert!(message.contains("in the way"), "{message}");
    }

    #[test]
    fn what_cannot_be_written_whole_leaves_what_was_there() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("report.html"), "old").expect("a file");
        write_into(&study(), folder.path().join("missing").as_path()).expect_err("no folder");
        // A folder where a file should go: found when all else is written.
        fs::create_dir_all(folder.path().join("anchors.csv").join("within")).expect("a folder");
        let message = write(&study(), folder.path()).expect_err("a folder in the way").to_string();
        assert!(message.contains("anchors.csv"), "{message}");
        assert_eq!(fs::read_to_string(folder.path().join("report.html")).expect("a file"), "old");
        let names = fs::read_dir(folder.path()).expect("entries");
        assert!(names.flatten().all(|entry| !entry.file_name().to_string_lossy().starts_with('.')));
    }
}
