//! The list of what fails.

use fixed::types::{I2F14, I2F30};
use half::f16;
use sunglint::trial::emulated::{FlushingF16, UnscaledF16};
use sunglint::trial::gloss::{CASES, Case};
use sunglint::trial::{Constants, Light, Method, Shading, lights};
use sunglint::{Real, SUN};

use super::{FLUSHING, Failing, Form, forms, sense};
use crate::pictures::album::{PER_CENT, RELATIVE};
use crate::pictures::lit;
use crate::pictures::patch::Patch;
use crate::pictures::sphere::Sphere;

const fn form(format: &'static str, what: &'static str) -> Form {
    Form { format, what }
}

/// All of them, directions first.
pub const ALL: [Failing; 10] = [
    Failing {
        name: "flushed-sun",
        subject: "direction",
        method: "cap",
        title: "The Sun is too wide where f16 flushes subnormals",
        forms: [form(FLUSHING, "squares as they are"), form(FLUSHING, "squares of 64 times the lengths")],
        scale: PER_CENT,
        sense: sense::width,
        draw: |side| [mirror::<UnscaledF16>(Method::Cap, side), mirror::<FlushingF16>(Method::Cap, side)],
    },
    Failing {
        name: "disc-f16",
        subject: "direction",
        method: "disc",
        title: "The disc by its cosine is lost in f16",
        forms: [form("f16", "disc, by the cosine"), form("f16", "cap, by the sine")],
        scale: PER_CENT,
        sense: sense::width,
        draw: |side| [mirror::<f16>(Method::Disc, side), mirror::<f16>(Method::Cap, side)],
    },
    Failing {
        name: "disc-i2f14",
        subject: "direction",
        method: "disc",
        title: "The disc by its cosine is lost in I2F14",
        forms: [form("I2F14", "disc, by the cosine"), form("I2F14", "cap, by the sine")],
        scale: PER_CENT,
        sense: sense::width,
        draw: |side| [mirror::<I2F14>(Method::Disc, side), mirror::<I2F14>(Method::Cap, side)],
    },
    Failing {
        name: "epic-f16",
        subject: "direction",
        method: "epic",
        title: "149.6 million kilometres do not fit f16",
        forms: [form("f16", "epic, with the distance"), form("f16", "factored, without it")],
        scale: PER_CENT,
        sense: sense::no_direction,
        draw: |side| [mirror::<f16>(Method::Epic, side), mirror::<f16>(Method::Factored, side)],
    },
    Failing {
        name: "subtraction-f16",
        subject: "pixel",
        method: "karis",
        title: "GGX by (n.h)^2 (alpha^2 - 1) + 1 in f16, alpha 0.01",
        forms: [form("f16", "1 - (n.h)^2 by subtraction"), form("f16", "from n - h")],
        scale: RELATIVE,
        sense: sense::lost,
        draw: |side| karis::<f16>(&GLOSS, side, forms::subtracted(&GLOSS)),
    },
    Failing {
        name: "subtraction-flushing",
        subject: "pixel",
        method: "karis",
        title: "The same where f16 flushes, alpha 0.005, from farther off",
        forms: [form(FLUSHING, "1 - (n.h)^2 by subtraction"), form(FLUSHING, "from n - h")],
        scale: RELATIVE,
        sense: sense::lost,
        draw: |side| {
            beside::<FlushingF16>(&FLUSHED, (&Patch::about_the_highlight(0.29), side), forms::subtracted(&FLUSHED))
        },
    },
    Failing {
        name: "subtraction-f32",
        subject: "pixel",
        method: "karis",
        title: "The same in f32, alpha 0.001, from near by",
        forms: [form("f32", "1 - (n.h)^2 by subtraction"), form("f32", "from n - h")],
        scale: RELATIVE,
        sense: sense::lost,
        draw: |side| karis::<f32>(&POLISH, side, forms::subtracted(&POLISH)),
    },
    Failing {
        name: "karis-squares",
        subject: "pixel",
        method: "karis",
        title: "Karis's factor of squares is 0/0 where f16 flushes, alpha 0.005",
        forms: [form(FLUSHING, "alpha^2 / alpha'^2"), form(FLUSHING, "over alpha' twice, not over its square")],
        scale: RELATIVE,
        sense: sense::lost,
        draw: |side| karis::<FlushingF16>(&FLUSHED, side, forms::squares_divided(&FLUSHED)),
    },
    Failing {
        name: "dim-light",
        subject: "pixel",
        method: "cone_ggx",
        title: "A thousandth of the light, brightened afterwards, shows as bands",
        forms: [form("I2F14", "exposure after the levels"), form("I2F14", "exposure in the illuminance")],
        scale: RELATIVE,
        sense: sense::shades,
        draw: |side| [forms::brightened(&CHALK, side), forms::in_the_light(&CHALK, side)],
    },
    Failing {
        name: "coarse-normals",
        subject: "pixel",
        method: "cone_ggx",
        title: "Rounded normals show as blocks on a polish, alpha 0.001",
        forms: [form("f16", "cone_ggx"), form("I2F30", "cone_ggx")],
        scale: RELATIVE,
        sense: sense::lost,
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
