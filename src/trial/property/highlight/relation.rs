//! Pixels that are related: mirrored, seen from the light, farther from the highlight, of a rougher surface, just
//! beside the disc's edge, and by two methods.

use core::f64::consts::FRAC_PI_2;

use super::super::Broken;
use super::budget::step;
use super::pixel::{cosine, mirrored};
use super::{Exact, Shaded, Surface, surface_and_pixel};
use crate::light::DistantLight;
use crate::oracle::highlight::Pixel;
use crate::trial::draw::Draw;
use crate::trial::format::Format;
use crate::trial::gloss::family;
use crate::trial::shading::Shading;

/// Reads a relation and says whether it is broken.
pub(super) fn hold(draw: &mut Draw<'_>, format: Format, method: Shading) -> Result<(), Broken> {
    let kind = draw.byte() % 8;
    let (surface, pixel) = surface_and_pixel(draw);
    let shaded = |method, surface, pixel| format.visit(Exact { method, surface, pixel });
    match kind {
        0 | 1 => mirror_images(&shaded(method, surface, pixel), draw.byte() % 3, surface),
        2 => {
            let surface = Surface { light: point(), ..surface };
            reciprocal(&shaded(method, surface, pixel), &shaded(method, surface, swapped(pixel)))
        }
        3 => {
            let steps = walk(draw, surface);
            fades(steps.map(|pixel| shaded(method, surface, pixel)))
        }
        4 => {
            let alpha = draw.between(surface.alpha, 1.0);
            let n = pixel.n;
            let pixel = Pixel { v: mirrored(n, pixel.l), ..pixel };
            rougher(&shaded(method, surface, pixel), &shaded(method, Surface { alpha, ..surface }, pixel))
        }
        5 => {
            let tiny = draw.logarithmic(1e-12, 1e-3);
            let sides = edge(draw, pixel, surface.light.angular_radius(), tiny);
            joined(sides.map(|pixel| shaded(method, surface, pixel)))
        }
        _ => energies(
            [Shading::None, Shading::KarisThird, Shading::ExactRp, Shading::Karis]
                .map(|method| shaded(method, surface, pixel)),
        ),
    }
}

fn point() -> DistantLight {
    DistantLight::from_ratio(0.0).unwrap_or(crate::SUN)
}

fn swapped(Pixel { n, v, l }: Pixel) -> Pixel {
    Pixel { n, v: l, l: v }
}

/// With one lane of all three vectors negated: the same, in floats to the bit.
fn mirror_images(shaded: &Shaded, lane: u8, surface: Surface) -> Result<(), Broken> {
    let lit = &shaded.lit;
    let turned = |mut vector: [f64; 3]| {
        vector[usize::from(lane)] = -vector[usize::from(lane)];
        vector
    };
    let Pixel { n, v, l } = lit.pixel;
    let pixel = Pixel { n: turned(n), v: turned(v), l: turned(l) };
    let image = lit.format.visit(Exact { method: lit.method, surface, pixel });
    let floats = matches!(lit.format, Format::F64 | Format::F32 | Format::Micromath | Format::F16);
    if !floats && !lit.is_defined() {
        return Ok(());
    }
    let allowed = if floats { 0.0 } else { 2.0 * lit.allowed(shaded.truth) };
    let off = if image.found == shaded.found { 0.0 } else { (image.found - shaded.found).abs() };
    shaded.case().at_most("a mirror image is another", off, allowed)
}

/// A point light and a viewer who change places: the same BRDF, so that `n.v` times one is `n.l` times the other.
fn reciprocal(there: &Shaded, back: &Shaded) -> Result<(), Broken> {
    if !(there.lit.is_defined() && back.lit.is_defined()) {
        return Ok(());
    }
    let Pixel { n, v, l } = there.lit.pixel.unit();
    let [n_dot_v, n_dot_l] = [cosine(n, v), cosine(n, l)];
    let off = (there.held() * n_dot_v - back.held() * n_dot_l).abs();
    // The greatest number of f16 on one side only.
    if there.overflows() || back.overflows() {
        return Ok(());
    }
    let allowed = there.lit.allowed(there.truth) * n_dot_v + back.lit.allowed(back.truth) * n_dot_l;
    there.case().at_most("light and viewer change places", off, allowed)
}

