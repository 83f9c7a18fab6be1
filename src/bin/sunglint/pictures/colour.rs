//! Colours: of light, of errors, and of what is no number.

use crate::display::{WHITES, srgb};

/// Red, green and blue of 0 to 255, in sRGB.
pub type Colour = [u8; 3];

/// Around the spheres.
pub const PAPER: Colour = [58, 60, 66];
/// Letters and bars.
pub const INK: Colour = [240, 240, 240];
/// Letters that matter less.
pub const SOFT: Colour = [186, 188, 194];
/// Not a number.
pub const NAN: Colour = [255, 0, 255];
/// Infinite.
pub const INFINITE: Colour = [0, 255, 255];
/// No error at all.
pub const EXACT: Colour = [0, 0, 0];

/// Steps of colour to a decade of the error.
const STEPS: f64 = 4.0;

/// A level of light, linear, 1 being white; nothing is toned down but what is brighter than that.
pub fn of_level(level: f64) -> Colour {
    match level {
        l if l.is_nan() => NAN,
        l if l.is_infinite() => INFINITE,
        l => [encoded(l); 3],
    }
}

/// The number of 8 bits for a share of the light of white.
fn encoded(linear: f64) -> u8 {
    (srgb(linear) * WHITES[0]).round() as u8
}

/// The decades of an error that have colours of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Exponent of the least error that is told from smaller ones.
    pub least: i32,
    /// Exponent of the least error that is not told from greater ones.
    pub most: i32,
    /// What the error is in, as a legend says it.
    pub unit: &'static str,
}

impl Scale {
    /// The colour of an error.
    pub fn colour(&self, error: f64) -> Colour {
        match error {
            e if e.is_nan() => NAN,
            e if e.is_infinite() => INFINITE,
            0.0 => EXACT,
            e => {
                let decades = f64::from(self.most - self.least);
                let step = ((e.log10() - f64::from(self.least)) * STEPS).floor() / STEPS / decades;
                heat(step.clamp(0.0, 1.0))
            }
        }
    }

    /// How many steps of colour there are.
    pub fn steps(&self) -> u32 {
        (self.most - self.least) as u32 * STEPS as u32
    }
}

/// From a dark blue by green to a pale yellow, evenly brighter from 0 to 1: told apart in grey too, and so by all eyes.
///
/// In Oklab (B. Ottosson, 2020) lightness and hue are linear, and the chroma is what sRGB has at every hue on the way.
fn heat(share: f64) -> Colour {
    let lightness = 0.25 + 0.70 * share;
    let hue = (280.0 - 172.0 * share).to_radians();
    let chroma = 0.095 + 0.06 * (2.0 * share - 1.0).powi(2);
    of_oklab([lightness, chroma * hue.cos(), chroma * hue.sin()])
}

/// sRGB of Oklab.
fn of_oklab([lightness, a, b]: [f64; 3]) -> Colour {
    let long = lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b;
    let medium = lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b;
    let short = lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b;
    let [long, medium, short] = [long, medium, short].map(|response| response.powi(3));
    [
        encoded(4.076_741_662_1 * long - 3.307_711_591_3 * medium + 0.230_969_929_2 * short),
        encoded(-1.268_438_004_6 * long + 2.609_757_401_1 * medium - 0.341_319_396_5 * short),
        encoded(-0.004_196_086_3 * long - 0.703_418_614_7 * medium + 1.707_614_701_0 * short),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCALE: Scale = Scale { least: -6, most: 2, unit: "per cent" };

    /// CIE lightness, 0 to 100.
    fn lightness(colour: Colour) -> f64 {
        let linear = colour.map(|code| {
            let share = f64::from(code) / 255.0;
            if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
        });
        let luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
        116.0 * luminance.cbrt() - 16.0
    }

    #[test]
    fn light_is_encoded_as_the_standard_says() {
        assert_eq!([0.0, 1.0, 7.0, -1.0, 0.5, 0.002].map(encoded), [0, 255, 255, 0, 188, 7]);
    }

    #[test]
    fn what_is_no_number_stands_out() {
        assert_eq!([of_level(f64::NAN), of_level(f64::INFINITY)], [NAN, INFINITE]);
        assert_eq!([SCALE.colour(f64::NAN), SCALE.colour(f64::INFINITY), SCALE.colour(0.0)], [NAN, INFINITE, EXACT]);
    }

    #[test]
    fn errors_grow_evenly_brighter() {
        let of_step = |step: u32| lightness(SCALE.colour(10f64.powf(-6.0 + (f64::from(step) + 0.5) / STEPS)));
        let steps: Vec<_> = (1..SCALE.steps()).map(|step| of_step(step) - of_step(step - 1)).collect();
        let [least, most] =
            [f64::min, f64::max].map(|of: fn(f64, f64) -> f64| steps.iter().copied().reduce(of).unwrap());
        assert!(least > 1.0 && most < 2.0 * least, "{least} to {most}");
        assert!(lightness(SCALE.colour(1e-9)) > 8.0, "more than exact");
    }

    #[test]
    fn beyond_the_scale_colours_stay() {
        assert_eq!(SCALE.colour(1e-9), SCALE.colour(1.1e-6));
        assert_eq!(SCALE.colour(1e9), SCALE.colour(1e2));
        assert_ne!(SCALE.colour(1e-3), SCALE.colour(1e-2));
    }
}
