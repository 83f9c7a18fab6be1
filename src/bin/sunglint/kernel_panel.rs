//! The panel of one building block in all formats.

use crate::author::{self, is_peer};
use crate::axis::{Costs, Price};
use crate::field::{Field, Point};
use crate::frame::Frame;
use crate::frontier::{self, Standing};
use crate::kernel::ULP;
use crate::mean::Mean;
use crate::required;
use crate::result::KernelRow;
use crate::said;

/// One error of those of `rows` that have a cost; all are of one building block. Where each format has a unit of its
/// own, as a last place is, no format is more exact than another, and there is no frontier.
pub fn field(rows: &[&KernelRow], mean: Mean, costs: Costs) -> Field {
    let priced = costs.priced(rows, KernelRow::call);
    let standing = |(row, price): &(&KernelRow, Price)| Standing {
        cost: price.cost,
        error: error(row, mean),
        works: failure(row).is_none(),
    };
    let on_frontier = frontier::members(&priced, |_| String::new(), standing);
    let comparable = rows.iter().all(|row| row.unit != ULP);
    let [name, unit] = rows.first().map_or([""; 2], |row| [&row.kernel, &row.unit]);
    let lines = if comparable || name.contains("root") { required::of_kernel(name, unit) } else { Vec::new() };
    let errors = priced.iter().map(|(row, _)| error(row, mean)).chain(lines.iter().map(|line| line.error));
    let frame = Frame::new(costs.axis, priced.iter().map(|(_, price)| price.cost), errors);
    Field {
        title: name.to_owned(),
        subtitle: format!("{} error", mean.adjective()),
        call: "call",
        axis: costs.axis,
        error_axis: if comparable { format!("error, {unit}") } else { format!("error, {unit} of each format") },
        per_cent: None,
        frame: if lines.is_empty() { frame } else { frame.with_lane() },
        points: priced
            .iter()
            .zip(on_frontier)
            .map(|(priced, member)| point(priced, mean, member && comparable, costs))
            .collect(),
        anchors: Vec::new(),
        lines,
    }
}

fn error(row: &KernelRow, mean: Mean) -> f64 {
    match mean {
        Mean::Rms => row.error_rms,
        Mean::Max => row.error_max,
    }
}

/// How it fails, if it is a peer that does.
fn failure(row: &KernelRow) -> Option<&'static str> {
    author::failure_of_peer(&row.kernel, &row.format, row.by)
}

fn point((row, price): &(&KernelRow, Price), mean: Mean, on_frontier: bool, costs: Costs) -> Point {
    let (label, failure) = (author::label(&row.format, row.by), failure(row));
    Point {
        method: row.kernel.clone(),
        format: row.format.clone(),
        peer: is_peer(row.by),
        cost: price.cost,
        error: error(row, mean),
        fails: failure.is_some() || !row.error_max.is_finite(),
        on_frontier,
        label: match failure {
            Some(failure) => format!("{label} {failure}"),
            None if error(row, mean) == 0.0 => format!("{label} exact"),
            None => label,
        },
        bound: (!is_peer(row.by)).then_some(row.bound),
        tooltip: said::of_kernel(row, failure, costs.chip),
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

    #[test]
    fn a_peer_whose_sums_wrap_fails_and_is_on_no_frontier() {
        let peer = KernelRow { by: "fixed 1.31.0", cost: 0.1, ..sample::kernel("I2F30", 1e-12) };
        let rows = [sample::kernel("f32", 1.0), peer];
        let field = field(&rows.iter().collect::<Vec<_>>(), Mean::Max, HOST);
        let failing = field.points.iter().find(|point| point.peer).expect("the peer");
        assert!(failing.fails && !failing.on_frontier && field.points[0].on_frontier);
        assert_eq!(failing.label, "I2F30 fixed 1.31.0 wraps");
    }
}
