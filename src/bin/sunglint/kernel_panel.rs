//! The panel of one building block in all formats.

use crate::field::{Field, Point};
use crate::frame::Frame;
use crate::frontier::{self, Standing};
use crate::kernel::ULP;
use crate::mean::Mean;
use crate::number;
use crate::result::KernelRow;

/// One error of `rows`, which are all of one building block. Where each format has a unit of its own, as a last place
/// is, no format is more exact than another, and there is no frontier.
pub fn field(rows: &[&KernelRow], mean: Mean) -> Field {
    let standing = |row: &&KernelRow| Standing { cost: row.cost, error: error(row, mean), works: true };
    let on_frontier = frontier::members(rows, |_| String::new(), standing);
    let comparable = rows.iter().all(|row| row.unit != ULP);
    let [name, unit] = rows.first().map_or([""; 2], |row| [&row.kernel, &row.unit]);
    Field {
        title: name.to_owned(),
        subtitle: format!("{} error", mean.adjective()),
        call: "call",
        error_axis: if comparable { format!("error, {unit}") } else { format!("error, {unit} of each format") },
        per_cent: None,
        frame: Frame::new(rows.iter().map(|row| row.cost), rows.iter().map(|row| error(row, mean))),
        points: rows
            .iter()
            .zip(on_frontier)
            .map(|(row, on_frontier)| point(row, mean, on_frontier && comparable))
            .collect(),
        lines: Vec::new(),
    }
}

fn error(row: &KernelRow, mean: Mean) -> f64 {
    match mean {
        Mean::Rms => row.error_rms,
        Mean::Max => row.error_max,
    }
}

fn point(row: &KernelRow, mean: Mean, on_frontier: bool) -> Point {
    Point {
        method: row.kernel.clone(),
        format: row.format.clone(),
        cost: row.cost,
        error: error(row, mean),
        fails: !row.error_max.is_finite(),
        on_frontier,
        label: if error(row, mean) == 0.0 { format!("{} exact", row.format) } else { row.format.clone() },
        tooltip: format!(
            "{} in {}\nerror up to {} {unit}, rms {} {unit}\ncost {}",
            row.kernel,
            row.format,
            number::scientific(row.error_max),
            number::scientific(row.error_rms),
            number::quartiles([row.cost, row.cost_low, row.cost_high]),
            unit = row.unit,
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn last_places_of_different_formats_make_no_frontier() {
        let rows = [sample::kernel("f32", 1.0), sample::kernel("f16", 0.5)];
        let shown = |rows: &[KernelRow]| field(&rows.iter().collect::<Vec<_>>(), Mean::Max);
        assert!(shown(&rows).points.iter().any(|point| point.on_frontier));
        let rows = rows.map(|row| KernelRow { unit: ULP.to_owned(), ..row });
        assert!(!shown(&rows).points.iter().any(|point| point.on_frontier));
    }
}
