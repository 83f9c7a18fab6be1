//! What a method costs in each format: time here, and instructions, bytes and stack on microcontrollers.

use sunglint::trial::chip::{Core, Cost};

use super::measurement::Measurement;
use super::subject::Subject;
use crate::chip::ChipRow;
use crate::number;
use crate::page::cells::{cell, slug, sortable, text};
use crate::result::Study;

const COLUMNS: [&str; 8] = [
    "format",
    "time",
    "latency",
    "instructions, M0+",
    "instructions, M3",
    "instructions, M4F",
    "bytes, M0+",
    "stack, M0+",
];

/// The table, with a line on what stands in it.
pub fn table(study: &Study, subject: Subject, measured: &[Measurement]) -> String {
    let mut formats: Vec<&Measurement> = Vec::new();
    for one in measured {
        if !formats.iter().any(|known| (known.format, known.by) == (one.format, one.by)) {
            formats.push(one);
        }
    }
    let whole = formats.iter().map(|one| line(study, one, measured));
    let alone = formats.iter().filter_map(|one| alone(study, subject, one));
    let lines: String = whole.chain(alone).collect();
    let table = sortable(&format!("costs-{}", slug(subject.name())), &COLUMNS, &lines);
    format!("<h5>Cost</h5>\n<p>{}</p>\n{table}\n", introduction(subject, measured))
}

/// Units, and the median over all formats.
fn introduction(subject: Subject, measured: &[Measurement]) -> String {
    let what = match subject {
        Subject::Highlight(_) | Subject::PixelQ14 => "a whole pixel",
        _ => "a call",
    };
    let under = subject.conditions();
    let over = if under.is_empty() { String::new() } else { format!(", the median over every {under}") };
    let typical = median(measured.iter().map(|one| one.call.host[0]));
    let typical = if typical.is_nan() {
        "There is no time of it, only counts.".to_owned()
    } else {
        format!("Over all formats the median time is {}.", number::cost(typical))
    };
    format!(
        "Time and latency of {what} in calls of f32 <code>factored</code>{over}; the latency is that of a call which waits for the \
         answer of the one before. Instructions are medians: outside / inside the light’s disc where that matters; bytes are code + tables, and the stack is in \
         bytes too. {typical}"
    )
}

fn line(study: &Study, one: &Measurement, measured: &[Measurement]) -> String {
    let same = || measured.iter().filter(|other| (other.format, other.by) == (one.format, one.by));
    let time = median(same().map(|other| other.call.host[0]));
    let latency = median(same().map(|other| other.latency).filter(|latency| *latency > 0.0));
    cells(&one.said(), [time, latency], &counted(study, &one.call.function, one))
}

/// The line of a highlight by itself, which is counted beside the whole pixel; none where it is not.
fn alone(study: &Study, subject: Subject, one: &Measurement) -> Option<String> {
    let Subject::Highlight(shading) = subject else { return None };
    let counted = counted(study, shading.name(), one);
    let name = format!("{}, the highlight alone", one.said());
    (!counted.is_empty()).then(|| cells(&name, [f64::NAN; 2], &counted))
}

fn cells(name: &str, times: [f64; 2], counted: &[&ChipRow]) -> String {
    let cost = |value: f64| if value.is_nan() { missing() } else { cell(value, &number::cost(value)) };
    let on_smallest = |part: fn(Cost) -> [u32; 2]| {
        let figures = counted.iter().find_map(|row| row.count.on(Core::M0)).map(part);
        figures.map_or_else(missing, |[first, second]| match second {
            0 => cell(first.into(), &number::count(first.into())),
            _ => cell(f64::from(first + second), &format!("{} + {second}", number::count(first.into()))),
        })
    };
    let cells = [
        text(name),
        times.map(cost).concat(),
        Core::ALL.map(|core| instructions(counted, core)).concat(),
        on_smallest(|cost| [cost.text, cost.rodata]),
        on_smallest(|cost| [cost.stack, 0]),
    ];
    format!("<tr>{}</tr>\n", cells.concat())
}

/// The counts of `function` in the format and by the code of `one`, from outside the disc to inside.
fn counted<'a>(study: &'a Study, function: &str, one: &Measurement) -> Vec<&'a ChipRow> {
    let same = |row: &&ChipRow| [row.count.function, row.count.format, row.count.by] == [function, one.format, one.by];
    let mut rows: Vec<_> = study.chip.iter().filter(same).collect();
    rows.sort_by_key(|row| row.count.case == "inside");
    rows
}

fn instructions(counted: &[&ChipRow], core: Core) -> String {
    let medians: Vec<_> = counted.iter().filter_map(|row| row.count.on(core)).map(|cost| cost.median).collect();
    let shown: Vec<_> = medians.iter().map(|&median| number::count(median.into())).collect();
    medians.first().map_or_else(missing, |&first| cell(first.into(), &shown.join(" / ")))
}

/// A cell without a figure, which comes last in any order.
fn missing() -> String {
    cell(f64::NAN, "–")
}

/// The middle one of the numbers among `values`, of two the lower; NaN of none.
pub fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<_> = values.filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len().saturating_sub(1) / 2).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use sunglint::trial::{Method, Shading};

    use super::*;
    use crate::sample;

    #[test]
    fn medians_leave_out_what_is_no_number() {
        assert_eq!(median([3.0, f64::NAN, 1.0, 2.0].into_iter()), 2.0);
        assert!(median([f64::NAN].into_iter()).is_nan());
    }

    #[test]
    fn a_line_has_times_and_counts() {
        let study = sample::methods_study();
        let cap = Subject::Direction(Method::Cap);
        let mut measured = cap.measurements(&study);
        measured.retain(|one| one.format == "f16");
        assert!(!table(&study, cap, &measured).contains("4\u{202f}700"), "no counts of f16 in the sample");
        measured[0].format = "f32";
        measured[0].latency = 1.5;
        let html = table(&study, cap, &measured);
        let figures = ["1.50", "4\u{202f}700 / 2\u{202f}500", "2\u{202f}600 / 1\u{202f}300", "900 + 192", ">100<"];
        assert!(figures.iter().all(|figure| html.contains(figure)), "{html}");
    }

    #[test]
    fn a_highlight_by_itself_has_a_line_where_it_is_counted() {
        let mut study = sample::methods_study();
        let karis = Subject::Highlight(Shading::Karis);
        let said = |study: &Study| table(study, karis, &karis.measurements(study));
        assert!(!said(&study).contains("alone"));
        study.chip.push(sample::count("karis", "f32", "outside", [Some(1234), None, None]));
        let html = said(&study);
        assert!(html.contains("f32, the highlight alone") && html.contains("1\u{202f}234"), "{html}");
    }
}
