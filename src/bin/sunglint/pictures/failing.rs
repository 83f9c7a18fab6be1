//! Forms that fail, each with the form that does not.

mod forms;

use fixed::types::{I2F14, I2F30};
use half::f16;
use sunglint::trial::gloss::{CASES, Case};
use sunglint::trial::{Constants, Format, Light, Method, Shading, lights};
use sunglint::{Real, SUN};

use super::album::{PER_CENT, RELATIVE};
use super::colour::Scale;
use super::figures::{Figures, per_cent};
use super::flushing::Flushing;
use super::lit;
use super::patch::Patch;
use super::raster::Raster;
use super::sphere::Sphere;
use super::{Kind, Picture};
use crate::number;
use crate::options::Options;

/// A failure and its cure, side by side.
pub struct Failing {
    /// Name of its files, after `failure-`.
    pub name: &'static str,
    /// `direction` or `pixel`.
    pub subject: &'static str,
    /// Name of the method.
    pub method: &'static str,
    /// What goes wrong, in a line.
    pub title: &'static str,
    /// Format and form of what fails and of what does not.
    pub forms: [Form; 2],
    /// The decades of its errors.
    pub scale: Scale,
    /// The figure that tells.
    pub sense: fn(&Figures) -> String,
    /// Draws both.
    pub draw: fn(u32) -> [Sphere; 2],
}

/// A way to compute it.
pub struct Form {
    /// Name of the number format.
    pub format: &'static str,
    /// What is computed, in a few words.
    pub what: &'static str,
}

const fn form(format: &'static str, what: &'static str) -> Form {
    Form { format, what }
}

/// f16 on hardware that flushes subnormals.
const FLUSHING: &str = "flushing f16";

/// All of them, directions first.
pub const ALL: [Failing; 10] = [
    Failing {
        name: "flushed-sun",
        subject: "direction",
        method: "cap",
        title: "The Sun is too wide where f16 flushes subnormals",
        forms: [form(FLUSHING, "squares as they are"), form(FLUSHING, "squares of 64 times the lengths")],
        scale: PER_CENT,
        sense: width,
        draw: |side| [mirror::<Flushing<false>>(Method::Cap, side), mirror::<Flushing<true>>(Method::Cap, side)],
    },
    Failing {
        name: "disc-f16",
        subject: "direction",
        method: "disc",
        title: "The disc by its cosine is lost in f16",
        forms: [form("f16", "disc, by the cosine"), form("f16", "cap, by the sine")],
        scale: PER_CENT,
        sense: width,
        draw: |side| [mirror::<f16>(Method::Disc, side), mirror::<f16>(Method::Cap, side)],
    },
    Failing {
        name: "disc-i2f14",
        subject: "direction",
        method: "disc",
        title: "The disc by its cosine is lost in I2F14",
        forms: [form("I2F14", "disc, by the cosine"), form("I2F14", "cap, by the sine")],
        scale: PER_CENT,
        sense: width,
        draw: |side| [mirror::<I2F14>(Method::Disc, side), mirror::<I2F14>(Method::Cap, side)],
    },
    Failing {
        name: "epic-f16",
        subject: "direction",
        method: "epic",
        title: "149.6 million kilometres do not fit f16",
        forms: [form("f16", "epic, with the distance"), form("f16", "factored, without it")],
        scale: PER_CENT,
        sense: no_direction,
        draw: |side| [mirror::<f16>(Method::Epic, side), mirror::<f16>(Method::Factored, side)],
    },
    Failing {
        name: "subtraction-f16",
        subject: "pixel",
        method: "karis",
        title: "GGX by (n.h)^2 (alpha^2 - 1) + 1 in f16, alpha 0.01",
        forms: [form("f16", "1 - (n.h)^2 by subtraction"), form("f16", "from n - h")],
        scale: RELATIVE,
        sense: lost,
        draw: |side| karis::<f16>(&GLOSS, side, forms::subtracted(&GLOSS)),
    },
    Failing {
        name: "subtraction-flushing",
        subject: "pixel",
        method: "karis",
        title: "The same where f16 flushes, alpha 0.005, from farther off",
        forms: [form(FLUSHING, "1 - (n.h)^2 by subtraction"), form(FLUSHING, "from n - h")],
        scale: RELATIVE,
        sense: lost,
        draw: |side| {
            beside::<Flushing<true>>(&FLUSHED, (&Patch::about_the_highlight(0.29), side), forms::subtracted(&FLUSHED))
        },
    },
    Failing {
        name: "subtraction-f32",
        subject: "pixel",
        method: "karis",
        title: "The same in f32, alpha 0.001, from near by",
        forms: [form("f32", "1 - (n.h)^2 by subtraction"), form("f32", "from n - h")],
        scale: RELATIVE,
        sense: lost,
        draw: |side| karis::<f32>(&POLISH, side, forms::subtracted(&POLISH)),
    },
    Failing {
        name: "karis-squares",
        subject: "pixel",
        method: "karis",
        title: "Karis's factor of squares is 0/0 where f16 flushes, alpha 0.005",
        forms: [form(FLUSHING, "alpha^2 / alpha'^2"), form(FLUSHING, "1 / alpha' twice, to the peak")],
        scale: RELATIVE,
        sense: lost,
        draw: |side| karis::<Flushing<true>>(&FLUSHED, side, forms::squares_divided(&FLUSHED)),
    },
    Failing {
        name: "dim-light",
        subject: "pixel",
        method: "cone_ggx",
        title: "A thousandth of the light, brightened afterwards",
        forms: [form("I2F14", "exposure after the levels"), form("I2F14", "exposure in the illuminance")],
        scale: RELATIVE,
        sense: shades,
        draw: |side| [forms::brightened(&CHALK, side), forms::in_the_light(&CHALK, side)],
    },
    Failing {
        name: "coarse-normals",
        subject: "pixel",
        method: "cone_ggx",
        title: "Normals in f16 on a polish, alpha 0.001",
        forms: [form("f16", "cone_ggx"), form("I2F30", "cone_ggx")],
        scale: RELATIVE,
        sense: lost,
        draw: |side| [forms::unrounded::<f16>(&POLISH, side), forms::unrounded::<I2F30>(&POLISH, side)],
    },
];

