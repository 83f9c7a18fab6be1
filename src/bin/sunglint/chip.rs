//! Instructions, stack and bytes on microcontrollers, next to the errors that the study found.

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};
use sunglint::trial::chip::{self, Core, Cost, peers};
use sunglint::trial::lights;

use crate::author::{failure_of_peer, is_peer};
use crate::axis::Price;
use crate::call::Call;
use crate::key::in_order;
use crate::number;
use crate::result::{Row, Study};

/// The case whose errors stand beside counts of pixels: under the Sun, the sharpest of a roughness as counted.
pub const PIXEL_CASE: &str = "Sun, alpha 0.0625";

/// What a pixel's function is called, before the name of its method.
pub const PIXEL: &str = "pixel ";

/// The light whose errors stand beside counts of directions.
const SUN: &str = lights::STUDY[0].name;

/// A line of counts, with the error of what was counted.
#[derive(Clone, Debug)]
pub struct ChipRow {
    /// The counts.
    pub count: chip::Row,
    /// What is known of the same code, by the study or of a peer.
    pub found: Option<Found>,
}

/// An error.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Worst arithmetic error.
    pub error: f64,
    /// What it is in.
    pub unit: String,
    /// How it fails, if it does.
    pub failure: Option<String>,
    /// What else there is to say of it.
    pub note: String,
}

/// Names of a core's columns: as those of the table that it comes from.
const COLUMNS: [[&str; 5]; 3] = [
    ["m0_median", "m0_worst", "m0_stack", "m0_text", "m0_rodata"],
    ["m3_median", "m3_worst", "m3_stack", "m3_text", "m3_rodata"],
    ["m4_median", "m4_worst", "m4_stack", "m4_text", "m4_rodata"],
];

/// By hand, as a line of CSV cannot hold a structure within.
impl Serialize for ChipRow {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { count, found } = self;
        let mut line = serializer.serialize_struct("ChipRow", 9 + 3 * 5)?;
        line.serialize_field("function", count.function)?;
        line.serialize_field("format", count.format)?;
        line.serialize_field("by", count.by)?;
        line.serialize_field("case", count.case)?;
        line.serialize_field("inputs", &count.inputs)?;
        line.serialize_field("error_max", &found.as_ref().map(|found| found.error))?;
        line.serialize_field("unit", &found.as_ref().map(|found| &found.unit))?;
        line.serialize_field("failure", &found.as_ref().and_then(|found| found.failure.as_ref()))?;
        for (names, cost) in COLUMNS.into_iter().zip(count.costs) {
            let figures = cost.map(|Cost { median, worst, stack, text, rodata }| [median, worst, stack, text, rodata]);
            for (place, name) in names.into_iter().enumerate() {
                line.serialize_field(name, &figures.map(|figures| figures[place]))?;
            }
        }
        line.serialize_field("note", &self.notes())?;
        line.end()
    }
}

impl ChipRow {
    /// Whether it is somebody else's.
    pub fn is_peers(&self) -> bool {
        is_peer(self.count.by)
    }

    /// What there is to say of the counts and of the error.
    pub fn notes(&self) -> String {
        joined([self.count.note, self.found.as_ref().map_or("", |found| &found.note)])
    }

    /// Why it is worth nothing, or nothing if it works.
    pub fn failure(&self) -> Option<&str> {
        let uncounted = self.count.costs.iter().all(Option::is_none);
        let found = self.found.as_ref().and_then(|found| found.failure.as_deref());
        found.or(uncounted.then_some(self.count.note))
    }
}

impl Row {
    /// Instructions on `core`, and whether they put it on the frontiers of the arithmetic and of the total error.
    pub fn on_chip(&self, core: Core) -> (Option<u32>, [bool; 2]) {
        match core {
            Core::M0 => (self.m0_instructions, [self.m0_frontier, self.m0_total_frontier]),
            Core::M3 => (self.m3_instructions, [self.m3_frontier, self.m3_total_frontier]),
            Core::M4 => (self.m4_instructions, [self.m4_frontier, self.m4_total_frontier]),
        }
    }

    /// The same, to be set.
    pub fn on_chip_mut(&mut self, core: Core) -> (&mut Option<u32>, [&mut bool; 2]) {
        match core {
            Core::M0 => (&mut self.m0_instructions, [&mut self.m0_frontier, &mut self.m0_total_frontier]),
            Core::M3 => (&mut self.m3_instructions, [&mut self.m3_frontier, &mut self.m3_total_frontier]),
            Core::M4 => (&mut self.m4_instructions, [&mut self.m4_frontier, &mut self.m4_total_frontier]),
        }
    }
}

/// All counts, each with what `study` has found of it.
pub fn rows(study: &Study) -> Vec<ChipRow> {
    let row = |count: chip::Row| ChipRow { found: found(study, &count), count };
    chip::rows().map(row).collect()
}

/// The error of what was counted: of directions under the Sun from Earth, of pixels in [`PIXEL_CASE`].
fn found(study: &Study, count: &chip::Row) -> Option<Found> {
    let own = |error: f64, unit: &str, failure: &Option<String>| Found {
        error,
        unit: unit.to_owned(),
        failure: failure.clone(),
        note: String::new(),
    };
    let same =
        |function: &str, format: &str, by: &str| [function, format, by] == [count.function, count.format, count.by];
    if is_peer(count.by) {
        let peer = peers::rows().find(|peer| same(peer.function, peer.format, peer.by))?;
        let failure = failure_of_peer(count.function, count.format, count.by).map(str::to_owned);
        return Some(Found { note: joined([peer.how, peer.note]), ..own(peer.error, peer.unit, &failure) });
    }
    if let Some(method) = count.function.strip_prefix(PIXEL) {
        let mut rows = study.all_pixels().filter(|row| row.case == PIXEL_CASE);
        let row = rows.find(|row| row.method == method && row.format == count.format && row.by == count.by);
        return row.map(|row| own(row.error_max, "relative", &row.failure));
    }
    let direction = study.all_directions().find(|row| row.light == SUN && same(&row.method, &row.format, row.by));
    let kernel = || study.all_kernels().find(|row| same(&row.kernel, &row.format, row.by));
    direction
        .map(|row| own(row.error_max, "rad", &row.failure))
        .or_else(|| kernel().map(|row| own(row.error_max, &row.unit, &None)))
}

