//! Errors and costs of lit pixels by `raw::PixelQ14`, which stand beside those of `disc_ggx` in I2F14.

use indicatif::ProgressBar;
use sunglint::Real;
use sunglint::fixed::types::I2F14;
use sunglint::material::{Material, Surface};
use sunglint::raw::{PixelQ14, SphereQ14};
use sunglint::scene::Channel;
use sunglint::trial::gloss::{ALBEDO, Case, F0};
use sunglint::trial::{Format, Light, Shading};

use crate::author::PIXEL_Q14;
use crate::clock::{self, Contender, chain};
use crate::directions;
use crate::options::Options;
use crate::pixels::{self, Judged, Truths};
use crate::result::PixelRow;
use crate::workers;

/// Pi in Q16, under which a white surface is white.
const PI: u32 = 205_887;

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    pixels::wanted(options).len() * (1 + pixels::rounds(options))
}

/// The errors in each case of `rows`, whose models are those of the same formula.
pub fn errors(rows: &[PixelRow], truths: &Truths, options: &Options, progress: &ProgressBar) -> Vec<PixelRow> {
    let rows = workers::map(&pixels::wanted(options), progress, |case| {
        progress.set_message(format!("{}, {PIXEL_Q14}", case.name));
        let same = |row: &&PixelRow| {
            [&*row.case, &*row.method, &*row.format] == [case.name, Shading::DiscGgx.name(), Format::I2F14.name()]
        };
        rows.iter().find(same).map(|row| judged(case, row, truths, options))
    });
    rows.into_iter().flatten().collect()
}

/// The row of the generic pixel, with the arithmetic of this one. Roundings of the inputs are the same.
fn judged(case: &Case, generic: &PixelRow, truths: &Truths, options: &Options) -> PixelRow {
    let judged = Judged::of(Shading::DiscGgx, case, options, |[n, v, l]: [_; 3]| {
        let level = pixel(case, l).map(|pixel| pixel.shade_channel(bits(n), bits(v), Channel::Green));
        level.map_or(f64::NAN, |level| f64::from(level) * core::f64::consts::PI / f64::from(PI))
    });
    // The command would compute the generic pixel.
    let row = PixelRow { by: PIXEL_Q14, repro: String::new(), ..generic.clone() };
    judged.row(row, Format::I2F14, truths.levels(case, Format::I2F14))
}

/// The surface of `case` under its light at `l`; nothing where `l` is no direction.
fn pixel(case: &Case, l: [I2F14; 3]) -> Option<PixelQ14> {
    let surface = Surface::of(&Material::new([ALBEDO; 3], case.alpha, [F0; 3]).ok()?);
    PixelQ14::new(bits(l), &SphereQ14::new(&case.light), &surface, [PI; 3]).ok()
}

fn q14(lane: f64) -> I2F14 {
    I2F14::from_f64(lane)
}

fn bits(v: [I2F14; 3]) -> [i16; 3] {
    v.map(I2F14::to_bits)
}

/// Adds the costs to `rows`, which are those of [`errors`].
pub fn add_costs(rows: &mut [PixelRow], options: &Options, progress: &ProgressBar) {
    for (case, row) in pixels::wanted(options).iter().zip(rows) {
        progress.set_message(format!("timing, {}, {PIXEL_Q14}", case.name));
        let baseline = directions::baseline(&Light { name: case.name, light: case.light });
        let costs = clock::costs(&[contender(case)], &baseline, pixels::rounds(options), progress);
        (row.cost, row.cost_low, row.cost_high) = costs[0].figures();
    }
}

fn contender(case: &Case) -> Contender {
    Contender::new(inputs(), calls(case), |&[n, _]| n)
}

/// Its calls that wait for each other.
pub fn waiting(case: &Case) -> Contender {
    let levels: Vec<_> = inputs().into_iter().map(|[[x, ..], _]| u32::from(x.unsigned_abs())).collect();
    let read = |&level: &u32| level.into();
    Contender {
        inputs: levels.len(),
        call: chain(inputs(), calls(case), read),
        empty: chain(levels, |&level| level, read),
    }
}

/// Normal and viewer.
fn inputs() -> Vec<[[i16; 3]; 2]> {
    pixels::ball().map(|pixel| pixel.map(|vector| bits(vector.map(q14)))).collect()
}

fn calls(case: &Case) -> impl Fn(&[[i16; 3]; 2]) -> u32 + use<> {
    let pixel = pixel(case, pixels::ball_light().map(q14)).expect("a unit vector");
    move |&[n, v]| pixel.shade_channel(n, v, Channel::Green)
}
