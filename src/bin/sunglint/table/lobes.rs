//! The table of whole highlights.

use super::{align_right, table};
use crate::key::in_order;
use crate::number;
use crate::result::{LobeRow, Study};

/// The incidences that are shown, in degrees.
const INCIDENCES: [u32; 4] = [0, 45, 60, 80];

/// The worst relative L1 over all roughnesses, of each method under the first light.
pub fn all(study: &Study) -> String {
    let rows = &study.lobes;
    let Some(LobeRow { light, nodes, .. }) = rows.first() else { return String::new() };
    let mut table = table(&["highlight", "0 degrees", "45", "60", "80"]);
    for method in in_order(rows.iter().map(|row| &row.method)) {
        let of = |incidence: u32| {
            let here = |row: &&LobeRow| row.light == *light && row.method == method && row.incidence == incidence;
            let worst = rows.iter().filter(here).map(|row| row.relative_l1).fold(f64::NAN, f64::max);
            number::scientific(worst)
        };
        table.add_row([method.clone()].into_iter().chain(INCIDENCES.map(of)));
    }
    align_right(&mut table, 1..5);
    let quick = if study.quick { ", fewer than a full run takes" } else { "" };
    format!(
        "{light}: relative L1 of the whole highlight against the integral over the disc, worst over alpha;\n\
         {nodes} nodes in each piece of the integrals{quick}\n{}\n",
        table.trim_fmt()
    )
}
