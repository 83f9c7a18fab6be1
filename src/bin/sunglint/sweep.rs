//! How many bits are enough? Every method over word lengths that types have and that none has.

mod answer;
mod arguments;
mod fewest;
mod goal;
mod measurement;
mod numbers;
mod text;

use indicatif::ProgressBar;
use serde::Serialize;
use sunglint::SUN;
use sunglint::trial::emulated::Word;
use sunglint::trial::{Light, Shading, lights};

use crate::failure::Failure;
use crate::filter;
use crate::options::Options;
use crate::workers;

pub use arguments::Arguments;
pub use fewest::{Family, fewest, said};
pub use goal::Goal;
use measurement::{HIGHLIGHTS, Subject, Task};
use numbers::Numbers;

/// One method in one word.
#[derive(Clone, Debug, Default, Serialize)]
pub struct SweepRow {
    /// `direction` or `pixel`.
    pub subject: &'static str,
    /// Name of the light.
    pub light: String,
    /// Radius over distance of the light.
    pub ratio: f64,
    /// GGX width of the surface; none for directions.
    pub alpha: Option<f64>,
    /// Name of the method.
    pub method: String,
    /// `fixed`, `float` or `flushing float`.
    pub family: &'static str,
    /// Bits of the exponent; none in fixed point.
    pub exponent: Option<u32>,
    /// Fraction bits, or digits of the significand.
    pub bits: u32,
    /// Bits of a number in all.
    pub width: u32,
    /// Name of the word, such as `Q14 in 16 bits` or `p 11, e 5, flushing`.
    pub word: String,
    /// Name of the number format that is this word, if one is.
    pub format: Option<&'static str>,
    /// Worst arithmetic error: radians, of pixels relative.
    pub error_max: f64,
    /// Root mean square of that.
    pub error_rms: f64,
    /// Worst total error.
    pub total_max: f64,
    /// Root mean square of that.
    pub total_rms: f64,
    /// Worst error of the formula itself.
    pub model_max: f64,
    /// Root mean square of that.
    pub model_rms: f64,
    /// Worst error of the drawn edge, in per cent of the radius; none for pixels.
    pub edge_max: Option<f64>,
    /// Inputs tried.
    pub samples: u64,
    /// Name of what failed, or nothing.
    pub failure: Option<String>,
}

/// Widths of the highlights in the main job: varnish, whose highlight is wider than the Sun, and a polish.
const ALPHAS: [f64; 2] = [0.0625, 0.001];

/// Lights of the study that the main job sweeps directions for.
const SHOWN: [&str; 2] = [lights::STUDY[0].name, lights::STUDY[3].name];

/// Steps of the progress bar in the main job.
pub fn steps(options: &Options) -> usize {
    let (directions, pixels) = (direction_lights(options).len(), cases(options).len());
    let methods = directions * options.methods().count() + pixels * highlights(options).len();
    methods * Word::ALL.len() + pixels
}

/// The rows of the main job, on all cores.
pub fn measure(options: &Options, progress: &ProgressBar) -> Vec<SweepRow> {
    let mut subjects = Vec::new();
    for light in direction_lights(options) {
        subjects.extend(options.methods().map(|method| Subject::Direction { light, method }));
    }
    subjects.extend(pixels(&cases(options), options, progress));
    in_all(&subjects, &words(), options, progress)
}

/// The command.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let question = arguments.question()?;
    let answer = answer::answer(&question, &arguments.options);
    crate::print(&if arguments.json { text::json(&question, &answer) } else { text::plain(&question, &answer) });
    Ok(())
}

/// Every subject in each of some numbers.
fn in_all(subjects: &[Subject], numbers: &[Numbers], options: &Options, progress: &ProgressBar) -> Vec<SweepRow> {
    let of_subject = |&subject: &Subject| numbers.iter().map(move |&numbers| Task { subject, numbers, options });
    let tasks: Vec<_> = subjects.iter().flat_map(of_subject).collect();
    let rows = workers::map(&tasks, progress, |task| {
        progress.set_message(task.name());
        task.row()
    });
    rows.into_iter().flatten().collect()
}

/// All words.
fn words() -> Vec<Numbers> {
    Word::ALL.iter().copied().map(Numbers::Word).collect()
}

