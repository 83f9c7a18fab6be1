//! Where the labels of the marks go: near their mark, off the other marks and off each other.
//!
//! All lengths are in pixels, with y growing downwards. Kuva can push labels apart by itself, but in
//! a crowd it lays them over the marks.

/// Neighbours of the same name up to this far apart share a label.
const TOGETHER: f64 = 36.0;
const LETTER: f64 = 6.7;
/// Height of a line of text.
pub const LINE: f64 = 12.0;
/// How far a mark keeps labels off, in pixels.
const MARGIN: f64 = 1.0;
/// A label further off than this from its mark needs a leader.
const NEAR: f64 = 20.0;
/// Weight of a pixel of overlap against a pixel of distance.
const OVERLAP: f64 = 4.0;
/// Around a mark of another name, how far a label looks as if it belonged to that mark.
const DOUBT: f64 = 17.0;
/// Weight of a pixel within that distance.
const DOUBTFUL: f64 = 0.12;

/// A mark and its name.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Centre of the mark.
    pub at: (f64, f64),
    /// Half its width.
    pub reach: f64,
    /// What the label says.
    pub name: String,
}

impl Mark {
    /// The space that it keeps for itself.
    fn area(&self) -> Area {
        Area::around(self.at, self.reach + MARGIN, self.reach + MARGIN)
    }
}

/// A label with its place.
#[derive(Clone, Debug)]
pub struct Label {
    /// What it says.
    pub text: String,
    /// Middle of the text.
    pub at: (f64, f64),
    /// The mark that it belongs to.
    pub mark: (f64, f64),
}

impl Label {
    /// Whether it stands so far off that a line has to lead to its mark.
    pub fn is_far(&self) -> bool {
        let near_x = (self.at.0 - self.mark.0).abs() < width(&self.text) / 2.0 + NEAR;
        let near_y = (self.at.1 - self.mark.1).abs() < NEAR;
        !(near_x && near_y)
    }

    /// The point of the text's edge that is nearest to the mark.
    pub fn foot(&self) -> (f64, f64) {
        let edge = area(self);
        (self.mark.0.clamp(edge.x.0, edge.x.1), self.mark.1.clamp(edge.y.0, edge.y.1))
    }
}

/// An upright rectangle.
#[derive(Clone, Copy, Debug)]
pub struct Area {
    /// Least and greatest x.
    pub x: (f64, f64),
    /// Least and greatest y.
    pub y: (f64, f64),
}

impl Area {
    /// A thin strip from one point to the other.
    pub fn spanned(a: (f64, f64), b: (f64, f64)) -> Self {
        let span = |a: f64, b: f64| (a.min(b) - 0.5, a.max(b) + 0.5);
        Self { x: span(a.0, b.0), y: span(a.1, b.1) }
    }

    fn around(at: (f64, f64), half_width: f64, half_height: f64) -> Self {
        Self { x: (at.0 - half_width, at.0 + half_width), y: (at.1 - half_height, at.1 + half_height) }
    }

    fn overlap(&self, other: &Self) -> f64 {
        let common = |a: (f64, f64), b: (f64, f64)| (a.1.min(b.1) - a.0.max(b.0)).max(0.0);
        common(self.x, other.x) * common(self.y, other.y)
    }

    fn size(&self) -> f64 {
        self.overlap(self)
    }
}

/// Places a label for each group of `marks`, inside `bounds` and off `taken`.
pub fn place(marks: &[Mark], bounds: Area, taken: &[Area]) -> Vec<Label> {
    let mut obstacles: Vec<Area> = marks.iter().map(Mark::area).collect();
    obstacles.extend(taken);
    let mut labels = Vec::new();
    for group in groups(marks).into_iter().filter(|group| !group[0].name.is_empty()) {
        let named = |mark: &&Mark| mark.name != group[0].name;
        let others: Vec<_> = marks.iter().filter(named).collect();
        if let Some(label) = best(&group, &others, &obstacles, &bounds) {
            obstacles.push(area(&label));
            labels.push(label);
        }
    }
    labels
}

/// Marks of the same name that stand next to each other, from left to right.
fn groups(marks: &[Mark]) -> Vec<Vec<Mark>> {
    let mut sorted = marks.to_vec();
    sorted.sort_by(|a, b| a.name.cmp(&b.name).then(a.at.0.total_cmp(&b.at.0)));
    let mut groups: Vec<Vec<Mark>> = Vec::new();
    for mark in sorted {
        let near = |group: &&mut Vec<Mark>| group.iter().any(|other| are_together(other, &mark));
        match groups.iter_mut().rev().find(near) {
            Some(group) => group.push(mark),
            None => groups.push(vec![mark]),
        }
    }
    groups
}

