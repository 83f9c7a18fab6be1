//! What came of comparing a kernel with its truth on many inputs.

use super::spread::Spread;

/// The greater of two errors; NaN if either is, which `f64::max` would drop.
pub fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b <= a { a } else { b }
}

/// The greatest of some errors; NaN if any is.
pub fn worst(errors: impl Iterator<Item = f64>) -> f64 {
    errors.fold(0.0, worse)
}

/// Worst, mean square, percentiles and bias of an error, and where the worst was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<const INPUTS: usize = 6> {
    /// The greatest error; infinite if any answer was not a number.
    pub max: f64,
    /// Inputs of the greatest error, as rounded into the format; unused places are zero.
    pub worst: [f64; INPUTS],
    /// Inputs that were tried.
    pub samples: u64,
    sum_square: f64,
    spread: Spread,
    /// Of the errors that have a sign, and how many those are.
    sum: f64,
    signed: u64,
}

impl<const INPUTS: usize> Found<INPUTS> {
    /// Nothing tried yet.
    pub const fn new() -> Self {
        let spread = Spread::new();
        Self { max: 0.0, worst: [0.0; INPUTS], samples: 0, sum_square: 0.0, spread, sum: 0.0, signed: 0 }
    }

    /// Takes in `error`, which is the size of one, found at `input`.
    pub fn add(&mut self, error: f64, input: [f64; INPUTS]) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        self.samples += 1;
        self.sum_square += error * error;
        self.spread.add(error);
        if error > self.max {
            (self.max, self.worst) = (error, input);
        }
    }

    /// The same of an error that has a sign: above zero where the answer is too great.
    pub fn add_signed(&mut self, error: f64, input: [f64; INPUTS]) {
        self.sum += error;
        self.signed += 1;
        self.add(libm::fabs(error), input);
    }

    /// Root mean square of the errors; zero of none.
    pub fn rms(&self) -> f64 {
        libm::sqrt(self.sum_square / self.samples.max(1) as f64)
    }

    /// The size that 99 in 100 errors do not exceed, to within 1.6 %; over all inputs, random and hard ones alike.
    pub fn p99(&self) -> f64 {
        // Of the worst errors' bin the middle may be beyond them.
        self.spread.percentile(0.99).min(self.max)
    }

    /// Mean of the errors with their signs, where all have one.
    pub fn bias(&self) -> Option<f64> {
        (self.signed > 0 && self.signed == self.samples).then(|| self.sum / self.samples as f64)
    }
}

impl<const INPUTS: usize> Default for Found<INPUTS> {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_of_either_sign_have_a_size_and_a_bias() {
        let mut found = Found::<1>::new();
        (0..200).for_each(|index| found.add_signed(if index % 4 == 0 { -0.5 } else { 0.25 }, [f64::from(index)]));
        assert_eq!((found.max, found.worst, found.samples), (0.5, [0.0], 200));
        assert_eq!(found.bias(), Some((3.0 * 0.25 - 0.5) / 4.0));
        assert_eq!((found.p99(), found.rms()), (0.5, (7.0_f64 / 64.0).sqrt()));
    }

    #[test]
    fn errors_without_a_sign_have_no_bias() {
        let mut found = Found::<1>::new();
        assert_eq!(found.bias(), None);
        found.add_signed(1.0, [0.0]);
        found.add(1.0, [0.0]);
        assert_eq!(found.bias(), None);
    }

    #[test]
    fn an_answer_that_is_no_number_is_infinitely_wrong() {
        let mut found = Found::<1>::new();
        found.add_signed(f64::NAN, [7.0]);
        assert_eq!((found.max, found.worst, found.p99()), (f64::INFINITY, [7.0], f64::INFINITY));
    }
}
