//! The integer kernels beneath [`Scaled`](crate::real::Scaled) and the fixed-point formats, for tests that try every
//! mantissa.

use crate::{reciprocal, root};

/// `2^31 / sqrt((m + 1/2) / 2^32)` for `m` from `2^30`, by which fixed point normalises: within 0.58 of the last place.
pub fn reciprocal_root(m: u32) -> u32 {
    root::reciprocal_root(m)
}

/// `2^32 (1 / sqrt(m / 2^32) - 1)` for `m` from `2^30`, by which `Scaled` takes roots: within 0.65 of the last place;
/// one less for `m = 2^30`.
pub fn fraction_of_reciprocal_root(m: u32) -> u32 {
    root::fraction_of_reciprocal_root(m)
}

/// `2^32 (2^31 / m - 1)` for `m` from `2^30` to `2^31 - 1`, by which `Scaled` divides: within 0.54 of the last place;
/// one less for `m = 2^30`.
pub fn fraction_of_reciprocal(m: u32) -> u32 {
    reciprocal::fraction_of_reciprocal(m)
}
