//! A chart of errors along an angle or a ratio: a line for each number format, on logarithmic axes.
//!
//! A page holds dozens of these, so each is a few paths, and what it says when pointed at is said once for each place.

mod columns;

use std::iter;

use kuva::prelude::{Layout, LinePlot, LineStyle, Plot, ShadedRegion, render_multiple};
use kuva::render::render::{PathData, Primitive};

use crate::axis::Axis;
use crate::chart;
use crate::curves::CurveRow;
use crate::frame::Frame;
use crate::key::{Key, in_order};
use crate::labels::{Label, width};
use crate::lettering;
use crate::lines::{self, LEAD, NARROW};
use crate::number;
use crate::panel::{self, LINE, PEER, STEP};
use crate::sheet::Sheet;

const SIZE: (f64, f64) = (580.0, 380.0);

/// Dashes of the model’s error.
const DASHES: &str = "5 3";

/// Half of a cross, in pixels.
const CROSS: f64 = 2.5;

/// The name of what varies from the opposite of the light.
const OPPOSITE: &str = "to opposite";

/// Chart of `rows`, which are all of one method along one thing; `name` is for screen readers.
pub fn svg(rows: &[&CurveRow], key: &Key, name: &str) -> String {
    let chart = Chart::new(rows, key);
    let layout = chart.layout();
    let sheet = Sheet::new(&chart.frame, &layout);
    let mut scene = render_multiple(chart.plots(&sheet), layout);
    scene.elements.extend(chart.formats.iter().filter_map(|format| chart.crosses(format, &sheet)));
    scene.elements.extend(chart.columns(&sheet));
    chart::svg(scene, name)
}

struct Chart<'a> {
    rows: &'a [&'a CurveRow],
    key: &'a Key,
    formats: Vec<String>,
    /// Where something was measured, from the least to the greatest.
    places: Vec<f64>,
    frame: Frame,
}

