//! Measures a method in a format under a light against the oracle.

use super::input::Pair;
use super::method::{Constants, Method};
use super::spread::Spread;
use crate::light::DistantLight;
use crate::oracle;
use crate::real::Real;

/// An error and the rounded inputs that it was found at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst<T> {
    /// In radians.
    pub error: f64,
    /// Direction to the light.
    pub l: [T; 3],
    /// Mirror direction.
    pub r: [T; 3],
}

/// What came of trying a method on many directions. Errors are angles in radians, each maximum and root mean square.
#[derive(Clone, Copy, Debug)]
pub struct Judgement<T> {
    /// Directions tried and judged.
    pub samples: u64,
    /// Directions left out, since the formula has no one answer there ([`Method::is_defined`]).
    pub excluded: u64,
    /// Answers that are no direction (NaN, infinity or the zero vector), which count in none of the errors.
    pub undirected: u64,
    /// Worst arithmetic error: computed against the exact value of the same formula at the rounded inputs. Where no
    /// answer is a direction, the first input.
    pub worst: Worst<T>,
    /// Mean of the squared arithmetic error.
    pub mean_square: f64,
    /// How the arithmetic errors spread: over all pairs, random and hard ones alike.
    pub spread: Spread,
    /// Mean of the signed arithmetic error: how much farther from the light's centre the answer lies than the exact
    /// value.
    pub bias: f64,
    /// Worst model error: the exact value of the formula against the nearest direction of the disc.
    pub model_max: f64,
    /// Mean of the squared model error.
    pub model_mean_square: f64,
    /// Worst error of both together.
    pub total_max: f64,
    /// Mean of the squared error of both together.
    pub total_mean_square: f64,
    /// Worst error of the nearest direction that rounding `l` and `r` into the format makes by itself, where they are
    /// within 90 degrees of each other. No method is blamed for it.
    pub input_max: f64,
    /// Mean of the squared error from rounding the inputs.
    pub input_mean_square: f64,
    /// Worst arithmetic error in units of the angular radius where `r` is within ten radii of the light (and 90
    /// degrees): how far off the disc is drawn. From [`DISC_LOST`] on the disc is lost.
    pub disc_lost: f64,
    /// Worst error of the drawn edge, in units of the angular radius: how much farther out or in than the disc's
    /// nearest point the answer lies, where `r` is as near to the light as that.
    pub edge_max: f64,
    /// Mean of the squared error of the edge.
    pub edge_mean_square: f64,
}

impl<T: Real> Judgement<T> {
    /// Nothing tried yet.
    fn none() -> Self {
        let zero = [T::ZERO; 3];
        Self {
            samples: 0,
            excluded: 0,
            undirected: 0,
            worst: Worst { error: 0.0, l: zero, r: zero },
            mean_square: 0.0,
            spread: Spread::new(),
            bias: 0.0,
            model_max: 0.0,
            model_mean_square: 0.0,
            total_max: 0.0,
            total_mean_square: 0.0,
            input_max: 0.0,
            input_mean_square: 0.0,
            disc_lost: 0.0,
            edge_max: 0.0,
            edge_mean_square: 0.0,
        }
    }
}

/// Half a radius.
pub const DISC_LOST: f64 = 0.5;

/// Tries `method` on `pairs`, each rounded into the format first; `epsilon` is how near to `-l`, in radians, `r` is
/// left out.
pub fn judge<T: Real>(
    method: Method,
    light: &DistantLight,
    pairs: impl Iterator<Item = Pair>,
    epsilon: f64,
) -> Judgement<T> {
    let constants = Constants::<T>::of(light);
    judge_code(method, |l, r| method.direction(l, r, &constants), light, pairs, epsilon)
}

/// The same of `code`, which computes what `method` does in its own way.
pub fn judge_code<T: Real>(
    method: Method,
    code: impl Fn([T; 3], [T; 3]) -> [T; 3],
    light: &DistantLight,
    pairs: impl Iterator<Item = Pair>,
    epsilon: f64,
) -> Judgement<T> {
    let mut sum = Judgement::none();
    let (mut facing, mut near) = (0_u64, 0_u64);
    for pair in pairs {
        let (l, r) = (pair.l.map(T::from_f64), pair.r.map(T::from_f64));
        if let Some(error) = input_error(pair, l.map(T::to_f64), r.map(T::to_f64), light) {
            facing += 1;
            sum.input_max = sum.input_max.max(error);
            sum.input_mean_square += error * error;
        }
        let answer = code(l, r).map(T::to_f64);
        if method.is_defined(l.map(T::to_f64), r.map(T::to_f64), light, epsilon) {
            near += u64::from(add(&mut sum, method, light, Worst { error: 0.0, l, r }, answer));
        } else {
            sum.excluded += 1;
        }
    }
    let mean = |total: f64| total / (sum.samples - sum.undirected).max(1) as f64;
    Judgement {
        mean_square: mean(sum.mean_square),
        bias: mean(sum.bias),
        model_mean_square: mean(sum.model_mean_square),
        total_mean_square: mean(sum.total_mean_square),
        input_mean_square: sum.input_mean_square / facing.max(1) as f64,
        edge_mean_square: sum.edge_mean_square / near.max(1) as f64,
        ..sum
    }
}

