//! Soft shadows: shares of what is seen, which never rise as more is hidden.

use super::Sample;
use crate::real::{Real, Scalar};
use crate::shadow::{SoftShadow, soft_shadow};
use crate::trial::format::Visitor;
use crate::trial::property::{Broken, Case};

pub struct Shadows {
    pub case: Case,
    pub sample: Sample,
}

impl Visitor for Shadows {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self { case, sample } = self;
        let cone = sample.cone::<T>();
        // A normal that has little to do with the light, or any bits.
        let n = sample.direction.map(T::from_f64);
        let wall = sample.z - 0.5;
        let shadow = |sees: fn(f64, f64) -> bool| {
            soft_shadow(&cone, n, sample.first, sample.count, |direction| sees(direction[0].to_f64(), wall))
        };
        let (all, some, few, none) = (
            shadow(|_, _| true),
            shadow(|x, wall| x > wall),
            shadow(|x, wall| x > wall && x < wall + 0.25),
            shadow(|_, _| false),
        );
        let levels = [all, some, few, none].map(numbers);
        for level in levels {
            case.holds("shadows are finite", level.into_iter().all(f64::is_finite))?;
            case.holds("shares are from 0 to 1", (0.0..=1.0).contains(&level[0]))?;
            case.holds("means of cosines are from 0 to 2", (0.0..=2.0).contains(&level[1]))?;
            case.at_most(
                "cosines are shares of what is seen",
                level[1],
                1.01 * level[0] + f64::from(u8::from(sample.raw)),
            )?;
        }
        case.holds("nothing seen is no light", numbers(none) == [0.0; 3])?;
        for [more, less] in [[levels[0], levels[1]], [levels[1], levels[2]], [levels[2], levels[3]]] {
            case.holds("what hides more is not brighter", [0, 1, 2].into_iter().all(|i| less[i] <= more[i]))?;
        }
        let facing = soft_shadow(&cone, sample.l.map(T::from_f64), sample.first, sample.count, |_| true);
        let whole = sample.count == 0 || sample.light.cos() < 0.1 || facing.visible.exact() == 1.0;
        case.holds("what faces the light sees all of it", sample.raw || whole)
    }
}

/// Share, cosine and radiance.
fn numbers<T: Real>(seen: SoftShadow<T>) -> [f64; 3] {
    let one = T::Scalar::ONE;
    [seen.visible, seen.cosine, seen.radiance(one, one)].map(Scalar::exact)
}