impl<'a> Chart<'a> {
    fn new(rows: &'a [&'a CurveRow], key: &'a Key) -> Self {
        let mut places: Vec<_> = rows.iter().map(|row| row.at).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let (least, most) = (places.first().copied().unwrap_or(1e-6), places.last().copied().unwrap_or(1.0));
        let models = rows.iter().map(|row| row.model_max).filter(|model| model.is_finite());
        let errors: Vec<_> = rows.iter().map(|row| row.error_max).chain(models).collect();
        let frame = Frame::new(Axis::Host, iter::empty(), errors.into_iter());
        let across = ((least.log10() + 0.2).floor(), most.log10().max((most.log10() - 0.1).round()));
        Self {
            rows,
            key,
            formats: in_order(rows.iter().map(|row| &row.format)),
            places,
            frame: frame.with_costs(across).with_lane(),
        }
    }

    fn along(&self) -> &'static str {
        self.rows.first().map_or("", |row| row.along)
    }

    fn is_direction(&self) -> bool {
        self.rows.first().is_some_and(|row| row.subject == "direction")
    }

    fn of<'b>(&'b self, format: &'b str) -> impl Iterator<Item = &'a CurveRow> + 'b {
        self.places
            .iter()
            .flat_map(move |&at| self.rows.iter().filter(move |row| row.at == at && row.format == format))
            .copied()
    }

    /// The model's error at each place, which is the same in every format.
    fn model(&self) -> Vec<(f64, f64)> {
        let at = |&place: &f64| {
            let models = self.rows.iter().filter(|row| row.at == place).map(|row| row.model_max);
            (place, models.fold(f64::NAN, f64::max))
        };
        let model: Vec<_> = self.places.iter().map(at).collect();
        if model.iter().any(|(_, error)| *error > 0.0) { model } else { Vec::new() }
    }

    fn layout(&self) -> Layout {
        let Frame { x, y, right, top, .. } = self.frame;
        let steps = |powers: f64| if powers > 8.0 { 2.0 } else { 1.0 };
        let powers = top - y.0;
        let written =
            move |at: f64| if at < x.1 + 1e-6 { number::power_of_ten(at.round() as i32) } else { String::new() };
        let layout = Layout::new((x.0, right), (y.0, top))
            .with_width(SIZE.0)
            .with_height(SIZE.1)
            .with_x_label(across(self.along()))
            .with_y_label(if self.is_direction() {
                "worst arithmetic error, rad"
            } else {
                "worst arithmetic error, relative"
            })
            .with_x_axis_min(x.0)
            .with_x_axis_max(right)
            .with_x_tick_step(1.0)
            .with_x_tick_format(panel::custom(written))
            .with_y_axis_min(y.0)
            .with_y_axis_max(top)
            .with_y_tick_step(steps(powers))
            .with_y_tick_format(panel::powers_up_to(y.1))
            .with_ticks((powers / steps(powers)).round() as usize)
            .with_shaded_region(ShadedRegion::horizontal(y.1, top).with_color(PEER));
        panel::dressed(layout)
    }

    fn plots(&self, sheet: &Sheet) -> Vec<Plot> {
        let mut plots: Vec<_> = self.radius().into_iter().map(Plot::Line).collect();
        let model = self.model();
        plots.extend(
            self.pieces(&model)
                .map(|piece| Plot::Line(line(piece, STEP, 1.4).with_line_style(LineStyle::Custom(DASHES.to_owned())))),
        );
        let mut named: Vec<_> = model.last().map(|end| ("model".to_owned(), STEP, *end)).into_iter().collect();
        for format in &self.formats {
            let points: Vec<_> = self.of(format).map(|row| (row.at, row.error_max)).collect();
            let colour = self.key.colour(format);
            plots.extend(self.pieces(&points).map(|piece| Plot::Line(line(piece, colour, 1.5))));
            named.extend(points.last().map(|end| (format.clone(), colour, *end)));
        }
        plots.extend(self.names(named, sheet));
        plots
    }

    /// What lies between places without a number.
    fn pieces(&self, points: &[(f64, f64)]) -> impl Iterator<Item = Vec<(f64, f64)>> + use<> {
        let frame = self.frame;
        let place = move |&(at, error): &(f64, f64)| (at.log10(), frame.up(error));
        let pieces = points.split(|(_, error)| !error.is_finite()).map(|piece| piece.iter().map(place).collect());
        let pieces: Vec<Vec<_>> = pieces.filter(|piece: &Vec<_>| !piece.is_empty()).collect();
        pieces.into_iter().map(|piece| match piece[..] {
            // A lone point is a short line.
            [(x, y)] => vec![(x - 0.03, y), (x + 0.03, y)],
            _ => piece,
        })
    }

    /// The disc's edge, and errors as large as the disc's radius.
    fn radius(&self) -> Vec<LinePlot> {
        let Frame { x, y, .. } = self.frame;
        let thin = |points: Vec<(f64, f64)>| line(points, LINE, 0.8);
        let inside = |value: f64, (low, high): (f64, f64)| (low..=high).contains(&value);
        let Some(radius) = self.rows.first().map(|row| row.ratio.asin().log10()) else { return Vec::new() };
        let mut lines = Vec::new();
        match self.along() {
            "ratio" if self.is_direction() => {
                let sizes = self.places.iter().map(|ratio| (ratio.log10(), ratio.asin().log10()));
                lines.push(thin(sizes.filter(|(_, size)| inside(*size, y)).collect()));
            }
            "ratio" => {}
            along => {
                if along != OPPOSITE && inside(radius, x) {
                    lines.push(thin(vec![(radius, y.0), (radius, y.1)]));
                }
                if self.is_direction() && inside(radius, y) {
                    lines.push(thin(vec![(x.0, radius), (x.1, radius)]));
                }
            }
        }
        lines
    }

    /// A name at the right for each line, apart from each other, each at the end of a leader in its line's colour.
    fn names(&self, mut named: Vec<(String, &'static str, (f64, f64))>, sheet: &Sheet) -> Vec<Plot> {
        let end = |(at, error): (f64, f64)| sheet.pixels((at.log10(), self.frame.up(error)));
        named.sort_by(|a, b| end(a.2).1.total_cmp(&end(b.2).1));
        let heights: Vec<_> = named.iter().map(|(.., at)| end(*at).1).collect();
        let start = sheet.pixels((self.frame.x.1, 0.0)).0;
        let mut labels = Vec::new();
        let mut plots = Vec::new();
        for ((text, colour, at), height) in named.iter().zip(lines::apart(&heights, 12.5, sheet.area.y)) {
            let mark = end(*at);
            let foot = (start + LEAD - 3.0, height);
            plots.push(Plot::Line(line(vec![sheet.data(mark), sheet.data(foot)], colour, 1.0)));
            let middle = start + LEAD + NARROW * width(text) / 2.0;
            labels.push(Label { text: text.clone(), at: (middle, height), mark });
        }
        plots.push(Plot::Scatter(lettering::texts(&labels, sheet)));
        plots
    }

    /// Crosses in the strip, at a height of its own, where `format` gives no number.
    fn crosses(&self, format: &str, sheet: &Sheet) -> Option<Primitive> {
        let order = self.formats.iter().position(|other| other == format)?;
        let part = (order as f64 + 0.5) / self.formats.len() as f64;
        let height = self.frame.y.1 + part * (self.frame.top - self.frame.y.1);
        let cross = |row: &CurveRow| {
            let (x, y) = sheet.pixels((row.at.log10(), height));
            let [left, top, side] = [x - CROSS, y - CROSS, 2.0 * CROSS];
            format!("M{left:.1} {top:.1}l{side} {side}m0-{side}l-{side} {side}")
        };
        let d: String = self.of(format).filter(|row| !row.error_max.is_finite()).map(cross).collect();
        let path = PathData {
            d,
            fill: None,
            stroke: self.key.colour(format).into(),
            stroke_width: 1.4,
            opacity: None,
            stroke_dasharray: None,
        };
        (!path.d.is_empty()).then(|| Primitive::Path(Box::new(path)))
    }
}