/// The Sun on a polish.
const POLISH: Case = CASES[0];

/// The Sun on what is a little less polished.
const GLOSS: Case = Case { name: "Sun, alpha 0.01", light: SUN, alpha: 0.01 };

/// The Sun on a roughness whose square is below the least normal f16.
const FLUSHED: Case = Case { name: "Sun, alpha 0.005", light: SUN, alpha: 0.005 };

/// The Sun on chalk.
const CHALK: Case = CASES[2];

/// The light of all of them.
pub const LIGHT: &str = "Sun from Earth";

impl Failing {
    /// Whether its method is asked for, and the format of what fails or of what does not.
    pub fn is_wanted(&self, options: &Options) -> bool {
        let wanted = |format: Format| self.forms.iter().any(|form| form.format == format.name());
        let of_hardware = self.forms.iter().any(|form| form.format == FLUSHING) && options.wants_format(Format::F16);
        let format =
            of_hardware || Format::ALL.into_iter().any(|format| options.wants_format(format) && wanted(format));
        options.wants_method(self.method) && format
    }

    /// What is to be seen of both, in a sentence.
    pub fn sentence(&self, spheres: &[Sphere; 2]) -> String {
        let [fails, cured] = [0, 1].map(|place| {
            let Form { format, what } = &self.forms[place];
            format!("{what} in {format}: {}", (self.sense)(&Figures::of(&spheres[place])))
        });
        format!("{}. Fails, {fails}. Cured, {cured}.", self.title)
    }

    /// As it fails, the truth, the error, and the cure with its error.
    pub fn pictures(&self, spheres: &[Sphere; 2]) -> [Picture; 5] {
        let [fails, cured] = spheres;
        let said = self.sentence(spheres);
        let picture = |name: &str, kind, format: &str, shown: &str, raster: Raster| Picture {
            name: format!("failure-{}-{name}", self.name),
            subject: self.subject,
            method: self.method.to_owned(),
            format: format.to_owned(),
            kind,
            caption: format!("{shown}. {said}"),
            size: raster.size,
            png: raster.png(),
        };
        let [form, cure] = [0, 1].map(|place| format!("{}, {}", self.forms[place].format, self.forms[place].what));
        [
            picture("lit", Kind::Lit, &form, "As it fails", fails.computed()),
            picture("truth", Kind::Truth, "f64", "As it is", cured.truth()),
            picture("error", Kind::Error, &form, "Its error", fails.error(&self.scale)),
            picture("cured-lit", Kind::Lit, &cure, "The cure", cured.computed()),
            picture("cured-error", Kind::Error, &cure, "The error of the cure", cured.error(&self.scale)),
        ]
    }
}

