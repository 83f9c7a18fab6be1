//! f32 in integers.

use sunglint::raw::sphere_q30;
use sunglint::soft::{cap, normalize, reciprocal_root, reflect, root};

use super::{CASES, Hash, Source};

/// Of any bits, NaN, infinities and subnormals included; then of lanes about 1.
pub fn hash() -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for _ in 0..CASES {
        let sphere = sphere_q30(source.ratio()).unwrap();
        let x = f32::from_bits(source.bits());
        for result in [reciprocal_root(x), root(x)] {
            hash.add_32(result.to_bits());
        }
        let any = [0; 3].map(|_: u8| f32::from_bits(source.bits()));
        let [n, v] = [0; 2].map(|_: u8| about_one(&mut source));
        let l = normalize(n);
        let r = reflect(l, normalize(v));
        let caps = [(l, r), (n, v), (any, l), (l, any)].map(|(l, r)| cap(l, r, &sphere));
        for lanes in [normalize(any), reflect(n, v), l, r].into_iter().chain(caps) {
            hash.add_q30(lanes.map(|lane| lane.to_bits() as i32));
        }
    }
    hash.0
}

/// Lanes whose size is from `2^-6` to 4.
fn about_one(source: &mut Source) -> [f32; 3] {
    [0; 3].map(|_: u8| {
        let bits = source.bits();
        f32::from_bits((bits & 0x807f_ffff) | ((121 + (source.bits() & 7)) << 23))
    })
}
