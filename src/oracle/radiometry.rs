//! Products and quotients of many factors in twice f64's digits: the truth of radiometry's formulas.
//!
//! `tests/radiometry.rs` holds it against 192 bits.

/// A number as its nearest f64 and what that lacks.
pub type Parts = [f64; 2];

/// Pi.
pub const PI: Parts = [core::f64::consts::PI, 1.224_646_799_147_353_2e-16];

/// The product of `above` over the product of `below`.
pub fn quotient(above: &[Parts], below: &[Parts]) -> Parts {
    divided(product(above), product(below))
}

/// `a a + b b + c c`.
pub fn square(v: [f64; 3]) -> Parts {
    v.into_iter().map(|lane| times([lane, 0.0], [lane, 0.0])).fold([0.0; 2], |[high, low], [a, b]| {
        let sum = high + a;
        // Both are positive, but either may be the greater.
        let lost = if high > a { a - (sum - high) } else { high - (sum - a) };
        normal(sum, lost + low + b)
    })
}

/// Relative difference of `computed` from the truth, above zero where it is too great.
pub fn relative_error(computed: f64, [high, low]: Parts) -> f64 {
    ((computed - high) - low) / high
}

fn product(factors: &[Parts]) -> Parts {
    factors.iter().fold([1.0, 0.0], |product, &factor| times(product, factor))
}

fn times([a, b]: Parts, [c, d]: Parts) -> Parts {
    let product = a * c;
    normal(product, libm::fma(a, c, -product) + (a * d + b * c))
}

fn divided([a, b]: Parts, [c, d]: Parts) -> Parts {
    let quotient = a / c;
    normal(quotient, (libm::fma(-quotient, c, a) + (b - quotient * d)) / c)
}

fn normal(high: f64, low: f64) -> Parts {
    let sum = high + low;
    [sum, low - (sum - high)]
}
