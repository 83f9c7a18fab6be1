//! Directions in Q30, and lights of all sizes in both formats.

use sunglint::raw::{
    SUN_Q30, SphereQ14, SphereQ30, cap_q14, cap_q30, factored_q14, factored_q30, normalize_q30, reciprocal_root_q16,
    reflect_q30, sphere_q14, sphere_q30,
};

use super::status::{OK, RATIO};
use super::{CASES, Hash, Source};

/// Ratios at the ends of what is allowed, and beyond.
const ENDS: [i32; 6] = [0, 1 << 30, (1 << 30) + 1, -1, i32::MIN, i32::MAX];

/// As in Q14, then the same of vectors of any length, and a root.
pub fn q30() -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for _ in 0..CASES {
        let [n, v, l] = [0; 3].map(|_: u8| normalize_q30(source.lanes_q30()));
        let r = reflect_q30(n, v);
        for lanes in [n, v, l, r, cap_q30(l, r, &SUN_Q30), factored_q30(l, r, &SUN_Q30)] {
            hash.add_q30(lanes);
        }
        let [n, v] = [0; 2].map(|_: u8| source.lanes_q30());
        for lanes in [reflect_q30(n, v), cap_q30(n, v, &SUN_Q30)] {
            hash.add_q30(lanes);
        }
        hash.add_32(reciprocal_root_q16(source.size()));
    }
    hash.0
}

/// Lights of any ratio, half of them out of range, where C has a point; and what two methods make of them.
pub fn lights() -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for case in 0..CASES {
        let ratio = ENDS.get(case as usize).copied().unwrap_or_else(|| source.signed());
        let (made, sphere) = (sphere_q14(ratio), sphere_q14(ratio).unwrap_or_else(|_| point_q14()));
        hash.add_32(if made.is_ok() { OK } else { RATIO });
        for bits in [sphere.sin(), sphere.sin_square(), sphere.cos(), sphere.versine()] {
            hash.add_32(bits as u32);
        }
        let [l, r] = [0; 2].map(|_: u8| source.lanes_q14());
        for lanes in [cap_q14(l, r, &sphere), factored_q14(l, r, &sphere)] {
            hash.add_q14(lanes);
        }

        let (made, sphere) = (sphere_q30(ratio), sphere_q30(ratio).unwrap_or_else(|_| point_q30()));
        hash.add_32(if made.is_ok() { OK } else { RATIO });
        for bits in [sphere.sin(), sphere.sin_square(), sphere.cos(), sphere.versine()] {
            hash.add_64(bits as u64);
        }
        let [l, r] = [0; 2].map(|_: u8| source.lanes_q30());
        for lanes in [cap_q30(l, r, &sphere), factored_q30(l, r, &sphere)] {
            hash.add_q30(lanes);
        }
    }
    hash.0
}

fn point_q14() -> SphereQ14 {
    sphere_q14(0).unwrap()
}

fn point_q30() -> SphereQ30 {
    sphere_q30(0).unwrap()
}