/// Two pixels whose mirror rays lie at a right angle to the plane of incidence, the second farther off.
fn walk(draw: &mut Draw<'_>, surface: Surface) -> [Pixel; 2] {
    let n = draw.direction();
    let l = draw.turned(n, draw.clone().between(0.0, FRAC_PI_2));
    let side = [n[1] * l[2] - n[2] * l[1], n[2] * l[0] - n[0] * l[2], n[0] * l[1] - n[1] * l[0]];
    let width = surface.light.angular_radius() + 4.0 * surface.alpha;
    let first = draw.between(0.0, 1.0);
    let second = draw.between(first, 1.0);
    [first, second].map(|share| {
        let away = (share * width).min(FRAC_PI_2);
        Pixel { n, v: mirrored(n, crate::trial::input::turned(l, side, away)), l }
    })
}

/// The farther from a point's highlight, the less light: as seen of a metal, per area of the surface that the viewer
/// sees.
fn fades([near, far]: [Shaded; 2]) -> Result<(), Broken> {
    // The averages over large discs rise a little as the half vector leans, by their formulas.
    let average = family(near.lit.method) > 1;
    if average || !(near.lit.is_defined() && far.lit.is_defined()) || near.lit.glossy.f0 < 1.0 {
        return Ok(());
    }
    let seen = |shaded: &Shaded| cosine(shaded.lit.pixel.n, shaded.lit.pixel.v);
    let rise = far.held() * seen(&far) - near.held() * seen(&near);
    let allowed = far.lit.allowed(far.truth) * seen(&far) + near.lit.allowed(near.truth) * seen(&near);
    far.case().at_most("a highlight fades away from its centre", rise, allowed)
}

/// At the centre of the highlight a rougher surface is darker.
fn rougher(smooth: &Shaded, rough: &Shaded) -> Result<(), Broken> {
    // A mirror under a point has no highlight, nor has one without an energy factor.
    if !(smooth.lit.is_defined() && rough.lit.is_defined()) || smooth.lit.glossy.alpha == 0.0 {
        return Ok(());
    }
    let rise = rough.held() - smooth.held();
    let allowed = smooth.lit.allowed(smooth.truth) + rough.lit.allowed(rough.truth);
    rough.case().at_most("a rougher surface has a lower peak", rise, allowed)
}

/// The mirror ray just inside and just outside the disc.
fn edge(draw: &mut Draw<'_>, pixel: Pixel, theta: f64, tiny: f64) -> [Pixel; 2] {
    let aside = draw.direction();
    [1.0 - tiny, 1.0 + tiny].map(|share| {
        let r = crate::trial::input::turned(pixel.l, aside, theta * share);
        Pixel { v: mirrored(pixel.n, r), ..pixel }
    })
}

/// No more lies between the two sides of the edge than between their exact values, but for both budgets: a switch of
/// forms there would show. The image in a mirror does end there.
fn joined([inside, outside]: [Shaded; 2]) -> Result<(), Broken> {
    if !(inside.lit.is_defined() && outside.lit.is_defined()) || inside.lit.glossy.alpha == 0.0 {
        return Ok(());
    }
    let jump = (inside.held() - outside.held()).abs();
    let truth = (inside.truth - outside.truth).abs();
    let allowed = truth + inside.lit.allowed(inside.truth) + outside.lit.allowed(outside.truth);
    inside.case().at_most("a jump at the disc's edge", jump, allowed)
}

/// The energy factors are in the order of their widths: none, a third, exact or a third, a half.
fn energies([none, third, exact, half]: [Shaded; 4]) -> Result<(), Broken> {
    // Karis's width is 1 at most, the exact one is not.
    let half = if half.lit.glossy.alpha + half.lit.glossy.ratio / 2.0 > 1.0 { third } else { half };
    let exact = if exact.lit.glossy.alpha + exact.lit.glossy.ratio / 2.0 > 1.0 { half } else { exact };
    // Of a mirror's image, without a factor the peak is infinite, and is given as zero.
    if none.lit.glossy.alpha == 0.0 {
        return Ok(());
    }
    // What f16 has left of products that are subnormal.
    let least = if none.lit.format == Format::F16 { f64::from(half::f16::MIN_POSITIVE) } else { 0.0 };
    // A division and two products each.
    let slack = |value: f64| value * 16.0 * step(none.lit.format) + least;
    for (name, less, more) in [
        ("karis is at most karis/3", half, third),
        ("karis/3 is at most none", third, none),
        ("karis is at most exact_rp", half, exact),
        ("exact_rp is at most none", exact, none),
    ] {
        if !(less.overflows() || more.overflows()) {
            less.case().at_most(name, less.held(), more.held() + slack(more.held()))?;
        }
    }
    Ok(())
}

impl Shaded {
    fn overflows(&self) -> bool {
        self.lit.format == Format::F16 && self.found.max(self.truth) >= 65504.0
    }

    /// What was found, no greater than the format's greatest number.
    fn held(&self) -> f64 {
        if self.lit.format == Format::F16 { self.found.min(65504.0) } else { self.found }
    }
}
