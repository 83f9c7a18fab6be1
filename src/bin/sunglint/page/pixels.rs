//! The sections of the page about lit pixels.

use sunglint::trial::chip::WIDTHS;

use super::{cells, costs, figures};
use crate::author::is_ours;
use crate::axis::Costs;
use crate::chart::{self, of_case};
use crate::key::{Key, in_order};
use crate::mean::Mean;
use crate::number;
use crate::pixel_error::{PixelError, PixelKind};
use crate::pixel_panel;
use crate::result::{PixelRow, Study};

const INTRODUCTION: &str = "<p>A lit pixel is the whole radiance that a surface sends to the viewer: diffuse part (albedo 0.2) and \
highlight (GGX, height-correlated Smith, Schlick with a reflectance of 0.04) under one light, over pixels from the middle of the \
highlight to ten of its widths beside it. Errors are relative to the pixel’s true value, or in steps of a display.</p>";

/// What the errors mean.
const ABOUT: &str = "<details><summary>What the errors mean</summary><p>The <strong>dashed lines</strong> in the \
charts of the total error, each with its method’s name at its right end, are model errors: the error of a method’s formula in \
exact arithmetic against the BRDF integrated over the disc. No mark can lie under its method’s line, and <strong>where a mark \
stands on its line, more precision buys nothing</strong>: only another method does. In the total, arithmetic and model error are \
combined as the root of the sum of their squares, and on its frontier stands only what gains in the first two digits.</p><p>What \
rounding the vectors into the format costs before any method has its turn is in neither, but in the column of rounded \
inputs; in I2F14 on a polish it is the greatest of the three. <strong>Steps</strong> are of sRGB on a display of 8 or 10 bits, \
where a white surface that faces the light is 1 and whatever is brighter is clipped; under half a step nothing is seen.</p>\
</details>";

/// Which calls the instructions are of.
fn counted() -> String {
    let [smoothest, .., roughest] = WIDTHS;
    format!(
        "a pixel (Scene::shade_channel, one light and one channel; the median of mirror rays outside the disc on \
         surfaces of alpha {smoothest} to {roughest} under the Sun, taken for each case)"
    )
}

/// The cases in the order of the rows.
pub fn cases(study: &Study) -> Vec<String> {
    in_order(study.pixels.iter().map(|row| &row.case))
}

/// A chart for each case, error, mean and cost; the script shows one at a time.
pub fn charts(study: &Study) -> String {
    let (key, cases, counted) = (chart::pixel_key(study), cases(study), counted());
    let calls: Vec<_> = study.pixels.iter().map(PixelRow::call).collect();
    let offered = Costs::offered(&study.chip, &calls);
    let errors = PixelKind::ALL.into_iter().flat_map(|kind| Mean::ALL.map(|mean| PixelError { kind, mean }));
    let errors: Vec<_> = errors.collect();
    // Charts that are alike follow each other, so that they pack well.
    let of_costs = |&costs| {
        let of_error = |&error: &PixelError| cases.iter().map(move |case| Shown { case, error, costs });
        errors.iter().flat_map(of_error).collect::<Vec<_>>()
    };
    let all: Vec<_> = offered.iter().flat_map(of_costs).collect();
    let choice = [
        cells::select("Light and roughness", "case", &cases),
        cells::radio("Error", "kind", &PixelKind::ALL.map(PixelKind::name)),
        cells::radio("Over the pixels", "mean", &Mean::ALL.map(Mean::name)),
        costs::choice(&offered),
    ];
    let figures = figures::shown(&all, |shown| shown.figure(study, &key, &counted));
    format!("{INTRODUCTION}\n{}{figures}{ABOUT}", cells::form(&choice.concat()))
}

/// What one chart shows.
struct Shown<'a> {
    case: &'a str,
    error: PixelError,
    costs: Costs<'a>,
}

impl Shown<'_> {
    fn figure(&self, study: &Study, key: &Key, counted: &str) -> String {
        let Self { case, error, costs } = *self;
        let rows = of_case(study.all_pixels(), case);
        let field = pixel_panel::field(&rows, &study.anchors, error, costs);
        let svg = chart::one_panel(&field, key, &chart::pixel_title(case, error, costs.axis));
        let (kind, mean) = (error.kind.name(), error.mean.name());
        let calls: Vec<_> = rows.iter().filter(|row| is_ours(row.by)).map(|row| row.call()).collect();
        let caption = format!("{case}: {mean} of the {}, {}", error.kind.said(), error.against());
        let caption = caption + &costs::caption(&costs, counted, &calls);
        figures::figure(&[("case", case), ("kind", kind), ("mean", mean), ("axis", costs.axis.name())], &caption, &svg)
    }
}

/// How many pixels were tried.
pub fn tried(study: &Study) -> String {
    let counts = study.pixels.first().map_or([0; 2], |row| [row.samples, row.model_samples]);
    let [arithmetic, model] = counts.map(number::count);
    format!("{arithmetic} random pixels for the arithmetic of each lit pixel and {model} for its model")
}
