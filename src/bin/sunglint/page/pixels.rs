//! The sections of the page about lit pixels.

use sunglint::trial::chip::WIDTHS;

use super::cells::{self, bits, cell, scientific, sortable, text};
use super::costs;
use crate::author::{self, is_ours};
use crate::axis::Costs;
use crate::chart::{self, of_case};
use crate::error_kind::ErrorKind;
use crate::key::in_order;
use crate::mean::Mean;
use crate::number;
use crate::pixel_error::PixelError;
use crate::pixel_panel;
use crate::result::{PixelRow, Study};

const INTRODUCTION: &str = "<p>A lit pixel is the whole radiance that a surface sends to the viewer: diffuse part (albedo 0.2) and \
highlight (GGX, height-correlated Smith, Schlick with a reflectance of 0.04) under one light. Errors are relative to the pixel’s \
true value, over pixels from the middle of the highlight to ten of its widths beside it. The <strong>dashed lines</strong> in the \
charts of the total error, each with its method’s name at its right end, are model errors: the error of a method’s formula in \
exact arithmetic against the BRDF integrated over the disc. No mark can lie under its method’s line, and <strong>where a mark \
stands on its line, more precision buys nothing</strong>: only \
another method does. None of these holds what rounding the \
vectors into the format costs before any method has its turn: the column of rounded inputs has it, and in I2F14 on a polish it \
is the greatest of the three. In the total, arithmetic and model error are \
combined as the root of the sum of their squares, and on its frontier stands only what gains in the first two digits.</p>\
<dl><dt>none (<code>PointGgx::none</code>)</dt><dd>GGX at the disc’s point nearest to the mirror ray: too bright, as the light’s energy is counted at every \
point.</dd>\
<dt>karis, karis/3 (<code>PointGgx::karis</code>, <code>karis_third</code>)</dt><dd>the same times (α/α′)², α′ = α + x/2 or α + x/3.</dd>\
<dt>exact_rp (<code>PointGgx::exact_rp</code>)</dt><dd>the same with the energy that the shape has for small angles.</dd>\
<dt>disc_ggx, disc_ggx dir (<code>DiscGgx::new</code>, <code>directional</code>)</dt><dd>GGX averaged over the disc in closed form, the disc in the half vectors taken for a circle \
or for an ellipse.</dd>\
<dt>PixelQ14 (<code>raw::PixelQ14</code>)</dt><dd>disc_ggx in I2F14 with code of its own, whose constants hold light, surface and \
illuminance.</dd>\
<dt>cone_ggx, cone_ggx shifted (<code>ConeGgx</code>, <code>ShiftedConeGgx</code>)</dt><dd>GGX integrated over the exact cone of half vectors, the rest of the BRDF taken at the disc’s centre, \
or between that and the point nearest to the mirror ray. The root of a cubic is found by three steps; what they leave, which is \
below 1e-8 of a pixel, counts as arithmetic error, in f64 too.</dd></dl>";

/// Which calls the instructions are of.
fn counted() -> String {
    let [smoothest, .., roughest] = WIDTHS;
    format!(
        "a pixel (Scene::shade_channel, one light and one channel; the median of mirror rays outside the disc on \
         surfaces of alpha {smoothest} to {roughest} under the Sun, taken for each case)"
    )
}

const COLUMNS: [&str; 16] = [
    "case",
    "method",
    "format",
    "cost",
    "cost quartiles",
    "total rms",
    "total max",
    "arithmetic rms",
    "arithmetic max",
    "model rms",
    "model max",
    "rounded inputs, rms",
    "frontier",
    "worst normal, raw bits",
    "worst viewer, raw bits",
    "worst light, raw bits",
];

fn cases(study: &Study) -> Vec<String> {
    in_order(study.pixels.iter().map(|row| &row.case))
}

/// A chart for each case, error, mean and cost; the script shows one at a time.
pub fn charts(study: &Study) -> String {
    let (key, cases) = (chart::pixel_key(study), cases(study));
    let calls: Vec<_> = study.pixels.iter().map(PixelRow::call).collect();
    let offered = Costs::offered(&study.chip, &calls);
    let counted = counted();
    let figure = |case: &String, error: PixelError, costs: Costs| {
        let rows = of_case(study.all_pixels(), case);
        let field = pixel_panel::field(&rows, error, costs);
        let svg = chart::one_panel(&field, &key, &chart::pixel_title(case, error, costs.axis));
        let (kind, mean) = (error.kind.name(), error.mean.name());
        let calls: Vec<_> = rows.iter().filter(|row| is_ours(row.by)).map(|row| row.call()).collect();
        let caption = format!("{case}: {mean} of the {kind} error {}", error.against());
        let caption = caption + &costs::caption(&costs, &counted, &calls);
        cells::figure(&[("case", case), ("kind", kind), ("mean", mean), ("axis", costs.axis.name())], &caption, &svg)
    };
    let errors = [ErrorKind::Total, ErrorKind::Arithmetic]
        .into_iter()
        .flat_map(|kind| Mean::ALL.map(|mean| PixelError { kind, mean }));
    let of_case = |case| {
        let errors = offered.iter().flat_map(|costs| errors.clone().map(|error| (error, *costs)));
        errors.map(|(error, costs)| figure(case, error, costs)).collect::<String>()
    };
    let figures: String = cases.iter().map(of_case).collect();
    let choice = [
        cells::select("Light and roughness", "case", &cases),
        cells::radio("Error", "kind", &[ErrorKind::Total, ErrorKind::Arithmetic].map(ErrorKind::name)),
        cells::radio("Over the pixels", "mean", &Mean::ALL.map(Mean::name)),
        costs::choice(&offered),
    ];
    format!("{INTRODUCTION}\n{}{figures}", cells::form(&choice.concat()))
}

/// Every row, to be sorted by any column.
pub fn all(study: &Study) -> String {
    let line = |row: &PixelRow| {
        let class = if row.failure.is_some() { " class=\"fails\"" } else { "" };
        format!("<tr{}{class}>{}</tr>\n", cells::data(&[("case", &row.case)]), line(row))
    };
    let lines: String = study.all_pixels().map(line).collect();
    let choice = cells::select("Light and roughness", "case", &[cases(study), vec![cells::ALL.to_owned()]].concat());
    format!("{}{}", cells::form(&choice), sortable("lit-pixels", &COLUMNS, &lines))
}

fn line(row: &PixelRow) -> String {
    let quartiles = format!("{} to {}", number::cost(row.cost_low), number::cost(row.cost_high));
    let frontier = if row.frontier { "yes" } else { "no" };
    [
        text(&row.case),
        text(&row.method),
        text(&author::said(&row.format, row.by)),
        cell(row.cost, &number::cost(row.cost)),
        cell(row.cost_low, &quartiles),
        scientific(row.total_rms),
        scientific(row.total_max),
        scientific(row.error_rms),
        scientific(row.error_max),
        scientific(row.model_rms),
        scientific(row.model_max),
        scientific(row.input_rms),
        text(row.failure.as_deref().unwrap_or(frontier)),
        bits(&row.worst_n),
        bits(&row.worst_v),
        bits(&row.worst_l),
    ]
    .concat()
}

/// How many pixels were tried.
pub fn tried(study: &Study) -> String {
    let counts = study.pixels.first().map_or([0; 2], |row| [row.samples, row.model_samples]);
    let [arithmetic, model] = counts.map(number::count);
    format!("{arithmetic} random pixels for the arithmetic of each lit pixel and {model} for its model")
}
