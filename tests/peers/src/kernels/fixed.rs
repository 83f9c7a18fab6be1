//! The crate `fixed` by its own operators: `*` floors, `/` is a division, `sqrt` floors.

use core::ops::{Add, Div, Mul};

use fixed::types::{I2F14, I2F30, I16F16, U16F16};

/// What the formats have in common here.
pub trait Number: Copy + Add<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    /// The square root.
    fn root(self) -> Self;
}

impl Number for I2F14 {
    #[inline]
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl Number for I2F30 {
    #[inline]
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl Number for I16F16 {
    #[inline]
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// The dot product.
pub fn dot<T: Number>([a, b]: &[[T; 3]; 2]) -> T {
    product(*a, *b)
}

/// A vector at unit length. Panics, or is meaningless, where the square leaves the format or is zero.
pub fn normalize<T: Number>(v: &[T; 3]) -> [T; 3] {
    let length = product(*v, *v).root();
    [v[0] / length, v[1] / length, v[2] / length]
}

/// The square root.
pub fn root(square: &U16F16) -> U16F16 {
    square.sqrt()
}

/// One over the square root.
pub fn reciprocal_root(square: &U16F16) -> U16F16 {
    square.sqrt().recip()
}

#[inline]
fn product<T: Number>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
