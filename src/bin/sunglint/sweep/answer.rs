//! The words that are enough, and the cheapest method and format that is.

use indicatif::ProgressBar;
use sunglint::trial::gloss::Case;
use sunglint::trial::{Format, Method, Shading};

use super::arguments::Question;
use super::measurement::Subject;
use super::{Goal, SweepRow, formats, in_all, pixels, words};
use crate::author::OURS;
use crate::axis::{Axis, Price};
use crate::call::Call;
use crate::chip::{self, PIXEL};
use crate::clock::{self, Contender, Pace};
use crate::options::Options;
use crate::result::Study;
use crate::{directions, pixels as pixel_rows};

/// Rounds of the clock, and the same with `--quick`.
const ROUNDS: [usize; 2] = [41, 9];

/// What came of a question.
#[derive(Debug)]
pub struct Answer {
    /// Every method in every word.
    pub words: Vec<SweepRow>,
    /// Every method in every format.
    pub formats: Vec<SweepRow>,
    /// The formats that are within the tolerance and of which a cost is known, the cheapest first.
    pub enough: Vec<Priced>,
}

/// A method in a format, and what a call costs.
#[derive(Debug)]
pub struct Priced {
    /// Its errors.
    pub row: SweepRow,
    /// Its cost.
    pub price: Price,
}

impl Answer {
    /// The method and format whose error is least; none where none was asked for.
    pub fn nearest(&self, goal: Goal) -> Option<&SweepRow> {
        self.formats.iter().min_by(|a, b| goal.error(a).total_cmp(&goal.error(b)))
    }

    /// Whether any format is within `tolerance`, whatever it costs.
    pub fn any_within(&self, goal: Goal, tolerance: f64) -> bool {
        self.formats.iter().any(|row| goal.error(row) <= tolerance)
    }
}

/// Measures what `question` needs.
pub fn answer(question: &Question, options: &Options) -> Answer {
    let progress = crate::progress(options);
    let subjects = subjects(question, options, &progress);
    let (words, formats) = (words(), formats(options));
    progress.inc_length((subjects.len() * (words.len() + formats.len())) as u64);
    let words = in_all(&subjects, &words, options, &progress);
    let formats = in_all(&subjects, &formats, options, &progress);
    let within = formats.iter().filter(|row| question.goal.error(row) <= question.tolerance).cloned().collect();
    let enough = priced(within, question, options, &progress);
    progress.finish_and_clear();
    Answer { words, formats, enough }
}

fn subjects(question: &Question, options: &Options, progress: &ProgressBar) -> Vec<Subject> {
    let Question { light, alpha, .. } = *question;
    match question.goal {
        Goal::Pixel => {
            progress.inc_length(1);
            pixels(&[(light, alpha)], options, progress)
        }
        Goal::Edge | Goal::Direction => options.methods().map(|method| Subject::Direction { light, method }).collect(),
    }
}

/// Those of `rows` whose cost is known, the cheapest first.
fn priced(rows: Vec<SweepRow>, question: &Question, options: &Options, progress: &ProgressBar) -> Vec<Priced> {
    let prices = match question.on.axis() {
        Axis::Host => timed(&rows, question, options, progress),
        Axis::Chip(core) => {
            let chip = chip::rows(&Study::default());
            rows.iter().map(|row| chip::price(&chip, core, &call(row))).collect()
        }
    };
    let known = |(row, price): (SweepRow, Option<Price>)| price.map(|price| Priced { row, price });
    let mut priced: Vec<_> = rows.into_iter().zip(prices).filter_map(known).collect();
    priced.sort_by(|a, b| a.price.cost.total_cmp(&b.price.cost));
    priced
}

/// What is called, by the names of the table of counts.
fn call(row: &SweepRow) -> Call {
    let function = if row.subject == "pixel" { format!("{PIXEL}{}", row.method) } else { row.method.clone() };
    Call { function, format: row.word.clone(), by: OURS, host: [f64::NAN; 3] }
}

/// Times of `rows` on this machine.
fn timed(rows: &[SweepRow], question: &Question, options: &Options, progress: &ProgressBar) -> Vec<Option<Price>> {
    progress.set_message("timing");
    let rounds = ROUNDS[usize::from(options.quick)];
    progress.inc_length(rounds as u64);
    let contenders: Vec<_> = rows.iter().filter_map(|row| contender(row, question)).collect();
    let costs = clock::costs(&contenders, &directions::baseline(&question.light), rounds, progress);
    let price = |cost: clock::Cost| {
        let (median, low, high) = cost.figures();
        let call = Call { host: [median, low, high], ..call(&SweepRow::default()) };
        Axis::Host.price(&[], &call)
    };
    costs.into_iter().map(price).collect()
}

/// The calls of a row of a format.
fn contender(row: &SweepRow, question: &Question) -> Option<Contender> {
    let format = row.format.and_then(Format::named)?;
    let direction = Method::named(&row.method);
    if let (Some(method), Goal::Edge | Goal::Direction) = (direction, question.goal) {
        return Some(directions::contender(method, format, &question.light, Pace::Independent));
    }
    let method = Shading::named(&row.method)?;
    let case = Case { name: "", light: question.light.light, alpha: question.alpha };
    Some(pixel_rows::contender(method, format, &case, Pace::Independent))
}
