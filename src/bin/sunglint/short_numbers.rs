//! The coordinates of a drawing to a tenth of a pixel: kuva writes some with 17 digits.

/// Numbers below this are left alone: they are widths and opacities.
const LEAST: f64 = 10.0;

/// `svg` with its coordinates rounded; its texts and its name stay as they are.
pub fn rounded(svg: &str) -> String {
    let mut pieces = svg.split('<');
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |mut text, piece| {
        let (tag, rest) = piece.split_once('>').unwrap_or((piece, ""));
        text.push('<');
        match tag.starts_with("svg") {
            true => text.push_str(tag),
            false => add_rounded(&mut text, tag),
        }
        if piece.contains('>') {
            text.push('>');
        }
        text + rest
    })
}

fn add_rounded(text: &mut String, tag: &str) {
    let mut rest = tag;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let end = rest[start..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(rest.len(), |end| start + end);
        let (before, number) = (&rest[..start], &rest[start..end]);
        text.push_str(before);
        text.push_str(&tenth(number));
        rest = &rest[end..];
    }
    text.push_str(rest);
}

/// The number as it is, or to a tenth if it is a coordinate.
fn tenth(number: &str) -> String {
    match number.parse::<f64>() {
        Ok(value) if number.contains('.') && value >= LEAST => format!("{}", (value * 10.0).round() / 10.0),
        _ => number.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_lose_their_noise_and_nothing_else_changes() {
        let svg = "<svg aria-label=\"alpha 12.0625\"><path d=\"M277.53000000000003,55.4 L-170.56,572\" opacity=\"0.25\" \
                   stroke=\"#1b1b1b\" /><text x=\"13.96\">12.0625 &lt;</text></svg>";
        let expected = "<svg aria-label=\"alpha 12.0625\"><path d=\"M277.5,55.4 L-170.6,572\" opacity=\"0.25\" \
                        stroke=\"#1b1b1b\" /><text x=\"14\">12.0625 &lt;</text></svg>";
        assert_eq!(rounded(svg), expected);
    }
}
