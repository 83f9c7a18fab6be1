//! Vectors of up to 1.16 times the length never overflow: fixed point does what f64 does.

use crate::light::DistantLight;
use crate::real::Real;
use crate::specular::{cap, factored, normalize, reflect};
use crate::sphere::DistantSphere;
use crate::trial::draw::Draw;
use crate::trial::format::{Format, Visitor};
use crate::trial::property::{Broken, Case, inputs};

/// Steps of the format by which a lane may be off, for vectors of 0.84 to 1.16 times the length and ratios up to 0.5:
/// of [`reflect`], [`normalize`], [`factored`] and [`cap`]. 1.12 times the worst of 10 million cases.
const STEPS: [f64; 4] = [0.88, 0.94, 3.2, 2.7];

/// What of an error of [`cap`] is due to the length, where the code by hand takes it to be 1: that share of what the
/// length lacks of 1 or is more. 1.12 times the worst of 10 million cases, I2F30's; I2F14's is 1.36.
const SHARE_OF_LENGTH: f64 = 1.6;

/// Reads a case and says what it breaks.
pub(super) fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let long = Long::drawn(draw);
    let case = Case { format: long.format, inputs: inputs([long.l, long.r, [long.light.sin(), 0.0, 0.0]]) };
    let names =
        ["reflect of long vectors", "normalize of long vectors", "factored of long vectors", "cap of long vectors"];
    let Found { steps, share } = long.format.visit(long);
    for ((name, steps), allowed) in names.into_iter().zip(steps).zip(STEPS) {
        case.at_most(name, steps, allowed)?;
    }
    case.at_most("cap of long vectors, beside their length", share, SHARE_OF_LENGTH)
}

#[derive(Clone, Copy)]
struct Long {
    format: Format,
    light: DistantLight,
    l: [f64; 3],
    r: [f64; 3],
}

impl Long {
    fn drawn(draw: &mut Draw<'_>) -> Self {
        let format = draw.one_of([Format::I2F14, Format::I2F30, Format::I16F16, Format::I2F14]);
        let light = draw.sphere();
        // Beyond, what is normalised may be as short as one likes.
        let light = if light.sin() > 0.5 { ratio(light.sin() / 2.0) } else { light };
        let (l, length) = (draw.direction(), draw.between(0.84, 1.16));
        let r = draw.beside(l, light.angular_radius());
        let [l, r] = [l, r].map(|v| v.map(|lane| lane * length));
        Self { format, light, l, r }
    }
}

fn ratio(ratio: f64) -> DistantLight {
    DistantLight::from_ratio(ratio.clamp(0.0, 1.0)).unwrap_or(crate::light::SUN)
}

/// How far off the functions are.
struct Found {
    /// Of [`STEPS`].
    steps: [f64; 4],
    /// What of [`cap`] is beyond them, by code by hand, as a share of what the length is off.
    share: f64,
}

impl Visitor for Long {
    type Output = Found;

    fn visit<T: Real>(self) -> Found {
        let Self { format, light, l, r } = self;
        let (l, r) = (l.map(T::from_f64), r.map(T::from_f64));
        let (a, b) = (l.map(T::to_f64), r.map(T::to_f64));
        let (sphere, exact) = (DistantSphere::<T>::of(&light), DistantSphere::<f64>::new(&light));
        let apart = |answer: [T; 3], truth: [f64; 3]| {
            let lanes = answer.into_iter().zip(truth);
            lanes.map(|(lane, truth)| (lane.to_f64() - truth).abs() / format.step()).fold(0.0, f64::max)
        };
        // A step inside or outside the rim, where the answer of vectors that are not of length 1 jumps.
        let capped = [0.0, -2.0, 2.0].map(|steps| {
            let beside = DistantSphere::<f64>::new(&ratio(light.sin() + steps * format.step()));
            apart(cap(l, r, &sphere), cap(a, b, &beside))
        });
        // So close to the opposite the rounding of the vectors says to which side the answer turns.
        let opposite = a.into_iter().zip(b).all(|(a, b)| (a + b).abs() < 16.0 * format.step());
        // Of long vectors the answer jumps at a right angle, and f64, which rounds, may see it on the other side.
        let right = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).abs() < 1e-15;
        let capped = if opposite || right { 0.0 } else { capped.into_iter().fold(f64::INFINITY, f64::min) };
        let off = libm::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) - 1.0;
        let by_hand = matches!(format, Format::I2F14 | Format::I2F30);
        let beyond = if by_hand { (capped - STEPS[3]).max(0.0) } else { 0.0 };
        let steps = [
            apart(reflect(l, r), reflect(a, b)),
            apart(normalize(l), normalize(a)),
            apart(factored(l, r, &sphere), factored(a, b, &exact)),
            if by_hand { capped.min(STEPS[3]) } else { capped },
        ];
        Found { steps, share: beyond * format.step() / off.abs().max(format.step()) }
    }
}

#[cfg(test)]
mod tests {
    use oorandom::Rand64;

    use super::*;
    use crate::trial::found::worse;

    #[test]
    fn no_budget_is_four_times_what_is_found() {
        let mut source = Rand64::new(9);
        let (mut worst, mut most) = ([0.0_f64; 4], 0.0_f64);
        for _ in 0..300_000 {
            let mut bytes = [0_u8; 128];
            bytes.chunks_exact_mut(8).for_each(|word| word.copy_from_slice(&source.rand_u64().to_le_bytes()));
            let long = Long::drawn(&mut Draw::new(&bytes));
            let Found { steps, share } = long.format.visit(long);
            for (worst, steps) in worst.iter_mut().zip(steps) {
                *worst = worse(*worst, steps);
            }
            most = worse(most, share);
        }
        println!("{worst:?} {most}");
        for (worst, allowed) in worst.into_iter().zip(STEPS).chain([(most, SHARE_OF_LENGTH)]) {
            assert!((allowed / 4.0..=allowed).contains(&worst), "{worst} of {allowed}");
        }
    }
}
