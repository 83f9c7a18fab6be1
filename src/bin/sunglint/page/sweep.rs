//! The section of the page about word lengths.

mod chart;

use super::cells::{self, cell, sortable, text};
use super::figures;
use crate::key::in_order;
use crate::number;
use crate::result::Study;
use crate::sweep::{self, Family, Goal, SweepRow, fewest};

const INTRODUCTION: &str = "<p>Every method in words that types have and in words that none has: fixed point of 8 to 30 \
fraction bits and two integer bits, floats of 8 to 24 digits with the exponent range of f16 (5 bits) or of f32 (8 bits), and the \
same where numbers below the least normal one are zero, as some hardware has it. All are emulated and run the same formulas; \
where a word is a type, its results are that type’s bit for bit, but for what I2F14 and I2F30 do by hand in \
<code>cap</code> and <code>normalize</code>.</p><p>Directions show the worst error of the drawn edge, in per cent of the light’s \
radius, formula and arithmetic together; lit pixels the root mean square of the arithmetic alone, with the \
error of each formula as a line of dashes: below it, more bits buy nothing. Vectors are exact in the word: \
what rounding them into it costs comes on top. A hollow mark loses the disc; what gave no number has none.</p>";

/// Tolerances of the table, in per cent.
const TOLERANCES: [f64; 3] = [10.0, 1.0, 0.1];

const COLUMNS: [&str; 7] =
    ["case", "method", "kind of number", "bits for 10 %", "for 1 %", "for 0.1 %", "best error, %"];

/// The section; empty where nothing was measured.
pub fn all(study: &Study) -> String {
    let rows = &study.sweep;
    if rows.is_empty() {
        return String::new();
    }
    let names: Vec<_> = rows.iter().map(case).collect();
    let cases = in_order(names.iter());
    let figures = figures::shown(&cases, |case| figure(rows, case));
    let lines: String = Family::all(rows).iter().map(line).collect();
    let samples = rows.iter().map(|row| row.samples);
    let [least, most] = [samples.clone().min(), samples.max()].map(|samples| number::count(samples.unwrap_or(0)));
    format!(
        "{INTRODUCTION}\n{}{figures}\n<p>Fewest fraction bits, or digits of the significand, that are within 10, 1 and 0.1 per \
         cent, as are all longer words, formula and arithmetic together: of the radius at the worst, of a lit pixel’s value in \
         the root mean square; 17–18 where 18 are enough, 16 are not, and 17 were not tried; in brackets the bits of a number in \
         all, at the most. Tried on {least} to {most} inputs a word. <code>sunglint sweep</code> answers for \
         other lights, roughnesses and tolerances, with the cheapest format.</p>\n{}",
        cells::form(&cells::select("Light and surface", "case", &cases)),
        sortable("fewest-bits", &COLUMNS, &lines)
    )
}

/// What a row is of, but for its method and word.
fn case(row: &SweepRow) -> String {
    match row.alpha {
        Some(alpha) => format!("lit pixel, {}, alpha {alpha}", row.light),
        None => format!("direction, {}", row.light),
    }
}

fn figure(rows: &[SweepRow], case: &str) -> String {
    let rows: Vec<_> = rows.iter().filter(|row| self::case(row) == case).collect();
    let caption = format!("Error against bits: {case}");
    figures::figure(&[("case", case)], &caption, &chart::of_words(&rows, &caption))
}

/// The fewest bits of a method in a family for each tolerance.
fn line(family: &Family) -> String {
    let (case, first) = (case(family.first()), family.first());
    let (goal, per_cent) = if first.alpha.is_some() { (Goal::Pixel, 100.0) } else { (Goal::Edge, 1.0) };
    let bits = TOLERANCES.map(|tolerance| match fewest(family, goal, tolerance / per_cent) {
        Some(row) => cell(row.bits.into(), &format!("{} ({})", sweep::said(family, row), row.width)),
        None => cell(f64::NAN, "none"),
    });
    let nearest = family.nearest(goal);
    let best = match &nearest.failure {
        Some(failure) => cell(f64::NAN, &cells::escape(failure)),
        None => cells::scientific(per_cent * goal.error(nearest)),
    };
    let cells = [text(&case), text(&first.method), text(&family.name()), bits.concat(), best];
    format!("<tr{}>{}</tr>\n", cells::data(&[("case", &case)]), cells.concat())
}

#[cfg(test)]
mod tests {
    use super::super::pack;
    use super::*;
    use crate::sample;

    #[test]
    fn there_is_a_figure_for_each_case_and_a_line_for_each_family() {
        let html = all(&Study { sweep: sample::sweep(), ..Study::default() });
        let packed = pack::all_unpacked(&html).concat();
        assert_eq!([&html, &packed].map(|part| part.matches("<figure data-case").count()), [1, 1]);
        assert_eq!(html.matches("<tr data-case").count(), 4);
        assert!(html.contains("direction, Sun from Earth") && html.contains("lit pixel, Sun, alpha 0.001"));
        assert!(!html.contains("inf") && !html.contains("NaN<"), "{html}");
    }

    #[test]
    fn the_table_has_the_fewest_bits() {
        let rows = sample::sweep();
        let cap = line(&Family::all(&rows)[0]);
        // The errors of the sample halve with every bit, from 8 % in 8.
        assert!(cap.contains(">≤ 8 (10)<") && cap.contains(">11–12 (14)<") && cap.contains(">none<"), "{cap}");
    }

    #[test]
    fn nothing_measured_is_no_section() {
        assert_eq!(all(&Study::default()), "");
    }
}
