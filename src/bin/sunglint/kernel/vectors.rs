//! The errors of the kernels that have no trial of their own in the library.

use oorandom::Rand64;
use sunglint::oracle::angle_between;
use sunglint::trial::{Found, input};
use sunglint::{Real, normalize, reflect};

/// Angle between `normalize(v)` and `v`, for lengths from a half to 1.15, the most that fits every format.
pub fn normalize_errors<T: Real>(seed: u64, count: usize) -> Found<3> {
    normalize_errors_of(normalize::<T>, seed, count)
}

/// The same of `code`, which does that in its own way.
pub fn normalize_errors_of<T: Real>(code: impl Fn([T; 3]) -> [T; 3], seed: u64, count: usize) -> Found<3> {
    let mut source = Rand64::new(u128::from(seed));
    let mut found = Found::new();
    for pair in input::random(seed, count, 0.0) {
        let length = 0.5 + 0.65 * source.rand_float();
        let v = pair.r.map(|lane| T::from_f64(length * lane));
        let exact = v.map(T::to_f64);
        found.add(angle(code(v), exact), exact);
    }
    found
}

/// Angle between `reflect(n, v)` and `2 (n.v) n - v` in f64, which is rounded less often here than there.
pub fn reflect_errors<T: Real>(seed: u64, count: usize) -> Found<6> {
    reflect_errors_of(reflect::<T>, seed, count)
}

/// The same of `code`, which does that in its own way.
pub fn reflect_errors_of<T: Real>(code: impl Fn([T; 3], [T; 3]) -> [T; 3], seed: u64, count: usize) -> Found<6> {
    let mut found = Found::new();
    for pair in input::random(seed, count, 0.0) {
        let [n, v] = [pair.l, pair.r].map(|vector| vector.map(T::from_f64));
        let [[a, b, c], [d, e, f]] = [n, v].map(|vector| vector.map(T::to_f64));
        let twice = 2.0 * a.mul_add(d, b.mul_add(e, c * f));
        let truth = [twice.mul_add(a, -d), twice.mul_add(b, -e), twice.mul_add(c, -f)];
        found.add(angle(code(n, v), truth), [a, b, c, d, e, f]);
    }
    found
}

/// The angle between an answer and the truth; NaN where the answer is no direction.
fn angle<T: Real>(answer: [T; 3], truth: [f64; 3]) -> f64 {
    let answer = answer.map(T::to_f64);
    if answer == [0.0; 3] { f64::NAN } else { angle_between(answer, truth) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_that_is_no_direction_is_as_wrong_as_can_be() {
        let mut found = Found::<3>::new();
        found.add(angle([0.0_f32; 3], [0.0, 0.0, 1.0]), [0.0; 3]);
        assert_eq!(found.max, f64::INFINITY);
        assert!(angle([f32::NAN; 3], [0.0, 0.0, 1.0]).is_nan());
    }
}