fn line(points: Vec<(f64, f64)>, colour: &str, stroke: f64) -> LinePlot {
    LinePlot::new().with_data(points).with_color(colour).with_stroke_width(stroke)
}

/// What stands along the lower axis.
fn across(along: &str) -> &'static str {
    match along {
        "ratio" => "radius over distance of the light",
        OPPOSITE => "angle between mirror ray and the light’s opposite, rad",
        _ => "angle between mirror ray and light, rad",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn drawn(rows: &[CurveRow]) -> String {
        let rows: Vec<_> = rows.iter().collect();
        let key = Key::new(rows.iter().map(|row| [&row.method, &row.format]));
        svg(&rows, &key, "<name>")
    }

    #[test]
    fn every_format_has_a_line_in_its_colour_and_a_name() {
        let svg = drawn(&sample::curves("cap", "angle"));
        for (format, colour) in [("f64", "#000000"), ("f16", "#d55e00")] {
            let paths = svg.matches(&format!("stroke=\"{colour}\"")).count();
            assert!(paths >= 2 && svg.contains(&format!(">{format}</text>")), "{format}: {paths}");
        }
        assert!(svg.contains("&lt;name&gt;") && !svg.contains("<name>"));
    }

    #[test]
    fn what_is_no_number_is_a_cross_and_a_gap() {
        let mut rows = sample::curves("cap", "angle");
        let whole = drawn(&rows).matches("<path").count();
        let middle = rows.len() / 4;
        (rows[middle].error_max, rows[middle + 1].error_max) = (f64::INFINITY, f64::NAN);
        let svg = drawn(&rows);
        // The line is in two pieces, and a path holds both crosses.
        assert_eq!(svg.matches("<path").count(), whole + 2);
        assert_eq!(svg.matches("m0-5l-5 5").count(), 2);
        assert!(!svg.contains("\"inf") && !svg.contains("\"NaN") && !svg.contains(" NaN "), "no place");
        assert!(svg.contains("f64 infinite\n") && svg.contains("f64 NaN\n"), "said when pointed at");
    }

    #[test]
    fn each_place_says_all_its_figures_once() {
        let rows = sample::curves("factored", "ratio");
        let svg = drawn(&rows);
        let places = rows.len() / 2;
        assert_eq!(svg.matches("class=\"mark\"").count(), places);
        assert_eq!(svg.matches("\nmodel 0.10").count(), places);
        assert!(svg.contains("<title>ratio 1.0e-6\nf64 1.0e-16\nf16 1.0e-3\nmodel 0.10</title>"));
    }

    #[test]
    fn a_model_without_error_has_no_line() {
        let rows = sample::curves("cap", "ratio").into_iter().map(|row| CurveRow { model_max: 0.0, ..row });
        assert!(!drawn(&rows.collect::<Vec<_>>()).contains("model"));
    }

    #[test]
    fn charts_stay_small() {
        let formats = ["f64", "f32", "micromath", "f16", "I2F14", "I2F30", "I16F16"];
        let rows = sample::curves("cap", "angle");
        let of = |format: &str| {
            rows.iter().take(25).map(|row| CurveRow { format: format.to_owned(), ..row.clone() }).collect::<Vec<_>>()
        };
        let size = drawn(&formats.map(of).concat()).len();
        assert!(size < 20_000, "{size} bytes");
    }
}