/// Those of `notes` that say something.
fn joined(notes: [&str; 2]) -> String {
    notes.into_iter().filter(|note| !note.is_empty()).collect::<Vec<_>>().join("; ")
}

/// What `call` costs on `core`: the median outside the disc, or of all inputs where these make no difference.
pub fn price(rows: &[ChipRow], core: Core, call: &Call) -> Option<Price> {
    let medians = ["outside", "any", "inside"].map(|case| Some((case, median(rows, core, call, case)?)));
    let [outside, any, inside] = medians;
    let (case, cost) = outside.or(any)?;
    let said = |(case, cost): (&str, u32)| match case {
        "any" => number::count(cost.into()),
        case => format!("{} {case} the disc", number::count(cost.into())),
    };
    let all: Vec<_> = [Some((case, cost)), inside].into_iter().flatten().map(said).collect();
    Some(Price { cost: cost.into(), said: format!("instructions on {}: {}", core.name(), all.join(", ")) })
}

/// The median of one case.
fn median(rows: &[ChipRow], core: Core, call: &Call, case: &str) -> Option<u32> {
    let Call { function, format, by, .. } = call;
    let here = |row: &&ChipRow| {
        let count = &row.count;
        [count.function, count.format, count.by, count.case] == [function.as_str(), format.as_str(), by, case]
    };
    rows.iter().find(here).and_then(|row| row.count.on(core)).map(|cost| cost.median)
}

/// The names that `part` has in `rows`, each once.
pub fn names(rows: &[ChipRow], part: impl Fn(&chip::Row) -> &'static str) -> Vec<String> {
    let names: Vec<_> = rows.iter().map(|row| part(&row.count).to_owned()).collect();
    in_order(names.iter())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::author::{FORMULA, OURS, SOFT};
    use crate::sample;

    #[test]
    fn the_study_has_every_line_of_the_table() {
        assert_eq!(rows(&sample::study(Vec::new())).len(), chip::TABLE.lines().count() - 1);
    }

    #[test]
    fn the_price_is_the_median_outside_the_disc() {
        let medians = |far: u32| [Some(far), None, Some(far / 5)];
        let rows = [
            sample::count("cap", "f32", "inside", medians(400)),
            sample::count("cap", "f32", "outside", medians(1000)),
            sample::count("normalize", "f32", "any", medians(70)),
        ];
        let call =
            |function: &str| Call { function: function.to_owned(), format: "f32".to_owned(), by: OURS, host: [1.0; 3] };
        let price = |core, function| price(&rows, core, &call(function)).map(|price| (price.cost, price.said));
        let said = "instructions on M0+: 1\u{202f}000 outside the disc, 400 inside the disc".to_owned();
        assert_eq!(price(Core::M0, "cap"), Some((1000.0, said)));
        assert_eq!(price(Core::M4, "normalize"), Some((14.0, "instructions on M4F: 14".to_owned())));
        assert_eq!(price(Core::M3, "cap"), None);
    }

    #[test]
    fn errors_are_found_for_each_kind_of_function() {
        let mut study = sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        study.pixels.iter_mut().for_each(|row| row.case = PIXEL_CASE.to_owned());
        let unit = |function| {
            let count = sample::count(function, "f32", "any", [None; 3]).count;
            found(&study, &count).map(|found| found.unit)
        };
        assert_eq!(unit("cap").as_deref(), Some("rad"));
        assert_eq!(unit("pixel cone_ggx").as_deref(), Some("relative"));
        assert_eq!(unit("normalize").as_deref(), Some("rad"));
        assert_eq!(unit("cone_ggx"), None, "a highlight alone is not judged here");
    }

    #[test]
    fn an_error_is_that_of_the_same_code() {
        let mut study = sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        study.rivals.directions.push(Row { by: SOFT, ..sample::row("cap", "f32", 1.0, 5e-8) });
        let found = |by| {
            let count = chip::Row { by, ..sample::count("cap", "f32", "outside", [Some(9); 3]).count };
            found(&study, &count).map(|found| (found.error, found.note))
        };
        assert_eq!(found(OURS), Some((1e-7, String::new())));
        assert_eq!(found(SOFT), Some((5e-8, String::new())));
        assert_eq!(found(FORMULA), None);
        let (error, note) = found("micromath 2.1.0").expect("a peer");
        assert!(error == 1.598e-4 && note.starts_with("200 000 random; by the exponent"), "{error:e} {note}");
    }

    #[test]
    fn what_nobody_could_count_fails_with_its_note() {
        assert!(sample::peer().is_peers() && !sample::count("cap", "f32", "any", [None; 3]).is_peers());
        let mut row = sample::count("root", "U16F16", "any", [None; 3]);
        row.count.note = "never returns";
        assert_eq!(row.failure(), Some("never returns"));
        assert_eq!(sample::count("root", "U16F16", "any", [Some(9); 3]).failure(), None);
    }
}
