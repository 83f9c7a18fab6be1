//! The pictures of a method: the lit sphere and where its error sits, in every format.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::key::in_order;
use crate::page::cells::escape;
use crate::pictures::{Kind, Picture, contact};
use crate::result::Study;

/// The spheres of `method`, format by format; empty where none was drawn.
pub fn of(study: &Study, method: &str) -> String {
    let pictures: Vec<_> = study.pictures.iter().filter(|picture| picture.method == method).collect();
    let formats = in_order(pictures.iter().map(|picture| &picture.format));
    let group = |format: &String| {
        let kinds = [Kind::Lit, Kind::Error].into_iter();
        let images = kinds.flat_map(|kind| pictures.iter().filter(move |picture| picture.kind == kind));
        let images: String =
            images.filter(|picture| picture.format == *format).map(|picture| image(study, picture)).collect();
        if images.is_empty() { images } else { figure(format, &images) }
    };
    let groups: String = formats.iter().map(group).collect();
    if groups.is_empty() {
        return groups;
    }
    format!("<h5>Lit, and where the error sits</h5>\n<div class=\"spheres\">{groups}</div>\n")
}

/// The true spheres to compare with.
pub fn truth(study: &Study, subject: &str) -> String {
    let truths = study.pictures.iter().filter(|picture| picture.kind == Kind::Truth && picture.subject == subject);
    let images: String = truths.map(|picture| image(study, picture)).collect();
    if images.is_empty() { images } else { format!("<div class=\"spheres\">{}</div>\n", figure("the truth", &images)) }
}

fn figure(format: &str, images: &str) -> String {
    format!("<figure><figcaption>{}</figcaption>{images}</figure>", escape(format))
}

/// A picture, cut out of the contact sheet of the page where it is on it.
fn image(study: &Study, picture: &Picture) -> String {
    let [width, height] = picture.size;
    let caption = escape(&picture.caption);
    if let Some([x, y]) = contact::place(picture, &study.pictures) {
        return format!(
            "<svg role=\"img\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"{x} {y} {width} {height}\"><title>{caption}</title><use href=\"#sheet-{}\"/></svg>",
            picture.subject
        );
    }
    format!(
        "<img alt=\"{caption}\" title=\"{caption}\" width=\"{width}\" height=\"{height}\" \
         src=\"data:image/png;base64,{}\">",
        STANDARD.encode(&picture.png)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn a_picture_has_its_size_its_words_and_its_bytes() {
        let study = sample::methods_study();
        let html = of(&study, "cap");
        assert_eq!(html.matches("<img ").count(), 2, "lit and error");
        assert!(html.contains("width=\"2\" height=\"2\"") && html.contains("alt=\"a sphere\""), "{html}");
        assert!(html.contains("base64,AQID\""), "the bytes 1, 2, 3");
        assert_eq!(truth(&study, "direction").matches("<img ").count(), 1);
        assert!(truth(&study, "pixel").is_empty() && of(&study, "disc").is_empty());
    }
}
