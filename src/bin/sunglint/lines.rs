//! The lines across a panel, and their names: one below the other in the lane on the right, as near to their lines as
//! the others let them.

use kuva::prelude::{LinePlot, LineStyle, Plot};

use crate::field::{Field, Line, Sort};
use crate::labels::{Area, LINE, Label, width};
use crate::lettering::{self, LEADER};
use crate::panel;
use crate::sheet::Sheet;

/// Room left of the names for what leads there, in pixels.
const LEAD: f64 = 14.0;

/// The width of the small letters that names are made of, as a part of what labels keep free.
const NARROW: f64 = 0.88;

/// The lines, which end where the lane begins.
pub fn plots(field: &Field) -> impl Iterator<Item = Plot> {
    let frame = field.frame;
    field.lines.iter().map(move |line| {
        let height = frame.up(line.error);
        let (colour, dashes) = style(line.sort);
        let dashes = LineStyle::Custom(dashes.to_owned());
        let line = LinePlot::new().with_data([(frame.x.0, height), (frame.x.1, height)]).with_color(colour);
        Plot::Line(line.with_line_style(dashes).with_stroke_width(1.2))
    })
}

/// Colour and dashes of the lines of a sort.
pub fn style(sort: Sort) -> (&'static str, &'static str) {
    match sort {
        Sort::Model => (panel::LINE, panel::LINE_DASHES),
        Sort::Size => (panel::SIZE, "9 3"),
        Sort::Required => (panel::REQUIRED, "2 3"),
    }
}

/// Where the lines run, and the lane of their names.
pub fn areas(field: &Field, sheet: &Sheet) -> Vec<Area> {
    let frame = &field.frame;
    let ends = |line: &Line| [frame.x.0, frame.x.1].map(|x| sheet.pixels((x, frame.up(line.error))));
    let lane = Area { x: (sheet.pixels((frame.x.1, 0.0)).0, sheet.area.x.1), ..sheet.area };
    field.lines.iter().map(ends).map(|[start, end]| Area::spanned(start, end)).chain([lane]).collect()
}

/// Names and leaders for the lines.
pub fn names(field: &Field, sheet: &Sheet) -> Vec<Plot> {
    let labels = labels(field, sheet);
    let leaders = labels.iter().map(|label| Plot::Line(leader(label, sheet)));
    leaders.chain([Plot::Scatter(lettering::texts(&labels, sheet))]).collect()
}

/// The names at the right ends of the lines, one below the other.
fn labels(field: &Field, sheet: &Sheet) -> Vec<Label> {
    let mut named: Vec<_> = field.lines.iter().collect();
    named.sort_by(|a, b| b.error.total_cmp(&a.error));
    let start = |line: &Line| sheet.pixels((field.frame.x.1, field.frame.up(line.error)));
    let heights: Vec<_> = named.iter().map(|line| start(line).1).collect();
    let label = |(line, height): (&&Line, f64)| {
        let mark = start(line);
        let middle = mark.0 + LEAD + NARROW * width(&line.name) / 2.0;
        Label { text: line.name.clone(), at: (middle, height), mark }
    };
    named.iter().zip(apart(&heights, LINE + 1.0, sheet.area.y)).map(label).collect()
}

fn leader(label: &Label, sheet: &Sheet) -> LinePlot {
    let foot = (label.mark.0 + LEAD - 3.0, label.at.1);
    LinePlot::new().with_data([sheet.data(label.mark), sheet.data(foot)]).with_color(LEADER).with_stroke_width(0.8)
}

/// `heights`, from the least to the greatest, moved until they are `gap` apart and within `bounds`.
fn apart(heights: &[f64], gap: f64, bounds: (f64, f64)) -> Vec<f64> {
    // Groups of neighbours that touch, each as long as it has members and centred on their mean.
    let mut groups: Vec<(f64, usize)> = Vec::new();
    for &height in heights {
        let mut group = (height, 1);
        while let Some(&(middle, count)) = groups.last() {
            let reach = gap * (count + group.1) as f64 / 2.0;
            if group.0 - middle >= reach {
                break;
            }
            groups.pop();
            let members = (count + group.1) as f64;
            group = ((middle * count as f64 + group.0 * group.1 as f64) / members, count + group.1);
        }
        let half = gap * group.1 as f64 / 2.0;
        let middle = group.0.min(bounds.1 - half).max(bounds.0 + half);
        groups.push((middle, group.1));
    }
    let places = |(middle, count): (f64, usize)| {
        (0..count).map(move |place| middle + gap * (place as f64 - (count - 1) as f64 / 2.0))
    };
    groups.into_iter().flat_map(places).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error_kind::ErrorKind;
    use crate::pixel_error::PixelError;
    use crate::result::Row;
    use crate::sample::{self, HOST};
    use crate::{chart, direction_panel, pixel_panel};

    #[test]
    fn names_keep_their_order_and_their_distance() {
        let places = apart(&[5.0, 100.0, 101.0, 103.0, 110.0, 300.0], 12.0, (0.0, 302.0));
        assert_eq!(places.len(), 6);
        assert!(places.windows(2).all(|pair| pair[1] - pair[0] > 11.99), "{places:?}");
        assert!(places[0] >= 6.0 - 1e-9 && places[5] <= 296.0 + 1e-9, "{places:?}");
    }

    #[test]
    fn who_has_room_stays() {
        assert_eq!(apart(&[50.0, 100.0], 12.0, (0.0, 200.0)), [50.0, 100.0]);
    }

    #[test]
    fn no_two_names_overlap_and_all_fit_into_the_lane() {
        let model = |method: &str, worst: f64| Row { model_max: worst, ..sample::row(method, "f32", 1.0, 1e-7) };
        // Sizes, models and requirements fall together here.
        let rows = [model("factored", 0.0046), model("epic", 0.0047), model("disc", 0.0039), model("cap", 1e-3)];
        let rows: Vec<_> = rows.iter().collect();
        let directions = direction_panel::field(&rows, &[], ErrorKind::Total, HOST);
        let pixels =
            ["none", "karis", "karis/3", "exact_rp", "disc_ggx", "disc_ggx dir", "cone_ggx", "cone_ggx shifted"]
                .map(|method| sample::pixel(method, "f32", 5.0, 1e-6));
        let pixels = pixel_panel::field(&pixels.iter().collect::<Vec<_>>(), &[], PixelError::default(), HOST);
        for field in [directions, pixels] {
            let sheet = Sheet::new(&field.frame, &panel::layout(&field, chart::ALONE));
            let labels = labels(&field, &sheet);
            assert!(labels.len() >= 8, "{}", labels.len());
            assert!(labels.windows(2).all(|pair| pair[1].at.1 - pair[0].at.1 >= LINE), "{labels:?}");
            let right = |label: &Label| label.at.0 + NARROW * width(&label.text) / 2.0;
            let widest = labels.iter().max_by(|a, b| right(a).total_cmp(&right(b))).expect("a label");
            assert!(right(widest) <= sheet.area.x.1 + 1.0, "{widest:?} {:?}", sheet.area);
        }
    }
}
