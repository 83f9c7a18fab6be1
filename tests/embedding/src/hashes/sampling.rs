//! Cones, their directions and soft shadows in both formats.

use sunglint::raw::{
    basis_q14, basis_q30, cone_contains_q14, cone_contains_q30, cone_direction_q14, cone_direction_q30, cone_q14,
    cone_q30, normalize_q14, normalize_q30, points_q14, points_q30, soft_shadow_q14, soft_shadow_q30, sphere_q14,
    sphere_q30,
};

use super::{CASES, Hash, Source};

/// Directions of every shadow at most.
const MOST: u32 = 15;

/// Lights of all sizes about unit vectors, and about any, by turns.
pub fn hash() -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for case in 0..CASES {
        q14(&mut source, &mut hash, case & 1 == 0);
        q30(&mut source, &mut hash, case & 1 == 0);
    }
    // C's pointers to nothing: a direction, an answer, two shadows and how often it was asked.
    hash.add(&[0; 3 * 2 + 4 + 2 * 8 + 4]);
    hash.add(&[0; 3 * 4 + 4 + 2 * 8 + 4]);
    hash.0
}

fn q14(source: &mut Source, hash: &mut Hash, unit: bool) {
    let (any, sphere) = (source.lanes_q14(), sphere_q14(source.ratio()).unwrap());
    let l = if unit { normalize_q14(any) } else { any };
    let cone = cone_q14(l, &sphere);
    for lanes in basis_q14(l) {
        hash.add_q14(lanes);
    }
    let first = source.bits();
    for [z, turn] in points_q14(first, 1) {
        hash.add_q14([z, turn, 0]);
        hash.add_q14(cone_direction_q14(&cone, [z, turn]));
    }
    let [z, turn, _] = source.lanes_q14();
    let direction = cone_direction_q14(&cone, [z, turn]);
    hash.add_q14(direction);
    let n = source.lanes_q14();
    for lanes in [direction, n] {
        hash.add_32(cone_contains_q14(&cone, lanes).into());
    }
    // Behind a wall through the light's centre.
    let (count, mut asked) = (source.bits() & MOST, 0);
    let seen = soft_shadow_q14(&cone, n, first, count, |direction| {
        asked += 1;
        direction[0] > l[0]
    });
    for mean in seen {
        hash.add_32(mean as u32);
    }
    hash.add_32(asked);
}

fn q30(source: &mut Source, hash: &mut Hash, unit: bool) {
    let (any, sphere) = (source.lanes_q30(), sphere_q30(source.ratio()).unwrap());
    let l = if unit { normalize_q30(any) } else { any };
    let cone = cone_q30(l, &sphere);
    for lanes in basis_q30(l) {
        hash.add_q30(lanes);
    }
    let first = source.bits();
    for [z, turn] in points_q30(first, 1) {
        hash.add_q30([z, turn, 0]);
        hash.add_q30(cone_direction_q30(&cone, [z, turn]));
    }
    let [z, turn, _] = source.lanes_q30();
    let direction = cone_direction_q30(&cone, [z, turn]);
    hash.add_q30(direction);
    let n = source.lanes_q30();
    for lanes in [direction, n] {
        hash.add_32(cone_contains_q30(&cone, lanes).into());
    }
    let (count, mut asked) = (source.bits() & MOST, 0);
    let seen = soft_shadow_q30(&cone, n, first, count, |direction| {
        asked += 1;
        direction[0] > l[0]
    });
    for mean in seen {
        hash.add_32(mean as u32);
    }
    hash.add_32(asked);
}
