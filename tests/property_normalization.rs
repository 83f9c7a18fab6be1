//! How near the claims of the family `normalization` come to what they allow: no allowance may be four times what
//! occurs.

use std::collections::BTreeMap;

use oorandom::Rand64;
use sunglint::trial::Draw;
use sunglint::trial::property::normalization::claims;

#[test]
fn allowances_are_tight() {
    let mut worst: BTreeMap<(&str, &str), [f64; 2]> = BTreeMap::new();
    let mut source = Rand64::new(1);
    for _ in 0..1_000_000 {
        let bytes = [(); 16].map(|()| source.rand_u64().to_le_bytes()).concat();
        let held = claims(&mut Draw::new(&bytes), &mut |case, (property, found, allowed)| {
            let [most, bound] = worst.entry((property, case.format.name())).or_default();
            (*most, *bound) = (most.max(if found.is_nan() { f64::INFINITY } else { found.abs() }), allowed);
            Ok(())
        });
        held.unwrap();
    }
    let mut loose = vec![];
    for (claim, [most, bound]) in &worst {
        println!("{claim:?}: worst {most:.4e}, allowed {bound:.4e}");
        if most > bound || *most < bound / 4.0 {
            loose.push((claim, most, bound));
        }
    }
    assert!(loose.is_empty(), "{loose:?}");
}
