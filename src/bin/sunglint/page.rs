//! report.html: charts, tables and explanations in one file that loads nothing.

mod cells;
mod chip;
mod costs;
mod directions;
mod kernels;
mod lobes;
mod methods;
mod pictures;
mod pixels;
mod presets;
mod quantities;
mod sweep;
mod take_away;

pub use cells::escape;

use crate::number;
use crate::result::Study;

const STYLE: &str = concat!(include_str!("page.css"), include_str!("page/methods.css"));
const SCRIPT: &str = include_str!("page.js");

const INTRODUCTION: &str = "<p>Each mark in a chart of error against cost is one way to compute the same thing: a method, told by \
its shape, in a number format, told by its colour and its label. Further <strong>left is \
cheaper</strong> (in time on the machine of this run, or in instructions on a microcontroller, as chosen \
above the chart), further <strong>down is more exact</strong>; both axes are logarithmic. The grey \
stairs are the Pareto frontier: for every mark off them there is another that is neither dearer nor \
more wrong. A hollow, crossed-out mark fails, and \
its label says how: <em>disc lost</em> is off by half of the radius or more within ten radii of the \
light; in the grey strip on top stands what gave no number at all. Marks that coincide are drawn inside each other, the outer ones larger. Point at a mark for its numbers.</p>";

const DIRECTIONS: &str = "<p>A highlight shows the point of a light that lies nearest to the mirror direction. \
These are ways to find the direction to that point. The dashed line is an error as large as the light’s own angular \
radius.</p>";

/// The whole page.
pub fn report(study: &Study) -> String {
    let sections = sections(study);
    let link = |section: &Section| Some(format!("<li><a href=\"#{}\">{}</a></li>", section.id, section.short?));
    let contents: String = sections.iter().filter_map(link).collect();
    let sections: String = sections.iter().map(Section::html).collect();
    format!(
        "<!doctype html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>sunglint: error against cost</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header><h1>sunglint</h1><p>Error against cost of light directions, lit pixels and their parts, {} \
         measurements</p></header>\n<nav><ul>{contents}</ul></nav>\n<main>\n{sections}</main>\n\
         <script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        study.all_directions().count()
            + study.all_pixels().count()
            + study.lobes.len()
            + study.kernels.len()
            + study.chip.len(),
    )
}

/// A part of the page under a heading.
struct Section {
    /// Address within the page.
    id: &'static str,
    /// Name in the contents, unless it belongs to the one before.
    short: Option<&'static str>,
    title: &'static str,
    content: String,
}

impl Section {
    fn html(&self) -> String {
        let Self { id, title, content, .. } = self;
        format!("<section id=\"{id}\">\n<h2>{title}</h2>\n{content}\n</section>\n")
    }
}