/// The formats that were asked for.
fn formats(options: &Options) -> Vec<Numbers> {
    options.formats().map(Numbers::Format).collect()
}

/// The highlight methods that were asked for, on surfaces under lights; a step of `progress` for each of these.
fn pixels(cases: &[(Light, f64)], options: &Options, progress: &ProgressBar) -> Vec<Subject> {
    let models = workers::map(cases, progress, |&(light, alpha)| measurement::models(light, alpha, options));
    let of_case = |(&(light, alpha), models): (&(Light, f64), [_; HIGHLIGHTS.len()])| {
        HIGHLIGHTS.into_iter().zip(models).map(move |(method, model)| Subject::Pixel { light, alpha, method, model })
    };
    let all = cases.iter().zip(models).flat_map(of_case);
    all.filter(|subject| options.wants_method(subject.method())).collect()
}

/// Lights of the main job's directions: two of the study's, or the user's own.
fn direction_lights(options: &Options) -> Vec<Light> {
    let shown = |light: &Light| SHOWN.contains(&light.name) || is_own(light);
    options.lights().into_iter().filter(shown).collect()
}

/// Lights and roughnesses of the main job's pixels.
fn cases(options: &Options) -> Vec<(Light, f64)> {
    let own = options.lights().into_iter().find(|light| is_own(light) && filter::has_pixels(&light.light));
    let light = own.unwrap_or(Light { name: "Sun", light: SUN });
    let wanted = |alpha: &f64| own.is_some() || options.wants(&format!("{}, alpha {alpha}", light.name));
    ALPHAS.into_iter().filter(wanted).map(|alpha| (light, alpha)).collect()
}

/// Whether a light is none of the study's.
fn is_own(light: &Light) -> bool {
    lights::STUDY.iter().all(|known| known.name != light.name)
}

