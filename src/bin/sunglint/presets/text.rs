//! Presets on the terminal.

use comfy_table::Table;

use super::Preset;
use super::row::{CURVE, PresetRow};
use crate::{number, table};

/// A value to two digits, or whole from a thousand on.
pub fn shown(value: f64) -> String {
    if (1000.0..1e12).contains(&value) {
        return number::count(value.round() as u64);
    }
    number::percent(value, 100.0)
}

/// A preset's question, source, table and verdict.
pub fn of(preset: &Preset, rows: &[PresetRow]) -> String {
    format!(
        "{}: {}\nReported: {}\n{}\n{}\n",
        preset.name,
        preset.question,
        preset.source,
        table(rows).trim_fmt(),
        preset.verdict(rows)
    )
}

fn table(rows: &[PresetRow]) -> Table {
    let mut table = table::table(&["", "form", "measured", "value", "allowed"]);
    let cells = |row: &PresetRow| {
        let allowed = row.criterion.clone().unwrap_or_default();
        [row.role.to_owned(), row.form.clone(), row.measure.clone(), shown(row.value), allowed]
    };
    table.add_rows(rows.iter().filter(|row| row.role != CURVE).map(cells));
    table::align_right(&mut table, 3..4);
    table
}

/// The rows as JSON; what is no number, or infinite, is null there.
pub fn json(rows: &[PresetRow]) -> String {
    serde_json::to_string_pretty(rows).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_short() {
        let values = [0.0, 93.24, 183.0, 1_048_576.2, 3e-7, f64::INFINITY, 0.05];
        let written = values.map(shown);
        assert_eq!(written, ["0", "93", "183", "1\u{202f}048\u{202f}576", "3.0e-7", "infinite", "0.050"]);
    }

    #[test]
    fn json_has_all_rows_and_no_number_is_null() {
        let rows = [PresetRow::new("fails", "a", "b", f64::INFINITY), PresetRow::new("cure", "a", "b", 2.0)];
        let value: serde_json::Value = serde_json::from_str(&json(&rows)).expect("JSON");
        assert_eq!((value[0]["value"].is_null(), value[1]["value"].as_f64()), (true, Some(2.0)));
    }
}
