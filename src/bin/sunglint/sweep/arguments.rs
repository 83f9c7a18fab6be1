//! What `sunglint sweep` is asked.

use clap::{Args, ValueEnum};
use serde::Serialize;
use sunglint::trial::chip::Core;
use sunglint::trial::{Light, Method, Shading};

use super::Goal;
use super::measurement::HIGHLIGHTS;
use crate::axis::Axis;
use crate::directions;
use crate::failure::Failure;
use crate::filter;
use crate::options::Options;

/// The roughness of pixels where none is given: varnish.
const ALPHA: f64 = 0.0625;

/// `sunglint sweep`.
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Without a light it is the Sun from Earth. Of lit pixels the methods karis, disc_ggx dir and cone_ggx are tried,
on a roughness of 0.0625 where none is given.
Errors are of the formula and its arithmetic together, on vectors that the word holds exactly.
  sunglint sweep                                 the Sun's edge to 1 % of its radius
  sunglint sweep --tolerance 0.1 --on m0         the same to 0.1 %, cheapest on a Cortex-M0+
  sunglint sweep --for pixel --alpha 0.001       a polished pixel to 1 %")]
pub struct Arguments {
    /// What is measured, and how long.
    #[command(flatten)]
    pub options: Options,

    /// What the tolerance is for
    #[arg(long = "for", value_enum, default_value_t)]
    pub goal: Goal,

    /// What is good enough: per cent of the radius for `edge` (default 1), radians for `direction` (default 0.001),
    /// relative root mean square for `pixel` (default 0.01)
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub tolerance: Option<f64>,

    /// The machine whose cheapest method and format are looked for
    #[arg(long, value_enum, default_value_t)]
    pub on: Machine,

    /// Print JSON, with every row, in place of a table
    #[arg(long)]
    pub json: bool,
}

/// A machine that costs are known of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Machine {
    /// This one, measured now, in calls of f32 `factored`
    #[default]
    Host,
    /// Cortex-M0+, in instructions
    M0,
    /// Cortex-M3, in instructions
    M3,
    /// Cortex-M4F, in instructions
    M4f,
}

impl Machine {
    /// The axis that its costs are on.
    pub const fn axis(self) -> Axis {
        match self {
            Self::Host => Axis::Host,
            Self::M0 => Axis::Chip(Core::M0),
            Self::M3 => Axis::Chip(Core::M3),
            Self::M4f => Axis::Chip(Core::M4),
        }
    }
}

/// What is to be found out, once all of it is known to be in range.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    /// The light.
    pub light: Light,
    /// The roughness of pixels.
    pub alpha: f64,
    /// What the tolerance is for.
    pub goal: Goal,
    /// The tolerance.
    pub tolerance: f64,
    /// Where it is to be cheap.
    pub on: Machine,
}

impl Arguments {
    /// What they ask.
    ///
    /// # Errors
    /// [`Failure::Usage`] for a tolerance out of range and for a light that there is not.
    pub fn question(&self) -> Result<Question, Failure> {
        let Self { goal, on, .. } = *self;
        let alpha = self.options.filter.alpha.unwrap_or(ALPHA);
        let tolerance = goal.checked(self.tolerance.unwrap_or(goal.default_tolerance()))?;
        let light = self.options.lights().first().copied().ok_or_else(Self::no_light)?;
        if goal == Goal::Pixel && !filter::has_pixels(&light.light) {
            return Err(filter::without_pixels(light));
        }
        if goal == Goal::Pixel && super::highlights(&self.options).is_empty() {
            let names = HIGHLIGHTS.map(Shading::name).join(", ");
            return Err(Failure::Usage(format!("of lit pixels there are the methods {names}")));
        }
        if goal != Goal::Pixel && self.options.methods().next().is_none() {
            let names = Method::ALL.map(Method::name).join(", ");
            return Err(Failure::Usage(format!("of directions there are the methods {names}")));
        }
        Ok(Question { light, alpha, goal, tolerance, on })
    }

    fn no_light() -> Failure {
        let names: Vec<_> = directions::names().collect();
        Failure::Usage(format!("no light has that name; there are: {}", names.join("; ")))
    }
}
