//! Figures of which one is shown at a time: the first is plain, the others are packed.

use indicatif::ProgressBar;

use super::{cells, pack};
use crate::workers;

/// The figures that `draw` makes of `items`, on all cores; those that are empty are left out.
pub fn shown<I: Sync>(items: &[I], draw: impl Fn(&I) -> String + Sync) -> String {
    let figures = workers::map(items, &ProgressBar::hidden(), draw);
    let mut figures = figures.into_iter().filter(|figure| !figure.is_empty());
    let first = figures.next().unwrap_or_default();
    let others: String = figures.collect();
    format!("<div class=\"figures\">\n{first}{}</div>\n", pack::packed(&others))
}

/// A figure that stands for a choice: names of choices and what is chosen.
pub fn figure(choices: &[(&str, &str)], caption: &str, svg: &str) -> String {
    format!(
        "<figure{}>\n<figcaption>{}</figcaption>\n<div class=\"wide\" tabindex=\"0\">{}</div>\n</figure>\n",
        cells::data(choices),
        cells::escape(caption),
        linked(svg)
    )
}

/// `svg` with marks that the keyboard reaches and that lead to the pages of their methods.
pub fn linked(svg: &str) -> String {
    const MARK: &str = "<g class=\"mark\"";
    let mut pieces = svg.split(MARK);
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |html, piece| match piece.strip_prefix(" data-to=\"") {
        // The groups of marks hold no groups.
        Some(rest) => format!("{html}<a class=\"mark\" href=\"#method-{}", rest.replacen("</g>", "</a>", 1)),
        None => format!("{html}{MARK} tabindex=\"0\"{piece}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_become_links_and_others_can_be_reached() {
        let svg = "<svg><g class=\"mark\" data-to=\"cap\"><title>a</title><path /></g><g class=\"mark\"><path /></g><g></g></svg>";
        let expected = "<svg><a class=\"mark\" href=\"#method-cap\"><title>a</title><path /></a><g class=\"mark\" tabindex=\"0\">\
                        <path /></g><g></g></svg>";
        assert_eq!(linked(svg), expected);
    }

    #[test]
    fn the_first_figure_is_plain_and_the_others_are_packed() {
        let html =
            shown(&[1, 2, 3], |item| if *item == 2 { String::new() } else { format!("<figure>{item}</figure>") });
        assert!(html.contains("<figure>1</figure>") && !html.contains("<figure>3"), "{html}");
        assert_eq!(pack::all_unpacked(&html), ["<figure>3</figure>"]);
    }
}