/// How far rounding moves the nearest direction, where the light and the mirror ray are within 90 degrees.
fn input_error(pair: Pair, l: [f64; 3], r: [f64; 3], light: &DistantLight) -> Option<f64> {
    let theta = light.angular_radius();
    let facing = oracle::angle_between(pair.l, pair.r) <= core::f64::consts::FRAC_PI_2;
    let before = || oracle::nearest_in_disc(pair.l, pair.r, theta);
    facing.then(|| oracle::angle_between(oracle::nearest_in_disc(l, r, theta), before()))
}

/// Takes in an answer; whether that is a direction near the disc.
fn add<T: Real>(sum: &mut Judgement<T>, method: Method, light: &DistantLight, at: Worst<T>, answer: [f64; 3]) -> bool {
    if sum.samples == 0 {
        sum.worst = at;
    }
    sum.samples += 1;
    // The zero vector has no direction, and atan2 would find no angle in it.
    if !answer.into_iter().all(f64::is_finite) || answer == [0.0; 3] {
        sum.undirected += 1;
        return false;
    }
    let (l, r, theta) = (at.l.map(T::to_f64), at.r.map(T::to_f64), light.angular_radius());
    let exact = method.truth(l, r, light);
    let nearest = oracle::nearest_in_disc(l, r, theta);
    let error = oracle::angle_between(answer, exact);
    let model = oracle::angle_between(exact, nearest);
    let total = oracle::angle_between(answer, nearest);
    let out = oracle::angle_between(l, answer);
    sum.mean_square += error * error;
    sum.model_mean_square += model * model;
    sum.total_mean_square += total * total;
    sum.spread.add(error);
    sum.bias += out - oracle::angle_between(l, exact);
    if error > sum.worst.error {
        sum.worst = Worst { error, ..at };
    }
    sum.model_max = sum.model_max.max(model);
    sum.total_max = sum.total_max.max(total);
    let away = oracle::angle_between(l, r);
    // A point has no disc to lose.
    let near = theta > 0.0 && away <= (10.0 * theta).min(core::f64::consts::FRAC_PI_2);
    if near {
        let edge = libm::fabs(out - away.min(theta)) / theta;
        sum.disc_lost = sum.disc_lost.max(error / theta);
        sum.edge_max = sum.edge_max.max(edge);
        sum.edge_mean_square += edge * edge;
    }
    near
}

#[cfg(test)]
mod tests {
    use super::super::input;
    use super::*;
    use crate::light::SUN;

    fn judged(code: impl Fn([f64; 3], [f64; 3]) -> [f64; 3]) -> Judgement<f64> {
        let pairs = input::random(1, 5000, SUN.angular_radius());
        judge_code(Method::Cap, code, &SUN, pairs, 1e-12)
    }

    /// Always the light's centre: the answer is never too far out, at most by the whole radius too far in.
    #[test]
    fn a_disc_that_is_drawn_as_a_point_is_a_radius_too_small() {
        let point = judged(|l, _| l);
        let theta = SUN.angular_radius();
        assert!((point.worst.error / theta - 1.0).abs() < 1e-9 && (point.edge_max - 1.0).abs() < 1e-9, "{point:?}");
        assert!(point.bias < -0.8 * theta && point.bias > -theta, "{point:?}");
        assert!((point.spread.percentile(0.99) / theta - 1.0).abs() < 0.016, "{point:?}");
    }

    /// Always the mirror ray, as if all of the sky were lit: the edge is judged up to ten radii from the centre.
    #[test]
    fn a_disc_that_never_ends_is_too_great() {
        let sky = judged(|_, r| r);
        assert!(sky.bias > 0.5 && sky.worst.error > 3.0, "{sky:?}");
        assert!((8.0..=9.0).contains(&sky.edge_max) && sky.edge_mean_square < sky.edge_max * sky.edge_max, "{sky:?}");
    }

    #[test]
    fn answers_that_are_no_direction_have_no_edge() {
        let broken = judged(|_, _| [f64::NAN; 3]);
        assert_eq!((broken.undirected, broken.edge_max, broken.bias), (broken.samples, 0.0, 0.0));
    }
}
