//! What `sunglint sweep` prints.

use comfy_table::Table;
use serde_json::json;

use super::answer::{Answer, Priced};
use super::arguments::Question;
use super::{Family, Goal, SweepRow, fewest, said};
use crate::axis::Axis;
use crate::{number, table};

/// The table and the sentence.
pub fn plain(question: &Question, answer: &Answer) -> String {
    format!("{}\n{}\n\n{}", heading(question), table(question, answer).trim_fmt(), sentence(question, answer))
}

fn heading(question: &Question) -> String {
    let Question { light, goal, tolerance, alpha, .. } = *question;
    let what = match goal {
        Goal::Edge => format!("Fewest bits that draw the edge to {}", goal.said(tolerance)),
        Goal::Direction => format!("Fewest bits that turn to {}", goal.said(tolerance)),
        Goal::Pixel => format!("Fewest bits that light a pixel of alpha {alpha} to {}", goal.said(tolerance)),
    };
    let ratio = number::scientific(light.light.sin());
    format!("{what}\n{}, radius over distance {ratio}; bits are fraction bits or digits of the significand", light.name)
}

fn table(question: &Question, answer: &Answer) -> Table {
    let mut table = table::table(&["method", "kind of number", "bits", "in all", "error"]);
    for family in Family::all(&answer.words) {
        table.add_row(line(&family, question));
    }
    table::align_right(&mut table, 2..5);
    table
}

/// A family's shortest word that is enough, or what its best comes to.
fn line(family: &Family, question: &Question) -> [String; 5] {
    let goal = question.goal;
    let found = fewest(family, goal, question.tolerance);
    // Some errors grow again, such as those right beside the opposite of the light where subnormals are flushed.
    let some = goal.error(family.nearest(goal)) <= question.tolerance;
    let none = if some { "not for good" } else { "none" };
    let (bits, width) = match found {
        Some(row) => (said(family, row), row.width.to_string()),
        None => (none.to_owned(), format!("best {}", family.nearest(goal).bits)),
    };
    let row = found.unwrap_or(family.nearest(goal));
    [family.first().method.clone(), family.name(), bits, width, error(goal, row)]
}

fn error(goal: Goal, row: &SweepRow) -> String {
    row.failure.clone().unwrap_or_else(|| number::scientific(goal.error(row)))
}

/// The cheapest method and format, or why there is none.
pub fn sentence(question: &Question, answer: &Answer) -> String {
    let Question { goal, tolerance, .. } = *question;
    let place = place(question);
    if let Some(Priced { row, price }) = answer.enough.first() {
        let (method, format) = (&row.method, &row.word);
        let error = goal.said(goal.error(row));
        let first = format!("Cheapest {place}: {method} in {format}, {error}; {}.", price.said);
        return first + &next(answer, goal);
    }
    let Some(nearest) = answer.nearest(goal) else {
        return "No format was asked for.".to_owned();
    };
    let (method, format, error) = (&nearest.method, &nearest.word, error(goal, nearest));
    let limit = goal.said(tolerance);
    if answer.any_within(goal, tolerance) {
        return format!(
            "None within {limit} has a known cost {place}; the most exact is {method} in {format}, {error}."
        );
    }
    format!("None: no format that is a type is within {limit}; the nearest is {method} in {format}, {error}.")
}

/// The two that come after the cheapest.
fn next(answer: &Answer, goal: Goal) -> String {
    let said = |Priced { row, price }: &Priced| {
        let cost = if price.cost < 100.0 { number::cost(price.cost) } else { number::count(price.cost as u64) };
        format!("{} in {}, {}, for {cost}", row.method, row.word, number::scientific(goal.error(row)))
    };
    let others: Vec<_> = answer.enough.iter().skip(1).take(2).map(said).collect();
    if others.is_empty() { String::new() } else { format!("\nNext: {}.", others.join("; ")) }
}

fn place(question: &Question) -> String {
    match question.on.axis() {
        Axis::Host => "on this machine".to_owned(),
        Axis::Chip(core) => format!("on a Cortex-{} (counted under the Sun)", core.name()),
    }
}

/// The same for machines; JSON has null for what is infinite or no number.
pub fn json(question: &Question, answer: &Answer) -> String {
    let Question { light, alpha, goal, tolerance, on } = *question;
    let fewest = |family: &Family| {
        let row = fewest(family, goal, tolerance);
        json!({
            "method": family.first().method,
            "family": family.first().family,
            "exponent": family.first().exponent,
            "bits": row.map(|row| row.bits),
            "width": row.map(|row| row.width),
            "error": goal.error(row.unwrap_or(family.nearest(goal))),
        })
    };
    let cheapest = |Priced { row, price }: &Priced| {
        json!({
            "method": row.method,
            "format": row.word,
            "error": goal.error(row),
            "cost": price.cost,
            "cost_unit": if on.axis() == Axis::Host { "calls of f32 factored" } else { "instructions" },
        })
    };
    let answer = json!({
        "light": light.name,
        "ratio": light.light.sin(),
        "alpha": (goal == Goal::Pixel).then_some(alpha),
        "for": goal,
        "unit": goal.unit(),
        "tolerance": tolerance,
        "on": on,
        "answer": sentence(question, answer),
        "cheapest": answer.enough.first().map(cheapest),
        "enough": answer.enough.iter().map(cheapest).collect::<Vec<_>>(),
        "fewest": Family::all(&answer.words).iter().map(fewest).collect::<Vec<_>>(),
        "words": answer.words,
        "formats": answer.formats,
    });
    format!("{answer:#}")
}
