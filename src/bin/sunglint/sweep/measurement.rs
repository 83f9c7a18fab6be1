//! The errors of one method in one word or format.

use sunglint::Real;
use sunglint::highlight::{ConeGgx, DiscGgx, Highlight, PointGgx};
use sunglint::oracle::quadrature::Quadrature;
use sunglint::scene::Channel;
use sunglint::trial::gloss::{self, Case};
use sunglint::trial::input::{self, Pair};
use sunglint::trial::{Constants, Found, Judgement, Light, Make, Method, Shading, Visitor, judge_code};

use super::SweepRow;
use super::numbers::Numbers;
use crate::directions;
use crate::options::Options;

/// The highlight methods that are swept: at a point, over the disc, over the cone.
pub const HIGHLIGHTS: [Shading; 3] = [Shading::Karis, Shading::Directional, Shading::ConeGgx];

/// Random pairs of directions, pixels, and pixels of which the model error is taken.
const SAMPLES: [usize; 3] = [10_000, 1500, 400];

/// The same with `--quick`.
const QUICK_SAMPLES: [usize; 3] = [1200, 150, 60];

fn samples(options: &Options) -> [usize; 3] {
    if options.quick { QUICK_SAMPLES } else { SAMPLES }
}

/// What is computed.
#[derive(Clone, Copy)]
pub enum Subject {
    /// The direction to a light.
    Direction { light: Light, method: Method },
    /// A lit pixel, with the worst error of the method's formula and the root mean square of it.
    Pixel { light: Light, alpha: f64, method: Shading, model: [f64; 2] },
}

impl Subject {
    /// Name of the method.
    pub fn method(&self) -> &'static str {
        match self {
            Self::Direction { method, .. } => method.name(),
            Self::Pixel { method, .. } => method.name(),
        }
    }

    /// The light.
    pub fn light(&self) -> Light {
        match *self {
            Self::Direction { light, .. } | Self::Pixel { light, .. } => light,
        }
    }
}

/// A subject in some numbers.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// What is computed.
    pub subject: Subject,
    /// What it is computed in.
    pub numbers: Numbers,
    /// How often, and from which seed.
    pub options: &'a Options,
}

impl Task<'_> {
    /// What the progress bar says.
    pub fn name(&self) -> String {
        format!("{}, {} in {}", self.subject.light().name, self.subject.method(), self.numbers.name())
    }

    /// The errors; nothing where the word has no type.
    pub fn row(&self) -> Option<SweepRow> {
        let light = self.subject.light();
        let row = SweepRow {
            light: light.name.to_owned(),
            ratio: light.light.sin(),
            method: self.subject.method().to_owned(),
            ..self.numbers.row()
        };
        match self.subject {
            Subject::Direction { method, .. } => self.direction(method, &light, row),
            Subject::Pixel { alpha, method, model, .. } => self.pixel(alpha, method, model, row),
        }
    }

    fn direction(&self, method: Method, light: &Light, row: SweepRow) -> Option<SweepRow> {
        let theta = light.light.angular_radius();
        let Code { rounded, direction } = self.numbers.visit(Direction { light, method })?;
        let pairs = input::random(self.options.seed, samples(self.options)[0], theta).chain(input::hard(theta));
        let pairs = pairs.map(|Pair { l, r }| Pair { l: rounded(l), r: rounded(r) });
        // In f64 what has been rounded stays what it is.
        let judgement = judge_code::<f64>(method, direction, &light.light, pairs, self.numbers.step());
        Some(judged(row, &judgement))
    }

    fn pixel(&self, alpha: f64, method: Shading, [model_max, model_rms]: [f64; 2], row: SweepRow) -> Option<SweepRow> {
        let Self { numbers, options, .. } = self;
        let case = Case { name: "", light: self.subject.light().light, alpha };
        let error = numbers.visit(Pixels { case, method, options })?;
        Some(SweepRow {
            subject: "pixel",
            alpha: Some(alpha),
            error_max: error.max,
            error_rms: error.rms(),
            total_max: error.max.hypot(model_max),
            total_rms: error.rms().hypot(model_rms),
            model_max,
            model_rms,
            samples: error.samples,
            failure: (!error.max.is_finite()).then(|| "NaN".to_owned()),
            ..row
        })
    }
}

/// `row` with what came of trying its method on directions.
fn judged(row: SweepRow, judgement: &Judgement<f64>) -> SweepRow {
    let failed = judgement.undirected == judgement.samples;
    let shown = |error: f64| if failed { f64::NAN } else { error };
    SweepRow {
        subject: "direction",
        error_max: shown(judgement.worst.error),
        error_rms: shown(judgement.mean_square.sqrt()),
        total_max: shown(judgement.total_max),
        total_rms: shown(judgement.total_mean_square.sqrt()),
        model_max: shown(judgement.model_max),
        model_rms: shown(judgement.model_mean_square.sqrt()),
        edge_max: Some(shown(100.0 * judgement.edge_max)),
        samples: judgement.samples,
        failure: directions::failure(judgement),
        ..row
    }
}

type Vector = [f64; 3];

/// A method in some numbers. Behind pointers, so that the measuring is compiled once, not for every word.
struct Code {
    /// The nearest vector.
    rounded: fn(Vector) -> Vector,
    /// The method's answer to such vectors.
    direction: Box<dyn Fn(Vector, Vector) -> Vector>,
}

struct Direction<'a> {
    light: &'a Light,
    method: Method,
}

impl Visitor for Direction<'_> {
    type Output = Code;

    fn visit<T: Real>(self) -> Code {
        let (method, constants) = (self.method, Constants::<T>::of(&self.light.light));
        let direction = move |l: Vector, r: Vector| {
            method.direction(l.map(T::from_f64), r.map(T::from_f64), &constants).map(T::to_f64)
        };
        Code { rounded: |v| v.map(|lane| T::from_f64(lane).to_f64()), direction: Box::new(direction) }
    }
}

struct Pixels<'a> {
    case: Case,
    method: Shading,
    options: &'a Options,
}

impl Visitor for Pixels<'_> {
    type Output = Found<9>;

    fn visit<T: Real>(self) -> Found<9> {
        let Self { case, method, options } = self;
        let pixels = case.pixels(options.seed, samples(options)[1]);
        gloss::arithmetic_of_code::<T>(method, &case, pixels, |pixel| match method {
            Shading::Karis => level(&case, pixel, PointGgx::karis),
            Shading::Directional => level(&case, pixel, DiscGgx::directional),
            _ => level(&case, pixel, ConeGgx::new),
        })
    }
}

/// The level of a pixel: normal, viewer and light.
#[inline(never)]
fn level<T: Real, H: Highlight<T>>(case: &Case, [n, v, l]: [[T; 3]; 3], method: Make<T, H>) -> f64 {
    let shaded = gloss::scene(case, l, method).map(|scene| scene.shade_channel(n, v, Channel::Green));
    shaded.map_or(f64::NAN, |level| sunglint::Scalar::exact(T::of_level(level)))
}

/// The errors of the formulas of [`HIGHLIGHTS`]: worst and root mean square.
pub fn models(light: Light, alpha: f64, options: &Options) -> [[f64; 2]; HIGHLIGHTS.len()] {
    let case = Case { name: "", light: light.light, alpha };
    let rule = Quadrature::<8>::new();
    let pixels = case.pixels(options.seed, samples(options)[2]);
    let all = gloss::models(&case, pixels.map(|pixel| (pixel, gloss::integral::<f64, 8>(&case, &pixel, &rule))));
    HIGHLIGHTS.map(|method| [all[method as usize].max, all[method as usize].rms()])
}
