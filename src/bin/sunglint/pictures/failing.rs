//! Forms that fail, each with the form that does not.

mod catalogue;
mod forms;
mod sense;

pub use catalogue::ALL;

use sunglint::trial::Format;

use super::colour::Scale;
use super::figures::Figures;
use super::raster::Raster;
use super::sphere::Sphere;
use super::{Kind, Picture};
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

/// f16 on hardware that flushes subnormals.
const FLUSHING: &str = "flushing f16";

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
            format!("({what} in {format}): {}", (self.sense)(&Figures::of(&spheres[place])))
        });
        format!("{}. It fails {fails}. Cured {cured}.", self.title)
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
