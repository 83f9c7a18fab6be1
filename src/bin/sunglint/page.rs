//! report.html: charts, tables and explanations in one file that loads nothing.

mod cells;
mod chip;
mod costs;
mod direction_table;
mod directions;
mod figures;
mod kernel_table;
mod kernels;
mod lobes;
mod methods;
mod origin;
mod pack;
mod pictures;
mod pixel_table;
mod pixels;
mod presets;
mod quantities;
mod short;
mod signs;
mod sweep;
mod take_away;

pub use cells::{escape, slug};

use crate::result::Study;

const STYLE: &str = concat!(include_str!("page.css"), include_str!("page/methods.css"));
const SCRIPT: &str = concat!(
    include_str!("page/choose.js"),
    include_str!("page/point.js"),
    include_str!("page/table.js"),
    include_str!("page/start.js")
);

const DIRECTIONS: &str = "<p>A highlight shows the point of a light that lies nearest to the mirror direction. \
These are ways to find the direction to that point, and what they cost.</p>";

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
         <header id=\"top\"><h1>sunglint</h1><p>Which formula in which number format is good enough, and what does it cost?</p>\n\
         {}</header>\n<nav aria-label=\"Contents\"><ul><li><a href=\"#top\">Top</a></li>{contents}</ul></nav>\n\
         <main>\n{}{sections}</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        origin::summary(study),
        short::all(study),
    )
}

/// A part of the page under a heading, which folds it.
struct Section {
    /// Address within the page.
    id: &'static str,
    /// Name in the contents, unless it belongs to the one before.
    short: Option<&'static str>,
    title: &'static str,
    content: String,
    /// Whether it is unfolded at first.
    open: bool,
}

impl Section {
    fn html(&self) -> String {
        let Self { id, title, content, open, .. } = self;
        let open = if *open { " open" } else { "" };
        format!(
            "<section id=\"{id}\">\n<details{open}><summary><h2>{title}</h2></summary>\n{content}\n</details>\n</section>\n"
        )
    }
}

