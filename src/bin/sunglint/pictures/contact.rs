//! Contact sheets: many pictures with their names and figures, and the legend of their colours.

use super::album::{Album, RELATIVE, Tile};
use super::colour::{Colour, EXACT, INFINITE, INK, NAN, SOFT, Scale};
use super::failing::Failing;
use super::figures::Figures;
use super::raster::{LETTER, Raster};
use super::sphere::Sphere;
use super::{Kind, Picture};
use crate::key::in_order;

/// Space around everything.
const MARGIN: u32 = 14;
/// Space between pictures.
const GAP: u32 = 8;
/// From one line of letters to the next.
const LINE: u32 = 12;
/// Height of a legend without its notes.
const LEGEND: u32 = 58;
/// Width of the words beside a failure, in letters.
const WORDS: u32 = 46;

/// What is to be known about the sheet of failures.
pub const FAILURES: &str = "Of directions a pixel is white where the answer is the mirror ray itself, which it is on \
     the light's disc. Bars are the light's radius. Of surfaces white is the brightest pixel of the truth, which is the \
     exact value of the same formula (of rounded normals, before they were rounded); of the one seen from farther off \
     white is a white surface that faces the Sun.";

/// Methods in rows, formats in columns, the truth first.
pub fn of_album(album: &Album, title: &str) -> Raster {
    let side = album.truth.size[0];
    let rows: Vec<&[Tile]> = album.tiles.chunk_by(|a, b| a.method == b.method).collect();
    let columns = 1 + rows.iter().map(|row| row.len()).max().unwrap_or(0) as u32;
    let pitch = pitch(side);
    let width = (2 * MARGIN + columns * pitch[0]).max(700);
    let notes = wrapped(&album.note, (width - 2 * MARGIN) / LETTER);
    let head = MARGIN + 2 * LINE;
    let foot = head + rows.len() as u32 * pitch[1];
    let mut sheet = Raster::blank([width, foot + LEGEND + notes.len() as u32 * LINE + MARGIN]);
    sheet.write([MARGIN, MARGIN], title, INK);
    for (y, row) in (head..).step_by(pitch[1] as usize).zip(rows) {
        sheet.write([MARGIN, y], row[0].method, INK);
        sheet.lay([MARGIN, y + LINE], &album.truth);
        sheet.write([MARGIN, y + LINE + side + GAP / 2], "truth", SOFT);
        for (x, tile) in (MARGIN + pitch[0]..).step_by(pitch[0] as usize).zip(row) {
            of_tile(&mut sheet, [x, y + LINE], tile, &album.scale);
        }
    }
    legend(&mut sheet, [MARGIN, foot], &album.scale, &notes);
    sheet
}

/// From one method in a format to the next, across and down.
fn pitch(side: u32) -> [u32; 2] {
    [side.max(15 * LETTER) + GAP, 2 * (side + GAP) + 5 * LINE]
}

/// Where on the sheet of its album `picture` lies; none where `pictures` have no such sheet, or more than one.
pub fn place(picture: &Picture, pictures: &[Picture]) -> Option<[u32; 2]> {
    let of_failure = |picture: &Picture| picture.name.starts_with("failure");
    let album = || pictures.iter().filter(|other| other.subject == picture.subject && !of_failure(other));
    if of_failure(picture)
        || picture.kind == Kind::Sheet
        || album().filter(|other| other.kind == Kind::Sheet).count() != 1
    {
        return None;
    }
    let (left, top, [_, side]) = (MARGIN, MARGIN + 3 * LINE, picture.size);
    if picture.kind == Kind::Truth {
        return Some([left, top]);
    }
    let lit = || album().filter(|other| other.kind == Kind::Lit);
    let row = in_order(lit().map(|other| &other.method)).iter().position(|name| *name == picture.method)? as u32;
    let column = in_order(lit().map(|other| &other.format)).iter().position(|name| *name == picture.format)? as u32;
    let down = if picture.kind == Kind::Error { side + GAP / 2 } else { 0 };
    let pitch = pitch(side);
    Some([left + (1 + column) * pitch[0], top + row * pitch[1] + down])
}

/// The sphere, its errors beneath, and the words.
fn of_tile(sheet: &mut Raster, [x, y]: [u32; 2], tile: &Tile, scale: &Scale) {
    let Some([computed, error]) = &tile.rasters else { return };
    let side = computed.size[1];
    sheet.lay([x, y], computed);
    sheet.lay([x, y + side + GAP / 2], error);
    let unit = if scale.most == 2 { " %" } else { "" };
    let [worst, rms] = tile.figures.lines(unit);
    let below = y + 2 * side + GAP;
    sheet.write([x, below], tile.format, INK);
    sheet.write([x, below + LINE], &worst, SOFT);
    sheet.write([x, below + 2 * LINE], &rms, SOFT);
}

