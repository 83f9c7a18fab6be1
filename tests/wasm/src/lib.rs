//! The Sun's glint for WebAssembly. A vector is three lanes of 16 bits in an i64, the first lowest, in Q14: 16384 is 1.

use sunglint::raw::{self, SUN_Q14};

/// The vector of length 1 in the direction of `v`.
#[unsafe(no_mangle)]
pub extern "C" fn normalize_q14(v: i64) -> i64 {
    packed(raw::normalize_q14(lanes(v)))
}

/// The mirror ray of `v`, the direction to the viewer, about the normal `n`.
#[unsafe(no_mangle)]
pub extern "C" fn reflect_q14(n: i64, v: i64) -> i64 {
    packed(raw::reflect_q14(lanes(n), lanes(v)))
}

/// The direction of the Sun's disc that is nearest to the mirror ray `r`; `l` is the direction to its centre.
#[unsafe(no_mangle)]
pub extern "C" fn cap_q14(l: i64, r: i64) -> i64 {
    packed(raw::cap_q14(lanes(l), lanes(r), &SUN_Q14))
}

/// How bright the glint is, 0 to 255: full on the Sun's disc, nothing from a degree (286 steps) outside.
#[unsafe(no_mangle)]
pub extern "C" fn glint_q14(n: i64, v: i64, l: i64) -> i32 {
    let r = reflect_q14(n, v);
    let (s, r) = (lanes(cap_q14(l, r)), lanes(r));
    let apart: i64 = (0..3).map(|i| (i64::from(s[i]) - i64::from(r[i])).pow(2)).sum();
    (255 - (apart * 255 / 81_796).min(255)) as i32
}

fn lanes(v: i64) -> [i16; 3] {
    [v as i16, (v >> 16) as i16, (v >> 32) as i16]
}

fn packed([x, y, z]: [i16; 3]) -> i64 {
    i64::from(x as u16) | i64::from(y as u16) << 16 | i64::from(z as u16) << 32
}
