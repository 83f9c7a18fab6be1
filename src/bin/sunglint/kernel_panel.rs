//! The panel of one building block in all formats.

use crate::author::{self, is_peer};
use crate::axis::{Costs, Price};
use crate::field::{Field, Point};
use crate::frame::Frame;
use crate::frontier::{self, Standing};
use crate::kernel::ULP;
use crate::mean::Mean;
use crate::number;
use crate::result::KernelRow;

/// One error of those of `rows` that have a cost; all are of one building block. Where each format has a unit of its
/// own, as a last place is, no format is more exact than another, and there is no frontier.
pub fn field(rows: &[&KernelRow], mean: Mean, costs: Costs) -> Field {
    let priced = costs.priced(rows, KernelRow::call);
    let standing =
        |(row, price): &(&KernelRow, Price)| Standing { cost: price.cost, error: error(row, mean), works: true };
    let on_frontier = frontier::members(&priced, |_| String::new(), standing);
    let comparable = rows.iter().all(|row| row.unit != ULP);
    let [name, unit] = rows.first().map_or([""; 2], |row| [&row.kernel, &row.unit]);
    Field {
        title: name.to_owned(),
        subtitle: format!("{} error", mean.adjective()),
        call: "call",
        axis: costs.axis,
        error_axis: if comparable { format!("error, {unit}") } else { format!("error, {unit} of each format") },
        per_cent: None,
        frame: Frame::new(
            costs.axis,
            priced.iter().map(|(_, price)| price.cost),
            priced.iter().map(|(row, _)| error(row, mean)),
        ),
        points: priced
            .iter()
            .zip(on_frontier)
            .map(|(priced, member)| point(priced, mean, member && comparable))
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

fn point((row, price): &(&KernelRow, Price), mean: Mean, on_frontier: bool) -> Point {
    let (label, unit) = (author::label(&row.format, row.by), &row.unit);
    let rms = match is_peer(row.by) {
        true => String::new(),
        false => format!(", rms {} {unit}", number::scientific(row.error_rms)),
    };
    Point {
        method: row.kernel.clone(),
        format: row.format.clone(),
        peer: is_peer(row.by),
        cost: price.cost,
        error: error(row, mean),
        fails: !row.error_max.is_finite(),
        on_frontier,
        label: if error(row, mean) == 0.0 { format!("{label} exact") } else { label },
        tooltip: format!(
            "{} in {}\nerror up to {} {unit}{rms}\n{}",
            row.kernel,
            author::said(&row.format, row.by),
            number::scientific(row.error_max),
            price.said,
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{self, HOST};

    #[test]
    fn last_places_of_different_formats_make_no_frontier() {
        let rows = [sample::kernel("f32", 1.0), sample::kernel("f16", 0.5)];
        let shown = |rows: &[KernelRow]| field(&rows.iter().collect::<Vec<_>>(), Mean::Max, HOST);
        assert!(shown(&rows).points.iter().any(|point| point.on_frontier));
        let rows = rows.map(|row| KernelRow { unit: ULP.to_owned(), ..row });
        assert!(!shown(&rows).points.iter().any(|point| point.on_frontier));
    }
}
