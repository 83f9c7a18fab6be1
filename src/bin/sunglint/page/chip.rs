//! The section of the page about instructions, stack and bytes on microcontrollers.

use sunglint::trial::chip::{Core, Cost, RUSTC, Row};

use super::cells::{self, cell, count, missing, scientific, sortable, text};
use super::pack;
use crate::chip::{self, ChipRow, PIXEL_CASE};
use crate::number;
use crate::result::Study;

const INTRODUCTION: &str = "<p>Instructions from the call to the return, all that it calls included, and the deepest \
stack in bytes, counted exactly under QEMU at <code>opt-level = 3</code>; bytes of code, with all that it calls, and \
of tables at <code>opt-level = \"s\"</code>. An instruction is not a cycle: loads, jumps and divisions may take \
several.</p><p><strong>By</strong> says whose it is: <em>sunglint</em> as it is always called, <em>formula</em> the generic \
code of a format that has code of its own beside it, <em>sunglint soft</em> f32 computed in integers, <em>PixelQ14</em> a lit pixel with code of its own, and everything \
else a peer with its version. <strong>Case</strong> says of which inputs the median and the worst are: rays inside \
the light’s disc, outside, or any.</p><p>The worst arithmetic error is the study’s own, where it has judged that code, and a peer’s as the crate \
<code>tests/peers</code> has found it on the inputs that its note names, without the hard ones: \
of a direction under the Sun from Earth, of a pixel in the case";

const COLUMNS: [&str; 17] = [
    "function",
    "format",
    "by",
    "case",
    "worst arithmetic error",
    "unit",
    "M0+ median",
    "M0+ worst",
    "M3 median",
    "M3 worst",
    "M4F median",
    "M4F worst",
    "stack, M0+ / M3 / M4F",
    "code, M0+ / M3 / M4F",
    "tables, M0+ / M3 / M4F",
    "inputs",
    "note",
];

/// Where the counts come from.
pub fn origin() -> String {
    format!(
        "<p>Nothing on this page about a Cortex-M was measured in this run. Those counts come with the source, in \
         <code>src/trial/chip/counts.csv</code>, made by rustc {RUSTC}. <code>tests/firmware/run</code> counts again, \
         in QEMU; the same compiler gives the same counts on every machine.</p>"
    )
}

/// Every line of counts, with its choice of function, format and author.
pub fn all(study: &Study) -> String {
    let rows = &study.chip;
    let names = |part: fn(&Row) -> &'static str| [vec![cells::ALL.to_owned()], chip::names(rows, part)].concat();
    let choice = [
        cells::select("Function", "function", &names(|row| row.function)),
        cells::select("Format", "format", &names(|row| row.format)),
        cells::select("By", "by", &names(|row| row.by)),
        cells::FIND.to_owned(),
    ];
    let lines: String = rows.iter().map(line).collect();
    let introduction = format!("{INTRODUCTION} {PIXEL_CASE}. A line without figures says why.</p>");
    format!("{introduction}\n{}{}", cells::form(&choice.concat()), pack::packed(&sortable("counts", &COLUMNS, &lines)))
}

fn line(row: &ChipRow) -> String {
    let counts = &row.count;
    let choices = cells::data(&[("function", counts.function), ("format", counts.format), ("by", counts.by)]);
    let class = match (row.failure(), row.is_peers()) {
        (Some(_), _) => " class=\"fails\"",
        (None, true) => " class=\"peer\"",
        (None, false) => "",
    };
    let instructions = Core::ALL.map(|core| {
        let cost = counts.on(core);
        figure(cost.map(|cost| cost.median)) + &figure(cost.map(|cost| cost.worst))
    });
    let cells = [
        [counts.function, counts.format, counts.by, counts.case].map(text).concat(),
        row.found.as_ref().map_or_else(missing, |found| scientific(found.error)),
        text(row.found.as_ref().map_or("", |found| &found.unit)),
        instructions.concat(),
        bytes(row, |cost| cost.stack),
        bytes(row, |cost| cost.text),
        bytes(row, |cost| cost.rodata),
        count(counts.inputs.into()),
        text(&said(row)),
    ];
    format!("<tr{choices}{class}>{}</tr>\n", cells.concat())
}

/// How the study says that it fails, and the note.
fn said(row: &ChipRow) -> String {
    let fails = row.failure().map(|why| format!("fails: {why}"));
    let note = Some(row.notes()).filter(|note| !note.is_empty() && row.failure() != Some(note));
    fails.into_iter().chain(note).collect::<Vec<_>>().join("; ")
}

fn figure(value: Option<u32>) -> String {
    value.map_or_else(missing, |value| count(value.into()))
}

/// A cell for three cores, sorted by the first that has a figure.
fn bytes(row: &ChipRow, part: impl Fn(Cost) -> u32) -> String {
    let figures = row.count.costs.map(|cost| cost.map(&part));
    let first = figures.into_iter().flatten().next();
    let shown = figures.map(|figure| figure.map_or_else(|| "–".to_owned(), |figure| number::count(figure.into())));
    first.map_or_else(missing, |first| cell(first.into(), &shown.join(" / ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn a_peer_that_fails_is_shown_as_such() {
        let html = line(&sample::peer());
        assert!(html.contains("class=\"fails\"") && html.contains("<td>fails: never returns</td>"), "{html}");
        assert!(html.contains("data-by=\"cordic 0.1.5\"") && !html.contains("NaN<"), "{html}");
    }

    #[test]
    fn a_core_without_a_figure_has_a_dash() {
        let html = line(&sample::count("disc", "I2F14", "outside", [Some(1000), None, Some(270)]));
        assert!(html.contains(">900 / – / 900<") && html.contains("data-value=\"1000\""), "{html}");
        assert!(!html.contains("class=\"fails\""), "{html}");
    }
}
