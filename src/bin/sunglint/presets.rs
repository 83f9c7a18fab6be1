//! Failures that users of other software have reported, run as named: the form that fails and its cure.

mod angle;
pub mod chart;
mod console;
mod cordic;
mod distant_light;
mod fast_root;
mod mediump;
mod pixels;
mod point;
mod roughness;
mod row;
mod small_sun;
mod text;

use clap::Args;
use indicatif::ProgressBar;

pub use row::PresetRow;
pub use text::shown;

use crate::failure::Failure;
use crate::options::Options;
use crate::workers;

/// A failure that was reported, and what shows it.
pub struct Preset {
    /// What it is asked for by.
    pub name: &'static str,
    /// Where it was reported, or seen.
    pub source: &'static str,
    /// What is computed, in a sentence.
    pub question: &'static str,
    /// The chart of the rows that stand on its axis, if they say more than a table.
    pub chart: Option<Axes>,
    measure: fn(Effort) -> Vec<PresetRow>,
    verdict: fn(&[PresetRow]) -> String,
}

/// What a chart of a preset shows: both axes are logarithmic.
pub struct Axes {
    /// Above the chart.
    pub title: &'static str,
    /// Below it.
    pub input: &'static str,
    /// Beside it.
    pub measure: &'static str,
    /// Its ticks are 0.1 times powers of this.
    pub base: f64,
    /// The least value that is shown; what is below is drawn there.
    pub lowest: f64,
}

/// How much is tried.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Effort {
    Quick,
    Full,
}

impl Effort {
    fn of(quick: bool) -> Self {
        if quick { Self::Quick } else { Self::Full }
    }

    /// How many inputs to try.
    fn count(self, quick: usize, full: usize) -> usize {
        if self == Self::Quick { quick } else { full }
    }
}

/// All of them, in the order of the page.
pub const ALL: [Preset; 9] = [
    mediump::PRESET,
    roughness::PRESET,
    console::PRESET,
    small_sun::PRESET,
    point::PRESET,
    angle::PRESET,
    distant_light::PRESET,
    fast_root::PRESET,
    cordic::PRESET,
];

impl Preset {
    /// The rows of a run.
    fn rows(&self, effort: Effort) -> Vec<PresetRow> {
        let &Self { name: preset, source, question, .. } = self;
        (self.measure)(effort).into_iter().map(|row| PresetRow { preset, source, question, ..row }).collect()
    }

    /// What `rows`, which are this preset's, say, in a sentence.
    pub fn verdict(&self, rows: &[PresetRow]) -> String {
        (self.verdict)(rows)
    }
}

/// `sunglint preset`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Name of a preset, as `sunglint list` has it; all of them where none is given
    pub name: Option<String>,

    /// Try fewer inputs, with coarser integrals
    #[arg(long)]
    pub quick: bool,

    /// Print the rows as JSON
    #[arg(long)]
    pub json: bool,
}

/// Names and what each is about.
pub fn names() -> Vec<(&'static str, &'static str)> {
    ALL.iter().map(|preset| (preset.name, preset.question)).collect()
}

/// Steps of the progress bar in the main job.
pub fn steps(_options: &Options) -> usize {
    ALL.len()
}

/// All presets.
pub fn measure(options: &Options, progress: &ProgressBar) -> Vec<PresetRow> {
    let all: Vec<_> = ALL.iter().collect();
    run_all(&all, Effort::of(options.quick), progress).concat()
}

/// The rows of each of `presets`, on all cores.
fn run_all(presets: &[&Preset], effort: Effort, progress: &ProgressBar) -> Vec<Vec<PresetRow>> {
    workers::map(presets, progress, |preset| {
        progress.set_message(format!("preset {}", preset.name));
        preset.rows(effort)
    })
}

/// The command.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let presets = named(arguments.name.as_deref())?;
    let rows = run_all(&presets, Effort::of(arguments.quick), &ProgressBar::hidden());
    let text = if arguments.json {
        text::json(&rows.concat())
    } else {
        let parts: Vec<_> = presets.iter().zip(&rows).map(|(preset, rows)| text::of(preset, rows)).collect();
        parts.join("\n")
    };
    crate::print(&text);
    Ok(())
}

/// The preset of a name, or all.
fn named(name: Option<&str>) -> Result<Vec<&'static Preset>, Failure> {
    let presets: Vec<_> =
        ALL.iter().filter(|preset| name.is_none_or(|name| name.eq_ignore_ascii_case(preset.name))).collect();
    if presets.is_empty() {
        let names: Vec<_> = ALL.iter().map(|preset| preset.name).collect();
        let asked = name.unwrap_or_default();
        return Err(Failure::Usage(format!("no preset is named '{asked}'; there are: {}", names.join(", "))));
    }
    Ok(presets)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The point of it all: what is said to fail fails, and what is said to cure does not.
    fn check(preset: &Preset, effort: Effort) {
        let rows = preset.rows(effort);
        for role in [row::FAILS, row::CURE] {
            let judged: Vec<_> = rows.iter().filter(|row| row.role == role && row.criterion.is_some()).collect();
            assert!(!judged.is_empty(), "{}: nothing {role}", preset.name);
            for row in judged {
                assert_eq!(row.fails, role == row::FAILS, "{row:?}");
            }
        }
    }

    #[test]
    fn what_fails_fails_and_what_cures_does_not() {
        ALL.iter().for_each(|preset| check(preset, Effort::Quick));
    }

    #[test]
    fn so_it_is_in_a_full_run() {
        ALL.iter().for_each(|preset| check(preset, Effort::Full));
    }

    #[test]
    fn the_same_run_gives_the_same_rows() {
        for preset in &ALL {
            let [first, second] = [(), ()].map(|()| text::of(preset, &preset.rows(Effort::Quick)));
            assert_eq!(first, second);
        }
    }

    #[test]
    fn a_chart_has_rows_and_only_a_chart() {
        for preset in &ALL {
            let rows = preset.rows(Effort::Quick);
            let placed = rows.iter().filter(|row| row.input.is_some()).count();
            assert_eq!(preset.chart.is_some(), placed > 0, "{}", preset.name);
            assert!(rows.iter().all(|row| row.input.is_some() == (row.role == row::CURVE)));
        }
    }

    #[test]
    fn an_unknown_name_lists_what_there_is() {
        let Err(failure) = named(Some("nothing")) else { panic!("there is none") };
        let message = failure.to_string();
        assert!(message.contains("'nothing'") && message.contains("console-16.16"), "{message}");
        assert_eq!(failure.code(), 2);
        assert_eq!(named(Some("Path-tracer-small-sun")).map(|found| found.len()).ok(), Some(1));
        assert_eq!(named(None).map(|found| found.len()).ok(), Some(ALL.len()));
    }
}