/// What the page is made of, less what was not measured.
fn sections(study: &Study) -> Vec<Section> {
    let section = |id, short, title, content| Section { id, short, title, content };
    let mut sections = vec![section("how", Some("How to read this"), "How to read this", INTRODUCTION.to_owned())];
    if !study.rows.is_empty() {
        let charts = format!("{DIRECTIONS}\n{}", directions::charts(study));
        let errors = "Specular direction: arithmetic error, model error, total error";
        sections.extend([
            section("directions", Some("Directions"), "Specular direction: error against cost", charts),
            section(
                "methods",
                None,
                "Specular direction: the methods",
                format!("{}\n{}", directions::METHODS, directions::RIVALS),
            ),
            section("errors", None, errors, directions::errors(study)),
            section("all-directions", None, "Specular direction: all measurements", directions::all(study)),
        ]);
    }
    if !study.pixels.is_empty() {
        sections.extend([
            section("pixels", Some("Lit pixels"), "Lit pixels: error against cost", pixels::charts(study)),
            section("all-pixels", None, "Lit pixels: all measurements", pixels::all(study)),
        ]);
    }
    if !study.lobes.is_empty() {
        let title = "Whole highlights: model error of every method";
        sections.push(section("highlights", Some("Whole highlights"), title, lobes::all(study)));
    }
    let more = [
        section("pictures", Some("Pictures"), "Pictures: lit spheres, and where the error sits", pictures::all(study)),
        section("method-pages", Some("Every method"), "Every method", methods::all(study)),
        section("bits", Some("How many bits?"), "How many bits do I need?", sweep::all(study)),
        section(
            "presets",
            Some("Reported failures"),
            "Failures that were reported, and their cures",
            presets::all(study),
        ),
        section("take-away", Some("Take it away"), "Take it away: files, columns, source code", take_away::all()),
    ];
    sections.extend(more.into_iter().filter(|section| !section.content.is_empty()));
    let last = [
        section("parts", Some("Building blocks"), "Building blocks", kernels::all(study)),
        section("chip", Some("On the chip"), "On the chip: instructions, stack and bytes", chip::all(study)),
        section("of-a-light", Some("Quantities"), "Quantities of the light", quantities::all(&study.quantities)),
        section("origin", Some("Origin"), "How the numbers were made", origin(study)),
    ];
    let measured = [!study.kernels.is_empty(), !study.chip.is_empty(), !study.quantities.is_empty(), true];
    sections.extend(last.into_iter().zip(measured).filter_map(|(section, measured)| measured.then_some(section)));
    sections
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
        "<p>sunglint {} tried {tried} directions for each measurement of a direction, drawn at random from seed {}, and the hard ones \
         that have broken a method, and {} (by the integral over the disc), also random. \
         To do it again: <code>{}</code>. The same seed gives the same errors. \
         The costs are times of this machine in this run on the pixels of a ball in scan order, less that of an \
         empty call: the median over the \
         rounds, as a multiple of the time of f32 <code>factored</code> in the same round, with the \
         quartiles beside it. A loop over a million pixels in fixed point is no faster than as many calls: early answers, \
         a table, leading zeros and products of 64 bits keep the compiler from vectorising it (<code>tests/peers</code> \
         measures that). Every worst case is given with the raw bits of its input (the first input, where no answer is a \
         direction), or in exact decimals for building blocks, so that it can be computed again (of soft_shadow the scene without the \
 direction to its light). The same numbers lie next to this page in <code>results.csv</code>, \
         <code>pixels.csv</code>, <code>lobes.csv</code>, <code>kernels.csv</code>, <code>chip.csv</code> and, all together, in \
         <code>results.json</code>, the first charts in <code>chart.svg</code>, <code>chips.svg</code> and <code>pixels.svg</code>.</p>\n{}",
        escape(&study.version),
        study.seed,
        pixels::tried(study),
        escape(&study.command),
        chip::origin()
    )
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
    fn there_is_a_figure_for_each_choice_and_a_row_for_each_measurement() {
        let study = sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        let html = report(&study);
        let count = |piece: &str| html.matches(piece).count();
        // Two kinds of error of the light, two by two of the case, two means of the building blocks, each over four
        // costs; the highlight.
        let figures = [count("<figure data-light"), count("<figure data-case"), count("class=\"several\"")];
        assert_eq!(figures, [2 * 4 + 1, 2 * 2 * 4, 2 * 4]);
        assert_eq!(count("<tr data-function"), study.chip.len());
        assert_eq!(count("<tr data-case"), study.all_pixels().count());
        assert_eq!(count("data-alpha"), study.lobes.len());
        for option in ["Sun, alpha 0.001", "45", "0.0625", "all"] {
            assert!(html.contains(&format!("<option>{option}</option>")), "{option}");
        }
        assert!(html.contains(&study.kernels[0].worst_input));
    }

    #[test]
    fn no_rows_still_make_a_page() {
        assert!(report(&sample::study(Vec::new())).ends_with("</html>\n"));
    }

    #[test]
    fn the_command_is_shown() {
        let study = Study { command: "sunglint --light '<b>'".to_owned(), ..sample::study(Vec::new()) };
        assert!(report(&study).contains("<code>sunglint --light &#39;&lt;b&gt;&#39;</code>"));
    }
}
