//! report.html: charts, tables and explanations in one file that loads nothing.

use crate::chart::{self, under_light};
use crate::error_kind::ErrorKind;
use crate::key::{Key, in_order};
use crate::number;
use crate::options::DEFAULT_SEED;
use crate::page_table;
use crate::result::Study;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

const INTRODUCTION: &str = "<p>A highlight shows the point of a light that lies nearest to the \
mirror direction. Each mark below is one way to find the direction to that point: a method, told by \
its shape, in a number format, told by its colour and its label. Further <strong>left is \
cheaper</strong>, further <strong>down is more exact</strong>; both axes are logarithmic. The grey \
stairs are the Pareto frontier: for every mark off them there is another that is neither dearer nor \
more wrong. The dashed line is an error as large as the light’s own angular radius. A hollow, crossed-out mark fails, and \
its label says how: <em>disc lost</em> is off by half of the radius or more within ten radii of the \
light; in the grey strip on top stands what gave no number at all. Point at a mark for its numbers.</p>";

const METHODS: &str = "<p>All take the unit directions l to the light’s centre and r along the mirror \
ray, and radius over distance, x = sin θ.</p>\n<dl>\
<dt>epic</dt><dd>C = (L·r) r − L, P = L + C sat(R / |C|), with L as long as the distance: Epic’s \
representative point as published. The Sun’s distance in kilometres overflows f16 and fixed point.</dd>\
<dt>factored</dt><dd>D = (l·r) r − l, P = l + D sat(x / |D|): the same with the distance divided out. \
Turns by about θ cos(angle), so it falls short away from the light and goes the wrong way behind it.</dd>\
<dt>disc</dt><dd>r where l·r ≥ cos θ, else cos θ l + sin θ times the tangent: the nearest direction of the \
disc, told by a cosine that narrow formats round to 1.</dd>\
<dt>cap</dt><dd>the same direction by the sine: e = r − l (r + l behind the light), s = e − (e·l) l; r \
where s·s ≤ x², else l + (x / |s|) s − (1 − cos θ) l.</dd></dl>";

const INPUTS: &str = "<p>None of these holds what <strong>rounding the directions</strong> into the format \
costs before any method has its turn: the truth is always computed from the rounded directions. That \
error is here, for rays within 90 degrees of the light.</p>";

const ERRORS: &str = "<p><strong>Arithmetic error</strong> is what the number format costs: the \
computed direction against the exact value of the same formula for the same input. <strong>Model \
error</strong> is what the formula costs: its exact value against the nearest point of the light’s \
disc. It hardly depends on the format, and no precision removes it. <strong>Total error</strong> is \
the computed direction against the nearest point, so it holds both. A method may lead by its \
arithmetic and yet trail by its model; hence two charts for each light, and two frontiers. The truth \
is computed in f64, so errors of some 1e-16 rad are the truth’s own rounding as much as the method’s, and \
their order says nothing. Left out are directions beside the opposite of the light, where all of \
the rim is as near, and where the representative point falls into the origin; the table counts them.</p>";

/// The whole page.
pub fn report(study: &Study) -> String {
    let lights = in_order(study.rows.iter().map(|row| &row.light));
    let sections = [
        section("How to read this", INTRODUCTION),
        section("The methods", METHODS),
        section("Error against cost", &charts(study, &lights)),
        section("Arithmetic error, model error, total error", &errors(study, &lights)),
        section("All measurements", &page_table::measurements(&study.rows, &lights)),
        section("Quantities of the light", &page_table::quantities(&study.quantities)),
        section("How the numbers were made", &origin(study)),
    ];
    format!(
        "<!doctype html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>sunglint: error against cost</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header><h1>sunglint</h1><p>Error against cost of the specular light direction, {} \
         measurements</p></header>\n<main>\n{}</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        study.rows.len(),
        sections.concat()
    )
}

/// `text` with the characters replaced that mean something in HTML.
pub fn escape(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;").replace('\'', "&#39;")
}

fn section(title: &str, content: &str) -> String {
    format!("<section>\n<h2>{title}</h2>\n{content}\n</section>\n")
}

