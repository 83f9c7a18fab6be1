//! I2F30 by hand: the lanes of `normalize` are faithful, and `cap` is where its formula is.

use fixed::types::I2F30;
use oorandom::Rand64;
use sunglint::trial::{formula, input};
use sunglint::{DistantLight, DistantSphere, cap, normalize};

/// In steps of the format, of the lane that is farthest off.
fn error(v: [i32; 3]) -> f64 {
    let exact = v.map(f64::from);
    let length = exact.iter().map(|lane| lane * lane).sum::<f64>().sqrt();
    let unit = normalize(v.map(I2F30::from_bits)).map(|lane| f64::from(lane.to_bits()));
    let errors = [0, 1, 2].map(|i| (unit[i] - exact[i] / length * f64::from(1 << 30)).abs());
    errors.into_iter().fold(0.0, f64::max)
}

fn random(source: &mut Rand64) -> [i32; 3] {
    let shift = source.rand_range(0..30);
    [(); 3].map(|()| (source.rand_u64() as i32) >> (shift + source.rand_range(0..2)))
}

/// A vector beside `v`.
fn moved(v: [i32; 3], source: &mut Rand64) -> [i32; 3] {
    let mut next = v;
    for _ in 0..source.rand_range(1..4) {
        let step = (source.rand_u64() as i32) >> source.rand_range(8..32);
        let lane = &mut next[source.rand_range(0..3) as usize];
        *lane = lane.saturating_add(step);
    }
    if next == [0; 3] { v } else { next }
}

/// Uphill from random vectors of all lengths, from a step to the greatest.
#[test]
fn every_lane_of_normalize_is_faithful() {
    let mut source = Rand64::new(30);
    let mut worst = 0.0_f64;
    for _ in 0..400 {
        let start = (0..100).map(|_| random(&mut source)).filter(|&v| v != [0; 3]);
        let (mut v, mut most) = start.map(|v| (v, error(v))).max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        for _ in 0..2000 {
            let next = moved(v, &mut source);
            let error = error(next);
            if error > most {
                (v, most) = (next, error);
            }
        }
        worst = worst.max(most);
    }
    println!("{worst:.3} of a step");
    assert!(worst < 0.9 && worst > 0.7, "{worst}");
}

/// Where both draw the same disc, each lane of the two is within 1.5 steps of one answer.
#[test]
fn cap_is_where_its_formula_is() {
    let mut worst = 0;
    for ratio in [0.0, 1e-9, 5e-5, 8.6e-5, 8.8e-5, 1e-4, 0.00465, 0.05, 0.3, 0.5, 0.69, 0.7, 0.72, 0.9, 1.0] {
        let light = DistantLight::from_ratio(ratio).unwrap();
        let sphere = DistantSphere::<I2F30>::new(&light);
        for pair in input::random(31, 20_000, light.angular_radius()).chain(input::hard(light.angular_radius())) {
            let (l, r) = (pair.l.map(I2F30::from_num), pair.r.map(I2F30::from_num));
            let [by_hand, by_formula] = [cap(l, r, &sphere), formula::cap(l, r, &sphere)];
            for lane in 0..3 {
                let apart = by_hand[lane].to_bits().abs_diff(by_formula[lane].to_bits());
                assert!(apart <= 3, "{ratio}: {l:?} {r:?}: {by_hand:?} {by_formula:?}");
                worst = worst.max(apart);
            }
        }
    }
    println!("{worst} steps apart");
    assert!(worst > 0);
}
