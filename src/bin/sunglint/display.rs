//! Errors of lit pixels as a display shows them.

/// The greatest numbers of 8 and of 10 bits, which are white.
pub const WHITES: [f64; 2] = [255.0, 1023.0];

/// Worst and root mean square of the difference between what is shown and what should be, white being 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// The worst.
    pub max: f64,
    /// Root mean square.
    pub rms: f64,
}

/// The difference between computed levels and true ones, each pair over the level of white, once a display has clipped
/// and encoded them. What is no number, or infinite, is as wrong as can be.
pub fn difference(levels: impl Iterator<Item = [f64; 2]>) -> Difference {
    let (mut max, mut sum, mut count) = (0.0_f64, 0.0, 0_u64);
    for [computed, truth] in levels {
        let apart = if computed.is_finite() { (srgb(computed) - srgb(truth)).abs() } else { 1.0 };
        (max, sum, count) = (max.max(apart), sum + apart * apart, count + 1);
    }
    Difference { max, rms: (sum / count.max(1) as f64).sqrt() }
}

/// What sRGB makes of a level (IEC 61966-2-1), both from 0 to 1; levels beyond are clipped.
pub fn srgb(level: f64) -> f64 {
    let level = level.clamp(0.0, 1.0);
    if level <= 0.003_130_8 { 12.92 * level } else { 1.055 * level.powf(1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ends, half of the light, and the middle of the scale, which is 21.4 % of the light.
    #[test]
    fn levels_are_encoded_as_the_standard_has_it() {
        for (level, encoded) in [(0.0, 0.0), (0.001, 0.01292), (0.5, 0.735_357), (0.214_041, 0.5), (1.0, 1.0)] {
            assert!((srgb(level) - encoded).abs() < 1e-6, "{level}: {}", srgb(level));
        }
        assert!((srgb(0.003_130_8) - srgb(0.003_130_9)).abs() < 2e-6, "the two parts meet");
        assert!(srgb(-3.0) == 0.0 && srgb(70_000.0) == srgb(1.0));
    }

    #[test]
    fn differences_beyond_white_are_not_seen_but_broken_numbers_are() {
        assert_eq!(difference([[5.0, 900.0]].into_iter()), Difference::default());
        for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(difference([[broken, 900.0]].into_iter()), Difference { max: 1.0, rms: 1.0 });
        }
        let half = difference([[0.0, 1.0], [0.5, 0.5], [0.2, 0.2], [1.0, 1.0]].into_iter());
        assert!((half.max - 1.0).abs() < 1e-12 && (half.rms - 0.5).abs() < 1e-12, "{half:?}");
    }
}
