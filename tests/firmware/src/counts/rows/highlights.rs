//! The highlight methods, and the whole pixel with some of them.

use sunglint::highlight::{ConeGgx, DiscGgx, Highlight, PointGgx};
use sunglint::material::Surface;
use sunglint::scene::{Lamp, Scene};
use sunglint::trial::chip::{Case, INPUTS, Pixel, WIDTHS, pixels};
use sunglint::trial::{Make, Shading, ShadingVisitor};
use sunglint::{DistantSphere, Real, SUN, Scalar};

use crate::calls::highlights::{self, Glossy, Lit};
use crate::counter::Counter;
use crate::inputs::{all, rounded};
use crate::row::Row;

pub fn count<T: Real>(counter: &Counter) {
    for case in Case::ALL {
        let pixels = all(pixels(case));
        let pixels = &pixels;
        for shading in Shading::ALL {
            shading.visit::<T, _>(Highlights { counter, row: row::<T>(shading.name(), case), pixels });
        }
        let pixel = |function| row::<T>(function, case);
        pixel("pixel cone_ggx").count(counter, highlights::pixel, &scenes::<T, _>(ConeGgx::new, pixels));
        pixel("pixel disc_ggx").count(counter, highlights::pixel, &scenes::<T, _>(DiscGgx::new, pixels));
        pixel("pixel disc_ggx dir").count(counter, highlights::pixel, &scenes::<T, _>(DiscGgx::directional, pixels));
        pixel("pixel karis").count(counter, highlights::pixel, &scenes::<T, _>(PointGgx::karis, pixels));
    }
}

fn row<T: Real>(function: &'static str, case: Case) -> Row {
    Row { function, format: T::NAME, by: "sunglint", case: case.name() }
}

/// Counts the highlight that comes.
struct Highlights<'a> {
    counter: &'a Counter,
    row: Row,
    pixels: &'a [Pixel; INPUTS],
}

impl<T: Real> ShadingVisitor<T> for Highlights<'_> {
    type Output = ();

    fn visit<H: Highlight<T> + 'static>(self, method: Make<T, H>) {
        let sphere = DistantSphere::of(&SUN);
        let methods = WIDTHS.map(|alpha| method(&sphere, T::Scalar::nearest(alpha)));
        let glossy = self.pixels.iter().enumerate().map(|(index, pixel)| {
            let [n, v, l] = [pixel.n, pixel.v, pixel.l].map(rounded::<T>);
            Glossy { n, v, l, highlight: methods[index % WIDTHS.len()] }
        });
        self.row.count(self.counter, highlights::shade, &all(glossy));
    }
}

/// A scene for each pixel: one light, on a surface of one of the widths.
fn scenes<T: Real, H: Highlight<T>>(method: Make<T, H>, pixels: &[Pixel; INPUTS]) -> [Lit<T, H>; INPUTS] {
    let sphere = DistantSphere::of(&SUN);
    let [half, dielectric, pi] = [0.5, 0.04, core::f64::consts::PI].map(T::Scalar::nearest);
    let surfaces =
        WIDTHS.map(|alpha| Surface::<T>::new([half; 3], T::Scalar::nearest(alpha), [dielectric; 3]).unwrap());
    all(pixels.iter().enumerate().map(|(index, pixel)| {
        let mut scene = Scene::with_highlight(&surfaces[index % WIDTHS.len()], method);
        scene.push(&Lamp::new(rounded(pixel.l), sphere, [T::level(pi); 3]).unwrap()).unwrap();
        Lit { n: rounded(pixel.n), v: rounded(pixel.v), scene }
    }))
}
