//! The host tool `sunglint`: measures every method in every number format and shows the result.
//!
//! Exit codes: 0 where all went well, 1 where a file could not be written, 2 for a wrong command line, 130 where it was
//! interrupted by Ctrl-C. A reader of the output that goes away, such as `head`, is no failure.

mod anchors;
mod author;
mod axis;
mod bound;
mod call;
mod chart;
mod chip;
mod chip_chart;
mod clock;
mod columns;
mod curve_panel;
mod curves;
mod direction_panel;
mod directions;
mod display;
mod error_kind;
mod failure;
mod field;
mod filter;
mod frame;
mod frontier;
mod interrupt;
mod kernel;
mod kernel_panel;
mod kernels;
mod key;
mod labels;
mod latency;
mod lettering;
mod lines;
mod list;
mod lobe_chart;
mod lobes;
mod mark_groups;
mod marks;
mod mean;
mod measure;
mod measurements;
mod number;
mod options;
mod output;
mod page;
mod panel;
mod pictures;
mod pixel_error;
mod pixel_panel;
mod pixel_q14;
mod pixels;
mod presets;
mod quantities;
mod repro;
mod required;
mod result;
mod rivals;
mod said;
#[cfg(test)]
mod sample;
mod sheet;
mod short_numbers;
mod snippets;
mod sweep;
mod table;
mod ticks;
mod workers;
mod worst;

use std::io::{self, Write};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};
use indicatif::{ProgressBar, ProgressStyle};

use crate::failure::Failure;
use crate::options::{Cli, Command, Options};

fn main() -> ExitCode {
    interrupt::heed();
    let Cli { command, options } = Cli::parse();
    match done(command.unwrap_or(Command::Chart(options))) {
        Ok(()) if LOST.load(Ordering::Relaxed) => {
            let _ = writeln!(io::stderr(), "sunglint: cannot write to standard output");
            ExitCode::FAILURE
        }
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Usage(message)) => Cli::command().error(ErrorKind::InvalidValue, message).exit(),
        Err(failure) => {
            let _ = writeln!(io::stderr(), "sunglint: {failure}");
            ExitCode::from(failure.code())
        }
    }
}

fn done(command: Command) -> Result<(), Failure> {
    if let Some(options) = command.options() {
        options.check()?;
    }
    match command {
        Command::Chart(options) => chart(&options),
        Command::Worst(arguments) => worst::run(&arguments),
        Command::Repro(arguments) => repro::run(&arguments),
        Command::Render(arguments) => pictures::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Preset(arguments) => presets::run(&arguments),
        Command::Snippet(arguments) => snippets::run(&arguments),
        Command::List => {
            print(list::text().trim_end());
            Ok(())
        }
    }
}

/// The main job: measure, print, write.
fn chart(options: &Options) -> Result<(), Failure> {
    output::prepare(&options.out)?;
    let progress = progress(options);
    let mut study = measure::run(options, &progress);
    progress.finish_and_clear();
    frontier::mark(&mut study);
    if !options.quiet {
        print(&table::all(&study));
    }
    let report = output::write(&study, &options.out)?;
    print(&report.display().to_string());
    Ok(())
}

/// A bar on stderr, which hides itself where stderr is no terminal.
pub fn progress(options: &Options) -> ProgressBar {
    if options.quiet {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {eta} left  {wide_msg}");
    let bar = ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    interrupt::clear(&bar);
    bar
}

/// Whether output was lost for another reason than that its reader has gone away.
static LOST: AtomicBool = AtomicBool::new(false);

/// Prints a line. A reader that has gone away, such as `head`, is no failure, and a full disc no reason to lose the
/// files that are still to be written.
pub fn print(text: &str) {
    let mut out = io::stdout().lock();
    let written = writeln!(out, "{text}").and_then(|()| out.flush());
    if written.is_err_and(|error| error.kind() != io::ErrorKind::BrokenPipe) {
        LOST.store(true, Ordering::Relaxed);
    }
}
