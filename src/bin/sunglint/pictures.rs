//! Pictures: lit spheres, the truth, and where the error sits.

mod album;
mod colour;
pub mod contact;
mod failing;
mod figures;
mod lit;
mod patch;
mod raster;
mod sphere;

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::Args;
use indicatif::ProgressBar;
use sunglint::trial::Light;
use sunglint::trial::gloss::Case;

use crate::failure::Failure;
use crate::options::Options;
use crate::{output, pixels, workers};
use album::{Album, Plan};
use failing::Failing;
use raster::Raster;

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The sphere as the method lights it.
    Lit,
    /// The sphere as it is.
    Truth,
    /// The error, on a scale of decades.
    Error,
    /// Many of them with their names.
    Sheet,
}

/// A picture, encoded.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Name of its file without its ending, such as `cap-f16-lit`.
    pub name: String,
    /// `direction` or `pixel`; of a sheet of failures `failure`.
    pub subject: &'static str,
    /// Name of the method; of the truth `truth`, of a sheet `all`.
    pub method: String,
    /// Name of the number format, or of the failing form; of the truth that of its vectors, of a sheet `all`.
    pub format: String,
    /// What it shows.
    pub kind: Kind,
    /// What one sees on it, in a sentence, for those who cannot.
    pub caption: String,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The PNG file.
    pub png: Vec<u8>,
}

/// `sunglint render`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    #[command(flatten)]
    pub options: Options,
    /// Pixels across a sphere, 8 to 4096; up to 160 there are contact sheets as well
    #[arg(long, value_name = "PIXELS", default_value_t = 256)]
    pub size: u32,
    /// Folder to write to in place of OUT/pictures
    #[arg(long, value_name = "DIR")]
    pub to: Option<PathBuf>,
}

/// Pixels across a sphere of the main job.
const SIDE: u32 = 120;

/// Pixels across a failing sphere of the main job.
const FAILING_SIDE: u32 = 144;

/// Pixels across the largest spheres that make a contact sheet.
const SHEET_SIDE: u32 = 160;

/// Pixels across that can be asked for.
const SIZES: RangeInclusive<u32> = 8..=4096;

/// The case that is drawn where none is asked for: its highlight can be seen on a whole sphere.
const FIRST_CASE: &str = "Sun, alpha 0.0625";

/// Steps of the progress bar in the main job.
pub fn steps(options: &Options) -> usize {
    steps_of(&lights(options)[..], &cases(options)[..], options)
}

fn steps_of(lights: &[Light], cases: &[Case], options: &Options) -> usize {
    lights.len() * album::directions_count(options)
        + cases.len() * album::pixels_count(options)
        + failing(options).len()
}

/// The pictures of the main job, small enough for the page, and the contact sheets, on all cores.
pub fn draw(options: &Options, progress: &ProgressBar) -> Vec<Picture> {
    let plan = Plan { options, side: SIDE, named: false };
    let mut pictures: Vec<_> = albums(plan, progress).flat_map(|album| all_of(album, plan)).collect();
    pictures.extend(failures(options, FAILING_SIDE, progress));
    pictures
}

/// The command.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { options, size, to } = arguments;
    if !SIZES.contains(size) {
        let [least, most] = [SIZES.start(), SIZES.end()];
        return Err(Failure::Usage(format!("--size is {size} pixels, allowed is {least} to {most}")));
    }
    let (lights, cases) = (lights(options), cases(options));
    let count = steps_of(&lights, &cases, options);
    if count == 0 {
        return Err(Failure::Usage("no sphere has that method, format and light; see sunglint list".to_owned()));
    }
    let folder = to.clone().unwrap_or_else(|| options.out.join("pictures"));
    output::prepare(&folder)?;
    let progress = crate::progress(options);
    progress.set_length(count as u64);
    let plan = Plan { options, side: *size, named: true };
    let write = |picture: Picture| -> Result<(), Failure> {
        let path = folder.join(format!("{}.png", picture.name));
        output::replace(&path, &picture.png)?;
        let shown = path.display();
        progress.suspend(|| {
            crate::print(&if options.quiet { shown.to_string() } else { format!("{shown}\n  {}", picture.caption) })
        });
        Ok(())
    };
    for album in albums(plan, &progress) {
        all_of(album, plan).into_iter().try_for_each(write)?;
    }
    failures(options, *size, &progress).into_iter().try_for_each(write)?;
    progress.finish_and_clear();
    Ok(())
}

