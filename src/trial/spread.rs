//! How errors spread: a histogram with bins of equal ratio, from which percentiles are read without keeping the errors.

use core::fmt;

/// Bins between a power of two and the next.
const BINS: usize = 32;

/// The exponents of the least and of the greatest error that are told apart: `2^-64` and `2^16`.
const EXPONENTS: [i32; 2] = [-64, 16];

/// As many bins as those make.
const COUNT: usize = BINS * (EXPONENTS[1] - EXPONENTS[0]) as usize;

/// Errors that are not negative, counted. A bin is at most a 32nd of its errors wide, so that its middle is within
/// 1.6 % of each of them. Errors below `2^-64` count as zero, those from `2^16` on as infinite.
#[derive(Clone, Copy, PartialEq)]
pub struct Spread {
    bins: [u32; COUNT],
    /// Errors below all bins.
    below: u64,
    /// Errors in all.
    samples: u64,
}

impl Spread {
    /// Nothing counted yet.
    pub const fn new() -> Self {
        Self { bins: [0; COUNT], below: 0, samples: 0 }
    }

    /// Counts `error`; NaN as infinite.
    pub fn add(&mut self, error: f64) {
        self.samples += 1;
        if error < libm::scalbn(1.0, EXPONENTS[0]) {
            self.below += 1;
        } else if let Some(bin) = self.bins.get_mut(bin(error)) {
            *bin += 1;
        }
    }

    /// The least error that a `share` of all, such as 0.99, does not exceed: to within 1.6 %. Zero where there is none.
    pub fn percentile(&self, share: f64) -> f64 {
        let rank = (libm::ceil(share * self.samples as f64) as u64).clamp(1, self.samples.max(1));
        let mut counted = self.below;
        if counted >= rank || self.samples == 0 {
            return 0.0;
        }
        for (index, &bin) in self.bins.iter().enumerate() {
            counted += u64::from(bin);
            if counted >= rank {
                return middle(index);
            }
        }
        f64::INFINITY
    }
}

/// The bin of an error that is at least that of the first. NaN and what is too great are beyond the last.
fn bin(error: f64) -> usize {
    // The exponent's bits and the first five of the mantissa's, which are in order as numbers are.
    let place = error.to_bits() >> (52 - BINS.ilog2());
    (place as usize).saturating_sub((1023 + EXPONENTS[0]) as usize * BINS)
}

fn middle(bin: usize) -> f64 {
    let exponent = EXPONENTS[0] + (bin / BINS) as i32;
    libm::scalbn(1.0 + ((bin % BINS) as f64 + 0.5) / BINS as f64, exponent)
}

impl Default for Spread {
    fn default() -> Self {
        Self::new()
    }
}

impl fmt::Debug for Spread {
    /// The thousands of bins would tell nothing.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percentiles = [0.5, 0.9, 0.99].map(|share| self.percentile(share));
        f.debug_struct("Spread").field("samples", &self.samples).field("percentiles", &percentiles).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_percentile_is_within_a_sixtieth_of_the_exact_one() {
        for size in [1e-18, 3e-7, 1.0, 700.0] {
            let mut spread = Spread::new();
            let errors: [f64; 1000] = core::array::from_fn(|index| size * libm::exp(index as f64 / 300.0));
            errors.iter().rev().for_each(|&error| spread.add(error));
            for (share, exact) in [(0.001, errors[0]), (0.5, errors[499]), (0.99, errors[989]), (1.0, errors[999])] {
                assert!((spread.percentile(share) / exact - 1.0).abs() < 0.016, "{share} of {size}: {exact}");
            }
        }
    }

    #[test]
    fn what_no_bin_holds_is_zero_or_infinite() {
        let mut spread = Spread::new();
        assert_eq!(spread.percentile(0.99), 0.0);
        [0.0, 1e-30, 1.0, 1e9, f64::INFINITY, f64::NAN].into_iter().for_each(|error| spread.add(error));
        assert_eq!([0.33, 0.84, 1.0].map(|share| spread.percentile(share)), [0.0, f64::INFINITY, f64::INFINITY]);
        assert!((spread.percentile(0.5) - 1.0).abs() < 0.016);
    }
}
