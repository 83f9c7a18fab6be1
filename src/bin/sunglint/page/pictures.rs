//! The contact sheets and what they show.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::escape;
use crate::pictures::{Kind, Picture};
use crate::result::Study;

const INTRODUCTION: &str = "<p>Every method in every number format, computed pixel by pixel, with the truth on the left and the error \
beneath. Light is linear, white is a white surface that faces the light, and the file has the code of sRGB; nothing is toned down. \
Errors are coloured by their decade, from dark blue to pale yellow, four steps to a decade and evenly brighter; black is exact. \
<strong>Magenta</strong> is NaN or no direction, <strong>cyan</strong> is infinite. The same pictures, each by itself, lie in \
<code>pictures/</code> next to this page; <code>sunglint render --size 1024</code> draws them larger.</p>";

/// What a sheet shows, above it.
fn heading(sheet: &Picture) -> [&'static str; 2] {
    match sheet.subject {
        "direction" => [
            "Specular directions",
            "A mirror: white where the method’s answer is the mirror ray itself, that is on the light’s disc. Where a disc is too \
             wide, blurred or lost, its white area is.",
        ],
        "pixel" => [
            "Lit pixels",
            "A dark, glossy sphere: diffuse light and highlight of a whole pixel. Where the error looks the same in all formats, \
             it is the method’s own, and more precision buys nothing.",
        ],
        _ => [
            "Failures, and their cures",
            "What goes wrong in a plain form, and what this crate does in its place. All figures are counted on the pixels.",
        ],
    }
}

/// The section; empty where nothing was drawn.
pub fn all(study: &Study) -> String {
    let sheets: String =
        study.pictures.iter().filter(|picture| picture.kind == Kind::Sheet).map(|sheet| figure(study, sheet)).collect();
    if sheets.is_empty() { sheets } else { format!("{INTRODUCTION}\n{sheets}") }
}

fn figure(study: &Study, sheet: &Picture) -> String {
    let [title, text] = heading(sheet);
    let failures = if sheet.subject == "failure" { sentences(study) } else { String::new() };
    format!(
        "<h3>{title}</h3>\n<p>{text}</p>\n{failures}<figure>\n<figcaption>{}</figcaption>\n\
         <div class=\"wide\" tabindex=\"0\">{}</div>\n</figure>\n",
        escape(&sheet.caption),
        image(sheet)
    )
}

/// What is to be seen of every failure.
fn sentences(study: &Study) -> String {
    let first = study
        .pictures
        .iter()
        .filter(|picture| picture.name.starts_with("failure-") && picture.name.ends_with("-error"));
    let of_failing = first.filter(|picture| !picture.name.ends_with("cured-error"));
    let line = |picture: &Picture| {
        let said = picture.caption.split_once(". ").map_or("", |(_, said)| said);
        format!("<li>{}</li>\n", escape(said))
    };
    format!("<ul>\n{}</ul>\n", of_failing.map(line).collect::<String>())
}

/// The picture within the page; the pages of the methods show parts of it.
fn image(picture: &Picture) -> String {
    let [width, height] = picture.size;
    format!(
        "<svg class=\"sheet\" role=\"img\" aria-label=\"{}\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\"><image id=\"sheet-{}\" width=\"{width}\" height=\"{height}\" \
         href=\"data:image/png;base64,{}\"/></svg>",
        escape(&picture.caption),
        picture.subject,
        STANDARD.encode(&picture.png)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn picture(name: &str, kind: Kind, caption: &str) -> Picture {
        let [method, format] = ["cap", "f16"].map(str::to_owned);
        let [name, caption] = [name, caption].map(str::to_owned);
        Picture { name, subject: "failure", method, format, kind, caption, size: [3, 2], png: vec![1, 2, 3] }
    }

    #[test]
    fn sheets_are_embedded_once_and_failures_have_a_sentence() {
        let mut study = sample::study(Vec::new());
        assert_eq!(all(&study), "");
        study.pictures = vec![
            picture("failure-a-lit", Kind::Lit, "As it fails. Too <wide>."),
            picture("failure-a-error", Kind::Error, "Its error. Too <wide>."),
            picture("failure-a-cured-error", Kind::Error, "The error of the cure. Too <wide>."),
            picture("failures", Kind::Sheet, "Failures"),
        ];
        let html = all(&study);
        assert_eq!(html.matches("<image ").count(), 1);
        assert!(html.contains("href=\"data:image/png;base64,AQID\"") && html.contains("width=\"3\" height=\"2\""));
        assert_eq!(html.matches("<li>Too &lt;wide&gt;.</li>").count(), 1);
    }
}
