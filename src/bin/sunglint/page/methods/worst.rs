//! The worst inputs of a method, each with what computes it again.

use super::measurement::Measurement;
use super::promised;
use super::subject::Subject;
use crate::number;
use crate::page::cells::{cell, count, escape, scientific, slug, sortable, text};
use crate::result::{Bound, Study};

/// The table of all formats under all lights.
pub fn table(study: &Study, subject: Subject, measured: &[Measurement]) -> String {
    let under = subject.conditions();
    let shown: &[&str] = if under.is_empty() { &[] } else { &[under] };
    let unit = measured.first().map_or("", |one| one.unit);
    let input = if under.is_empty() { "worst input here" } else { "worst input here, raw bits" };
    let rest = [
        "format",
        &format!("worst, {unit}"),
        "99th percentile",
        "bias",
        "promised: at most",
        "worst known",
        "how known",
        "inputs",
        input,
        "computes the worst known again",
    ];
    let columns = [shown, &rest].concat();
    let lines: String = measured.iter().map(|one| line(subject, one, study.seed)).collect();
    let table = sortable(&format!("worst-{}", slug(subject.name())), &columns, &lines);
    format!(
        "<h5>Worst inputs</h5>\n<p class=\"note\">The worst, the 99th percentile and the bias, above zero where {}, are of \
         this run; the worst known and how many inputs it took may be of a longer search.</p>\n{table}\n",
        sign(subject)
    )
}

fn line(subject: Subject, one: &Measurement, seed: u64) -> String {
    let class = if one.failure.is_some() { " class=\"fails\"" } else { "" };
    let cells = [
        if subject.conditions().is_empty() { String::new() } else { text(one.under) },
        text(&one.said()),
        scientific(one.max),
        scientific(one.p99),
        one.bias.map_or_else(|| cell(f64::NAN, "–"), signed),
        promised::of(subject, one).map_or_else(|| cell(f64::NAN, "–"), scientific),
        scientific(one.bound_max),
        text(&known(one.bound, seed)),
        count(one.bound_samples),
        input(one),
        again(one.repro),
    ];
    format!("<tr{class}>{}</tr>\n", cells.concat())
}

/// What a positive bias says.
fn sign(subject: Subject) -> &'static str {
    match subject {
        Subject::Direction(_) | Subject::Soft => "answers lie too far from the light’s centre",
        Subject::Highlight(_) | Subject::PixelQ14 => "pixels are too bright",
        Subject::Block(_) => "answers are too great",
    }
}

/// What the worst known error rests on, in words.
fn known(bound: Bound, seed: u64) -> String {
    match bound {
        Bound::Exhaustive => "every input tried".to_owned(),
        Bound::Searched => "searched, climbing from the worst".to_owned(),
        Bound::Sampled => format!("sampled, seed {seed}"),
    }
}

/// A mean, with its sign.
fn signed(value: f64) -> String {
    let sign = if value > 0.0 { "+" } else { "" };
    cell(value, &format!("{sign}{}", number::scientific(value)))
}

fn input(one: &Measurement) -> String {
    let named = |(name, bits): &(&str, &str)| match *name {
        "" => format!("<code>{}</code>", escape(bits)),
        _ => format!("<i>{name}</i> <code>{}</code>", escape(bits)),
    };
    let parts: Vec<_> = one.worst.iter().filter(|(_, bits)| !bits.is_empty()).map(named).collect();
    format!("<td class=\"input\">{}</td>", parts.join(" &nbsp; "))
}

fn again(command: &str) -> String {
    if command.is_empty() {
        return text("–");
    }
    let command = escape(command);
    format!(
        "<td class=\"again\"><button class=\"copy\" type=\"button\" data-copy=\"{command}\">Copy</button> \
         <code class=\"repro\">{command}</code></td>"
    )
}

#[cfg(test)]
mod tests {
    use sunglint::trial::Method;

    use super::*;
    use crate::sample;

    #[test]
    fn a_line_says_how_a_bound_is_known_and_how_to_see_it_again() {
        let study = sample::methods_study();
        let cap = Subject::Direction(Method::Cap);
        let mut measured = cap.measurements(&study);
        measured.truncate(1);
        (measured[0].bound, measured[0].bound_samples, measured[0].bias) = (Bound::Searched, 1_000_000, Some(2e-9));
        measured[0].repro = "sunglint repro cap --l '1 2'";
        let html = table(&study, cap, &measured);
        assert!(html.contains("searched") && html.contains("1\u{202f}000\u{202f}000") && html.contains(">+2.0e-9<"));
        assert!(html.contains("data-copy=\"sunglint repro cap --l &#39;1 2&#39;\""), "{html}");
        assert!(html.contains("2.5e-16"), "what the documentation promises");
        assert!(html.contains("<i>l</i> <code>0x3f800000"));
        measured[0].repro = "";
        assert!(!table(&study, cap, &measured).contains("<button class=\"copy\""));
    }
}
