//! Tables, and what is not shown at first, packed: `DecompressionStream` of the browser unpacks them when they are
//! shown.
//!
//! What is packed is any HTML; its titles, which repeat from figure to figure, stand once, before it. The script looks
//! for packs in an element of class `figures`, and in any `details`, which is filled where it is first opened.

use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;

/// Stands between two titles.
const NEXT: char = '\u{1e}';
/// Stands between the titles and the HTML.
const BODY: char = '\u{1d}';
/// Stands before the place of a title in the list.
const PLACE: char = '\u{1f}';

const OPENING: &str = "<title>";
const CLOSING: &str = "</title>";

/// What is said where a browser cannot unpack.
const REFUSAL: &str = "<p class=\"no-unpack\" hidden>This browser cannot unpack the tables and the other charts. The main charts \
and all figures lie next to this page, as SVG and CSV.</p>";

/// `html` as a pack, with the sentence for browsers that cannot unpack it; nothing where there is nothing to pack.
pub fn packed(html: &str) -> String {
    if html.is_empty() {
        return String::new();
    }
    match zipped(&with_titles_apart(html)) {
        Ok(bytes) => format!(
            "<script type=\"application/octet-stream\" class=\"packed\">{}</script>{REFUSAL}\n",
            STANDARD.encode(bytes)
        ),
        // Memory takes all that is written to it; should it ever not, the page is larger, not poorer.
        Err(_) => html.to_owned(),
    }
}

fn zipped(text: &str) -> io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(text.as_bytes())?;
    encoder.finish()
}

/// The list of titles, and `html` with their places for them.
fn with_titles_apart(html: &str) -> String {
    let mut titles: Vec<&str> = Vec::new();
    let mut pieces = html.split(OPENING);
    let mut body = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (title, rest) = piece.split_once(CLOSING).unwrap_or((piece, ""));
        let place = titles.iter().position(|known| *known == title).unwrap_or_else(|| {
            titles.push(title);
            titles.len() - 1
        });
        body += &format!("{OPENING}{PLACE}{place};{CLOSING}{rest}");
    }
    format!("{}{BODY}{body}", titles.join(&NEXT.to_string()))
}

/// What the script makes of a pack's text in base64.
#[cfg(test)]
pub fn unpacked(base64: &str) -> String {
    use std::io::Read;
    let mut text = String::new();
    let bytes = STANDARD.decode(base64).expect("base64");
    flate2::read::GzDecoder::new(&bytes[..]).read_to_string(&mut text).expect("gzip of text");
    let (titles, body) = text.split_once(BODY).expect("titles and body");
    let titles: Vec<_> = titles.split(NEXT).collect();
    let mut pieces = body.split(PLACE);
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |html, piece| {
        let (place, rest) = piece.split_once(';').expect("a place");
        html + titles[place.parse::<usize>().expect("a number")] + rest
    })
}

/// All packs of a page, unpacked.
#[cfg(test)]
pub fn all_unpacked(page: &str) -> Vec<String> {
    let packs = page.split("class=\"packed\">").skip(1);
    packs.map(|rest| unpacked(rest.split('<').next().unwrap_or_default())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_comes_out_again() {
        let html =
            "<p>è &amp; ü</p><g><title>one\ntwo</title></g><g><title>2; 3</title></g><g><title>one\ntwo</title>a</g>";
        let page = format!("<div>{}</div>", packed(html));
        assert_eq!(all_unpacked(&page), [html]);
        assert!(!page.contains("one"));
    }

    #[test]
    fn a_title_is_packed_once_and_the_same_text_gives_the_same_pack() {
        let html = "<title>long enough to be seen</title>".repeat(3);
        assert_eq!(with_titles_apart(&html).matches("long").count(), 1);
        assert_eq!(packed(&html), packed(&html));
        assert_eq!(packed(""), "");
    }
}
