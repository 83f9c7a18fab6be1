//! All methods in all formats under one light: pictures, and what a contact sheet is made of.

use indicatif::ProgressBar;
use sunglint::Real;
use sunglint::oracle;
use sunglint::trial::gloss::{ALBEDO, Case, F0};
use sunglint::trial::{Constants, Format, Light, Method, Visitor};

use super::colour::Scale;
use super::figures::Figures;
use super::lit;
use super::patch::Patch;
use super::raster::Raster;
use super::sphere::{RADII, Sphere};
use super::{Kind, Picture, SHEET_SIDE};
use crate::number;
use crate::options::Options;
use crate::workers;

/// Of errors in per cent of the light's radius.
pub const PER_CENT: Scale = Scale { least: -6, most: 2, unit: "per cent of the light's radius" };

/// Of errors relative to the true level.
pub const RELATIVE: Scale = Scale { least: -8, most: 0, unit: "of the true level" };

/// How pictures are drawn.
#[derive(Clone, Copy)]
pub struct Plan<'a> {
    /// What is asked for.
    pub options: &'a Options,
    /// Pixels across a sphere.
    pub side: u32,
    /// Whether the names of the files begin with the light's.
    pub named: bool,
}

/// The pictures of a light, and what goes on their sheet.
pub struct Album {
    /// `direction` or `pixel`.
    pub subject: &'static str,
    /// Name of the light or of the case.
    pub of: String,
    /// The decades of its errors.
    pub scale: Scale,
    /// What is to be known about the truth.
    pub note: String,
    /// What the truth looks like.
    pub truth: Raster,
    /// Method by method, format by format.
    pub tiles: Vec<Tile>,
    /// The truth first, then two of each tile.
    pub pictures: Vec<Picture>,
}

/// A method in a format.
pub struct Tile {
    /// Name of the method.
    pub method: &'static str,
    /// Name of the format.
    pub format: &'static str,
    /// The sphere as it was computed, and its errors; kept only for a contact sheet.
    pub rasters: Option<[Raster; 2]>,
    /// What its pixels come to.
    pub figures: Figures,
}

/// What of a sphere is seen, for captions.
fn extent(patch: &Patch, across: &str) -> String {
    if patch.is_whole() { "the whole sphere".to_owned() } else { format!("{across}; the bar is the light's radius") }
}

/// How many spheres the directions of a light are.
pub fn directions_count(options: &Options) -> usize {
    options.directions().len()
}

/// How many spheres the lit pixels of a case are, their truths included.
pub fn pixels_count(options: &Options) -> usize {
    let methods = options.shadings().count();
    if methods == 0 { 0 } else { (methods + 1) * options.formats().count() }
}

/// Directions under `light`, which is no point; nothing where no method is asked for.
pub fn directions(light: &Light, plan: Plan, progress: &ProgressBar) -> Option<Album> {
    let theta = light.light.angular_radius();
    let items = plan.options.directions();
    if items.is_empty() {
        return None;
    }
    let patch = Patch::about_the_highlight(RADII * theta);
    let seen = extent(&patch, &format!("{} radii of the light across", 2.0 * RADII));
    let scene = format!("{} in a mirror sphere, {seen}", light.name);
    let drawn = workers::map(&items, progress, |&(method, format)| {
        progress.set_message(format!("pictures, {}, {} in {}", light.name, method.name(), format.name()));
        let sphere = format.visit(Mirror { light, method, side: plan.side });
        tile("direction", [method.name(), format.name()], &PER_CENT, &sphere, &scene)
    });
    let truth = Sphere::mirror::<f64>(light, plan.side, |l, r| oracle::nearest_in_disc(l, r, theta));
    let caption = format!("{scene}, as it is: white where the mirror ray meets the disc.");
    let note = format!(
        "A mirror sphere, {seen}. A pixel is white where the method's answer is the mirror ray itself, which it is on \
         the light's disc. Truth: the disc's nearest point at the directions as rounded into the format."
    );
    Some(album(("direction", light.name, PER_CENT, note), (truth.truth(), Format::F64.name(), caption), drawn, plan))
}

struct Mirror<'a> {
    light: &'a Light,
    method: Method,
    side: u32,
}

impl Visitor for Mirror<'_> {
    type Output = Sphere;

    fn visit<T: Real>(self) -> Sphere {
        let constants = Constants::<T>::of(&self.light.light);
        Sphere::mirror(self.light, self.side, |l, r| self.method.direction(l, r, &constants))
    }
}

