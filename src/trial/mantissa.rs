//! The integer kernels beneath [`Scaled`](crate::real::Scaled) and the fixed-point formats, for tests that try every
//! mantissa.

use crate::{reciprocal, root};

/// `2^31 / sqrt((m + 1/2) / 2^32)` for `m` from `2^30`, by which fixed point normalises: within 0.573 of the
/// last place.
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

/// The two above, by products of 64 bits and by those of 16-bit halves, the same.
pub fn by_words_and_halves(m: u32) -> [[u32; 2]; 2] {
    [
        [root::of_middle::<false>(m), root::of_whole::<32, false>(m)],
        [root::of_middle::<true>(m), root::of_whole::<32, true>(m)],
    ]
}