/// The lights whose directions are drawn: the first, unless others were asked for; none that is a point.
fn lights(options: &Options) -> Vec<Light> {
    let lights: Vec<_> = options.lights().into_iter().filter(|light| light.light.angular_radius() > 0.0).collect();
    if options.filter.light.is_some() { lights } else { lights.into_iter().take(1).collect() }
}

/// The cases that are drawn: one, unless others were asked for.
fn cases(options: &Options) -> Vec<Case> {
    let cases = pixels::wanted(options);
    if options.filter.light.is_some() || cases.len() < 2 {
        return cases;
    }
    let first = cases.iter().find(|case| case.name == FIRST_CASE).or(cases.first());
    first.into_iter().copied().collect()
}

/// The failures of the methods that are asked for, if the Sun is.
fn failing(options: &Options) -> Vec<&'static Failing> {
    let wanted = |failing: &&Failing| options.wants(failing::LIGHT) && failing.is_wanted(options);
    failing::ALL.iter().filter(wanted).collect()
}

/// One light after the other.
fn albums(plan: Plan<'_>, progress: &ProgressBar) -> impl Iterator<Item = Album> {
    let directions =
        lights(plan.options).into_iter().filter_map(move |light| album::directions(&light, plan, progress));
    let pixels = cases(plan.options).into_iter().filter_map(move |case| album::pixels(&case, plan, progress));
    directions.chain(pixels)
}

/// The pictures of a light, with a sheet where they are small and many.
fn all_of(album: Album, plan: Plan) -> Vec<Picture> {
    let sheet = (plan.side <= SHEET_SIDE && album.tiles.len() > 1).then(|| {
        let what = if album.subject == "direction" { "Directions" } else { "Lit pixels" };
        let title = format!("{what} under {}: as computed, and the error beneath", album.of);
        let name = format!("{}s", album.subject);
        let name = if plan.named { format!("{}-{name}", album::slug(&album.of)) } else { name };
        let caption = format!("{title}. {}", album.note);
        sheet(name, album.subject, caption, &contact::of_album(&album, &title))
    });
    album.pictures.into_iter().chain(sheet).collect()
}

fn sheet(name: String, subject: &'static str, caption: String, raster: &Raster) -> Picture {
    let all = "all".to_owned();
    let (method, format) = (all.clone(), all);
    Picture { name, subject, method, format, kind: Kind::Sheet, caption, size: raster.size, png: raster.png() }
}

/// Every failure as it is, its truth, its error, its cure, and a sheet of them.
fn failures(options: &Options, side: u32, progress: &ProgressBar) -> Vec<Picture> {
    let drawn = workers::map(&failing(options), progress, |failing| {
        progress.set_message(format!("pictures, {}", failing.title));
        let spheres = (failing.draw)(side);
        (*failing, failing.pictures(&spheres), spheres)
    });
    let mut pictures = Vec::new();
    let mut spheres = Vec::new();
    for (failing, its, both) in drawn {
        pictures.extend(its);
        spheres.push((failing, both));
    }
    if side <= SHEET_SIDE && spheres.len() > 1 {
        let title = "Failures and their cures, under the Sun from Earth";
        let raster = contact::of_failures(&spheres, side, title);
        let caption = format!("{title}. {}", contact::FAILURES);
        pictures.push(sheet("failures".to_owned(), "failure", caption, &raster));
    }
    pictures
}

#[cfg(test)]
mod tests {
    use super::*;
    use sunglint::trial::{Format, Method, Shading};

    const SMALL: u32 = 16;

