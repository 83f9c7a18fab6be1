//! The charts of a method's errors along the angle and along the size of the light.

use super::subject::Subject;
use crate::chart;
use crate::curve_panel;
use crate::curves::CurveRow;
use crate::number;
use crate::page::cells::escape;
use crate::result::Study;

const EXPLANATION: &str = "A line for each format: the worst arithmetic error at each place. Dashed: the model’s error, which no \
format removes. The thin ochre lines are the light’s radius, across where a direction is off by as much and upright at the edge of \
the disc. Crosses in the strip are answers that are no numbers. Point at a place for its figures.";

/// A chart for each thing that varies, on each surface; empty where nothing was measured.
pub fn charts(study: &Study, subject: Subject) -> String {
    let (kind, key) = match subject {
        Subject::Direction(_) => ("direction", chart::direction_key(study)),
        Subject::Highlight(_) => ("pixel", chart::pixel_key(study)),
        Subject::Soft | Subject::PixelQ14 | Subject::Block(_) => return String::new(),
    };
    let of_method = |row: &&CurveRow| row.subject == kind && row.method == subject.name();
    let rows: Vec<_> = study.curves.iter().filter(of_method).collect();
    let mut groups: Vec<(&str, Option<f64>)> = Vec::new();
    for row in &rows {
        let group = (row.along, row.alpha);
        if !groups.contains(&group) {
            groups.push(group);
        }
    }
    let figure = |(along, alpha): &(&str, Option<f64>)| {
        let here: Vec<_> = rows.iter().copied().filter(|row| (row.along, row.alpha) == (*along, *alpha)).collect();
        let said = caption(&here, along, *alpha);
        let svg = curve_panel::svg(&here, &key, &format!("{}: {said}", subject.name()));
        format!("<figure class=\"curve\"><figcaption>{}</figcaption>{svg}</figure>\n", escape(&said))
    };
    let figures: String = groups.iter().map(figure).collect();
    if figures.is_empty() {
        return figures;
    }
    format!(
        "<h5>Where the error lies</h5>\n<div class=\"curves\">{figures}</div>\n<p class=\"note\">{EXPLANATION}</p>\n"
    )
}

/// What varies, and what does not.
fn caption(rows: &[&CurveRow], along: &str, alpha: Option<f64>) -> String {
    let surface = alpha.map_or_else(String::new, |alpha| format!(", alpha {alpha}"));
    let ratio = rows.first().map_or(f64::NAN, |row| row.ratio);
    match along {
        "ratio" => format!("Error against the size of the light{surface}"),
        "angle" => format!("Error against the angle, ratio {}{surface}", number::scientific(ratio)),
        _ => format!("Error beside the light’s opposite, ratio {}{surface}", number::scientific(ratio)),
    }
}
