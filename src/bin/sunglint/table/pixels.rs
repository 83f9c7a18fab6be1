//! The tables of lit pixels.

use super::{add_group, align_right, table};
use crate::chart::{of_case, pixel_key};
use crate::key::in_order;
use crate::number;
use crate::result::{PixelRow, Study};

/// Total error in every case, and cost in the first one.
pub fn all(study: &Study) -> String {
    let key = pixel_key(study);
    let cases = in_order(study.pixels.iter().map(|row| &row.case));
    let mut header = vec!["lit pixel", "model"];
    header.extend(key.formats.iter().map(String::as_str));
    let mut errors = table(&header);
    for case in &cases {
        let rows = of_case(&study.pixels, case);
        let methods = key.methods.iter().map(|method| {
            let model = |row: &PixelRow| number::scientific(row.model_rms);
            [cell(&rows, method, None, model)].into_iter().chain(
                key.formats.iter().map(|format| cell(&rows, method, Some(format), |row| shown(row, row.total_rms))),
            )
        });
        let lines =
            key.methods.iter().zip(methods).map(|(method, cells)| [method.clone()].into_iter().chain(cells).collect());
        add_group(&mut errors, [vec![format!("{case}:")]].into_iter().chain(lines));
    }
    align_right(&mut errors, 1..header.len());
    format!(
        "Lit pixels: rms error relative to the pixel, of the model alone and of model and arithmetic\n{}\n\n{}\n",
        errors.trim_fmt(),
        costs(study, &cases[0])
    )
}

/// Cost of each method and format in one case.
fn costs(study: &Study, case: &str) -> String {
    let key = pixel_key(study);
    let rows = of_case(&study.pixels, case);
    let mut header = vec!["lit pixel"];
    header.extend(key.formats.iter().map(String::as_str));
    let mut costs = table(&header);
    for method in &key.methods {
        let cells = key.formats.iter().map(|format| cell(&rows, method, Some(format), |row| number::cost(row.cost)));
        costs.add_row([method.clone()].into_iter().chain(cells));
    }
    align_right(&mut costs, 1..header.len());
    format!("{case}: cost of a pixel in calls of f32 factored\n{}", costs.trim_fmt())
}

/// What `shown` makes of the row of `method` and of `format`, of any if there is none.
fn cell(rows: &[&PixelRow], method: &str, format: Option<&String>, shown: impl Fn(&PixelRow) -> String) -> String {
    let is = |row: &&&PixelRow| row.method == method && format.is_none_or(|format| row.format == *format);
    rows.iter().find(is).map_or_else(String::new, |row| shown(row))
}

fn shown(row: &PixelRow, error: f64) -> String {
    row.failure.clone().unwrap_or_else(|| number::scientific(error))
}
