//! Failures that were reported, and their cures.

use super::cells::{cell, escape, text};
use super::figures;
use crate::number;
use crate::presets::{self, Preset, PresetRow, chart, shown};
use crate::result::Study;

const INTRODUCTION: &str = "<p>Each of these was reported by users of other software, is written in its \
documentation, or was found while this crate was compared with it. The run behind this page computed the plain form \
and its cure on the same inputs, and judged both by what the last column allows. Errors are against f64, of the inputs \
as they were rounded into the format. <em>Flushing f16</em> is f16 whose subnormal results become zero, as on many \
phones.</p>";

const COLUMNS: [&str; 5] = ["", "form", "measured", "value", "allowed"];

/// The section; empty where nothing was measured.
pub fn all(study: &Study) -> String {
    let articles: String = presets::ALL.iter().filter_map(|preset| article(preset, &study.presets)).collect();
    if articles.is_empty() { articles } else { format!("{INTRODUCTION}\n{articles}") }
}

fn article(preset: &Preset, rows: &[PresetRow]) -> Option<String> {
    let rows: Vec<_> = rows.iter().filter(|row| row.preset == preset.name).cloned().collect();
    if rows.is_empty() {
        return None;
    }
    let figure = preset.chart.as_ref().map(|axes| {
        let svg = chart::against(&rows, axes);
        let lowest = number::power_of_ten(axes.lowest.log10().round() as i32);
        let caption = format!(
            "{}: {} against {}; what is below {lowest} is drawn on the lower edge",
            axes.title, axes.measure, axes.input
        );
        figures::figure(&[], &caption, &svg)
    });
    Some(format!(
        "<article id=\"preset-{name}\">\n<h3>{question}</h3>\n<p>Reported: {source}.</p>\n\
         <p><strong>{verdict}</strong></p>\n{table}\n{figure}\
         <p>To run it: <code>sunglint preset {name}</code></p>\n</article>\n",
        name = preset.name,
        question = escape(preset.question),
        source = escape(preset.source),
        verdict = escape(&preset.verdict(&rows)),
        table = table(&rows),
        figure = figure.unwrap_or_default(),
    ))
}

fn table(rows: &[PresetRow]) -> String {
    let heads: String = COLUMNS.iter().map(|name| format!("<th scope=\"col\">{name}</th>")).collect();
    let lines: String = rows.iter().filter(|row| row.input.is_none()).map(line).collect();
    format!(
        "<div class=\"wide\" tabindex=\"0\"><table class=\"preset\">\n<thead><tr>{heads}</tr></thead>\n\
         <tbody>\n{lines}</tbody>\n</table></div>"
    )
}

fn line(row: &PresetRow) -> String {
    let class = if row.fails { " class=\"fails\"" } else { "" };
    let cells = [
        text(row.role),
        text(&row.form),
        text(&row.measure),
        cell(row.value, &shown(row.value)),
        text(row.criterion.as_deref().unwrap_or_default()),
    ];
    format!("<tr{class}>{}</tr>\n", cells.concat())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn study() -> Study {
        let preset = presets::ALL[1].name;
        let named = |row: PresetRow| PresetRow { preset, ..row };
        let rows = [
            PresetRow::new("fails", "a < b", "pixels lost, per cent", f64::INFINITY).at_most(1.0),
            PresetRow::new("cure", "a - b", "pixels lost, per cent", 0.0).at_most(1.0),
            PresetRow::point("a < b", "pixels lost, per cent", 0.1, 50.0),
            PresetRow::point("a < b", "pixels lost, per cent", 0.2, 5.0),
        ];
        Study { presets: rows.map(named).into(), ..sample::study(Vec::new()) }
    }

    #[test]
    fn a_preset_has_a_table_a_chart_and_its_command() {
        let html = all(&study());
        for piece in ["id=\"preset-threejs-roughness4\"", "<svg", "sunglint preset threejs-roughness4", "at most 1.0"] {
            assert!(html.contains(piece), "{piece}");
        }
        assert_eq!(html.matches("<tr class=\"fails\">").count(), 1);
        assert_eq!(html.matches("<article").count(), 1);
        assert!(!html.contains("a < b") && html.contains(">infinite<"));
    }

    #[test]
    fn nothing_is_shown_of_nothing() {
        assert!(all(&sample::study(Vec::new())).is_empty());
    }
}
