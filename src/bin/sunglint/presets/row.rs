//! The rows of a preset.

use serde::Serialize;

use super::shown;

/// A form that fails.
pub const FAILS: &str = "fails";
/// A form that does not.
pub const CURE: &str = "cure";
/// What the others are compared with.
pub const TRUTH: &str = "truth";
/// A point of the chart.
pub const CURVE: &str = "curve";

/// One form of one preset.
#[derive(Clone, Debug, Default, Serialize)]
pub struct PresetRow {
    /// Name of the preset, such as `filament-mediump`.
    pub preset: &'static str,
    /// Where it was reported, or seen.
    pub source: &'static str,
    /// What is computed, in a sentence.
    pub question: &'static str,
    /// `fails`, `cure`, `truth`, or `curve` for a point of the chart.
    pub role: &'static str,
    /// The form: its formula and number format.
    pub form: String,
    /// What was measured, such as `pixels that are no number, per cent`.
    pub measure: String,
    /// Where on the chart's axis; none in the table.
    pub input: Option<f64>,
    /// Its value.
    pub value: f64,
    /// What is allowed, such as `at most 1`; none where nothing is asked.
    pub criterion: Option<String>,
    /// Whether the form fails by that.
    pub fails: bool,
}

impl PresetRow {
    /// A row of which nothing is asked.
    pub fn new(role: &'static str, form: &str, measure: &str, value: f64) -> Self {
        Self { role, form: form.to_owned(), measure: measure.to_owned(), value, ..Self::default() }
    }

    /// A point of the chart.
    pub fn point(form: &str, measure: &str, input: f64, value: f64) -> Self {
        Self { input: Some(input), ..Self::new(CURVE, form, measure, value) }
    }

    /// The same, failing above `limit` and where it is no number.
    pub fn at_most(self, limit: f64) -> Self {
        let holds = self.value <= limit;
        Self { criterion: Some(format!("at most {}", shown(limit))), fails: !holds, ..self }
    }

    /// The same, failing below `limit` and where it is no number.
    pub fn at_least(self, limit: f64) -> Self {
        let holds = self.value >= limit;
        Self { criterion: Some(format!("at least {}", shown(limit))), fails: !holds, ..self }
    }
}

/// The value of `form` in `measure`, as it is shown.
pub fn figure(rows: &[PresetRow], form: &str, measure: &str) -> String {
    let row = rows.iter().find(|row| row.form == form && row.measure == measure && row.input.is_none());
    row.map_or_else(|| "nothing".to_owned(), |row| shown(row.value))
}

/// The value of `form` in `measure`.
#[cfg(test)]
pub fn value(rows: &[PresetRow], form: &str, measure: &str) -> f64 {
    let row = rows.iter().find(|row| row.form == form && row.measure == measure && row.input.is_none());
    row.map_or(f64::NAN, |row| row.value)
}

/// `part` of `whole` in per cent.
pub fn per_cent(part: usize, whole: usize) -> f64 {
    100.0 * part as f64 / whole as f64
}

/// The greatest of `values`; NaN if one is.
pub fn worst(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |worst: f64, value| if worst >= value || worst.is_nan() { worst } else { value })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_fails_either_way() {
        let row = || PresetRow::new(FAILS, "form", "measure", f64::NAN);
        assert!(row().at_most(1.0).fails && row().at_least(1.0).fails);
        let two = || PresetRow::new(CURE, "form", "measure", 2.0);
        assert!(two().at_most(1.0).fails && !two().at_most(2.0).fails);
        assert!(!two().at_least(2.0).fails && two().at_least(2000.0).fails);
        assert_eq!(two().at_most(0.1).criterion.as_deref(), Some("at most 0.10"));
    }

    #[test]
    fn the_worst_is_the_greatest_or_no_number() {
        assert_eq!(worst([1.0, 3.0, 2.0].into_iter()), 3.0);
        assert!(worst([1.0, f64::NAN, 2.0].into_iter()).is_nan());
    }
}
