//! A page for each method: formula, costs, errors along angle and ratio, worst inputs, pictures, failures.

mod about;
mod costs;
mod curves;
mod failures;
mod measurement;
mod place;
mod precision;
mod promised;
mod subject;
mod thumbnails;
mod worst;

use self::about::About;
use self::measurement::Measurement;
use self::subject::{Group, Subject};
use super::cells::{escape, slug};
use super::pack;
use crate::number;
use crate::result::Study;

const INTRODUCTION: &str = "<p>One page for each method and each building block; the marks of the charts lead here. Open one for \
its formula, what it costs, where along the angle and the size of the light its error lies, the worst inputs with the command that \
computes each again, and what fails. Vectors have length 1: <i>n</i> is the normal, <i>v</i> the direction to the viewer, <i>l</i> \
to the light’s centre, <i>r</i> the mirror ray. The light’s radius over its distance is <i>x</i> = sin θ, θ its angular radius \
and <i>w</i> = 1 − cos θ; α is the GGX width, perceptual roughness squared.</p>";

/// The section; empty where nothing was measured.
pub fn all(study: &Study) -> String {
    if study.rows.is_empty() && study.pixels.is_empty() && study.kernels.is_empty() {
        return String::new();
    }
    let contents: String = Group::ALL.into_iter().map(links).collect();
    let groups: String = Group::ALL.into_iter().map(|group| articles(study, group)).collect();
    format!(
        "{INTRODUCTION}\n<div class=\"methods\" role=\"navigation\" aria-label=\"Methods\">\n{contents}</div>\n{groups}"
    )
}

/// A line of links to the pages of a group.
fn links(group: Group) -> String {
    let link = |subject: Subject| {
        let name = subject.name();
        format!("<li><a href=\"#method-{}\">{}</a></li>", slug(name), escape(name))
    };
    let links: String = group.subjects().into_iter().map(link).collect();
    format!("<p>{}</p><ul>{links}</ul>\n", group.name())
}

fn articles(study: &Study, group: Group) -> String {
    let articles: String = group.subjects().into_iter().map(|subject| article(study, subject)).collect();
    let truth = match group {
        Group::Directions => thumbnails::truth(study, "direction"),
        Group::Pixels => thumbnails::truth(study, "pixel"),
        Group::Blocks => String::new(),
    };
    format!("<h3>{}</h3>\n{truth}{articles}", group.name())
}

/// The page of one method, folded.
fn article(study: &Study, subject: Subject) -> String {
    let (name, about) = (subject.name(), subject.about());
    let measured = subject.measurements(study);
    let parts = match measured.is_empty() {
        true => "<p>Not measured in this run.</p>\n".to_owned(),
        false => parts(study, subject, &measured),
    };
    format!(
        "<article id=\"method-{}\"><details>\n<summary><h4>{}</h4> <span>{}</span></summary>\n{}{parts}{}</details></article>\n",
        slug(name),
        escape(name),
        about.what,
        facts(&about),
        failures::part(study, subject, &measured)
    )
}

/// What was measured of a method: what is said of it plain, the rest packed.
fn parts(study: &Study, subject: Subject, measured: &[Measurement]) -> String {
    let large = [
        costs::table(study, subject, measured),
        curves::charts(study, subject),
        worst::table(study, subject, measured),
        thumbnails::of(study, subject.name()),
    ];
    let precision =
        if let Subject::Block(kernel) = subject { precision::paragraph(kernel, measured) } else { String::new() };
    place::paragraph(study, subject, measured) + &precision + &pack::packed(&large.concat())
}

/// What stands fast of a method: formula, ranges, use, name in the crate.
fn facts(about: &About) -> String {
    let formula: String = about.formula.iter().map(|line| format!("<p>{line}</p>")).collect();
    format!(
        "<div class=\"formula\">{formula}</div>\n<dl class=\"facts\"><div><dt>Takes</dt><dd>{}</dd></div>\
         <div><dt>Good for</dt><dd>{}</dd></div><div><dt>In the crate</dt><dd><code>{}</code></dd></div></dl>\n",
        about.takes, about.good_for, about.function
    )
}

/// A number within a sentence, which no line may break.
fn figure(value: f64) -> String {
    format!("<span class=\"number\">{}</span>", number::scientific(value))
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;
    use crate::result::Row;
    use crate::sample;

    fn page() -> String {
        unpacked(all(&sample::methods_study()))
    }

    /// The page with its packs at its end.
    fn unpacked(html: String) -> String {
        let packs = pack::all_unpacked(&html).concat();
        html + &packs
    }

    #[test]
    fn every_method_and_building_block_has_a_page_and_a_link() {
        let html = page();
        let names = Group::ALL.into_iter().flat_map(Group::subjects).map(Subject::name);
        let names: Vec<_> = names.collect();
        assert_eq!(names.len(), 4 + 1 + 8 + 1 + 13);
        for name in names {
            let id = format!("method-{}", slug(name));
            assert_eq!(html.matches(&format!("<article id=\"{id}\">")).count(), 1, "{name}");
            assert_eq!(html.matches(&format!("href=\"#{id}\"")).count(), 1, "{name}");
        }
    }

    #[test]
    fn no_id_stands_twice_and_no_link_leads_nowhere() {
        let html = page();
        let values = |attribute: &str| -> Vec<String> {
            let parts = html.split(attribute).skip(1);
            parts.filter_map(|part| part.split('"').next()).map(str::to_owned).collect()
        };
        let ids = values(" id=\"");
        let once: HashSet<_> = ids.iter().cloned().collect();
        assert_eq!(once.len(), ids.len(), "{ids:?}");
        // Reported failures have a section of their own.
        let targets = values("href=\"#");
        assert!(targets.iter().filter(|target| !target.starts_with("preset-")).all(|target| once.contains(target)));
    }

    #[test]
    fn every_format_with_rows_has_a_line_in_both_charts() {
        let html = all(&sample::methods_study());
        let cap = html.split("<article id=\"method-cap\">").nth(1).and_then(|rest| rest.split("</article>").next());
        let cap = pack::all_unpacked(cap.expect("an article")).concat();
        assert_eq!(cap.matches("<svg").count(), 2, "angle and ratio");
        for format in ["f64", "f16"] {
            assert_eq!(cap.matches(&format!(">{format}</text>")).count(), 2, "{format}");
        }
    }

    #[test]
    fn what_comes_from_rows_is_escaped_and_nothing_is_loaded() {
        let mut study = sample::methods_study();
        for row in &mut study.rows {
            let name = "<b>\"&'".to_owned();
            *row = Row {
                light: name.clone(),
                failure: Some(name.clone()),
                repro: name.clone(),
                worst_l: name,
                ..row.clone()
            };
        }
        study.pictures[0].caption = "<b>".to_owned();
        let html = unpacked(all(&study)).replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
        assert!(!html.contains("<b>") && html.contains("&lt;b&gt;&quot;&amp;&#39;"));
        assert!(!html.contains("http://") && !html.contains("https://"));
        assert_eq!(html.matches(" src=\"").count(), html.matches(" src=\"data:image/png;base64,").count());
    }

    #[test]
    fn what_was_not_measured_is_said_and_no_study_makes_no_section() {
        assert!(page().contains("Not measured in this run."));
        assert!(all(&sample::study(Vec::new())).is_empty());
    }
}
