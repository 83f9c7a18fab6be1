//! What came of comparing a kernel with its truth on many inputs.

/// The greater of two errors; NaN if either is, which `f64::max` would drop.
pub fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b <= a { a } else { b }
}

/// The greatest of some errors; NaN if any is.
pub fn worst(errors: impl Iterator<Item = f64>) -> f64 {
    errors.fold(0.0, worse)
}

/// Worst and mean square of an error, and where the worst was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<const INPUTS: usize = 6> {
    /// The greatest error; infinite if any answer was not a number.
    pub max: f64,
    /// Inputs of the greatest error, as rounded into the format; unused places are zero.
    pub worst: [f64; INPUTS],
    /// Inputs that were tried.
    pub samples: u64,
    sum_square: f64,
}

impl<const INPUTS: usize> Found<INPUTS> {
    /// Nothing tried yet.
    pub const fn new() -> Self {
        Self { max: 0.0, worst: [0.0; INPUTS], samples: 0, sum_square: 0.0 }
    }

    /// Takes in `error`, found at `input`.
    pub fn add(&mut self, error: f64, input: [f64; INPUTS]) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        self.samples += 1;
        self.sum_square += error * error;
        if error > self.max {
            (self.max, self.worst) = (error, input);
        }
    }

    /// Root mean square of the errors; zero of none.
    pub fn rms(&self) -> f64 {
        libm::sqrt(self.sum_square / self.samples.max(1) as f64)
    }
}

impl<const INPUTS: usize> Default for Found<INPUTS> {
    fn default() -> Self {
        Self::new()
    }
}
