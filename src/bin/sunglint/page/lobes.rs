//! The section of the page about whole highlights.

use super::cells::{self, cell, scientific, sortable, text};
use super::{figures, pack};
use crate::key::in_order;
use crate::lobe_chart;
use crate::result::{LobeRow, Study};

const INTRODUCTION: &str = "<p>No number format is in these: each method’s formula in exact arithmetic, over all viewers of a surface \
that is lit from one direction, against the BRDF integrated over the disc. <strong>Energy</strong> is all light that the method \
sends out over the true amount, <strong>peak</strong> its brightest value over the true one, and <strong>relative L1</strong> the \
integral of the difference’s size over that of the truth: 0 is perfect, 1 is as wrong as no highlight at all.</p>";

const COLUMNS: [&str; 7] = ["light", "alpha", "incidence, degrees", "method", "energy", "peak", "relative L1"];

/// The chart and the table, with their choice of light, incidence and roughness.
pub fn all(study: &Study) -> String {
    let rows = &study.lobes;
    let lights = in_order(rows.iter().map(|row| &row.light));
    let shown: Vec<_> = rows.iter().map(|row| [row.alpha.to_string(), row.incidence.to_string()]).collect();
    let alphas = in_order(shown.iter().map(|[alpha, _]| alpha));
    let incidences = in_order(shown.iter().map(|[_, incidence]| incidence));
    let choice = [
        cells::select("Light", "light", &lights),
        cells::select("Incidence in degrees", "incidence", &incidences),
        cells::select("Alpha in the table", "alpha", &[vec![cells::ALL.to_owned()], alphas].concat()),
    ];
    let every: Vec<_> =
        lights.iter().flat_map(|light| incidences.iter().map(move |incidence| (light, incidence))).collect();
    let figures = figures::shown(&every, |(light, incidence)| figure(rows, light, incidence));
    let lines: String = rows.iter().map(line).collect();
    let nodes = rows.first().map_or(0, |row| row.nodes);
    format!(
        "{INTRODUCTION}\n<p>The integrals take {nodes} nodes in each of their pieces; differences under some 1e-5 are their own{}.</p>\n\
         {}{figures}{}",
        if study.quick { ". This quick run left out nodes and incidences" } else { "" },
        cells::form(&choice.concat()),
        pack::packed(&sortable("lobes", &COLUMNS, &lines))
    )
}

fn figure(rows: &[LobeRow], light: &str, incidence: &str) -> String {
    let here = |row: &&LobeRow| row.light == light && row.incidence.to_string() == incidence;
    let rows: Vec<_> = rows.iter().filter(here).collect();
    let caption = format!("{light} at {incidence} degrees: relative L1 against roughness; alpha 0 is a mirror");
    let svg = lobe_chart::l1(&rows, &caption);
    figures::figure(&[("light", light), ("incidence", incidence)], &caption, &svg)
}

fn line(row: &LobeRow) -> String {
    let [alpha, incidence] = [row.alpha.to_string(), row.incidence.to_string()];
    let choices = cells::data(&[("light", &row.light), ("incidence", &incidence), ("alpha", &alpha)]);
    let cells = [
        text(&row.light),
        cell(row.alpha, &alpha),
        cell(row.incidence.into(), &incidence),
        cells::method(&row.method),
        ratio(row.energy),
        ratio(row.peak),
        scientific(row.relative_l1),
    ];
    format!("<tr{choices}>{}</tr>\n", cells.concat())
}

/// A ratio that should be 1, to four decimals.
fn ratio(value: f64) -> String {
    cell(value, &format!("{value:.4}"))
}
