//! The budgets for highlights of any light, roughness and directions hold where a search looks for the worst, and are tight.

use oorandom::Rand64;
use sunglint::trial::property::highlight::budget::{self, STEPS};
use sunglint::trial::property::highlight::{Exact, surface_and_pixel};
use sunglint::trial::{Draw, Format, Shading, gloss};

/// More than a case reads.
const LENGTH: usize = 128;

/// An error as a share of what is allowed, and what of it is no change of directions, in steps.
fn judged(bytes: &[u8], format: Format, method: Shading) -> [f64; 2] {
    let (surface, pixel) = surface_and_pixel(&mut Draw::new(bytes));
    let shaded = format.visit(Exact { method, surface, pixel });
    let error = shaded.error();
    if !shaded.lit.is_defined() || error == 0.0 {
        return [0.0; 2];
    }
    assert!(!error.is_nan(), "{} in {}: {shaded:?}", method.name(), format.name());
    let parts = shaded.lit.allowance(shaded.truth);
    let rest = (error - parts.change - parts.root) / (budget::step(format) * parts.unit);
    [error / shaded.lit.allowed(shaded.truth), rest.max(0.0)]
}

/// The worst of `count` random cases and of climbs from the worst of them, byte by byte.
fn search(format: Format, method: Shading, seed: u64, count: usize, climbs: usize) -> [f64; 2] {
    let mut source = Rand64::new(seed.into());
    let mut cases: Vec<(f64, Vec<u8>)> = Vec::new();
    let mut worst = [0.0_f64; 2];
    let mut note = |found: [f64; 2]| worst = [worst[0].max(found[0]), worst[1].max(found[1])];
    for _ in 0..count {
        let bytes: Vec<u8> = (0..LENGTH / 8).flat_map(|_| source.rand_u64().to_le_bytes()).collect();
        let found = judged(&bytes, format, method);
        note(found);
        cases.push((found[0], bytes));
    }
    cases.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (score, bytes) in cases.iter_mut().take(20) {
        for _ in 0..climbs {
            let mut other = bytes.clone();
            for _ in 0..=source.rand_range(0..3) {
                let place = source.rand_range(0..LENGTH as u64) as usize;
                let nudge = if source.rand_range(0..2) == 0 { source.rand_u64() as u8 } else { 1 };
                other[place] = other[place].wrapping_add(nudge);
            }
            let found = judged(&other, format, method);
            note(found);
            if found[0] >= *score {
                (*score, *bytes) = (found[0], other);
            }
        }
    }
    worst
}

#[test]
fn the_worst_that_a_search_finds_is_allowed_and_not_much_less_than_that() {
    for format in Format::ALL {
        for method in Shading::ALL {
            let [share, _] = search(format, method, 1, 2000, 20);
            let name = format!("{} in {}", method.name(), format.name());
            assert!((0.25..=1.0).contains(&share), "{name}: {share} of what is allowed");
        }
    }
}

/// Prints what [`STEPS`] is made of: the worst of each family in each format.
#[test]
#[ignore = "five minutes: cargo test --release --test highlight_budget -- --ignored --nocapture"]
fn prints_the_steps() {
    for (family, row) in STEPS.iter().enumerate() {
        let cell = |format: Format| {
            let methods = Shading::ALL.into_iter().filter(|&method| gloss::family(method) == family);
            methods
                .flat_map(|method| [1, 2].map(|seed| search(format, method, seed, 20_000, 500)[1]))
                .fold(0.0, f64::max)
        };
        println!("{:.2?}, budgets {row:?}", Format::ALL.map(cell));
    }
}
