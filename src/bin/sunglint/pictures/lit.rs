//! Spheres that a highlight method lights, and the integral over the disc that they are held against.

use indicatif::ProgressBar;
use sunglint::highlight::Highlight;
use sunglint::oracle::highlight::Pixel;
use sunglint::oracle::quadrature::Quadrature;
use sunglint::scene::Channel;
use sunglint::trial::gloss::{self, Case};
use sunglint::trial::{Format, Make, Shading, ShadingVisitor, Visitor};
use sunglint::{Real, Scalar};

use super::patch::Patch;
use super::sphere::{self, Sphere};
use crate::workers;

/// Widths of a highlight that a patch shows to each side of its centre.
const WIDTHS: f64 = 3.0;

/// What of a sphere is drawn for `case`.
pub fn patch(case: &Case) -> Patch {
    Patch::about_the_highlight(WIDTHS * (case.light.angular_radius() + 2.0 * case.alpha))
}

/// The levels that are right, of all pixels in rows from the top, and by how much twice the nodes move one in forty of
/// them, relative to its value.
#[derive(Clone, Debug)]
pub struct Truth {
    levels: Vec<f64>,
    /// The greatest of that: errors below it are the truth's own.
    pub floor: f64,
}

/// Integrates over the disc, at the vectors as they are in `format`, on all cores.
pub fn truth(case: &Case, format: Format, side: u32, coarse: bool, progress: &ProgressBar) -> Truth {
    let rows: Vec<_> = (0..side).collect();
    let rows = workers::map(&rows, progress, |&y| format.visit(Row { case, y, side, coarse }));
    let floor = rows.iter().map(|(_, floor)| *floor).fold(0.0, f64::max);
    Truth { levels: rows.into_iter().flat_map(|(levels, _)| levels).collect(), floor }
}

/// A row of the truth.
struct Row<'a> {
    case: &'a Case,
    y: u32,
    side: u32,
    coarse: bool,
}

impl Visitor for Row<'_> {
    type Output = (Vec<f64>, f64);

    fn visit<T: Real>(self) -> (Vec<f64>, f64) {
        if self.coarse { self.integrals::<T, 6, 12>() } else { self.integrals::<T, 8, 16>() }
    }
}

impl Row<'_> {
    /// Levels, and how far those of `M` nodes are from them at most.
    fn integrals<T: Real, const N: usize, const M: usize>(&self) -> (Vec<f64>, f64) {
        const APART: usize = 41;
        let (rule, finer) = (Quadrature::<N>::new(), Quadrature::<M>::new());
        let pixels = patch(self.case).row(self.y, self.side).map(|n| n.map(|n| sphere::rounded::<T>(n).1));
        let mut floor: f64 = 0.0;
        let level = |(x, pixel): (usize, Option<Pixel>)| {
            let Some(pixel) = pixel else { return f64::NAN };
            let level = gloss::integrated::<T, N>(self.case, &pixel, &rule);
            if (x + 7 * self.y as usize).is_multiple_of(APART) && level > 0.0 {
                floor = floor.max((gloss::integrated::<T, M>(self.case, &pixel, &finer) / level - 1.0).abs());
            }
            level
        };
        (pixels.enumerate().map(level).collect(), floor)
    }
}

/// What draws the sphere of a method in a format.
pub struct Drawing<'a> {
    /// The method.
    pub method: Shading,
    /// The light and the roughness.
    pub case: &'a Case,
    /// Pixels across.
    pub side: u32,
    /// Of the same format, case and size.
    pub truth: &'a Truth,
}

impl Visitor for Drawing<'_> {
    type Output = Sphere;

    fn visit<T: Real>(self) -> Sphere {
        let Self { method, case, side, truth } = self;
        let theta = case.light.angular_radius();
        Sphere::lit::<T>((&patch(case), side, theta), code(method, case), |index, _| truth.levels[index])
    }
}

/// Levels of whole pixels by the scene of `case`.
pub fn code<T: Real>(method: Shading, case: &Case) -> impl Fn([[T; 3]; 3]) -> f64 {
    let shade = method.visit(Scene { case });
    move |pixel| shade(pixel)
}

struct Scene<'a> {
    case: &'a Case,
}

impl<T: Real> ShadingVisitor<T> for Scene<'_> {
    type Output = Box<dyn Fn([[T; 3]; 3]) -> f64>;

    fn visit<H: Highlight<T> + 'static>(self, method: Make<T, H>) -> Self::Output {
        // The light is the same in all pixels of a sphere.
        let l = crate::pixels::ball_light().map(T::from_f64);
        let scene = gloss::scene(self.case, l, method);
        Box::new(move |[n, v, _]| {
            let level = scene.as_ref().map(|scene| scene.shade_channel(n, v, Channel::Green));
            level.map_or(f64::NAN, |level| T::of_level(level).exact())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::figures::Figures;
    use sunglint::trial::gloss::CASES;

    #[test]
    fn the_exact_method_is_as_near_to_the_truth_as_its_budget_says() {
        let case = &CASES[1];
        let truth = truth(case, Format::F64, 24, true, &ProgressBar::hidden());
        assert!(truth.floor > 0.0 && truth.floor < 1e-4, "{:e}", truth.floor);
        let of = |method| Figures::of(&Format::F64.visit(Drawing { method, case, side: 24, truth: &truth }));
        let [none, cone] = [of(Shading::None), of(Shading::ConeGgx)];
        assert!(cone.rms < 1e-3 && none.worst > 0.03, "{cone:?} {none:?}");
    }

    #[test]
    fn a_polish_is_drawn_from_near_and_varnish_whole() {
        assert_eq!(CASES.map(|case| patch(&case).is_whole()), [false, true, true, false, true]);
    }
}
