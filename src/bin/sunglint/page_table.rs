//! The tables of report.html.

use crate::chart::under_light;
use crate::key::in_order;
use crate::number;
use crate::page::escape;
use crate::result::{QuantityRow, Row};
use crate::table;

/// Every row, to be sorted by any column.
pub fn measurements(rows: &[Row], lights: &[String]) -> String {
    const COLUMNS: [&str; 20] = [
        "light",
        "method",
        "format",
        "cost",
        "cost quartiles",
        "arithmetic max, rad",
        "in % of radius",
        "arithmetic rms, rad",
        "model max, rad",
        "total max, rad",
        "in % of radius",
        "total rms, rad",
        "outcome",
        "frontier",
        "tried",
        "left out",
        "no direction",
        "worst at angle, rad",
        "worst light, raw bits",
        "worst mirror direction, raw bits",
    ];
    let line = |row: &Row| {
        let light = lights.iter().position(|light| *light == row.light).unwrap_or(0);
        let class = if row.failure.is_some() { " class=\"fails\"" } else { "" };
        format!("<tr data-light=\"{light}\"{class}>{}</tr>\n", cells(row))
    };
    let lines: String = rows.iter().map(line).collect();
    format!(
        "<form class=\"choice\" hidden><label><input type=\"checkbox\" id=\"all\"> rows of all lights\
         </label></form>\n{}",
        sortable("measurements", &COLUMNS, &lines)
    )
}

fn cells(row: &Row) -> String {
    let quartiles = format!("{} to {}", number::cost(row.cost_low), number::cost(row.cost_high));
    let outcome = row.failure.as_ref().map_or("works".to_owned(), |why| format!("fails: {why}"));
    let frontier = table::frontier(row);
    [
        text(&row.light),
        text(&row.method),
        text(&row.format),
        figure(row.cost, &number::cost(row.cost)),
        figure(row.cost_low, &quartiles),
        radians(row.error_max),
        percent(row.error_max, row.theta),
        radians(row.error_rms),
        radians(row.model_max),
        radians(row.total_max),
        percent(row.total_max, row.theta),
        radians(row.total_rms),
        text(&outcome),
        text(if frontier.is_empty() { "no" } else { frontier }),
        count(row.samples),
        count(row.excluded),
        count(row.undirected),
        radians(row.worst_angle),
        bits(&row.worst_l),
        bits(&row.worst_r),
    ]
    .concat()
}

fn bits(value: &str) -> String {
    format!("<td><code>{}</code></td>", escape(value))
}

/// Worst model error of each method under each light.
pub fn model_errors(rows: &[Row], lights: &[String]) -> String {
    by_light("models", "worst model error, rad", rows, lights, |row| (&row.method, row.model_max))
}

/// What rounding the directions costs in each format under each light.
pub fn input_errors(rows: &[Row], lights: &[String]) -> String {
    by_light("inputs", "rms error from rounded inputs, rad", rows, lights, |row| (&row.format, row.input_rms))
}

/// A line for each light and a column for each name that `cell` gives, in the cells the greatest of its figures.
fn by_light(
    id: &str,
    title: &str,
    rows: &[Row],
    lights: &[String],
    cell: impl Fn(&Row) -> (&String, f64) + Copy,
) -> String {
    let names = in_order(rows.iter().map(|row| cell(row).0));
    let mut columns = vec![title];
    columns.extend(names.iter().map(String::as_str));
    let line = |light: &String| {
        let rows = under_light(rows, light);
        let cells: String = names.iter().map(|name| greatest(&rows, name, cell)).collect();
        format!("<tr>{}{cells}</tr>\n", text(light))
    };
    sortable(id, &columns, &lights.iter().map(line).collect::<String>())
}

fn greatest(rows: &[&Row], name: &str, cell: impl Fn(&Row) -> (&String, f64)) -> String {
    let theta = rows.first().map_or(1.0, |row| row.theta);
    let figures = rows.iter().map(|row| cell(row)).filter(|(other, _)| *other == name).map(|(_, figure)| figure);
    let worst = figures.fold(f64::NAN, f64::max);
    let shown = format!("{} ({} %)", number::scientific(worst), number::percent(worst, theta));
    figure(worst, &shown)
}

/// Every quantity, to be sorted by any column.
pub fn quantities(rows: &[QuantityRow]) -> String {
    const COLUMNS: [&str; 7] =
        ["quantity", "format", "unit", "worst error in units", "worst input", "tried", "refused"];
    let line = |row: &QuantityRow| {
        let cells = [
            text(&row.quantity),
            text(&row.format),
            text(&row.unit),
            figure(row.error_max, &table::units(row.error_max)),
            figure(row.worst_input, &format!("{:e}", row.worst_input)),
            count(row.samples),
            count(row.refused),
        ];
        format!("<tr>{}</tr>\n", cells.concat())
    };
    let lines: String = rows.iter().map(line).collect();
    format!(
        "<p>What a renderer derives once for each light. An input is refused, with an error that says \
         why, where the format holds no value for the answer. The truth is f64’s: of the errors of the 64-bit \
         fixed-point answers up to 0.75 is its own rounding.</p>\n{}",
        sortable("quantities", &COLUMNS, &lines)
    )
}

fn sortable(id: &str, columns: &[&str], lines: &str) -> String {
    let head = |name: &&str| format!("<th scope=\"col\"><button type=\"button\">{}</button></th>", escape(name));
    let heads: String = columns.iter().map(head).collect();
    format!(
        "<div class=\"wide\" tabindex=\"0\"><table id=\"{id}\">\n<thead><tr>{heads}</tr></thead>\n\
         <tbody>\n{lines}</tbody>\n</table></div>"
    )
}

fn text(value: &str) -> String {
    format!("<td>{}</td>", escape(value))
}

fn radians(value: f64) -> String {
    figure(value, &number::scientific(value))
}

fn percent(part: f64, whole: f64) -> String {
    figure(part / whole, &number::percent(part, whole))
}

fn count(value: u64) -> String {
    format!("<td class=\"figure\" data-value=\"{value}\">{}</td>", number::count(value))
}

/// A number that is shown as `shown` and sorted by its full value.
fn figure(value: f64, shown: &str) -> String {
    format!("<td class=\"figure\" data-value=\"{value:e}\">{shown}</td>")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn a_failure_is_said_in_words_and_bits_are_shown() {
        let mut row = sample::row("epic", "f16", 1.0, f64::NAN);
        row.failure = Some("NaN".to_owned());
        let html = measurements(&[row.clone()], &[row.light.clone()]);
        assert!(html.contains("fails: NaN") && html.contains(&row.worst_l));
    }

    #[test]
    fn the_model_error_is_the_worst_over_the_formats() {
        let mut rows = [1e-9, f64::NAN, 2e-5].map(|_| sample::row("epic", "f32", 1.0, 1e-7));
        (rows[0].model_max, rows[1].model_max, rows[2].model_max) = (1e-9, f64::NAN, 2e-5);
        let html = model_errors(&rows, &[rows[0].light.clone()]);
        assert!(html.contains("2.0e-5 (0.43 %)"), "{html}");
    }
}
