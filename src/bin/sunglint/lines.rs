//! The lines across a panel, and their names: one below the other in the lane on the right, as near to their lines as
//! the others let them.

use kuva::prelude::{LinePlot, LineStyle, Plot};

use crate::field::{Field, Line};
use crate::labels::{Area, LINE, Label, width};
use crate::lettering::{self, LEADER};
use crate::panel;
use crate::sheet::Sheet;

/// Room left of the names for what leads there, in pixels.
pub const LEAD: f64 = 14.0;

/// The width of the small letters that names are made of, as a part of what labels keep free.
pub const NARROW: f64 = 0.88;

/// The lines, which end where the lane begins.
pub fn plots(field: &Field) -> impl Iterator<Item = Plot> {
    let frame = field.frame;
    field.lines.iter().map(move |line| {
        let height = frame.up(line.error);
        let dashes = LineStyle::Custom(panel::LINE_DASHES.to_owned());
        let line = LinePlot::new().with_data([(frame.x.0, height), (frame.x.1, height)]).with_color(panel::LINE);
        Plot::Line(line.with_line_style(dashes).with_stroke_width(1.2))
    })
}

/// Where the lines run, and the lane of their names.
pub fn areas(field: &Field, sheet: &Sheet) -> Vec<Area> {
    let frame = &field.frame;
    let ends = |line: &Line| [frame.x.0, frame.x.1].map(|x| sheet.pixels((x, frame.up(line.error))));
    let lane = Area { x: (sheet.pixels((frame.x.1, 0.0)).0, sheet.area.x.1), ..sheet.area };
    field.lines.iter().map(ends).map(|[start, end]| Area::spanned(start, end)).chain([lane]).collect()
}

/// Names and leaders for the lines that have names.
pub fn names(field: &Field, sheet: &Sheet) -> Vec<Plot> {
    let mut named: Vec<_> = field.lines.iter().filter(|line| !line.name.is_empty()).collect();
    named.sort_by(|a, b| b.error.total_cmp(&a.error));
    let start = |line: &Line| sheet.pixels((field.frame.x.1, field.frame.up(line.error)));
    let heights: Vec<_> = named.iter().map(|line| start(line).1).collect();
    let label = |(line, height): (&&Line, f64)| {
        let mark = start(line);
        let middle = mark.0 + LEAD + NARROW * width(&line.name) / 2.0;
        Label { text: line.name.clone(), at: (middle, height), mark }
    };
    let labels: Vec<_> = named.iter().zip(apart(&heights, LINE + 1.0, sheet.area.y)).map(label).collect();
    let leaders = labels.iter().map(|label| Plot::Line(leader(label, sheet)));
    leaders.chain([Plot::Scatter(lettering::texts(&labels, sheet))]).collect()
}

fn leader(label: &Label, sheet: &Sheet) -> LinePlot {
    let foot = (label.mark.0 + LEAD - 3.0, label.at.1);
    LinePlot::new().with_data([sheet.data(label.mark), sheet.data(foot)]).with_color(LEADER).with_stroke_width(0.8)
}

/// `heights`, from the least to the greatest, moved until they are `gap` apart and within `bounds`.
pub fn apart(heights: &[f64], gap: f64, bounds: (f64, f64)) -> Vec<f64> {
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
}
