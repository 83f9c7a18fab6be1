//! Where a method stands among its like: which formats are cheapest, most exact and good enough.

use sunglint::trial::chip::Core;

use super::costs::median;
use super::figure;
use super::measurement::{Measurement, Origin};
use super::subject::Subject;
use crate::author::is_ours;
use crate::chip;
use crate::key::in_order;
use crate::number;
use crate::page::cells::escape;
use crate::result::{PixelRow, Row, Study};

/// What counts as good enough: a part of the light's radius, or of a pixel's value.
const ENOUGH: f64 = 0.01;

/// A few computed sentences.
pub fn paragraph(study: &Study, subject: Subject, measured: &[Measurement]) -> String {
    let first = measured.first().map_or("", |one| one.under);
    let here: Vec<_> = measured.iter().filter(|one| one.under == first).collect();
    let sentences = [cheapest(study, &here), most_exact(&here), enough(&here), rank(study, subject, first)];
    let sentences: Vec<_> = sentences.into_iter().filter(|sentence| !sentence.is_empty()).collect();
    let under = if first.is_empty() { String::new() } else { format!("<strong>{}.</strong> ", escape(first)) };
    format!("<p class=\"place\">{under}{}</p>\n", sentences.join(" "))
}

/// The formats of the least time and of the fewest instructions.
fn cheapest(study: &Study, here: &[&Measurement]) -> String {
    let by_time = least(here, |one| one.call.host[0]);
    let by_count =
        least(here, |one| chip::price(&study.chip, Core::M0, &one.call).map_or(f64::NAN, |price| price.cost));
    let time = by_time.map(|(format, cost)| {
        format!("{} on this machine ({} calls of f32 factored)", escape(&format), number::cost(cost))
    });
    let count = by_count
        .map(|(format, cost)| format!("{} on an M0+ ({} instructions)", escape(&format), number::count(cost as u64)));
    let both: Vec<_> = time.into_iter().chain(count).collect();
    if both.is_empty() { String::new() } else { format!("Cheapest of what works: {}.", both.join(", ")) }
}

fn most_exact(here: &[&Measurement]) -> String {
    let unit = here.first().map_or("", |one| one.unit);
    let narrow: Vec<_> = here.iter().copied().filter(|one| one.format != "f64").collect();
    let Some((first, error)) = least(here, |one| one.max) else { return "No format works.".to_owned() };
    let said = |format: &str, error| format!("{} ({} {unit})", escape(format), figure(error));
    let next = least(&narrow, |one| one.max).filter(|(format, _)| *format != first);
    let next = next.map_or_else(String::new, |(format, error)| format!(", then {}", said(&format, error)));
    format!("Most exact by the worst error: {}{next}.", said(&first, error))
}