/// Names of the highlight methods that were asked for.
fn highlights(options: &Options) -> Vec<&'static str> {
    HIGHLIGHTS.into_iter().map(Shading::name).filter(|name| options.wants_method(name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;
    use fixed::types::I2F14;
    use sunglint::DistantSphere;
    use sunglint::trial::{Format, Method};
    use sunglint::trial::{formula, input, judge_code};

    use crate::options::{Cli, Command};

    fn arguments(given: &[&str]) -> Arguments {
        let cli = Cli::try_parse_from(["sunglint", "sweep", "--quick", "--quiet"].iter().chain(given)).expect("sound");
        match cli.command {
            Some(Command::Sweep(arguments)) => arguments,
            _ => panic!("another command"),
        }
    }

    fn row(method: Method, numbers: Numbers) -> SweepRow {
        let options = arguments(&[]).options;
        let subject = Subject::Direction { light: lights::STUDY[0], method };
        Task { subject, numbers, options: &options }.row().expect("a type")
    }

    #[test]
    fn a_bit_more_halves_the_error() {
        let error = |word| row(Method::Cap, Numbers::Word(word)).error_rms;
        let fixed = |fraction| error(Word::Fixed { fraction });
        let float = |digits| error(Word::Float { digits, exponent: 8, flushing: false });
        let ratios = [
            fixed(16) / fixed(18),
            fixed(20) / fixed(22),
            fixed(26) / fixed(28),
            float(12) / float(14),
            float(20) / float(22),
        ];
        assert!(ratios.iter().all(|ratio| (3.2..5.0).contains(ratio)), "{ratios:?}");
    }

    #[test]
    fn a_word_that_is_a_type_is_as_wrong_as_the_type() {
        for word in [(11, 5, Format::F16), (24, 8, Format::F32)] {
            let (digits, exponent, format) = word;
            let word = Numbers::Word(Word::Float { digits, exponent, flushing: false });
            for method in Method::ALL {
                let figures = |row: SweepRow| {
                    let all = [row.error_max, row.error_rms, row.total_max, row.edge_max.unwrap_or(0.0)];
                    (all.map(f64::to_bits), row.failure, row.samples, row.format)
                };
                assert_eq!(
                    figures(row(method, word)),
                    figures(row(method, Numbers::Format(format))),
                    "{}",
                    method.name()
                );
            }
        }
    }

    #[test]
    fn q14_is_as_wrong_as_i2f14_by_the_formula() {
        let found = row(Method::Cap, Numbers::Word(Word::Fixed { fraction: 14 }));
        let (theta, sphere) = (SUN.angular_radius(), DistantSphere::<I2F14>::new(&SUN));
        let pairs = input::random(1, 1200, theta).chain(input::hard(theta));
        let cap = |l, r| formula::cap(l, r, &sphere);
        let judged = judge_code(Method::Cap, cap, &SUN, pairs, Format::I2F14.step());
        assert_eq!((found.error_max, found.edge_max), (judged.worst.error, Some(100.0 * judged.edge_max)));
        assert_eq!((found.samples, found.error_rms), (judged.samples, judged.mean_square.sqrt()));
    }

    /// The sentence that answers a question.
    fn said(given: &[&str]) -> String {
        let arguments = arguments(given);
        let question = arguments.question().expect("in range");
        text::sentence(&question, &answer::answer(&question, &arguments.options))
    }

    #[test]
    fn the_answer_follows_the_tolerance() {
        let coarse = said(&["--on", "m0", "--tolerance", "2"]);
        assert!(coarse.contains("cap in I2F14") && coarse.contains("Cortex-M0+"), "{coarse}");
        let fine = said(&["--on", "m0", "--tolerance", "0.01"]);
        assert!(fine.contains("cap in I2F30"), "{fine}");
        let none = said(&["--on", "m0", "--tolerance", "1e-13"]);
        assert!(none.starts_with("None") && none.contains("f64"), "{none}");
    }

    #[test]
    fn pixels_are_asked_for_by_their_roughness() {
        let polish = said(&["--for", "pixel", "--alpha", "0.001", "--on", "m3", "--method", "cone_ggx"]);
        assert!(polish.contains("cone_ggx in I2F14") && polish.contains("root mean square"), "{polish}");
        let host = said(&["--for", "direction", "--method", "cap", "--format", "f32"]);
        assert!(host.contains("cap in f32") && host.contains("cost"), "{host}");
    }

    #[test]
    fn what_is_out_of_range_is_refused_with_value_and_range() {
        for (given, said) in [
            (&["--tolerance", "0"][..], "a tolerance of 0 is out of range: it has to be above 0 and at most 100 %"),
            (&["--tolerance", "101"], "101 is out of range"),
            (&["--tolerance", "nan"], "NaN is out of range"),
            (&["--for", "direction", "--tolerance", "-1"], "at most 3.1 rad"),
            (&["--for", "pixel", "--tolerance", "1.5"], "above 0 and at most 1 of the pixel"),
            (&["--light", "lamp 0.3"], "Sun from Mars"),
            (&["--for", "pixel", "--method", "cap"], "karis, disc_ggx dir, cone_ggx"),
            (&["--method", "karis"], "epic, factored, disc, cap"),
            (&["--for", "pixel", "--angle", "200"], "angle 200 cannot light a roughness"),
            (&["--for", "pixel", "--ratio", "1e-300"], "1e-6 to 1"),
        ] {
            let Err(Failure::Usage(message)) = arguments(given).question() else { panic!("{given:?} is allowed") };
            assert!(message.contains(said), "{message}");
        }
    }

    #[test]
    fn machines_get_json() {
        let arguments = arguments(&["--json", "--on", "m4f", "--method", "cap"]);
        let question = arguments.question().expect("in range");
        let text = text::json(&question, &answer::answer(&question, &arguments.options));
        let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!((&value["for"], &value["tolerance"]), (&"edge".into(), &1.0.into()));
        assert_eq!(value["words"].as_array().map(Vec::len), Some(Word::ALL.len()));
        assert_eq!(value["cheapest"]["cost_unit"], "instructions");
    }

    #[test]
    fn the_main_job_takes_as_many_steps_as_it_says() {
        let options = Options::parse_from(["sunglint", "--quick", "--light", "sun"]);
        let progress = ProgressBar::hidden();
        let rows = measure(&options, &progress);
        assert_eq!(rows.len() + ALPHAS.len(), steps(&options));
        assert_eq!(progress.position(), steps(&options) as u64);
        assert!(rows.iter().any(|row| row.alpha == Some(0.001)) && rows.iter().all(|row| row.ratio < 0.005));
    }
}
