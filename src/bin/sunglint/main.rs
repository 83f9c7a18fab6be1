//! The host tool `sunglint`: measures every method in every number format and shows the result.
//!
//! Exit codes: 0 where all went well, 1 where a file could not be written, 2 for a wrong command line.

mod author;
mod axis;
mod call;
mod chart;
mod chip;
mod chip_chart;
mod clock;
mod direction_panel;
mod directions;
mod error_kind;
mod field;
mod frame;
mod frontier;
mod kernel;
mod kernel_panel;
mod kernels;
mod key;
mod labels;
mod lettering;
mod lines;
mod lobe_chart;
mod lobes;
mod marks;
mod mean;
mod measure;
mod number;
mod options;
mod output;
mod page;
mod panel;
mod pixel_error;
mod pixel_panel;
mod pixel_q14;
mod pixels;
mod quantities;
mod result;
mod rivals;
#[cfg(test)]
mod sample;
mod sheet;
mod table;
mod ticks;
mod workers;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};
use indicatif::{ProgressBar, ProgressStyle};

use crate::options::Options;
use crate::output::WriteError;

fn main() -> ExitCode {
    let options = Options::parse();
    refuse_unknown_light(&options);
    match study(&options) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(io::stderr(), "sunglint: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Ends the run with clap's own message and code if no light has the name that was asked for.
fn refuse_unknown_light(options: &Options) {
    let names = measure::light_names();
    if !names.iter().any(|name| options.wants(name)) {
        let asked = options.light.as_deref().unwrap_or_default();
        let message = format!("no light is named '{asked}'; there are: {}", names.join("; "));
        Options::command().error(ErrorKind::InvalidValue, message).exit();
    }
}

/// The main job: measure, print, write.
fn study(options: &Options) -> Result<(), WriteError> {
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
fn progress(options: &Options) -> ProgressBar {
    if options.quiet {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {eta} left  {wide_msg}");
    ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Prints a line. A reader that has gone away, such as `head`, is no reason to lose the files.
fn print(text: &str) {
    let _ = writeln!(io::stdout().lock(), "{text}");
}
