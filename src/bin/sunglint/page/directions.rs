//! The sections of the page about the direction methods.

use super::cells::{self, cell, sortable, text};
use super::{costs, figures};
use crate::author::is_ours;
use crate::axis::Costs;
use crate::chart::{self, under_light};
use crate::direction_panel;
use crate::error_kind::ErrorKind;
use crate::key::{Key, in_order};
use crate::number;
use crate::result::{Row, Study};

const INPUTS: &str = "<p>None of these holds what <strong>rounding the directions</strong> into the format \
costs before any method has its turn: the truth is always computed from the rounded directions. That \
error is here, for rays within 90 degrees of the light.</p>";

const ERRORS: &str = "<p><strong>Arithmetic error</strong> is what the number format costs: the \
computed direction against the exact value of the same formula for the same input. <strong>Model \
error</strong> is what the formula costs: its exact value against the nearest point of the light’s \
disc. It hardly depends on the format, and no precision removes it. <strong>Total error</strong> is \
the computed direction against the nearest point, so it holds both. A method may lead by its \
arithmetic and yet trail by its model; hence a chart and a frontier for each.</p><p>The truth \
is computed in f64, so errors of some 1e-16 rad are the truth’s own rounding as much as the method’s, and \
their order says nothing. Left out are directions beside the opposite of the light, where all of \
the rim is as near, and where the representative point falls into the origin; the table counts them.</p>";

/// What only charts over instructions show.
const RIVALS: &str = "<p>Over instructions there are more marks, of code that no format runs by itself. \
<em>f32 soft</em> (<code>soft::cap</code>) computes f32 in integers, by way of I2F30; it is judged on the same directions, \
and at its worst beside the opposite of the light, where the side of the rim hangs on the rounding. <em>formula</em> is the \
generic code where a format has code of its own.</p><p><strong>Grey</strong> are peers, under the Sun from Earth alone: the \
crate <code>tests/peers</code> has tried them on 200 000 random directions, without the hard ones, and their total error is at \
most what is drawn, their arithmetic error and the model’s together.</p>";

/// Which calls the instructions are of.
const COUNTED: &str = "a call (the median of rays outside the disc, under the Sun from Earth; taken for each light, \
whose size changes constants, not the code)";

/// The lights in the order of the rows.
pub fn lights(study: &Study) -> Vec<String> {
    in_order(study.rows.iter().map(|row| &row.light))
}

/// A chart for each light, kind of error and cost; the script shows one at a time.
pub fn charts(study: &Study) -> String {
    let key = chart::direction_key(study);
    let lights = lights(study);
    let calls: Vec<_> = study.rows.iter().map(Row::call).collect();
    let offered = Costs::offered(&study.chip, &calls);
    let choice = [
        cells::select("Light", "light", &lights),
        cells::radio("Error", "kind", &ErrorKind::CHARTS.map(ErrorKind::name)),
        costs::choice(&offered),
    ];
    // Charts that are alike follow each other, so that they pack well.
    let of_costs = |&costs| {
        let of_kind = |kind| lights.iter().map(move |light| Shown { light, kind, costs }).collect::<Vec<_>>();
        ErrorKind::CHARTS.into_iter().flat_map(of_kind).collect::<Vec<_>>()
    };
    let all: Vec<_> = offered.iter().flat_map(of_costs).collect();
    cells::form(&choice.concat()) + &figures::shown(&all, |shown| shown.figure(study, &key))
}

/// What one chart shows.
struct Shown<'a> {
    light: &'a str,
    kind: ErrorKind,
    costs: Costs<'a>,
}

impl Shown<'_> {
    fn figure(&self, study: &Study, key: &Key) -> String {
        let Self { light, kind, costs } = *self;
        let rows = under_light(study.all_directions(), light);
        let name = format!("{}: {} error", chart::direction_title(light, costs.axis), kind.name());
        let svg = chart::one_panel(&direction_panel::field(&rows, &study.anchors, kind, costs), key, &name);
        let calls: Vec<_> = rows.iter().filter(|row| is_ours(row.by)).map(|row| row.call()).collect();
        let caption = format!("{light}, {} error {}", kind.name(), kind.against());
        let caption = caption + &costs::caption(&costs, COUNTED, &calls);
        figures::figure(&[("light", light), ("kind", kind.name()), ("axis", costs.axis.name())], &caption, &svg)
    }
}

/// What the kinds of error are, and the two that the charts do not tell apart.
pub fn errors(study: &Study) -> String {
    let lights = lights(study);
    let models = model_errors(&study.rows, &lights);
    format!("{ERRORS}\n{models}\n{INPUTS}\n{}\n{RIVALS}", input_errors(&study.rows, &lights))
}

/// Worst model error of each method under each light.
fn model_errors(rows: &[Row], lights: &[String]) -> String {
    by_light("models", "worst model error, rad", rows, lights, |row| (&row.method, row.model_max))
}

/// What rounding the directions costs in each format under each light.
fn input_errors(rows: &[Row], lights: &[String]) -> String {
    by_light("inputs", "rms error from rounded inputs, rad", rows, lights, |row| (&row.format, row.input_rms))
}

/// A line for each light and a column for each name that `part` gives, in the cells the greatest of its figures.
fn by_light(
    id: &str,
    title: &str,
    rows: &[Row],
    lights: &[String],
    part: impl Fn(&Row) -> (&String, f64) + Copy,
) -> String {
    let names = in_order(rows.iter().map(|row| part(row).0));
    let mut columns = vec![title];
    columns.extend(names.iter().map(String::as_str));
    let line = |light: &String| {
        let rows = under_light(rows, light);
        let cells: String = names.iter().map(|name| greatest(&rows, name, part)).collect();
        format!("<tr>{}{cells}</tr>\n", text(light))
    };
    sortable(id, &columns, &lights.iter().map(line).collect::<String>())
}

fn greatest(rows: &[&Row], name: &str, part: impl Fn(&Row) -> (&String, f64)) -> String {
    let theta = rows.first().map_or(1.0, |row| row.theta);
    let figures = rows.iter().map(|row| part(row)).filter(|(other, _)| *other == name).map(|(_, figure)| figure);
    let worst = figures.fold(f64::NAN, f64::max);
    let shown = format!("{} ({} %)", number::scientific(worst), number::percent(worst, theta));
    cell(worst, &shown)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn the_model_error_is_the_worst_over_the_formats() {
        let mut rows = [1e-9, f64::NAN, 2e-5].map(|_| sample::row("epic", "f32", 1.0, 1e-7));
        (rows[0].model_max, rows[1].model_max, rows[2].model_max) = (1e-9, f64::NAN, 2e-5);
        let html = model_errors(&rows, &[rows[0].light.clone()]);
        assert!(html.contains("2.0e-5 (0.43 %)"), "{html}");
    }
}
