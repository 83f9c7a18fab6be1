//! `normalize` of I2F14 in 32-bit registers: faithful in every lane, for raw bits of any length.

use oorandom::Rand64;
use sunglint::raw::normalize_q14;

/// The greatest error of a lane, in the last place, against the exact quotient; all inputs with `z = 0` are in
/// `tests/exhaustive`.
fn error(v: [i16; 3]) -> f64 {
    let exact = v.map(f64::from);
    let length = exact.iter().map(|lane| lane * lane).sum::<f64>().sqrt();
    if length == 0.0 {
        assert_eq!(normalize_q14(v), v);
        return 0.0;
    }
    let errors = normalize_q14(v).into_iter().zip(exact).map(|(lane, exact)| {
        let truth = exact / length * 16_384.0;
        assert!(f64::from(lane) == truth || (f64::from(lane) - truth).abs() < 1.0, "{v:?}");
        (f64::from(lane) - truth).abs()
    });
    errors.fold(0.0, f64::max)
}

/// Steps of lanes uphill from `v`.
fn climbed(mut v: [i16; 3], source: &mut Rand64) -> f64 {
    let mut most = error(v);
    for _ in 0..200 {
        let mut next = v;
        for lane in &mut next {
            *lane = lane.wrapping_add(source.rand_range(0..9) as i16 - 4);
        }
        let found = error(next);
        if found > most {
            (most, v) = (found, next);
        }
    }
    most
}

#[test]
fn normalize_is_faithful_in_three_lanes() {
    let mut source = Rand64::new(14);
    let mut worst = 0.0_f64;
    for index in 0..20_000 {
        let bits = source.rand_u64();
        // Of all lengths, from a few steps to all bits.
        let shift = if index % 2 == 0 { 0 } else { bits >> 60 };
        let v = [bits, bits >> 16, bits >> 32].map(|bits| bits as i16 >> shift);
        worst = worst.max(climbed(v, &mut source));
    }
    println!("{worst} of the last place");
    assert!(worst < 0.78 && worst > 0.7, "{worst}");
}

/// Everything that is at most eight steps long, where a step counts most.
#[test]
fn normalize_is_faithful_for_the_shortest() {
    let lanes = || -8..=8_i16;
    let all = lanes().flat_map(|x| lanes().flat_map(move |y| lanes().map(move |z| [x, y, z])));
    let worst = all.map(error).fold(0.0, f64::max);
    assert!(worst < 0.78 && worst > 0.2, "{worst}");
}

#[test]
fn normalize_takes_the_ends_of_the_range() {
    let ends = [i16::MIN, i16::MIN + 1, -1, 0, 1, i16::MAX];
    for x in ends {
        for y in ends {
            for z in ends {
                assert!(error([x, y, z]) < 0.78, "{x} {y} {z}");
            }
        }
    }
}
