//! A sphere as it was computed, as it is, and how far apart the two are.

use sunglint::Real;
use sunglint::oracle;
use sunglint::oracle::highlight::Pixel;
use sunglint::trial::Light;

use super::colour::{self, Colour, INK, PAPER, Scale};
use super::patch::{Patch, mirrored};
use super::raster::Raster;
use crate::pixels::ball_light;

/// Angular radii of the light that a patch shows to each side of its centre.
pub const RADII: f64 = 3.0;

/// How far off the mirror ray, in radii of the light, the light of a mirror falls to a quarter.
const FALL: f64 = 0.25;

/// A pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// How bright it was computed to be.
    pub level: f32,
    /// How bright it is.
    pub truth: f32,
    /// The error, in the unit of its scale.
    pub error: f32,
}

/// All pixels of a picture.
#[derive(Clone, Debug)]
pub struct Sphere {
    side: u32,
    cells: Vec<Option<Cell>>,
    /// How many pixels the radius of the light takes.
    bar: Option<u32>,
    /// The level that is shown as white.
    white: f32,
}

impl Sphere {
    /// Asks for every normal in rows from the top; the index is that of the pixel.
    fn new(patch: &Patch, side: u32, theta: f64, mut cell: impl FnMut(usize, [f64; 3]) -> Cell) -> Self {
        let normals = (0..side).flat_map(|y| patch.row(y, side));
        let cells = normals.enumerate().map(|(index, n)| n.map(|n| cell(index, n))).collect();
        Self { side, cells, bar: patch.pixels(theta, side), white: 1.0 }
    }

    /// A mirror: a pixel is white where `code` answers with the mirror ray itself, and darker the farther off the
    /// answer is. Errors are in per cent of the angular radius.
    pub fn mirror<T: Real>(light: &Light, side: u32, code: impl Fn([T; 3], [T; 3]) -> [T; 3]) -> Self {
        let theta = light.light.angular_radius();
        let l = ball_light().map(T::from_f64);
        let glow = |answer: [f64; 3], r: [f64; 3]| {
            let off = oracle::angle_between(answer, r) / theta / FALL;
            1.0 / (1.0 + off * off) / (1.0 + off * off)
        };
        Self::new(&Patch::about_the_highlight(RADII * theta), side, theta, |_, n| {
            let r = mirrored(n).map(T::from_f64);
            let answer = code(l, r).map(T::to_f64);
            let [l, r] = [l, r].map(|vector| vector.map(T::to_f64));
            let nearest = oracle::nearest_in_disc(l, r, theta);
            // The zero vector has no direction, and atan2 would find no angle in it.
            let lost = answer == [0.0; 3] || !answer.into_iter().all(f64::is_finite);
            let answer = if lost { [f64::NAN; 3] } else { answer };
            let error = 100.0 * oracle::angle_between(answer, nearest) / theta;
            Cell { level: glow(answer, r) as f32, truth: glow(nearest, r) as f32, error: error as f32 }
        })
    }

    /// A surface: `code` makes a level of normal, viewer and light, `truth` the right one of the pixel's index and the
    /// rounded vectors. Errors are relative.
    pub fn lit<T: Real>(
        (patch, side, theta): (&Patch, u32, f64),
        code: impl Fn([[T; 3]; 3]) -> f64,
        truth: impl Fn(usize, &Pixel) -> f64,
    ) -> Self {
        Self::new(patch, side, theta, |index, n| {
            let (lanes, pixel) = rounded::<T>(n);
            let [level, truth] = [code(lanes), truth(index, &pixel)];
            let error = if level == truth { 0.0 } else { (level - truth).abs() / truth };
            Cell { level: level as f32, truth: truth as f32, error: error as f32 }
        })
    }

    /// The same with the brightest level of the truth as white, as a highlight of a polish would be white all over.
    pub fn exposed(self) -> Self {
        let white = self.cells().map(|cell| cell.truth).fold(0.0, f32::max);
        Self { white, ..self }
    }

