//! How far a number can be shifted up, on chips that cannot count leading zeros by a search instead. Both ways give the
//! same number.

use crate::multiply::NARROW;

/// The leading zeros of `word`, less one where they are odd: from 0 to 30, and 0 for 0.
#[inline(always)]
pub(crate) const fn even_zeros(word: u32) -> u32 {
    if NARROW { even_zeros_by_search(word) } else { word.leading_zeros() & 30 }
}

#[inline(always)]
const fn even_zeros_by_search(word: u32) -> u32 {
    if word == 0 {
        return 0;
    }
    let (mut word, mut zeros) = (word, 0);
    if word >> 16 == 0 {
        word <<= 16;
        zeros = 16;
    }
    if word >> 24 == 0 {
        word <<= 8;
        zeros |= 8;
    }
    if word >> 28 == 0 {
        word <<= 4;
        zeros |= 4;
    }
    if word >> 30 == 0 { zeros | 2 } else { zeros }
}

#[cfg(test)]
mod tests {
    use super::{even_zeros, even_zeros_by_search};

    #[test]
    fn a_search_counts_the_same() {
        let ends = (0..32).flat_map(|place| [1_u32 << place, (1 << place) - 1, u32::MAX >> place]);
        for word in ends.chain((0..100_000_u32).map(|step| step.wrapping_mul(2_654_435_761) >> (step % 32))) {
            let even = if word == 0 { 0 } else { word.leading_zeros() / 2 * 2 };
            assert_eq!([even_zeros(word), even_zeros_by_search(word)], [even; 2], "{word:#x}");
        }
    }
}