/// A chart for each light and kind of error; the script shows one at a time.
fn charts(study: &Study, lights: &[String]) -> String {
    let key = Key::new(&study.rows);
    let mut html = selectors(lights);
    for (place, light) in lights.iter().enumerate() {
        let rows = under_light(&study.rows, light);
        for kind in ErrorKind::ALL {
            let name = kind.name();
            let svg = chart::one_error(&rows, kind, &key);
            html += &format!(
                "<figure data-light=\"{place}\" data-kind=\"{name}\">\n<figcaption>{}, {name} error \
                 {}</figcaption>\n<div class=\"wide\" tabindex=\"0\">{svg}</div>\n</figure>\n",
                escape(light),
                kind.against()
            );
        }
    }
    html
}

fn selectors(lights: &[String]) -> String {
    let option = |(place, light): (usize, &String)| format!("<option value=\"{place}\">{}</option>", escape(light));
    let options: String = lights.iter().enumerate().map(option).collect();
    let kind = |kind: ErrorKind| {
        let name = kind.name();
        let checked = if kind == ErrorKind::Arithmetic { " checked" } else { "" };
        format!("<label><input type=\"radio\" name=\"kind\" value=\"{name}\"{checked}> {name}</label>")
    };
    format!(
        "<form class=\"choice\" hidden><label>Light <select id=\"light\">{options}</select></label>\
         <fieldset><legend>Error</legend>{}</fieldset></form>\n",
        ErrorKind::ALL.map(kind).concat()
    )
}

fn errors(study: &Study, lights: &[String]) -> String {
    let models = page_table::model_errors(&study.rows, lights);
    format!("{ERRORS}\n{models}\n{INPUTS}\n{}", page_table::input_errors(&study.rows, lights))
}

/// Seed, size and command of the run.
fn origin(study: &Study) -> String {
    let tried = study.rows.iter().map(|row| row.samples);
    let (least, most) = (tried.clone().min().unwrap_or(0), tried.max().unwrap_or(0));
    let tried = match least == most {
        true => number::count(most),
        false => format!("{} to {}", number::count(least), number::count(most)),
    };
    format!(
        "<p>sunglint {} tried {tried} directions for each measurement, drawn at random from seed {}, and the hard ones \
         that have broken a method. \
         To do it again: <code>{}</code>. The same seed gives the same errors. \
         The costs are times of this machine in this run on the pixels of a ball in scan order, less that of an \
         empty call: the median over the \
         rounds, as a multiple of the time of f32 <code>factored</code> in the same round, with the \
         quartiles beside it. Every worst case is given with the raw bits of its input (the first input, where no answer is a \
         direction), so that it can be computed again. The same numbers lie next to this page in <code>results.csv</code> and \
         <code>results.json</code>, the first light’s charts in <code>chart.svg</code>.</p>",
        escape(&study.version),
        study.seed,
        command(study)
    )
}

fn command(study: &Study) -> String {
    let mut command = "sunglint".to_owned();
    if study.quick {
        command += " --quick";
    }
    if let Some(light) = &study.light {
        command += &format!(" --light '{}'", escape(light));
    }
    if study.seed != DEFAULT_SEED {
        command += &format!(" --seed {}", study.seed);
    }
    command
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn names_are_escaped() {
        let mut row = sample::row("<b>", "\"f32\" & co", 1.0, 1e-7);
        row.light = "<script>".to_owned();
        let html = report(&sample::study(vec![row]));
        assert!(!html.contains("<b>") && html.contains("&lt;b&gt;"));
        assert_eq!(html.matches("<script>").count(), 1);
    }

    #[test]
    fn no_rows_still_make_a_page() {
        assert!(report(&sample::study(Vec::new())).ends_with("</html>\n"));
    }

    #[test]
    fn the_command_repeats_the_run() {
        let mut study = sample::study(Vec::new());
        assert_eq!(command(&study), "sunglint --quick");
        (study.quick, study.seed) = (false, 7);
        assert_eq!(command(&study), "sunglint --seed 7");
    }
}
