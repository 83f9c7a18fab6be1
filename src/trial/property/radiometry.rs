//! Radiometry: power, intensity, irradiance, radiance, and the diffuse part down to sunset.

mod diffuse;
mod formulas;
mod refusals;
mod scale;

use super::figures::{self, Figures, Row};
use super::{Broken, Case};
use crate::light::DistantLight;
use crate::trial::draw::Draw;
use crate::trial::format::Format;
use crate::trial::radiometry::Formula;

/// Budgets of the formulas, then those of diffuse light.
pub const BUDGETS: [Row; FORMULAS + DIFFUSE] = {
    let mut rows = [("", [0.0; 7]); FORMULAS + DIFFUSE];
    let mut row = 0;
    while row < FORMULAS {
        rows[row] = formulas::BUDGETS[row];
        row += 1;
    }
    while row < FORMULAS + DIFFUSE {
        rows[row] = diffuse::BUDGETS[row - FORMULAS];
        row += 1;
    }
    rows
};

const FORMULAS: usize = formulas::BUDGETS.len();

const DIFFUSE: usize = diffuse::BUDGETS.len();

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let lamp = Lamp::new(draw);
    let case = lamp.case();
    figures::within(&case, &BUDGETS, figures_of(&lamp))?;
    lamp.format.visit(formulas::Laws(lamp))?;
    lamp.format.visit(refusals::Refusals(lamp))?;
    if lamp.lit { lamp.format.visit(diffuse::Laws(lamp)) } else { Ok(()) }
}

/// The errors of a case that are budgeted, for the search.
pub fn errors(draw: &mut Draw<'_>) -> (Format, Figures) {
    let lamp = Lamp::new(draw);
    (lamp.format, figures_of(&lamp))
}

fn figures_of(lamp: &Lamp) -> Figures {
    let [first, second, third, ..] = if lamp.lit { lamp.format.visit(diffuse::Errors(*lamp)) } else { [None; 8] };
    let shifted = |figure: Option<(usize, f64)>| figure.map(|(row, error)| (FORMULAS + row, error));
    let formula = lamp.format.visit(formulas::Errors(*lamp));
    [formula, shifted(first), shifted(second), shifted(third), None, None, None, None]
}

/// A formula's factors, and a disc over a plane.
#[derive(Clone, Copy, Debug)]
struct Lamp {
    format: Format,
    /// Whether all numbers are any bits.
    raw: bool,
    /// Whether diffuse light is asked for too.
    lit: bool,
    formula: Formula,
    /// Powers, areas, distances, as the formula has them.
    levels: [f64; 4],
    cosines: [f64; 2],
    light: DistantLight,
    n_dot_l: f64,
    albedo: f64,
}

impl Lamp {
    fn new(draw: &mut Draw<'_>) -> Self {
        let format = draw.format();
        let kind = draw.byte();
        let (raw, lit) = (kind.is_multiple_of(8), kind % 4 < 2);
        let formula = Formula::ALL[usize::from(draw.byte()) % Formula::ALL.len()];
        let light = draw.light();
        let levels = [(); 4].map(|()| if raw { draw.any(format) } else { level(draw, format) });
        let cosines = [(); 2].map(|()| if raw { draw.any(format) } else { cosine(draw) });
        let n_dot_l = if raw { draw.any(format) } else { elevation(draw, light.sin()) };
        let albedo = if raw { draw.any(format) } else { draw.fraction() };
        Self { format, raw, lit, formula, levels, cosines, light, n_dot_l, albedo }
    }

    fn case(&self) -> Case {
        let ([a, b, c, d], [cos, other]) = (self.levels, self.cosines);
        let (n_dot_l, albedo) = (self.n_dot_l, self.albedo);
        let light = [self.light.sin(), self.light.cos()];
        Case { format: self.format, inputs: [a, b, c, d, cos, other, light[0], light[1], n_dot_l, albedo] }
    }
}

/// What a format's exponents hold, subnormal numbers of f16 included; what lies about one; and one itself.
fn level(draw: &mut Draw<'_>, format: Format) -> f64 {
    let [least, most] = match format {
        Format::F64 => [1e-300, 1e300],
        Format::F32 | Format::Micromath => [1e-37, 1e38],
        Format::F16 => [6e-8, 65_504.0],
        Format::I2F14 | Format::I2F30 | Format::I16F16 => [2.4e-10, 4e9],
    };
    match draw.byte() % 8 {
        0 => draw.one_of([0.0, 1.0, least, most, 2.0, 0.5, 16_384.0, 65_504.0]),
        1 | 2 => draw.logarithmic(least, most),
        3 => draw.logarithmic(1e-4, 6e4),
        _ => draw.logarithmic(0.01, 100.0),
    }
}

/// Any cosine, also of what faces away or along, and those of tiny elevations.
fn cosine(draw: &mut Draw<'_>) -> f64 {
    match draw.byte() % 8 {
        0 => draw.one_of([1.0, 0.0, -1.0, -0.5]),
        1 => draw.logarithmic(1e-4, 1.0),
        _ => draw.fraction(),
    }
}

/// A sine of the elevation of the centre of a disc of sine `x`: any; where the horizon cuts the disc; beside the two
/// places where it touches it and where the centre sets; the last and the first slivers.
fn elevation(draw: &mut Draw<'_>, x: f64) -> f64 {
    match draw.byte() % 8 {
        0 => draw.between(-1.0, 1.0),
        1 => x * (draw.logarithmic(1e-7, 1.0) - 1.0),
        2 => x * (1.0 - draw.logarithmic(1e-7, 1.0)),
        3 => x * (1.0 + draw.logarithmic(1e-7, 1.0)),
        4 => -x * (1.0 + draw.logarithmic(1e-7, 1.0)),
        5 => x * draw.one_of([-1.0, 1.0, 0.0, 1e-3, -1e-3]),
        _ => x * draw.between(-1.0, 1.0),
    }
}