/// A failure in each row: as it fails, as it is, its error, the cure, the cure's error.
pub fn of_failures(drawn: &[(&Failing, [Sphere; 2])], side: u32, title: &str) -> Raster {
    let pitch = [side + GAP, side + 2 * LINE];
    let width = 2 * MARGIN + 5 * pitch[0] + WORDS * LETTER;
    let notes = wrapped(FAILURES, (width - 2 * MARGIN) / LETTER);
    let head = MARGIN + 4 * LINE;
    let foot = head + drawn.len() as u32 * pitch[1];
    let mut sheet = Raster::blank([width, foot + LEGEND + notes.len() as u32 * LINE + MARGIN]);
    sheet.write([MARGIN, MARGIN], title, INK);
    let places = (MARGIN..).step_by(pitch[0] as usize);
    for (x, name) in places.clone().zip(["fails", "truth", "its error", "cured", "its error"]) {
        sheet.write([x, MARGIN + 2 * LINE], name, SOFT);
    }
    for (y, (failing, spheres)) in (head..).step_by(pitch[1] as usize).zip(drawn) {
        let [fails, cured] = spheres;
        let scale = &failing.scale;
        let pictures = [fails.computed(), cured.truth(), fails.error(scale), cured.computed(), cured.error(scale)];
        places.clone().zip(&pictures).for_each(|(x, picture)| sheet.lay([x, y], picture));
        words(&mut sheet, [MARGIN + 5 * pitch[0], y], failing, spheres);
    }
    // Of a hundredth of what per cent are, the decades are the same.
    let scale = Scale { unit: "of the light's radius (directions) or of the true level (surfaces)", ..RELATIVE };
    legend(&mut sheet, [MARGIN, foot], &scale, &notes);
    sheet
}

/// What a failure is, and the figures of both.
fn words(sheet: &mut Raster, [x, y]: [u32; 2], failing: &Failing, spheres: &[Sphere; 2]) {
    let mut lines: Vec<_> = wrapped(failing.title, WORDS).into_iter().map(|line| (line, INK)).collect();
    for ((name, form), sphere) in ["Fails", "Cured"].into_iter().zip(&failing.forms).zip(spheres) {
        let figures = (failing.sense)(&Figures::of(sphere));
        let said = wrapped(&format!("{name}: {} in {}, {figures}", form.what, form.format), WORDS);
        lines.push((String::new(), SOFT));
        lines.extend(said.into_iter().map(|line| (line, SOFT)));
    }
    for (y, (line, colour)) in (y..).step_by(LINE as usize).zip(lines) {
        sheet.write([x, y], &line, colour);
    }
}

/// The colours of errors with their decades, and of what is no number.
fn legend(sheet: &mut Raster, [x, y]: [u32; 2], scale: &Scale, notes: &[String]) {
    const STEP: u32 = 12;
    let per_decade = scale.steps() / (scale.most - scale.least) as u32;
    sheet.write([x, y], &format!("Error, {}, in decades", scale.unit), INK);
    for step in 0..scale.steps() {
        let exponent = f64::from(scale.least) + (f64::from(step) + 0.5) / f64::from(per_decade);
        sheet.fill([x + step * STEP, y + LINE], [STEP, 16], scale.colour(10f64.powf(exponent)));
    }
    for (decade, exponent) in (scale.least..=scale.most).enumerate() {
        let at = x + decade as u32 * per_decade * STEP;
        sheet.fill([at, y + LINE + 16], [1, 4], INK);
        sheet.write([at, y + LINE + 22], &power(exponent), SOFT);
    }
    let beside = x + scale.steps() * STEP + 5 * LETTER;
    let swatches: [(Colour, &str); 3] = [(EXACT, "exact"), (NAN, "NaN"), (INFINITE, "infinite")];
    for (place, (colour, name)) in (beside..).step_by(10 * LETTER as usize).zip(swatches) {
        sheet.fill([place, y + LINE], [2 * LETTER, 16], colour);
        sheet.write([place, y + LINE + 22], name, SOFT);
    }
    for (y, note) in (y + LEGEND..).step_by(LINE as usize).zip(notes) {
        sheet.write([x, y], note, SOFT);
    }
}

/// A power of ten, short.
fn power(exponent: i32) -> String {
    match exponent {
        -2..=2 => format!("{}", 10f64.powi(exponent)),
        _ => format!("1e{exponent}"),
    }
}

/// `text` in lines of at most so many letters, broken between words.
fn wrapped(text: &str, letters: u32) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.is_empty() => *line = word.to_owned(),
            Some(line) if line.len() + 1 + word.len() <= letters as usize => *line += &format!(" {word}"),
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_kept_whole() {
        assert_eq!(wrapped("a bc def g", 4), ["a bc", "def", "g"]);
        assert_eq!(wrapped("", 4), [""]);
    }

    #[test]
    fn ticks_are_short() {
        assert_eq!([-6, -2, 0, 2].map(power), ["1e-6", "0.01", "1", "100"]);
    }
}
