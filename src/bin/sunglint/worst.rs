//! The worst inputs of every method, each with the command that computes it again.

use clap::Args;
use indicatif::ProgressBar;
use serde::Serialize;

use crate::failure::Failure;
use crate::key::in_order;
use crate::options::Options;
use crate::pixels::Truths;
use crate::result::{Bound, KernelRow, PixelRow, Row};
use crate::{directions, kernels, number, pixels, print, progress, table};

/// `sunglint worst`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// What is measured.
    #[command(flatten)]
    pub options: Options,

    /// Print a line of JSON for each in place of tables
    #[arg(long)]
    pub json: bool,
}

/// The worst known input of one method in one format under one light.
#[derive(Clone, Debug, Serialize)]
pub struct Worst {
    /// `direction`, `lit pixel` or `building block`.
    subject: &'static str,
    /// Name of the light or of the case; nothing for building blocks.
    light: String,
    /// Name of the method.
    method: String,
    /// Name of the number format.
    format: String,
    /// Worst arithmetic error; JSON has null for what is no number.
    pub error: f64,
    /// What that is in.
    unit: String,
    /// How the method fails, if it does.
    failure: Option<String>,
    /// What the error rests on.
    bound: Bound,
    /// How many inputs that took.
    samples: u64,
    /// Seed of the inputs, where they were sampled.
    seed: Option<u64>,
    /// The input: raw bits, of building blocks decimals.
    input: String,
    /// The command that computes it again.
    repro: String,
}

/// The command.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let progress = progress(&arguments.options);
    let rows = rows(&arguments.options, &progress);
    progress.finish_and_clear();
    if rows.is_empty() {
        return Err(Failure::Usage("nothing has that method, format and light; see sunglint list".to_owned()));
    }
    let text = if arguments.json { rows.iter().map(json).collect() } else { text(&rows) };
    print(text.trim_end());
    Ok(())
}

/// What was asked for, on all cores.
pub fn rows(options: &Options, progress: &ProgressBar) -> Vec<Worst> {
    let cases = pixels::wanted(options).len();
    let steps = directions::rows(options) + cases + pixels::rows(options) + kernels::rows(options);
    progress.set_length(steps as u64);
    let directions = directions::errors(options, progress);
    let pixels = pixels::errors(&Truths::default(), options, progress);
    let kernels = kernels::errors(options, progress);
    let directions = directions.iter().map(|row| of_direction(row, options));
    let pixels = pixels.iter().map(|row| of_pixel(row, options));
    directions.chain(pixels).chain(kernels.iter().map(|row| of_kernel(row, options))).collect()
}

fn seed(bound: Bound, options: &Options) -> Option<u64> {
    (bound == Bound::Sampled).then_some(options.seed)
}

fn of_direction(row: &Row, options: &Options) -> Worst {
    Worst {
        subject: "direction",
        light: row.light.clone(),
        method: row.method.clone(),
        format: row.format.clone(),
        error: row.bound_max,
        unit: "rad".to_owned(),
        failure: row.failure.clone(),
        bound: row.bound,
        samples: row.bound_samples,
        seed: seed(row.bound, options),
        input: vectors(&row.repro),
        repro: row.repro.clone(),
    }
}

fn of_pixel(row: &PixelRow, options: &Options) -> Worst {
    Worst {
        subject: "lit pixel",
        light: row.case.clone(),
        method: row.method.clone(),
        format: row.format.clone(),
        error: row.bound_max,
        unit: "relative".to_owned(),
        failure: row.failure.clone(),
        bound: row.bound,
        samples: row.bound_samples,
        seed: seed(row.bound, options),
        input: vectors(&row.repro),
        repro: row.repro.clone(),
    }
}

/// Of this run: what a search or all inputs know beyond that is kept without an input of the study's kind, and the
/// command would not find it.
fn of_kernel(row: &KernelRow, options: &Options) -> Worst {
    Worst {
        subject: "building block",
        light: String::new(),
        method: row.kernel.clone(),
        format: row.format.clone(),
        error: row.error_max,
        unit: row.unit.clone(),
        failure: None,
        bound: Bound::Sampled,
        samples: row.samples,
        seed: seed(Bound::Sampled, options),
        input: row.worst_input.clone(),
        repro: row.repro.clone(),
    }
}