    /// The picture as it was computed.
    pub fn computed(&self) -> Raster {
        self.raster(|cell| colour::of_level((cell.level / self.white).into()))
    }

    /// The picture as it is.
    pub fn truth(&self) -> Raster {
        self.raster(|cell| colour::of_level((cell.truth / self.white).into()))
    }

    /// Where the error sits.
    pub fn error(&self, scale: &Scale) -> Raster {
        self.raster(|cell| scale.colour(cell.error.into()))
    }

    /// All pixels of the sphere.
    pub fn cells(&self) -> impl Iterator<Item = Cell> {
        self.cells.iter().copied().flatten()
    }

    /// With the light's radius as a bar below, if there is room for one.
    fn raster(&self, colour: impl Fn(Cell) -> Colour) -> Raster {
        let pixels = self.cells.iter().map(|cell| cell.map_or(PAPER, &colour)).collect();
        let mut raster = Raster::square(self.side, pixels);
        if let Some(bar) = self.bar.filter(|bar| (4..self.side / 2).contains(bar)) {
            let thick = (self.side / 100).max(2);
            let corner = [2 * thick, self.side - 4 * thick];
            raster.fill(corner.map(|edge| edge - thick / 2), [bar + thick / 2 * 2, 2 * thick], PAPER);
            raster.fill(corner, [bar, thick], INK);
        }
        raster
    }
}

/// A pixel of a sphere in a format, and what that is exactly.
pub fn rounded<T: Real>(n: [f64; 3]) -> ([[T; 3]; 3], Pixel) {
    let lanes = [n, [0.0, 0.0, 1.0], ball_light()].map(|vector| vector.map(T::from_f64));
    let [n, v, l] = lanes.map(|vector| vector.map(T::to_f64));
    (lanes, Pixel { n, v, l })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::colour::{EXACT, NAN};
    use sunglint::cap;
    use sunglint::trial::{Constants, lights};

    const SIDE: u32 = 40;
    const PER_CENT: Scale = Scale { least: -6, most: 2, unit: "%" };

    #[test]
    fn the_truth_against_itself_is_black() {
        let theta = lights::STUDY[0].light.angular_radius();
        let sphere = Sphere::mirror::<f64>(&lights::STUDY[0], SIDE, |l, r| oracle::nearest_in_disc(l, r, theta));
        assert!(sphere.error(&PER_CENT).all(|colour| colour == EXACT || colour == INK));
        assert_eq!(sphere.computed(), sphere.truth());
        let patch = Patch::about_the_highlight(1.0);
        let lit = Sphere::lit::<f32>((&patch, SIDE, theta), |[n, ..]| n[2].into(), |_, pixel| pixel.n[2]);
        assert!(lit.error(&PER_CENT).all(|colour| colour == EXACT));
    }

    #[test]
    fn what_is_no_direction_is_magenta() {
        for nothing in [f32::NAN, f32::INFINITY, 0.0] {
            let sphere = Sphere::mirror::<f32>(&lights::STUDY[0], SIDE, |_, _| [nothing; 3]);
            assert!(sphere.computed().all(|colour| colour == NAN || colour == INK));
            assert!(sphere.error(&PER_CENT).all(|colour| colour == NAN || colour == INK));
        }
    }

    #[test]
    fn the_bar_is_as_long_as_the_disc_is_deep() {
        let light = lights::STUDY[0];
        let sphere = Sphere::mirror::<f64>(&light, 400, |l, r| cap(l, r, &Constants::of(&light.light).sphere));
        let white = sphere.cells().filter(|cell| cell.level == 1.0).count() as f64;
        let radius = (white / std::f64::consts::PI).sqrt();
        assert_eq!(sphere.bar, Some(67));
        // An ellipse, as much flattened by the slant of the sphere as it is stretched across.
        assert!((radius / (200.0 / RADII) - 1.0).abs() < 0.01, "{radius}");
    }
}
