//! What a chart says when one points at a place.

use std::iter;

use kuva::render::render::Primitive;

use super::{Chart, OPPOSITE};
use crate::curves::CurveRow;
use crate::number;
use crate::panel;
use crate::sheet::Sheet;

impl Chart<'_> {
    /// An unpainted column about each place, which says what was measured there.
    pub(super) fn columns(&self, sheet: &Sheet) -> Vec<Primitive> {
        let centres: Vec<_> = self.places.iter().map(|at| sheet.pixels((at.log10(), 0.0)).0).collect();
        let edge = |pair: &[f64]| f64::midpoint(pair[0], pair[1]);
        let ends = [sheet.area.x.0, sheet.pixels((self.frame.x.1, 0.0)).0];
        let edges: Vec<_> = iter::once(ends[0]).chain(centres.windows(2).map(edge)).chain([ends[1]]).collect();
        let column = |(at, sides): (&f64, &[f64])| {
            let title = Some(self.said(*at));
            let start = Primitive::GroupStart { transform: None, title, extra_attrs: None };
            let area = Primitive::Rect {
                x: sides[0],
                y: sheet.area.y.0,
                width: (sides[1] - sides[0]).max(0.0),
                height: sheet.area.y.1 - sheet.area.y.0,
                fill: panel::INK.into(),
                stroke: None,
                stroke_width: None,
                opacity: Some(0.0),
            };
            [start, area, Primitive::GroupEnd]
        };
        self.places.iter().zip(edges.windows(2)).flat_map(column).collect()
    }

    fn said(&self, at: f64) -> String {
        let here = || self.rows.iter().filter(|row| row.at == at);
        let radii = here().next().filter(|_| self.along() == "angle").map(|row| at / row.ratio.asin());
        let radii = radii.map_or_else(String::new, |radii| format!(", {} radii", number::scientific(radii)));
        let error = |row: &&CurveRow| format!("{} {}", row.format, number::scientific(row.error_max));
        let model = self.model().into_iter().find(|(place, _)| *place == at);
        let model = model.map(|(_, model)| format!("model {}", number::scientific(model)));
        let head = format!("{} {}{radii}", unit(self.along()), number::scientific(at));
        let lines: Vec<_> = iter::once(head).chain(here().map(error)).chain(model).collect();
        lines.join("\n")
    }
}

/// How a place on it is called.
fn unit(along: &str) -> &'static str {
    match along {
        "ratio" => "ratio",
        OPPOSITE => "rad from the opposite:",
        _ => "angle in rad",
    }
}