fn mirror<T: Real>(method: Method, side: u32) -> Sphere {
    let light: Light = lights::STUDY[0];
    let constants = Constants::<T>::of(&light.light);
    Sphere::mirror(&light, side, |l, r| method.direction(l, r, &constants))
}

/// A form of Karis's highlight in `patch`, and this crate's.
fn beside<T: Real>(case: &Case, seen: (&Patch, u32), form: impl Fn([[T; 3]; 3]) -> f64) -> [Sphere; 2] {
    let ours = lit::code::<T>(Shading::Karis, case);
    [forms::against((Shading::Karis, case), seen, form), forms::against((Shading::Karis, case), seen, ours)]
}

/// The same from near by.
fn karis<T: Real>(case: &Case, side: u32, form: impl Fn([[T; 3]; 3]) -> f64) -> [Sphere; 2] {
    beside(case, (&lit::patch(case), side), form).map(Sphere::exposed)
}

fn width(figures: &Figures) -> String {
    let width = match figures.lit {
        lit if lit > 0.6 => "wider than the picture".to_owned(),
        _ => format!("{:.2} times as wide as the Sun", figures.width),
    };
    format!("{width}, errors up to {} % of its radius", number::percent(figures.worst, 100.0))
}

fn no_direction(figures: &Figures) -> String {
    match figures.nan {
        0.0 => width(figures),
        share => format!("{} % of the pixels are NaN", per_cent(share)),
    }
}

/// What is no number, and what is far off.
fn lost(figures: &Figures) -> String {
    let share = |share: f64, what: &str| (share > 0.0).then(|| format!("{} % {what}", per_cent(share)));
    let shares = [
        share(figures.nan, "NaN"),
        share(figures.infinite, "infinite"),
        share(figures.doubled, "off by a factor of two"),
        share(figures.visible - figures.doubled, "off by a tenth"),
    ];
    let shares: Vec<_> = shares.into_iter().flatten().collect();
    match shares.is_empty() {
        true => format!("no pixel is off by a tenth, worst error {} %", per_cent(figures.worst)),
        false => format!("of the pixels {}", shares.join(", ")),
    }
}

fn shades(figures: &Figures) -> String {
    format!("{} levels of grey", figures.shades)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(name: &str) -> [Figures; 2] {
        let failing = ALL.iter().find(|failing| failing.name == name).expect("a failure");
        (failing.draw)(64).map(|sphere| Figures::of(&sphere))
    }

    #[test]
    fn the_suns_that_are_too_wide_are_so_and_cap_is_not() {
        for (name, least) in [("flushed-sun", 1.5), ("disc-f16", 1.5), ("disc-i2f14", 1.02)] {
            let [fails, cured] = drawn(name);
            println!("{name}: {:.3} and {:.3}, rms {:.2} and {:.2}", fails.width, cured.width, fails.rms, cured.rms);
            assert!(fails.width > least && (cured.width - 1.0).abs() < 0.03, "{name}");
        }
    }

    #[test]
    fn what_has_no_number_is_cured() {
        for name in ["epic-f16", "karis-squares"] {
            let [fails, cured] = drawn(name);
            println!("{name}: {} and {}, rms {:.3}", fails.nan, cured.nan, cured.rms);
            assert!(fails.nan > 0.9 && cured.nan == 0.0, "{name}");
        }
    }

    #[test]
    fn subtraction_is_lost_in_f16_and_noise_in_f32() {
        let [fails, cured] = drawn("subtraction-f16");
        println!("{fails:?}\n{cured:?}");
        assert!(fails.infinite + fails.doubled > 0.3 && cured.infinite + cured.doubled == 0.0);
        let [fails, cured] = drawn("subtraction-flushing");
        println!("{fails:?}\n{cured:?}");
        assert!(fails.nan > 0.1 && cured.nan == 0.0 && cured.visible == 0.0);
        let [fails, cured] = drawn("subtraction-f32");
        println!("{fails:?}\n{cured:?}");
        assert!(fails.worst > 0.2 && cured.worst < 3e-4);
    }

    #[test]
    fn bands_are_few_levels_and_coarse_normals() {
        let [fails, cured] = drawn("dim-light");
        println!("{fails:?}\n{cured:?}");
        assert!(fails.shades < 40 && cured.shades > 1000);
        let [fails, cured] = drawn("coarse-normals");
        println!("{fails:?}\n{cured:?}");
        assert!(fails.visible > 0.15 && cured.visible == 0.0);
    }
}
