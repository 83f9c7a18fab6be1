//! How numbers are written for people.

use crate::clock;

/// Two figures, with a power of ten unless they are short without: `3.9e-4`, `0.99`, `NaN`, `infinite` or `0`.
pub fn scientific(value: f64) -> String {
    match value {
        v if v.is_nan() => "NaN".to_owned(),
        v if v.is_infinite() => "infinite".to_owned(),
        0.0 => "0".to_owned(),
        v if (0.0995..0.995).contains(&v.abs()) => format!("{v:.2}"),
        v if (0.995..9.95).contains(&v.abs()) => format!("{v:.1}"),
        v => format!("{v:.1e}"),
    }
}

/// As few digits as tell it from its neighbours; with a power of ten where they would stand behind many zeros.
pub fn shortest(value: f64) -> String {
    let plain = value == 0.0 || !value.is_finite() || (1e-4..1e15).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

/// `value` to two significant digits.
pub fn two_digits(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

/// `part` of `whole` in per cent, in plain digits as far as they stay short; a dash where the whole is 0.
pub fn percent(part: f64, whole: f64) -> String {
    let value = part / whole * 100.0;
    match value.abs() {
        _ if whole == 0.0 => "–".to_owned(),
        v if !(0.001..10_000.0).contains(&v) => scientific(value),
        v if v >= 10.0 => format!("{value:.0}"),
        v if v >= 1.0 => format!("{value:.1}"),
        v if v >= 0.1 => format!("{value:.2}"),
        v if v >= 0.01 => format!("{value:.3}"),
        _ => format!("{value:.4}"),
    }
}

/// Cost over that of f32 `factored`, to two decimals; with a sign where the clock could not tell.
pub fn cost(value: f64) -> String {
    if value <= clock::LEAST { format!("≤{value:.2}") } else { format!("{value:.2}") }
}

/// Median and quartiles of a cost.
pub fn quartiles([median, low, high]: [f64; 3]) -> String {
    format!("{} ({} to {})", cost(median), cost(low), cost(high))
}

/// A whole number with its thousands apart.
pub fn count(value: u64) -> String {
    let digits = value.to_string();
    let groups = digits.as_bytes().rchunks(3).rev();
    let groups: Vec<_> = groups.map(String::from_utf8_lossy).collect();
    groups.join("\u{202f}")
}

/// Ten to the power of `exponent`, as an axis writes it: `10⁻¹⁶`, `0.01`, `100`.
pub fn power_of_ten(exponent: i32) -> String {
    match exponent {
        -2..=3 => format!("{}", 10f64.powi(exponent)),
        _ => format!("10{}", superscript(exponent)),
    }
}

/// Two to the power of `exponent`, as an axis writes it: `1/4`, `1`, `8`.
pub fn power_of_two(exponent: i32) -> String {
    let size = 2f64.powi(exponent.abs());
    if exponent < 0 { format!("1/{size}") } else { format!("{size}") }
}

/// `number` in superscript digits.
fn superscript(number: i32) -> String {
    let raise = |c: char| match c.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    };
    number.to_string().chars().map(raise).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scientific_copes_with_every_number() {
        let values = [3.94e-4, f64::NAN, f64::INFINITY, 0.0, 0.99, 1.1, 2.1e4];
        let written = values.map(scientific);
        let expected = ["3.9e-4", "NaN", "infinite", "0", "0.99", "1.1", "2.1e4"];
        assert_eq!(written, expected);
    }

    #[test]
    fn two_digits_are_left() {
        assert_eq!([1.26e-5, 0.0, 994.0, f64::INFINITY].map(two_digits), [1.3e-5, 0.0, 990.0, f64::INFINITY]);
        assert!(two_digits(f64::NAN).is_nan());
    }

    #[test]
    fn a_cost_that_the_clock_cannot_tell_says_so() {
        assert_eq!([1.0 / 16.0, 0.07, 12.0].map(cost), ["≤0.06", "0.07", "12.00"]);
    }

    #[test]
    fn percent_stays_short() {
        let values = [8.4, 0.123_4, 0.005_6, 0.084, 0.999e-7, 0.0, f64::NAN, 2.15];
        let written = values.map(|value| percent(value, 1.0));
        let expected = ["840", "12", "0.56", "8.4", "1.0e-5", "0", "NaN", "215"];
        assert_eq!(written, expected);
    }

    #[test]
    fn counts_and_powers_read_well() {
        assert_eq!(count(1_234_567), "1\u{202f}234\u{202f}567");
        assert_eq!(count(12), "12");
        assert_eq!([-16, -2, 0, 2].map(power_of_ten), ["10⁻¹⁶", "0.01", "1", "100"]);
        assert_eq!([-2, 0, 3].map(power_of_two), ["1/4", "1", "8"]);
    }
}
