//! What of a sphere is seen: all of it, or the patch about its highlight.

use crate::pixels;

/// A patch wider than this share of the sphere is drawn as the whole of it.
const WHOLE: f64 = 0.15;

/// A square of a unit sphere that is seen from `(0, 0, 1)` and lit from [`pixels::ball_light`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// Middle.
    centre: [f64; 2],
    /// Half of its side.
    half: f64,
}

impl Patch {
    /// Where the mirror ray comes within `reach` radians of the light.
    pub fn about_the_highlight(reach: f64) -> Self {
        let l = pixels::ball_light();
        let halfway = [l[0], l[1], l[2] + 1.0];
        let length = halfway.iter().map(|lane| lane * lane).sum::<f64>().sqrt();
        // The mirror ray turns twice as far as the normal.
        match reach / 2.0 {
            half if half > WHOLE => Self { centre: [0.0; 2], half: 1.0 },
            half => Self { centre: [halfway[0] / length, halfway[1] / length], half },
        }
    }

    /// Whether the whole sphere is seen.
    pub fn is_whole(&self) -> bool {
        self.half == 1.0
    }

    /// The normals of a row of pixels at their centres; none beside the sphere.
    pub fn row(&self, y: u32, side: u32) -> impl Iterator<Item = Option<[f64; 3]>> + use<> {
        let Self { centre: [x0, y0], half } = *self;
        let place = move |pixel: u32| (2.0 * f64::from(pixel) + 1.0) / f64::from(side) - 1.0;
        (0..side).map(move |x| {
            let [x, y] = [x0 + half * place(x), y0 - half * place(y)];
            let square = 1.0 - x * x - y * y;
            (square > 0.0).then(|| [x, y, square.sqrt()])
        })
    }

    /// How many pixels the angle `theta` of the mirror ray takes, where that is the same in all of the patch.
    pub fn pixels(&self, theta: f64, side: u32) -> Option<u32> {
        let length = theta / 2.0 / self.half * f64::from(side) / 2.0;
        (!self.is_whole()).then_some(length.round() as u32)
    }
}

/// Where the view `(0, 0, 1)` is mirrored to.
pub fn mirrored(n: [f64; 3]) -> [f64; 3] {
    [2.0 * n[2] * n[0], 2.0 * n[2] * n[1], 2.0 * n[2] * n[2] - 1.0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use sunglint::oracle::angle_between;

    #[test]
    fn the_middle_of_a_patch_mirrors_the_light_and_its_edge_the_reach() {
        let patch = Patch::about_the_highlight(0.02);
        let normals: Vec<_> = patch.row(50, 101).flatten().collect();
        let away = |n: [f64; 3]| angle_between(mirrored(n), pixels::ball_light());
        assert!(away(normals[50]) < 1e-12);
        assert!((away(normals[0]) - 0.02).abs() < 2e-3, "{}", away(normals[0]));
        assert_eq!(patch.pixels(0.005, 100), Some(13));
    }

    #[test]
    fn a_wide_highlight_takes_the_whole_sphere() {
        let patch = Patch::about_the_highlight(1.0);
        assert!(patch.is_whole() && patch.pixels(0.1, 100).is_none());
        let row: Vec<_> = patch.row(0, 100).collect();
        assert!(row[0].is_none() && row[99].is_none() && row[50].is_some(), "a corner lies beside it");
    }
}
