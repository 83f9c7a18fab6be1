//! The same bits everywhere: in debug, in release, and on the targets that `tests/firmware` and Miri run.

use sunglint::trial::digest::{CASES, Digester, FEW, FIXED_POINT, FLOATS};

/// Under Miri a few cases alone.
fn keep(digesters: &[Digester]) {
    let mut stale = String::new();
    for digester in digesters {
        let [all, _] = digester.expected;
        let all = if cfg!(miri) { all } else { digester.digest(CASES).hash };
        let found = [all, digester.digest(FEW).hash];
        if found != digester.expected {
            let name = digester.name.to_uppercase();
            stale += &format!("pub(super) const {name}: [u64; 2] = [{:#018x}, {:#018x}];\n", found[0], found[1]);
        }
    }
    assert!(stale.is_empty(), "other bits than those of src/trial/digest/expected.rs:\n{stale}");
}

#[test]
fn fixed_point_gives_the_same_bits_everywhere() {
    keep(&FIXED_POINT);
}

#[test]
#[cfg_attr(
    all(miri, any(target_arch = "x86", target_arch = "x86_64")),
    ignore = "libm takes roots by an instruction that Miri does not know"
)]
fn floats_give_the_same_bits_everywhere() {
    keep(&FLOATS);
}

#[test]
#[cfg_attr(miri, ignore = "takes too long")]
fn a_million_results_are_in_the_fixed_point_digests() {
    let results: Vec<_> = FIXED_POINT.iter().map(|digester| digester.digest(CASES).results).collect();
    println!("{results:?}");
    assert!(results.iter().sum::<u32>() >= 1_000_000);
}

/// That a result is noticed.
#[test]
#[cfg_attr(miri, ignore = "takes too long")]
fn one_case_more_is_another_digest() {
    for digester in FIXED_POINT.iter().chain(&FLOATS) {
        let (some, more) = (digester.digest(2), digester.digest(3));
        assert!(some.hash != more.hash && some.results < more.results, "{}", digester.name);
    }
}