/// Lit pixels of `case`; nothing where no method is asked for.
pub fn pixels(case: &Case, plan: Plan, progress: &ProgressBar) -> Option<Album> {
    let items = plan.options.highlights();
    if items.is_empty() {
        return None;
    }
    let rows = ProgressBar::hidden();
    let truth_in = |format| {
        progress.set_message(format!("pictures, {}, integrals in {}", case.name, Format::name(format)));
        let truth = lit::truth(case, format, plan.side, plan.options.quick, &rows);
        progress.inc(1);
        truth
    };
    let truths: Vec<_> = plan.options.formats().map(|format| (format, truth_in(format))).collect();
    let seen = extent(&lit::patch(case), "the patch about the highlight");
    let scene = format!("A sphere of albedo {ALBEDO} and reflectance {F0} under {}, {seen}", case.name);
    let drawn = workers::map(&items, progress, |&(method, format)| {
        progress.set_message(format!("pictures, {}, {} in {}", case.name, method.name(), format.name()));
        let truth = truths.iter().find(|(of, _)| *of == format).map(|(_, truth)| truth)?;
        let sphere = format.visit(lit::Drawing { method, case, side: plan.side, truth });
        // The first format is the most exact one; one of its spheres shows the truth.
        let shown = ((method, format) == items[0]).then(|| sphere.truth());
        Some((tile("pixel", [method.name(), format.name()], &RELATIVE, &sphere, &scene), shown))
    });
    let (drawn, shown): (Vec<_>, Vec<_>) = drawn.into_iter().flatten().unzip();
    let shown = shown.into_iter().flatten().next()?;
    let floor = truths.iter().map(|(_, truth)| truth.floor).fold(0.0, f64::max);
    let note = format!(
        "A sphere of albedo {ALBEDO} and reflectance {F0}, {seen}. Truth: the BRDF integrated over the disc at the \
         vectors as rounded into the format. Twice the nodes move it by {} at most: what is below that is the truth's \
         own error.",
        number::scientific(floor)
    );
    let caption = format!("{scene}, as it is: the BRDF integrated over the disc.");
    let format = items[0].1.name();
    Some(album(("pixel", case.name, RELATIVE, note), (shown, format, caption), drawn, plan))
}

/// A tile and its two pictures, which have no light in their names yet.
fn tile(
    subject: &'static str,
    [method, format]: [&'static str; 2],
    scale: &Scale,
    sphere: &Sphere,
    scene: &str,
) -> (Tile, [Picture; 2]) {
    let figures = Figures::of(sphere);
    let rasters = [sphere.computed(), sphere.error(scale)];
    let said = figures.sentence(scale.unit);
    let picture = |kind, raster: &Raster, caption| Picture {
        name: format!("{}-{format}-{}", slug(method), if kind == Kind::Lit { "lit" } else { "error" }),
        subject,
        method: method.to_owned(),
        format: format.to_owned(),
        kind,
        caption,
        size: raster.size,
        png: raster.png(),
    };
    let pictures = [
        picture(Kind::Lit, &rasters[0], format!("{scene}, by {method} in {format}: {said}.")),
        picture(Kind::Error, &rasters[1], format!("The error of {method} in {format}. {scene}: {said}.")),
    ];
    let small = rasters[0].size[0] <= SHEET_SIDE;
    (Tile { method, format, rasters: small.then_some(rasters), figures }, pictures)
}

fn album(
    (subject, of, scale, note): (&'static str, &str, Scale, String),
    (truth, format, caption): (Raster, &str, String),
    drawn: Vec<(Tile, [Picture; 2])>,
    plan: Plan,
) -> Album {
    let (tiles, pictures): (Vec<_>, Vec<_>) = drawn.into_iter().unzip();
    let first = Picture {
        name: format!("{subject}-truth"),
        subject,
        method: "truth".to_owned(),
        format: format.to_owned(),
        kind: Kind::Truth,
        caption,
        size: truth.size,
        png: truth.png(),
    };
    let mut pictures: Vec<_> = [first].into_iter().chain(pictures.into_iter().flatten()).collect();
    if plan.named {
        pictures.iter_mut().for_each(|picture| picture.name = format!("{}-{}", slug(of), picture.name));
    }
    Album { subject, of: of.to_owned(), scale, note, truth, tiles, pictures }
}

/// A name as part of a file's: `karis-3`, `sun-alpha-0.001`.
pub fn slug(name: &str) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() || "._".contains(c) { c.to_ascii_lowercase() } else { '-' };
    let dashed: String = name.chars().map(kept).collect();
    dashed.split('-').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_have_neither_spaces_nor_slashes() {
        assert_eq!(["karis/3", "Sun, alpha 0.001", "cone_ggx"].map(slug), ["karis-3", "sun-alpha-0.001", "cone_ggx"]);
    }
}
