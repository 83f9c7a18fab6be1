//! The schema: every column of every file that the study writes, with its type, unit, range and meaning.
//!
//! It is kept as the file that a run writes, `columns.csv`; the tests hold it against what a run writes.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

/// A column, or a field of the JSON file.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Column {
    /// The file, such as `results.csv`.
    pub file: String,
    /// Its name.
    pub column: String,
    /// `text`, `number`, `integer`, `boolean`; `table` in the JSON file.
    pub kind: String,
    /// `rad`, `per cent`, ...; may be empty.
    pub unit: String,
    /// Which values there may be, in words.
    pub range: String,
    /// What it says.
    pub meaning: String,
}

const SOURCE: &str = include_str!("columns.csv");

static ALL: LazyLock<Vec<Column>> =
    LazyLock::new(|| csv::Reader::from_reader(SOURCE.as_bytes()).deserialize().filter_map(Result::ok).collect());

/// All of them, in the order of the files.
pub fn all() -> &'static [Column] {
    &ALL
}

/// Those of one file.
pub fn of(file: &str) -> impl Iterator<Item = &'static Column> {
    all().iter().filter(move |column| column.file == file)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::anchors::AnchorRow;
    use crate::curves::CurveRow;
    use crate::presets::PresetRow;
    use crate::result::{Row, Study};
    use crate::sweep::SweepRow;
    use crate::{output, sample};
    use std::collections::HashSet;

    /// A study with a row at least in every table.
    fn whole(rows: Vec<Row>) -> Study {
        let mut study = sample::whole_study(rows);
        study.anchors.push(AnchorRow::default());
        study.curves.push(CurveRow::default());
        study.sweep.push(SweepRow::default());
        study.presets.push(PresetRow::default());
        study
    }

    #[test]
    fn every_line_of_the_schema_is_read() {
        assert_eq!(all().len(), SOURCE.lines().count() - 1);
    }

    #[test]
    fn every_column_says_what_it_is() {
        let mut said = HashSet::new();
        for Column { file, column, kind, unit, meaning, .. } in all() {
            assert!(
                ["text", "number", "integer", "boolean", "table"].contains(&kind.as_str()),
                "{file} {column} {kind}"
            );
            assert_eq!(kind == "table", file == "results.json" && meaning.contains("s of "), "{file} {column}");
            assert!(meaning.len() >= 10 && !meaning.ends_with('.'), "{file} {column}: {meaning}");
            assert!(said.insert((file, meaning)), "{file}: two columns say '{meaning}'");
            let counted = ["number", "integer"].contains(&kind.as_str());
            assert!(!counted || !unit.is_empty(), "{file} {column} has no unit");
            assert!(
                ["number", "integer", "text"].contains(&kind.as_str()) || unit.is_empty(),
                "{file} {column} {unit}"
            );
        }
    }

    /// The CSV files of a study, each with its text.
    fn tables(study: &Study) -> Vec<(&'static str, String)> {
        let folder = tempfile::tempdir().expect("a folder");
        output::write(study, folder.path()).expect("files");
        let text = |name| std::fs::read_to_string(folder.path().join(name)).expect("a file");
        output::TABLES.into_iter().map(|name| (name, text(name))).collect()
    }

    #[test]
    fn every_table_has_the_columns_of_the_schema_even_without_rows() {
        let full = whole(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        for (study, rows) in [(full, 1), (sample::study(Vec::new()), 0)] {
            for (name, text) in tables(&study) {
                assert!(text.lines().count() > rows, "{name}");
                let listed: Vec<_> = of(name).map(|column| column.column.as_str()).collect();
                let written: Vec<_> = text.lines().next().unwrap_or_default().split(',').collect();
                assert_eq!(written, listed, "{name}");
            }
        }
    }

    fn fits(kind: &str, cell: &str) -> bool {
        match kind {
            "text" => true,
            "number" => cell.is_empty() || cell.parse::<f64>().is_ok(),
            "integer" => cell.is_empty() || cell.parse::<u64>().is_ok(),
            "boolean" => ["true", "false"].contains(&cell),
            _ => false,
        }
    }

    #[test]
    fn cells_are_of_the_kind_of_their_column() {
        let mut failed = sample::row("epic", "f16", 0.5, f64::NAN);
        failed.failure = Some("NaN".to_owned());
        let study = whole(vec![failed, sample::row("cap", "I2F14", 1.0, f64::INFINITY)]);
        let mut cells = 0;
        for (name, text) in tables(&study) {
            for record in csv::Reader::from_reader(text.as_bytes()).into_records() {
                for (cell, column) in record.expect("as many cells as columns").iter().zip(of(name)) {
                    assert!(fits(&column.kind, cell), "{name} {}: '{cell}' is no {}", column.column, column.kind);
                    cells += 1;
                }
            }
        }
        assert!(cells > 1000 && !fits("number", "1,5") && !fits("integer", "-1"));
    }

    #[test]
    fn the_json_has_the_fields_of_the_schema_and_says_so_itself() {
        let study = sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        let folder = tempfile::tempdir().expect("a folder");
        output::write(&study, folder.path()).expect("files");
        let text = std::fs::read_to_string(folder.path().join("results.json")).expect("a file");
        let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let fields: HashSet<_> = value.as_object().expect("an object").keys().map(String::as_str).collect();
        assert_eq!(fields, of("results.json").map(|column| column.column.as_str()).collect());
        let schema: Vec<Column> = serde_json::from_value(value["schema"].clone()).expect("columns");
        assert_eq!(schema, all());
        let row = value["rows"][0].as_object().expect("a row");
        let columns: HashSet<_> = row.keys().map(String::as_str).collect();
        assert_eq!(columns, of("results.csv").map(|column| column.column.as_str()).collect());
    }
}