/// The vectors that a command names, with their raw bits.
fn vectors(command: &str) -> String {
    let arguments = command.split(" --").filter_map(|argument| argument.split_once(' '));
    let vectors = arguments.filter(|(name, _)| ["n", "v", "l", "r"].contains(name));
    vectors.map(|(name, bits)| format!("{name} {}", bits.trim_matches('\''))).collect::<Vec<_>>().join(", ")
}

fn json(row: &Worst) -> String {
    // Strings and numbers have no way to fail.
    serde_json::to_string(row).unwrap_or_default() + "\n"
}

/// A table for each subject, under each line the command.
fn text(rows: &[Worst]) -> String {
    let subjects: Vec<_> = rows.iter().map(|row| row.subject.to_owned()).collect();
    in_order(subjects.iter()).iter().map(|subject| of_subject(rows, subject)).collect::<Vec<_>>().join("\n")
}

fn of_subject(rows: &[Worst], subject: &str) -> String {
    let rows: Vec<_> = rows.iter().filter(|row| row.subject == subject).collect();
    let mut table = table::table(&["subject", "light", "method", "format", "worst error", "how known", "input"]);
    table.add_rows(rows.iter().map(|row| cells(row)));
    let text = table.trim_fmt();
    let (head, lines) = text.lines().partition::<Vec<_>, _>(|line| !line.starts_with(subject));
    let commands = rows.iter().map(|row| format!("  {}", row.repro));
    let lines = lines.into_iter().zip(commands).map(|(line, command)| format!("{line}\n{command}\n"));
    head.iter().map(|line| format!("{line}\n")).chain(lines).collect()
}

fn cells(row: &Worst) -> [String; 7] {
    let failure = row.failure.as_ref().map(|failure| format!(", fails: {failure}"));
    [
        row.subject.to_owned(),
        row.light.clone(),
        row.method.clone(),
        row.format.clone(),
        format!("{} {}{}", number::scientific(row.error), row.unit, failure.unwrap_or_default()),
        how_known(row),
        row.input.clone(),
    ]
}

fn how_known(row: &Worst) -> String {
    let count = number::count(row.samples);
    match (row.bound, row.seed) {
        (Bound::Exhaustive, _) => format!("exhaustive, all {count}"),
        (Bound::Searched, _) => format!("searched, {count}"),
        (Bound::Sampled, seed) => format!("sampled, {count}, seed {}", seed.unwrap_or_default()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn options() -> Options {
        Options::parse_from(["sunglint", "--quick"])
    }

    #[test]
    fn a_seed_is_said_of_what_was_sampled_alone() {
        let repro = "sunglint repro cap f32 --light 'Sun from Earth' --l '1 2 3' --r '4 5 6'".to_owned();
        let searched = Row { bound_max: 2e-8, repro, ..sample::row("cap", "f32", 1.0, 1e-8) };
        let found = of_direction(&searched, &options());
        assert_eq!((found.error, found.seed, found.input.as_str()), (2e-8, None, "l 1 2 3, r 4 5 6"));
        assert!(how_known(&found).starts_with("searched"));
        let sampled = Row { bound: Bound::Sampled, bound_samples: 1000, ..searched };
        assert_eq!(how_known(&of_direction(&sampled, &options())), "sampled, 1\u{202f}000, seed 1");
    }

    #[test]
    fn each_line_is_followed_by_its_command_alone() {
        let rows = [
            of_direction(&sample::row("cap", "f32", 1.0, 1e-8), &options()),
            of_pixel(&sample::pixel("karis", "f16", 1.0, f64::INFINITY), &options()),
            of_kernel(&sample::kernel("I2F14", 1e-4), &options()),
        ];
        let text = text(&rows);
        let lines: Vec<_> = text.lines().collect();
        for row in &rows {
            let place = lines.iter().position(|line| line.trim() == row.repro).expect("a command");
            assert!(lines[place - 1].contains(&row.method), "{text}");
        }
        assert!(text.contains("infinite relative, fails: NaN") && text.contains("1.0e-4 rad"), "{text}");
        let value: serde_json::Value = serde_json::from_str(&json(&rows[1])).expect("JSON");
        assert!(value["error"].is_null() && value["method"] == "karis" && value["seed"] == 1);
    }
}