/// What the page is made of, less what was not measured.
fn sections(study: &Study) -> Vec<Section> {
    let section = |id, short, title, content| Section { id, short, title, content, open: true };
    let mut sections = Vec::new();
    if !study.rows.is_empty() {
        let charts = format!("{DIRECTIONS}\n{}", directions::charts(study));
        let errors = "Specular direction: what the errors mean";
        sections.extend([
            section("directions", Some("Directions"), "Specular direction: error against cost", charts),
            section("how", Some("How to read"), "How to read the charts", signs::all()),
            section("all-directions", None, "Specular direction: all measurements", direction_table::all(study)),
            Section { open: false, ..section("errors", None, errors, directions::errors(study)) },
        ]);
    }
    if !study.pixels.is_empty() {
        sections.extend([
            section("pixels", Some("Lit pixels"), "Lit pixels: error against cost", pixels::charts(study)),
            section("all-pixels", None, "Lit pixels: all measurements", pixel_table::all(study)),
        ]);
    }
    if !study.lobes.is_empty() {
        let title = "Whole highlights: model error of every method";
        sections.push(section("highlights", Some("Highlights"), title, lobes::all(study)));
    }
    let blocks = section("parts", Some("Blocks"), "Building blocks", kernels::all(study));
    let chip = section("chip", Some("Chip"), "On the chip: instructions, stack and bytes", chip::all(study));
    let light =
        section("of-a-light", Some("Quantities"), "Quantities of the light", quantities::all(&study.quantities));
    let measured = |measured: bool, section: Section| measured.then_some(section);
    sections.extend(measured(!study.kernels.is_empty(), blocks));
    sections.extend(measured(!study.chip.is_empty(), Section { open: false, ..chip }));
    sections.extend(measured(!study.quantities.is_empty(), Section { open: false, ..light }));
    let more = [
        section("bits", Some("Bits"), "How many bits do I need?", sweep::all(study)),
        section("method-pages", Some("Methods"), "Every method", methods::all(study)),
        section("pictures", Some("Pictures"), "Pictures: lit spheres, and where the error sits", pictures::all(study)),
        section("presets", Some("Failures"), "Failures that were reported, and their cures", presets::all(study)),
        section("take-away", Some("Take away"), "Take it away: files, columns, source code", take_away::all()),
    ];
    sections.extend(more.into_iter().filter(|section| !section.content.is_empty()));
    let origin = section("origin", Some("Origin"), "How the numbers were made", origin::section(study));
    sections.push(Section { open: false, ..origin });
    sections
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::sample;

    #[test]
    fn names_are_escaped() {
        let mut row = sample::row("<b>", "\"f32\" & co", 1.0, 1e-7);
        row.light = "<script>".to_owned();
        let html = report(&sample::study(vec![row]));
        assert!(!html.contains("<b>") && html.contains("&lt;b&gt;"));
        assert_eq!(html.matches("<script>").count(), 1);
        assert!(pack::all_unpacked(&html).iter().all(|html| !html.contains("<b>") && !html.contains("<script>")));
    }

    #[test]
    fn there_is_a_figure_for_each_choice_and_a_row_for_each_measurement() {
        let study = sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        let html = report(&study);
        let plain = |piece: &str| html.matches(piece).count();
        // One of a section or a group is plain: the light's, the case's, the highlight's, the building blocks'.
        let shown = ["<figure data-light", "<figure data-case", "class=\"several\""].map(plain);
        assert_eq!(shown, [2, 1, 1]);
        // Four kinds of error of the light, five by two of the case, two means of the building blocks, each over four
        // costs; the highlight.
        let everything = html.clone() + &pack::all_unpacked(&html).concat();
        let count = |piece: &str| everything.matches(piece).count();
        let figures = ["<figure data-light", "<figure data-case", "class=\"several\""].map(count);
        assert_eq!(figures, [4 * 4 + 1, 5 * 2 * 4, 2 * 4]);
        assert_eq!(count("<tr data-function") - study.all_kernels().count(), study.chip.len());
        assert_eq!(count("<tr data-light") - study.lobes.len(), study.all_directions().count());
        assert_eq!(count("<tr data-case"), study.all_pixels().count());
        assert_eq!(count("data-alpha"), study.lobes.len());
        for option in ["Sun, alpha 0.001", "45", "0.0625", "all"] {
            assert!(html.contains(&format!("<option>{option}</option>")), "{option}");
        }
        assert!(everything.contains(&study.kernels[0].worst_input));
    }

    /// The first of every control is what is chosen when the page opens.
    #[test]
    fn the_plain_figures_are_those_that_the_controls_begin_with() {
        let html = report(&sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]));
        for first in [
            "<figure data-light=\"Sun from Earth\" data-kind=\"total\" data-axis=\"host\">",
            "<figure data-case=\"Sun, alpha 0.001\" data-kind=\"total\" data-mean=\"rms\" data-axis=\"host\">",
            "<figure class=\"several\" data-mean=\"rms\" data-axis=\"host\">",
        ] {
            assert!(html.contains(first), "{first}");
        }
    }

    #[test]
    fn a_pack_holds_the_same_drawings_as_are_drawn() {
        let study = sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        let packed = pack::all_unpacked(&report(&study)).concat();
        let rows = crate::chart::under_light(study.all_directions(), "Sun from Earth");
        let costs = crate::axis::Costs { axis: crate::axis::Axis::ALL[1], chip: &study.chip };
        let kind = crate::error_kind::ErrorKind::Total;
        let field = crate::direction_panel::field(&rows, &study.anchors, kind, costs);
        let name = format!("{}: total error", crate::chart::direction_title("Sun from Earth", costs.axis));
        let svg = crate::chart::one_panel(&field, &crate::chart::direction_key(&study), &name);
        assert!(packed.contains(&figures::linked(&svg)));
    }

    #[test]
    fn every_mark_leads_to_the_page_of_its_method() {
        let study = sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        let html = report(&study);
        let everything = html.clone() + &pack::all_unpacked(&html).concat();
        let targets: BTreeSet<_> =
            everything.split("href=\"#method-").skip(1).filter_map(|rest| rest.split('"').next()).collect();
        let pixels = study.all_pixels().map(|row| &row.method);
        let kernels = study.all_kernels().map(|row| &row.kernel);
        let methods = study.all_directions().map(|row| &row.method).chain(pixels).chain(kernels);
        let slugs: Vec<_> = methods.map(|name| slug(name)).collect();
        assert!(slugs.iter().all(|slug| targets.contains(slug.as_str())), "{targets:?}");
        let missing = targets.iter().filter(|target| !html.contains(&format!("id=\"method-{target}\"")));
        assert_eq!(missing.collect::<Vec<_>>(), Vec::<&&str>::new());
    }

    #[test]
    fn every_link_within_the_page_has_a_target_and_no_id_stands_twice() {
        let html = report(&sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]));
        let between = |piece: &str| -> Vec<String> {
            html.split(piece).skip(1).filter_map(|rest| rest.split('"').next()).map(str::to_owned).collect()
        };
        let ids = between(" id=\"");
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len(), "{ids:?}");
        let links = between("href=\"#");
        let missing: Vec<_> = links.iter().filter(|link| !link.starts_with("method-") && !ids.contains(link)).collect();
        assert!(links.len() > 8 && missing.is_empty(), "{missing:?}");
    }

    #[test]
    fn nothing_is_loaded() {
        let html = report(&sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]));
        let everything = html.clone() + &pack::all_unpacked(&html).concat();
        for loader in ["src=\"http", "href=\"http", "url(", "@import", "<link", "fetch(", "import("] {
            assert!(!everything.contains(loader), "{loader}");
        }
        // What is left of addresses are names.
        let names = everything.matches("http").count();
        assert_eq!(names, everything.matches("xmlns=\"http://www.w3.org/2000/svg\"").count());
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
