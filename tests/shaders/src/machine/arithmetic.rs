//! Arithmetic as a graphics processor may do it: rounded to f32 or f16, subnormals flushed or not, roots and quotients
//! as far off as Vulkan allows.

use std::cell::Cell;

use half::f16;

/// The number format of all operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// f32.
    Single,
    /// f16.
    Half,
}

/// Which way roots and quotients are off.
#[derive(Clone, Debug)]
enum Slack {
    /// They are correctly rounded.
    None,
    /// By all that is allowed, times this sign.
    One(f64),
    /// By a part of it, drawn at random.
    Random(Cell<u64>),
}

/// How a shader computes.
#[derive(Clone, Debug)]
pub struct Arithmetic {
    width: Width,
    flush: bool,
    fused: bool,
    slack: Slack,
}

/// What Vulkan allows, in units in the last place: of an inverse root, a quotient, and a root, which is one over the
/// inverse root.
const ALLOWED: [f64; 3] = [2.0, 2.5, 4.5];

impl Arithmetic {
    /// Every operation correctly rounded.
    pub fn exact(width: Width) -> Self {
        Self { width, flush: false, fused: false, slack: Slack::None }
    }

    /// Subnormals are zero.
    pub fn flushing(self) -> Self {
        Self { flush: true, ..self }
    }

    /// Sums take products before they are rounded, as compilers may arrange where no source says `precise`.
    pub fn fusing(self) -> Self {
        Self { fused: true, ..self }
    }

    /// Roots and quotients all too large, or all too small, by what is allowed.
    pub fn off(self, sign: f64) -> Self {
        Self { slack: Slack::One(sign), ..self }
    }

    /// Roots and quotients off at random.
    pub fn off_at_random(self, seed: u64) -> Self {
        Self { slack: Slack::Random(Cell::new(seed)), ..self }
    }

    /// Four ways of being off.
    pub fn as_vulkan_allows(width: Width) -> [Self; 4] {
        let exact = || Self::exact(width).flushing();
        [exact().off(1.0), exact().off(-1.0), exact().off_at_random(1), exact().off_at_random(2).fusing()]
    }

    pub(super) fn fuses(&self) -> bool {
        self.fused
    }

    /// The nearest number of the format. Rounding f64 again changes no sum, product, quotient or root.
    pub fn rounded(&self, value: f64) -> f64 {
        let (rounded, least) = match self.width {
            Width::Single => (f64::from(value as f32), f64::from(f32::MIN_POSITIVE)),
            Width::Half => (f64::from(f16::from_f64(value)), f64::from(f16::MIN_POSITIVE)),
        };
        if self.flush && rounded.abs() < least { 0.0 } else { rounded }
    }

    pub(super) fn quotient(&self, a: f64, b: f64) -> f64 {
        self.off_by(a / b, ALLOWED[1])
    }

    pub(super) fn root(&self, square: f64) -> f64 {
        self.off_by(square.sqrt(), ALLOWED[2])
    }

    pub(super) fn inverse_root(&self, square: f64) -> f64 {
        self.off_by(1.0 / square.sqrt(), ALLOWED[0])
    }

    pub(super) fn dot(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|lane| a[lane] * b[lane]);
        let [y, z] = [y, z].map(|product| if self.fused { product } else { self.rounded(product) });
        self.rounded(self.rounded(self.rounded(x) + y) + z)
    }

    /// `exact` moved by at most `units` in the last place.
    fn off_by(&self, exact: f64, units: f64) -> f64 {
        let share = match &self.slack {
            Slack::None => 0.0,
            Slack::One(sign) => *sign,
            Slack::Random(state) => draw(state),
        };
        if share == 0.0 || !exact.is_normal() {
            return self.rounded(exact);
        }
        let digits = match self.width {
            Width::Single => 23,
            Width::Half => 10,
        };
        let unit = exact.abs().log2().floor().exp2() / f64::from(1 << digits);
        self.rounded(exact + share * units * unit)
    }
}

/// From -1 to 1.
fn draw(state: &Cell<u64>) -> f64 {
    let next = state.get().wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    state.set(next);
    (next >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}
