//! Lines of the table of minimal firmware.

use std::fmt;

use crate::committed::{self, is_off};
use crate::image::Cost;

/// In the order of the table's columns, and of the targets.
pub const CORES: [&str; 4] = ["M0+", "M3", "M4F", "riscv32imc"];

/// Of one core.
const FIGURES: [&str; 3] = ["text", "rodata", "stack"];

/// An image's figures.
pub struct Line {
    /// Function, format and author.
    pub key: String,
    /// Text, rodata and stack on each core; none where it was not measured.
    pub costs: [Option<Cost>; 4],
}

impl committed::Line for Line {
    const HEADER: &str = "function,format,by,m0_text,m0_rodata,m0_stack,m3_text,m3_rodata,m3_stack,\
        m4_text,m4_rodata,m4_stack,rv_text,rv_rodata,rv_stack";

    fn key(&self) -> String {
        self.key.clone()
    }

    fn parse(text: &str) -> Option<Self> {
        let columns: Vec<_> = text.split(',').collect();
        if columns.len() != 15 {
            return None;
        }
        let mut costs = [None; 4];
        for (core, cost) in costs.iter_mut().enumerate() {
            let figures: Result<Vec<_>, _> =
                columns[3 + 3 * core..6 + 3 * core].iter().map(|text| text.parse()).collect();
            *cost = figures.ok().and_then(|figures| figures.try_into().ok());
        }
        Some(Line { key: columns[..3].join(","), costs })
    }

    /// Figures that are off from those `before` by more than 2 % and by more than the 4 that a literal takes.
    fn against(&self, before: &Self) -> Vec<String> {
        let mut complaints = Vec::new();
        for (core, name) in CORES.into_iter().enumerate() {
            // What this machine cannot run is not compared.
            let Some(now) = self.costs[core] else { continue };
            let Some(was) = before.costs[core] else {
                complaints.push(format!("{} on {name} has no figures in the table", self.key));
                continue;
            };
            for (figure, (now, was)) in FIGURES.into_iter().zip(now.into_iter().zip(was)) {
                if is_off(now, was, 4) {
                    complaints.push(format!("{} on {name}: {figure} {now}, in the table {was}", self.key));
                }
            }
        }
        complaints
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.key)?;
        self.costs.iter().flatten().flatten().try_for_each(|figure| write!(f, ",{figure}"))
    }
}