/// The format of the least figure among what works, and that figure.
fn least(here: &[&Measurement], figure: impl Fn(&Measurement) -> f64) -> Option<(String, f64)> {
    let works = here.iter().filter(|one| one.failure.is_none());
    let figures = works.map(|one| (one.said(), figure(one))).filter(|(_, figure)| figure.is_finite());
    figures.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Which formats are within a hundredth: of the radius, of the pixel.
fn enough(here: &[&Measurement]) -> String {
    let names = |good: &dyn Fn(&Measurement) -> bool| {
        let names: Vec<_> =
            here.iter().filter(|one| one.failure.is_none() && good(one)).map(|one| escape(&one.said())).collect();
        if names.is_empty() { "none".to_owned() } else { names.join(", ") }
    };
    match here.first().map(|one| one.row) {
        Some(Origin::Direction(_)) => {
            let arithmetic =
                names(&|one| matches!(one.row, Origin::Direction(row) if row.error_max <= ENOUGH * row.theta));
            let total = names(&|one| matches!(one.row, Origin::Direction(row) if row.total_max <= ENOUGH * row.theta));
            format!(
                "Within 1 % of the light’s radius at the worst, by the arithmetic alone: {arithmetic}; with the model’s error: {total}."
            )
        }
        Some(Origin::Pixel(_)) => {
            let total = names(&|one| matches!(one.row, Origin::Pixel(row) if row.total_rms <= ENOUGH));
            let wasted = names(&|one| matches!(one.row, Origin::Pixel(row) if row.error_rms <= row.model_rms));
            format!(
                "Within 1 % of the true pixel, root mean square: {total}. Arithmetic below the model’s own error, so that more \
                 precision buys nothing: {wasted}."
            )
        }
        Some(Origin::Block) | None => String::new(),
    }
}

/// The place among all methods by cost and by total error, each by its median over the formats that all have.
fn rank(study: &Study, subject: Subject, under: &str) -> String {
    let (name, figures) = match subject {
        Subject::Direction(method) => (method.name(), of_directions(study, under)),
        Subject::Highlight(shading) => (shading.name(), of_pixels(study, under)),
        Subject::Soft | Subject::PixelQ14 | Subject::Block(_) => return String::new(),
    };
    let Some(own) = figures.iter().find(|(other, _)| other == name).map(|(_, own)| *own) else { return String::new() };
    let place = |part: usize| 1 + figures.iter().filter(|(_, other)| other[part] < own[part]).count();
    let of = figures.len();
    if of < 2 || own.iter().any(|figure| figure.is_nan()) {
        return String::new();
    }
    format!("In f32 it is number {} of {of} methods by time and number {} by total error.", place(0), place(1))
}

/// Time and worst total error of each method in f32, the errors to two digits.
fn of_directions(study: &Study, light: &str) -> Vec<(String, [f64; 2])> {
    let here = |row: &&Row| row.light == light && row.format == "f32" && is_ours(row.by);
    let rows: Vec<_> = study.rows.iter().filter(here).collect();
    let figures = |method: &String| {
        let rows = || rows.iter().filter(|row| row.method == *method);
        [median(rows().map(|row| row.cost)), number::two_digits(median(rows().map(|row| row.total_max)))]
    };
    in_order(rows.iter().map(|row| &row.method)).into_iter().map(|name| (name.clone(), figures(&name))).collect()
}

/// Time and total error, root mean square, likewise.
fn of_pixels(study: &Study, case: &str) -> Vec<(String, [f64; 2])> {
    let here = |row: &&PixelRow| row.case == case && row.format == "f32" && is_ours(row.by);
    let rows: Vec<_> = study.pixels.iter().filter(here).collect();
    let figures = |method: &String| {
        let rows = || rows.iter().filter(|row| row.method == *method);
        [median(rows().map(|row| row.cost)), number::two_digits(median(rows().map(|row| row.total_rms)))]
    };
    in_order(rows.iter().map(|row| &row.method)).into_iter().map(|name| (name.clone(), figures(&name))).collect()
}

#[cfg(test)]
mod tests {
    use sunglint::trial::{Method, Shading};

    use super::*;
    use crate::sample;

    fn said(subject: Subject) -> String {
        let study = sample::methods_study();
        paragraph(&study, subject, &subject.measurements(&study))
    }

    #[test]
    fn the_cheapest_and_the_most_exact_are_found() {
        let html = said(Subject::Direction(Method::Cap));
        assert!(
            html.contains("<strong>Sun from Earth.</strong> ")
                && html.contains("Cheapest of what works: f64 on this machine (1.00 calls"),
            "{html}"
        );
        assert!(html.contains("Most exact by the worst error: f64 (<span class=\"number\">1.0e-16</span> rad), then f16 (<span class=\"number\">1.0e-3</span> rad)"), "{html}");
        assert!(
            html.contains("by the arithmetic alone: f64; with the model’s error: f64."),
            "f16 is off by a fifth: {html}"
        );
    }

    #[test]
    fn what_fails_is_no_bargain() {
        assert!(said(Subject::Direction(Method::Epic)).contains("No format works."));
    }

    #[test]
    fn methods_are_ranked_in_f32() {
        let html = said(Subject::Highlight(Shading::Karis));
        assert!(html.contains("number 1 of 2 methods by time and number 1 by total error"), "{html}");
        let html = said(Subject::Highlight(Shading::ConeGgx));
        assert!(
            html.contains("number 2 of 2 methods by time and number 1 by total error"),
            "equal to two digits: {html}"
        );
    }
}
