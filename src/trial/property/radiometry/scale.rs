//! Definitions over all of f64's range: each factor as a number about one and a power of two, so that neither the
//! product nor what twice the digits need leaves that range.

use crate::oracle::radiometry::{Parts, relative_error};
use crate::trial::radiometry::Formula;

/// A truth: a number about one in twice f64's digits, times two to a power.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    parts: Parts,
    exponent: i32,
}

impl Truth {
    /// The definition of a formula.
    pub fn of(formula: Formula, levels: [f64; 4], cosines: [f64; 2]) -> Self {
        // Of the sphere, one power for all lanes of the position.
        let shared = matches!(formula, Formula::SmallSphere);
        let largest = levels[..3].iter().fold(0.0, |most: f64, level| most.max(level.abs()));
        let powers = [0, 1, 2, 3].map(|i| power(if shared && i < 3 { largest } else { levels[i] }));
        let [first, second] = cosines.map(power);
        let near = [0, 1, 2, 3].map(|i| scaled(levels[i], -powers[i]));
        let cosines_near = [scaled(cosines[0], -first), scaled(cosines[1], -second)];
        let [a, b, c, d] = powers;
        let exponent = match formula {
            Formula::AreaRadiance => a - b - c,
            Formula::LambertianRadiance => a - b,
            Formula::SphereRadiance => a - 2 * b,
            Formula::PointIntensity => a,
            Formula::Irradiance | Formula::PatchSolidAngle => a + first - 2 * b,
            Formula::DiffuseRadiance => first + a,
            Formula::Flux => a + b + first + c + second - 2 * d,
            Formula::SmallSphere => 2 * a - 2 * d,
        };
        Self { parts: formula.truth(near, cosines_near), exponent }
    }

    /// The nearest f64: infinite or zero where it has none.
    pub fn value(self) -> f64 {
        scaled(self.parts[0], self.exponent)
    }

    /// Distance of `computed` as a part of the truth, or of `least` where that is greater.
    pub fn error(self, computed: f64, least: f64) -> f64 {
        let value = self.value();
        if value < least {
            return libm::fabs(computed - value) / least;
        }
        libm::fabs(relative_error(scaled(computed, -self.exponent), self.parts))
    }
}

fn power(value: f64) -> i32 {
    if value == 0.0 || !value.is_finite() { 0 } else { libm::ilogb(value) }
}

/// In two steps, since a power that takes f64 from one end of its range to the other is none itself.
fn scaled(value: f64, exponent: i32) -> f64 {
    libm::scalbn(libm::scalbn(value, exponent / 2), exponent - exponent / 2)
}