    fn drawn(options: &Options) -> Vec<Picture> {
        let progress = ProgressBar::hidden();
        let plan = Plan { options, side: SMALL, named: false };
        let mut pictures: Vec<_> = albums(plan, &progress).flat_map(|album| all_of(album, plan)).collect();
        pictures.extend(failures(options, SMALL, &progress));
        assert_eq!(progress.position(), steps(options) as u64);
        pictures
    }

    fn quick() -> Options {
        Options::parse_from(["sunglint", "--quick"])
    }

    fn render(size: u32, folder: PathBuf) -> Result<(), Failure> {
        let options = Options::parse_from(["sunglint", "--quick", "--quiet", "--light", "area light 0.05"]);
        run(&Arguments { options, size, to: Some(folder) })
    }

    #[test]
    fn every_method_in_every_format_has_a_picture_and_its_error() {
        let pictures = drawn(&quick());
        let names = Method::ALL.map(Method::name).into_iter().chain(Shading::ALL.map(Shading::name));
        for (method, format) in names.flat_map(|method| Format::ALL.map(move |format| (method, format.name()))) {
            for kind in [Kind::Lit, Kind::Error] {
                let here =
                    |picture: &&Picture| picture.method == method && picture.format == format && picture.kind == kind;
                assert_eq!(pictures.iter().filter(here).count(), 1, "{method} in {format}");
            }
        }
        let sheets = pictures.iter().filter(|picture| picture.kind == Kind::Sheet);
        assert_eq!(sheets.map(|sheet| &sheet.name[..]).collect::<Vec<_>>(), ["directions", "pixels", "failures"]);
        let mut names: Vec<_> = pictures.iter().map(|picture| &picture.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), pictures.len(), "every file has a name of its own");
    }

    #[test]
    fn a_picture_lies_on_its_sheet_where_its_place_is() {
        let pictures = drawn(&quick());
        for subject in ["direction", "pixel"] {
            let of_subject = || pictures.iter().filter(|picture| picture.subject == subject);
            let sheet = of_subject().find(|picture| picture.kind == Kind::Sheet).expect("a sheet");
            let (_, pixels) = raster::decoded(&sheet.png);
            let lines: Vec<_> = pixels.chunks(3 * sheet.size[0] as usize).collect();
            let placed = of_subject().filter_map(|picture| Some((picture, contact::place(picture, &pictures)?)));
            let placed: Vec<_> = placed.collect();
            let methods = if subject == "direction" { Method::ALL.len() } else { Shading::ALL.len() };
            assert_eq!(placed.len(), 1 + 2 * methods * Format::ALL.len());
            for (picture, place) in placed {
                let [x, y, width, height] =
                    [place[0], place[1], picture.size[0], picture.size[1]].map(|of| of as usize);
                let cut: Vec<u8> =
                    lines[y..y + height].iter().flat_map(|line| line[3 * x..3 * (x + width)].to_vec()).collect();
                assert!(cut == raster::decoded(&picture.png).1, "{}", picture.name);
            }
        }
    }

    #[test]
    fn pictures_repeat() {
        assert!(drawn(&quick()) == drawn(&quick()));
    }

    #[test]
    fn sizes_out_of_range_are_refused() {
        for size in [0, 7, 4097, u32::MAX] {
            let failure = render(size, PathBuf::from("/nowhere")).expect_err("no picture");
            assert_eq!(failure.code(), 2);
            assert_eq!(failure.to_string(), format!("--size is {size} pixels, allowed is 8 to 4096"));
        }
    }

    #[test]
    fn files_are_written_and_a_light_that_is_none_is_refused() {
        let folder = tempfile::tempdir().expect("a folder");
        render(8, folder.path().join("new")).expect("pictures");
        let files = std::fs::read_dir(folder.path().join("new")).expect("files").count();
        assert_eq!(files, 2 + 2 * Method::ALL.len() * Format::ALL.len());
        let options = Options::parse_from(["sunglint", "--quick", "--light", "no such"]);
        let failure = run(&Arguments { options, size: 8, to: None }).expect_err("no light");
        assert_eq!(failure.code(), 2);
    }
}
