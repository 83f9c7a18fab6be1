//! The unevaluated sum of two floats, for the few quantities of a light that are computed once and should be right to
//! the last place. Dekker's arithmetic, which needs no fused multiply-add.

use crate::real::{Float, Real};

/// `high + low`, `low` being what rounding took from `high`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair<T> {
    pub(crate) high: T,
    pub(crate) low: T,
}

impl<T: Float> Pair<T> {
    /// A constant given as its nearest number and what that lacks.
    pub(crate) fn constant([high, low]: [T; 2]) -> Self {
        Self { high, low }
    }

    /// Both parts times a power of two.
    pub(crate) fn scaled(self, scale: T) -> Self {
        Self { high: self.high * scale, low: self.low * scale }
    }

    /// `a + b`, exactly, for `a` at least as large as `b`.
    pub(crate) fn sum(a: T, b: T) -> Self {
        let high = a + b;
        Self { high, low: b - (high - a) }
    }

    /// `a b` of numbers that are not negative, exactly as long as nothing underflows.
    pub(crate) fn product(a: T, b: T) -> Self {
        let high = a * b;
        let ([a1, a2], [b1, b2]) = (halves(a), halves(b));
        let low = ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2;
        Self { high, low }
    }

    pub(crate) fn times(self, other: Self) -> Self {
        let Self { high, low } = Self::product(self.high, other.high);
        Self::sum(high, low + (self.high * other.low + self.low * other.high))
    }

    pub(crate) fn over(self, divisor: Self) -> Self {
        let first = self.high / divisor.high;
        let taken = Self::product(first, divisor.high);
        let rest = ((self.high - taken.high) - taken.low) + (self.low - first * divisor.low);
        Self::sum(first, rest / divisor.high)
    }

    /// The square root; zero for zero.
    pub(crate) fn root(self) -> Self {
        let first = self.high.root();
        if first <= T::WIDE_ZERO {
            return self;
        }
        let taken = Self::product(first, first);
        let rest = ((self.high - taken.high) - taken.low) + self.low;
        Self::sum(first, rest / (first + first))
    }

    /// Rounded to the format.
    pub(crate) fn rounded(self) -> T {
        self.high + self.low
    }
}

/// `a`, which must not be negative, cut into two halves of at most half its digits each.
fn halves<T: Float>(a: T) -> [T; 2] {
    // Large numbers have no room above them to be cut in place.
    let room = (T::SPLITTER - T::WIDE_ONE) * (T::WIDE_ONE + T::WIDE_ONE);
    let unit = if a > room { room } else { T::WIDE_ONE };
    let small = a / unit;
    let scaled = small * T::SPLITTER;
    let high = scaled - (scaled - small);
    [high * unit, (small - high) * unit]
}
