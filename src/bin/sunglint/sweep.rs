//! How many bits are enough? Every method over word lengths that types have and that none has.

mod answer;
mod arguments;
mod fewest;
mod goal;
mod measurement;
mod text;

use indicatif::ProgressBar;
use serde::Serialize;
use sunglint::SUN;
use sunglint::trial::emulated::Word;
use sunglint::trial::{Format, Light, Method, lights};

use crate::failure::Failure;
use crate::options::Options;
use crate::workers;

pub use arguments::Arguments;
pub use fewest::{Family, fewest};
pub use goal::Goal;
use measurement::{HIGHLIGHTS, Numbers, Subject, Task};

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
    let methods = directions * methods(options).len() + pixels * highlights(options).len();
    methods * Word::ALL.len() + pixels
}

/// The rows of the main job, on all cores.
pub fn measure(options: &Options, progress: &ProgressBar) -> Vec<SweepRow> {
    let mut subjects = Vec::new();
    for light in direction_lights(options) {
        subjects.extend(methods(options).into_iter().map(|method| Subject::Direction { light, method }));
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
    Format::ALL.into_iter().filter(|&format| options.wants_format(format)).map(Numbers::Format).collect()
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
    let own = options.lights().into_iter().find(|light| is_own(light) && light.light.cos() >= 0.0);
    let light = own.unwrap_or(Light { name: "Sun", light: SUN });
    let wanted = |alpha: &f64| own.is_some() || options.wants(&format!("{}, alpha {alpha}", light.name));
    ALPHAS.into_iter().filter(wanted).map(|alpha| (light, alpha)).collect()
}

/// Whether a light is none of the study's.
fn is_own(light: &Light) -> bool {
    lights::STUDY.iter().all(|known| known.name != light.name)
}

fn methods(options: &Options) -> Vec<Method> {
    Method::ALL.into_iter().filter(|method| options.wants_method(method.name())).collect()
}

fn highlights(options: &Options) -> Vec<&'static str> {
    HIGHLIGHTS.into_iter().map(sunglint::trial::Shading::name).filter(|name| options.wants_method(name)).collect()
}
