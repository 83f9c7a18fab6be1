//! The answer at once: of the first light, what is cheapest, what is most exact and what fails.

use super::cells::{self, slug};
use crate::author::{self, is_peer};
use crate::axis::{Axis, Costs, Price};
use crate::chart::under_light;
use crate::error_kind::ErrorKind;
use crate::key::in_order;
use crate::number;
use crate::result::{Row, Study};

/// The part of the light's radius that an answer may be wrong by.
const WITHIN: f64 = 0.01;

/// The box; empty where no direction was measured, or the light is a point.
pub fn all(study: &Study) -> String {
    // No error is a part of a point's radius.
    let Some(first) = study.rows.first().filter(|row| row.theta > 0.0) else { return String::new() };
    // Peers are there to compare with, not to choose from.
    let rows: Vec<_> = under_light(study.all_directions(), &first.light);
    let rows: Vec<_> = rows.into_iter().filter(|row| !is_peer(row.by)).collect();
    let calls: Vec<_> = rows.iter().map(|row| row.call()).collect();
    let lines: String = Costs::offered(&study.chip, &calls).iter().map(|costs| line(&rows, *costs)).collect();
    format!(
        "<aside class=\"short\" aria-label=\"In short\">\n<h2>In short: {}</h2>\n<p>Which way to turn a mirror direction to \
         the light is within {} % of the light’s radius everywhere, as far as this run and searches know, and what does it cost?</p>\n\
         <div class=\"wide\" tabindex=\"0\"><table><thead><tr><th scope=\"col\">on</th><th scope=\"col\">cheapest within {} %</th>\
         <th scope=\"col\">most exact</th></tr></thead>\n<tbody>{lines}</tbody></table></div>\n<p>{}</p>\n</aside>\n",
        cells::escape(&first.light),
        WITHIN * 100.0,
        WITHIN * 100.0,
        failing(&rows)
    )
}

/// The cheapest and the most exact of `rows` by some cost.
fn line(rows: &[&Row], costs: Costs) -> String {
    let priced = costs.priced(rows, Row::call);
    let works =
        |(row, price): &&(&Row, Price)| row.failure.is_none() && row.total_max.is_finite() && price.cost.is_finite();
    let by_cost = |a: &&(&Row, Price), b: &&(&Row, Price)| {
        a.1.cost.total_cmp(&b.1.cost).then(a.0.total_max.total_cmp(&b.0.total_max))
    };
    let by_error = |a: &&(&Row, Price), b: &&(&Row, Price)| {
        a.0.total_max.total_cmp(&b.0.total_max).then(a.1.cost.total_cmp(&b.1.cost))
    };
    // What a search knows counts too: `disc` is lost beside -l in f64, which few runs come upon.
    let near = |(row, _): &&(&Row, Price)| row.total_max.max(row.bound_max) <= WITHIN * row.theta;
    let cheapest = priced.iter().filter(works).filter(near).min_by(by_cost);
    let most_exact = priced.iter().filter(works).min_by(by_error);
    let on = match costs.axis {
        Axis::Host => "this machine, in calls of f32 factored".to_owned(),
        Axis::Chip(core) => format!("Cortex-{}", core.name()),
    };
    let cells = [cheapest, most_exact]
        .map(|found| found.map_or_else(|| "<td>none</td>".to_owned(), |(row, price)| answer(row, price, costs.axis)));
    format!("<tr><th scope=\"row\">{on}</th>{}</tr>\n", cells.concat())
}

fn answer(row: &Row, price: &Price, axis: Axis) -> String {
    let cost = match axis {
        Axis::Host => format!("cost {}", number::cost(price.cost)),
        Axis::Chip(_) => format!("{} instructions", number::count(price.cost as u64)),
    };
    format!(
        "<td>{} in {}: {cost}, error {} %</td>",
        link(&row.method),
        cells::escape(&author::said(&row.format, row.by)),
        number::percent(ErrorKind::Total.worst(row), row.theta)
    )
}

fn link(method: &str) -> String {
    format!("<a href=\"#method-{}\">{}</a>", slug(method), cells::escape(method))
}

/// Which methods fail in which formats, and how.
fn failing(rows: &[&Row]) -> String {
    let failed: Vec<_> = rows.iter().filter(|row| row.failure.is_some()).collect();
    let of_method = |method: &String| {
        let rows = failed.iter().filter(|row| row.method == *method);
        let said = |row: &&&Row| {
            let format = author::said(&row.format, row.by);
            cells::escape(&format!("{format} ({})", row.failure.as_deref().unwrap_or_default()))
        };
        format!("{} in {}", link(method), rows.map(said).collect::<Vec<_>>().join(", "))
    };
    let methods: Vec<_> = in_order(failed.iter().map(|row| &row.method)).iter().map(of_method).collect();
    match methods.is_empty() {
        true => "None fails.".to_owned(),
        false => format!("<strong>These fail:</strong> {}.", methods.join("; ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn the_cheapest_that_is_near_and_the_most_exact_are_found() {
        let failed = Row { failure: Some("disc lost".to_owned()), ..sample::row("disc", "f16", 0.1, 1e-9) };
        // A hundredth of the radius is 4.65e-5.
        let rows = vec![
            failed,
            sample::row("epic", "f32", 0.5, 4.7e-5),
            sample::row("cap", "I2F14", 0.8, 4.2e-5),
            Row { bound_max: 4e-3, ..sample::row("disc", "I2F30", 0.7, 2e-6) },
            sample::row("cap", "f32", 1.0, 1e-7),
        ];
        let mut study = sample::study(rows);
        let chip = sample::count("cap", "I2F14", "outside", [Some(1000), None, None]);
        let html = |study: &Study| all(study).replace("<a href=\"#method-", "[").replace("</a>", "]");
        let shown = html(&study);
        assert!(shown.contains(">cap] in I2F14: cost 0.80, error 0.90 %</td>"), "{shown}");
        assert!(shown.contains(">cap] in f32: cost 1.00, error 0.0022 %</td>"), "{shown}");
        assert!(shown.contains(">disc] in f16 (disc lost)."), "{shown}");
        study.chip = vec![chip];
        assert!(
            html(&study).contains("Cortex-M0+</th><td>[cap\">cap] in I2F14: 1\u{202f}000 instructions"),
            "{}",
            html(&study)
        );
    }

    #[test]
    fn where_none_is_near_it_says_so() {
        let html = all(&sample::study(vec![sample::row("epic", "f32", 0.5, 1e-3)]));
        assert!(html.contains("<td>none</td>") && html.contains("None fails."), "{html}");
        assert_eq!(all(&sample::study(Vec::new())), "");
    }
}