fn are_together(a: &Mark, b: &Mark) -> bool {
    a.name == b.name && (a.at.0 - b.at.0).hypot(a.at.1 - b.at.1) < TOGETHER
}

/// The place for the label of `group` that covers least, lies nearest and keeps off the `others`.
fn best(group: &[Mark], others: &[&Mark], obstacles: &[Area], bounds: &Area) -> Option<Label> {
    let price = |label: &Label, distance: f64| {
        let area = area(label);
        let covered: f64 = obstacles.iter().map(|other| area.overlap(other)).sum();
        let outside = area.size() - area.overlap(bounds);
        let near = |mark: &&Mark| area.overlap(&Area::around(mark.at, DOUBT, DOUBT));
        let doubtful: f64 = others.iter().map(near).sum();
        OVERLAP * (covered + outside) + DOUBTFUL * doubtful + distance
    };
    let candidates = group.iter().flat_map(candidates);
    let priced = candidates.map(|(label, distance)| (price(&label, distance), label));
    priced.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, label)| label)
}

/// Places around `mark`, each with its distance.
fn candidates(mark: &Mark) -> impl Iterator<Item = (Label, f64)> {
    const SIDES: [(f64, f64); 12] = [
        (1.0, 0.0),
        (-1.0, 0.0),
        (0.0, -1.0),
        (0.0, 1.0),
        (0.5, -1.0),
        (-0.5, -1.0),
        (0.5, 1.0),
        (-0.5, 1.0),
        (1.0, -1.0),
        (-1.0, -1.0),
        (1.0, 1.0),
        (-1.0, 1.0),
    ];
    let (mark, half, reach) = (mark.clone(), width(&mark.name) / 2.0, mark.reach + MARGIN);
    let at = move |(x, y): (f64, f64), gap: f64| Label {
        text: mark.name.clone(),
        at: (mark.at.0 + x * (half + reach + gap), mark.at.1 + y * (LINE / 2.0 + reach + gap)),
        mark: mark.at,
    };
    let gaps = [1.0, 8.0, 16.0, 26.0, 38.0, 52.0, 70.0];
    gaps.into_iter().flat_map(move |gap| SIDES.map(|side| (at(side, gap), gap)))
}

fn area(label: &Label) -> Area {
    Area::around(label.at, width(&label.text) / 2.0, LINE / 2.0)
}

/// About how wide `text` is.
pub fn width(text: &str) -> f64 {
    LETTER * text.chars().count() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: Area = Area { x: (0.0, 600.0), y: (0.0, 600.0) };
    const CORNER: Area = Area { x: (590.0, 600.0), y: (0.0, 10.0) };

    fn mark(x: f64, y: f64, name: &str) -> Mark {
        Mark { at: (x, y), reach: 6.0, name: name.to_owned() }
    }

    #[test]
    fn neighbours_of_one_name_share_a_label() {
        let marks = [mark(100.0, 100.0, "f32"), mark(120.0, 104.0, "f32"), mark(300.0, 100.0, "f32")];
        assert_eq!(place(&marks, BOUNDS, &[CORNER]).len(), 2);
    }

    #[test]
    fn a_crowd_is_labelled_without_overlap() {
        let names = ["f64", "f32", "f16", "I2F14", "I2F30", "I16F16"];
        let marks: Vec<_> = (0..6).map(|i| mark(300.0 + 9.0 * i as f64, 300.0, names[i])).collect();
        let areas: Vec<_> = place(&marks, BOUNDS, &[CORNER]).iter().map(area).collect();
        for (i, one) in areas.iter().enumerate() {
            assert!(areas[..i].iter().all(|other| one.overlap(other) == 0.0));
            let on_mark = |m: &Mark| one.overlap(&m.area()) > 0.0;
            assert!(!marks.iter().any(on_mark));
        }
    }

    #[test]
    fn a_wide_mark_is_not_covered() {
        let wide = Mark { reach: 15.0, ..mark(300.0, 300.0, "f32") };
        let labels = place(std::slice::from_ref(&wide), BOUNDS, &[CORNER]);
        assert_eq!(area(&labels[0]).overlap(&wide.area()), 0.0);
    }

    #[test]
    fn labels_stay_inside() {
        let labels = place(&[mark(598.0, 2.0, "I16F16")], BOUNDS, &[CORNER]);
        let area = area(&labels[0]);
        assert!(area.x.1 <= 600.0 && area.y.0 >= 0.0, "{area:?}");
    }
}
