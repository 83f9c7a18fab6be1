//! The study in long form: one row a figure, made of the tables, so that it says what they say.

use csv::StringRecord;
use serde::Serialize;

use crate::author::OURS;
use crate::columns::{self, Column};

/// One figure.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Measurement {
    /// What it is about, such as `direction`.
    pub subject: &'static str,
    /// Method, building block or quantity; of anchors what they are of.
    pub method: String,
    /// Name of the number format.
    pub format: String,
    /// Whose code it is.
    pub by: String,
    /// Name of the light, or of the case.
    pub light: String,
    /// Radius over distance of the light.
    pub ratio: String,
    /// GGX width of the surface.
    pub alpha: String,
    /// Degrees between the normal and the light.
    pub incidence: String,
    /// The column that it is from.
    pub measure: &'static str,
    /// What the value is in.
    pub unit: String,
    /// As the table has it.
    pub value: String,
    /// What an error rests on.
    pub bound: String,
    /// How many inputs it rests on.
    pub samples: String,
    /// Seed of the random inputs.
    pub seed: u64,
    /// The command that computes the worst input again.
    pub repro: String,
}

/// The tables that are made of measurements, and what they are about.
pub const SUBJECTS: [(&str, &str); 6] = [
    ("results.csv", "direction"),
    ("pixels.csv", "pixel"),
    ("lobes.csv", "highlight"),
    ("kernels.csv", "building block"),
    ("quantities.csv", "quantity"),
    ("anchors.csv", "anchor"),
];

/// Columns that say which row it is or where, and no result.
const PLACES: [&str; 9] =
    ["ratio", "theta", "alpha", "incidence", "nodes", "samples", "model_samples", "bound_samples", "worst_input"];

/// What the rows of `table`, the text of `file`, say.
pub fn of(file: &str, table: &[u8], seed: u64) -> Result<Vec<Measurement>, csv::Error> {
    let Some(&(_, subject)) = SUBJECTS.iter().find(|(name, _)| *name == file) else { return Ok(Vec::new()) };
    let measures: Vec<_> = columns::of(file).filter(|column| is_measure(column)).collect();
    let mut reader = csv::Reader::from_reader(table);
    let names = reader.headers()?.clone();
    let mut measurements = Vec::new();
    for record in reader.into_records() {
        let record = record?;
        let row = Row { subject, seed, names: &names, record: &record };
        measurements.extend(measures.iter().filter_map(|column| row.measurement(column)));
    }
    Ok(measurements)
}

fn is_measure(column: &Column) -> bool {
    ["number", "integer"].contains(&column.kind.as_str()) && !PLACES.contains(&column.column.as_str())
}

/// A row of a table.
struct Row<'a> {
    subject: &'static str,
    seed: u64,
    names: &'a StringRecord,
    record: &'a StringRecord,
}

impl Row<'_> {
    /// The cell under the first of `names` that the table has; empty where it has none.
    fn cell(&self, names: &[&str]) -> String {
        let place = names.iter().find_map(|name| self.names.iter().position(|other| other == *name));
        place.and_then(|place| self.record.get(place)).unwrap_or_default().to_owned()
    }

    /// The figure of one column; none where its cell is empty.
    fn measurement(&self, column: &'static Column) -> Option<Measurement> {
        let value = Some(self.cell(&[&column.column])).filter(|value| !value.is_empty())?;
        let by = Some(self.cell(&["by"])).filter(|by| !by.is_empty());
        let [bound, samples] = self.rests_on(&column.column);
        let worst = ["error_max", "bound_max"].contains(&column.column.as_str());
        Some(Measurement {
            subject: self.subject,
            method: self.cell(&["method", "kernel", "quantity", "subject"]),
            format: self.cell(&["format"]),
            by: by.unwrap_or_else(|| OURS.to_owned()),
            light: self.cell(&["light", "case"]),
            ratio: self.cell(&["ratio"]),
            alpha: self.cell(&["alpha"]),
            incidence: self.cell(&["incidence"]),
            measure: &column.column,
            unit: self.unit(column),
            value,
            bound,
            samples,
            seed: self.seed,
            repro: if worst { self.cell(&["repro"]) } else { String::new() },
        })
    }

    /// The unit of a figure, where the schema leaves it to the row.
    fn unit(&self, column: &Column) -> String {
        match (column.unit.as_str(), self.cell(&["subject"]).as_str()) {
            ("as unit says", _) => self.cell(&["unit"]),
            ("rad, of pixels relative", "direction") => "rad".to_owned(),
            ("rad, of pixels relative", _) => "relative".to_owned(),
            (unit, _) => unit.to_owned(),
        }
    }

    /// What a figure rests on and how many inputs that took; nothing for what is no error.
    fn rests_on(&self, column: &str) -> [String; 2] {
        const ERRORS: [&str; 6] = ["error", "model", "total", "input", "edge", "steps"];
        let sampled = |samples: &[&str]| ["sampled".to_owned(), self.cell(samples)];
        match column {
            "bound_max" => [self.cell(&["bound"]), self.cell(&["bound_samples"])],
            _ if column.starts_with("model") => sampled(&["model_samples", "samples"]),
            _ if ERRORS.iter().any(|start| column.starts_with(start)) => sampled(&["samples"]),
            _ => Default::default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "light,ratio,method,format,error_max,model_max,samples,bound,bound_max,bound_samples,repro,cost\n\
                         Sun,0.5,cap,f16,inf,1e-3,7,searched,0.25,9,again,\n";

    #[test]
    fn every_figure_is_a_row() {
        let rows = of("results.csv", TABLE.as_bytes(), 3).expect("a table");
        let told: Vec<_> =
            rows.iter().map(|row| [row.measure, &row.value, &row.unit, &row.bound, &row.samples, &row.repro]).collect();
        assert_eq!(
            told,
            [
                ["error_max", "inf", "rad", "sampled", "7", "again"],
                ["model_max", "1e-3", "rad", "sampled", "7", ""],
                ["bound_max", "0.25", "rad", "searched", "9", "again"],
            ]
        );
        assert!(rows.iter().all(|row| [&row.light, &row.method, &row.format, &row.by] == ["Sun", "cap", "f16", OURS]));
        assert!(rows.iter().all(|row| row.subject == "direction" && row.seed == 3 && row.ratio == "0.5"));
    }

    #[test]
    fn the_unit_may_be_the_row_s_own() {
        let table = "quantity,format,unit,error_max\nflux,f16,ULP,0.5\n";
        let rows = of("quantities.csv", table.as_bytes(), 1).expect("a table");
        assert_eq!([rows[0].unit.as_str(), rows[0].method.as_str()], ["ULP", "flux"]);
        let table = "subject,light,format,rounded_max\ndirection,Sun,f16,1e-4\npixel,Sun,f16,1e-3\n";
        let rows = of("anchors.csv", table.as_bytes(), 1).expect("a table");
        let told: Vec<_> = rows.iter().map(|row| [row.method.as_str(), &row.unit]).collect();
        assert_eq!(told, [["direction", "rad"], ["pixel", "relative"]]);
        assert!(of("chip.csv", table.as_bytes(), 1).expect("nothing").is_empty());
    }
}
