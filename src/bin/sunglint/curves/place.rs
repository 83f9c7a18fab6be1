//! Where along an angle or a ratio errors are taken, and the inputs there.

use std::f64::consts::{FRAC_PI_2, PI};

use sunglint::oracle::highlight::Pixel;
use sunglint::trial::gloss::Case;
use sunglint::trial::input::{self, Pair};
use sunglint::{DistantLight, SUN};

/// GGX width of the surface whose pixels are lit.
pub const ALPHA: f64 = 0.0625;

/// The least angle in radians and the least ratio.
const LEAST: f64 = 1e-6;

/// What is lit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A direction.
    Direction,
    /// A surface.
    Pixel,
}

/// What varies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// The angle between mirror ray and light.
    Angle,
    /// What that is short of pi.
    ToOpposite,
    /// Radius over distance of the light.
    Ratio,
}

impl Along {
    pub fn name(self) -> &'static str {
        match self {
            Self::Angle => "angle",
            Self::ToOpposite => "to opposite",
            Self::Ratio => "ratio",
        }
    }
}

/// A range of angles, or a ratio from itself to itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// What is lit there.
    pub subject: Subject,
    /// What varies.
    pub along: Along,
    /// From where to where.
    pub range: [f64; 2],
}

/// All places: angles by four ranges a decade, ratios three a decade.
pub fn places() -> Vec<Place> {
    let angles = |subject, along, most| ranges(most).map(move |range| Place { subject, along, range });
    let ratios = |subject| {
        let ratio = |step: i32| 10_f64.powf(f64::from(step) / 3.0);
        (-18..=0).map(move |step| Place { subject, along: Along::Ratio, range: [ratio(step); 2] })
    };
    let of_directions = angles(Subject::Direction, Along::Angle, PI)
        .chain(angles(Subject::Direction, Along::ToOpposite, FRAC_PI_2))
        .chain(ratios(Subject::Direction));
    of_directions.chain(angles(Subject::Pixel, Along::Angle, FRAC_PI_2)).chain(ratios(Subject::Pixel)).collect()
}

/// From [`LEAST`] to `most`, of which the last may be narrower.
fn ranges(most: f64) -> impl Iterator<Item = [f64; 2]> {
    let edge = |index: i32| LEAST * 10_f64.powf(f64::from(index) / 4.0);
    (0..).map(move |index| [edge(index), edge(index + 1).min(most)]).take_while(move |[from, _]| *from < most)
}

impl Place {
    /// The geometric middle.
    pub fn at(self) -> f64 {
        if self.range[0] == self.range[1] { self.range[0] } else { (self.range[0] * self.range[1]).sqrt() }
    }

    pub fn light(self) -> DistantLight {
        match self.along {
            Along::Ratio => DistantLight::from_ratio(self.range[0]).unwrap_or(SUN),
            Along::Angle | Along::ToOpposite => SUN,
        }
    }

    /// Pairs of directions there; for a ratio at all angles.
    pub fn pairs(self, seed: u64, count: usize) -> Box<dyn Iterator<Item = Pair>> {
        let [least, most] = self.range;
        let between = move |part: f64| least * (most / least).powf(part);
        match self.along {
            Along::Angle => Box::new(input::at_angles(seed, count, between)),
            Along::ToOpposite => Box::new(input::at_angles(seed, count, move |part| PI - between(part))),
            Along::Ratio => Box::new(input::random(seed, count, self.light().angular_radius())),
        }
    }

    /// The surface under its light.
    pub fn case(self) -> Case {
        Case { name: "", light: self.light(), alpha: ALPHA }
    }

    /// Pixels of the surface there; for a ratio all over the highlight.
    pub fn lit(self, seed: u64, count: usize) -> Vec<Pixel> {
        match self.along {
            Along::Ratio => self.case().pixels(seed, count).collect(),
            Along::Angle | Along::ToOpposite => Case::pixels_off(seed, count, self.range).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_meet_and_end_where_they_are_to() {
        let ranges: Vec<_> = ranges(PI).collect();
        assert_eq!((ranges.len(), ranges[0][0], ranges[25][1]), (26, LEAST, PI));
        assert!(ranges.windows(2).all(|pair| pair[0][1] == pair[1][0]));
    }
}
