//! The budgets of `trial::property` for any input: within them, and not far within, is the worst that draws and an
//! ascent on their bytes find.

use std::fs;
use std::path::Path;

use oorandom::Rand64;
use sunglint::trial::property::figures::{Figures, Row};
use sunglint::trial::property::{blackbody, radiometry, sampling};
use sunglint::trial::{Draw, Format};

const LENGTH: usize = 256;

type Bytes = [u8; LENGTH];

type Errors = fn(&mut Draw<'_>) -> (Format, Figures);

/// The worst that has been found of a row, and the bytes of its case.
#[derive(Clone, Copy)]
struct Top {
    error: f64,
    bytes: Bytes,
}

struct Search {
    errors: Errors,
    source: Rand64,
    tops: Vec<Top>,
}

impl Search {
    fn new(errors: Errors, rows: usize, seed: u64) -> Self {
        Self { errors, source: Rand64::new(seed.into()), tops: vec![Top { error: 0.0, bytes: [0; LENGTH] }; rows] }
    }

    /// Every row's worst of some draws, which begin with the byte of a format.
    fn draw(&mut self, format: u8, count: usize) {
        // So that a row without a draw climbs in this format too.
        self.tops.iter_mut().for_each(|top| top.bytes[0] = format);
        let mut bytes = [0; LENGTH];
        for _ in 0..count {
            for word in bytes.chunks_exact_mut(8) {
                word.copy_from_slice(&self.source.rand_u64().to_le_bytes());
            }
            bytes[0] = format;
            self.take(&bytes);
        }
    }

    /// What the fuzzers' corpus has of a format.
    fn replay(&mut self, family: &str, format: Format) {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(family);
        for entry in fs::read_dir(folder).unwrap() {
            let case = fs::read(entry.unwrap().path()).unwrap();
            let mut bytes = [0; LENGTH];
            let length = case.len().min(LENGTH);
            bytes[..length].copy_from_slice(&case[..length]);
            if Draw::new(&bytes).format() == format {
                self.take(&bytes);
            }
        }
    }

    /// Steps from every row's worst, in one to three bytes or single bits at a time; a row takes what others find.
    fn climb(&mut self, count: usize) {
        for row in 0..self.tops.len() {
            for _ in 0..count {
                let mut bytes = self.tops[row].bytes;
                for _ in 0..=self.source.rand_u64() % 3 {
                    let random = self.source.rand_u64();
                    // Cases are short.
                    let place = 1 + (random >> 32) as usize % 120;
                    match random & 3 {
                        0 => bytes[place] = (random >> 8) as u8,
                        1 => bytes[place] ^= 1 << ((random >> 8) & 7),
                        2 => bytes[place] = bytes[place].wrapping_add(1),
                        _ => bytes[place] = bytes[place].wrapping_sub(1),
                    }
                }
                self.take(&bytes);
            }
        }
    }

    fn take(&mut self, bytes: &Bytes) {
        let (_, figures) = (self.errors)(&mut Draw::new(bytes));
        for (row, error) in figures.into_iter().flatten() {
            let error = if error.is_nan() { f64::INFINITY } else { error };
            let top = &mut self.tops[row];
            if error > top.error {
                *top = Top { error, bytes: *bytes };
            }
        }
    }
}

/// A little more than the worst, to two digits.
fn suggested(worst: f64) -> f64 {
    format!("{:.1e}", 1.12 * worst * (1.0 + 1e-12)).parse::<f64>().map_or(worst, |rounded| {
        let unit = 10_f64.powf(rounded.log10().floor() - 1.0);
        let wanted = 1.12 * worst;
        if rounded < wanted { format!("{:.1e}", rounded + unit).parse().unwrap() } else { rounded }
    })
}

/// The worst of every row in every format.
fn worst(family: &str, errors: Errors, rows: usize, seed: u64, draws: usize, climbs: usize) -> Vec<[f64; 7]> {
    let mut table = vec![[0.0; 7]; rows];
    for format in Format::ALL {
        let mut search = Search::new(errors, rows, seed);
        search.draw(format as u8, draws);
        search.replay(family, format);
        search.climb(climbs);
        for (row, top) in table.iter_mut().zip(search.tops) {
            row[format as usize] = top.error;
        }
    }
    table
}

/// Directions on the wrong side of the rim are so rare that only a long search finds the worst, and not from every seed.
fn rare(name: &str) -> bool {
    name.starts_with("rim")
}

fn holds(family: &str, errors: Errors, rows: &[Row]) {
    for ((name, budgets), found) in rows.iter().zip(worst(family, errors, rows.len(), 1, 20_000, 1000)) {
        println!("{name}: worst {found:?}, budgets {budgets:?}");
        for format in Format::ALL {
            let (budget, found) = (budgets[format as usize], found[format as usize]);
            assert!(found <= budget, "{name} in {}: {found:e} is above {budget:e}", format.name());
            assert!(
                rare(name) || 4.0 * found >= budget,
                "{name} in {}: {budget:e} is far above {found:e}",
                format.name()
            );
        }
    }
}

fn measured(family: &str, errors: Errors, rows: &[Row], seeds: u64, climbs: usize) {
    let mut table = vec![[0.0_f64; 7]; rows.len()];
    for seed in 1..=seeds {
        for (most, found) in table.iter_mut().zip(worst(family, errors, rows.len(), seed, 300_000, climbs)) {
            *most = std::array::from_fn(|i| most[i].max(found[i]));
        }
    }
    let mut stale = 0;
    for ((name, budgets), found) in rows.iter().zip(table) {
        let list = found.map(|found| format!("{:e}", suggested(found))).join(", ");
        println!("    (\"{name}\", [{list}]),");
        let near = |i: usize| found[i] <= budgets[i] && (rare(name) || 1.12 * found[i] >= budgets[i] / 1.25);
        stale += (0..7).filter(|&i| !near(i)).count();
    }
    assert_eq!(stale, 0, "budgets of other figures than those printed");
}

#[test]
fn sampling_keeps_its_budgets() {
    holds("sampling", sampling::errors, &sampling::BUDGETS);
}

#[test]
#[ignore = "two minutes in release: cargo test --release --test figures -- --ignored --nocapture"]
fn budgets_of_sampling_measured() {
    measured("sampling", sampling::errors, &sampling::BUDGETS, 8, 60_000);
}

#[test]
fn black_bodies_keep_their_budgets() {
    holds("blackbody", blackbody::errors, &blackbody::BUDGETS);
}

#[test]
#[ignore = "two minutes in release: cargo test --release --test figures -- --ignored --nocapture"]
fn budgets_of_black_bodies_measured() {
    measured("blackbody", blackbody::errors, &blackbody::BUDGETS, 3, 20_000);
}

#[test]
fn radiometry_keeps_its_budgets() {
    holds("radiometry", radiometry::errors, &radiometry::BUDGETS);
}

#[test]
#[ignore = "five minutes in release: cargo test --release --test figures -- --ignored --nocapture"]
fn budgets_of_radiometry_measured() {
    measured("radiometry", radiometry::errors, &radiometry::BUDGETS, 3, 20_000);
}
