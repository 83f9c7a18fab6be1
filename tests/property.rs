//! The properties that the fuzz targets check, on stable Rust: every case of the corpus, then fresh random ones.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use oorandom::Rand64;
use sunglint::trial::Draw;
use sunglint::trial::property::{FAMILIES, Family};

/// Fresh cases of each family; Miri takes a thousand times longer.
const COUNT: usize = if cfg!(miri) { 8 } else { 100_000 };

/// More than any family reads.
const LENGTH: usize = 256;

/// A new one at every run, so that each run tries what none has tried before; `SUNGLINT_SEED` brings one back.
fn seed() -> u64 {
    let now = || SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_nanos() as u64);
    std::env::var("SUNGLINT_SEED").ok().map_or_else(now, |seed| seed.parse().expect("SUNGLINT_SEED is a whole number"))
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The fuzzers' folder, also where `tests/miri` has this test.
fn fuzz() -> PathBuf {
    let mut above = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().map(|folder| folder.join("fuzz"));
    above.find(|fuzz| fuzz.join("corpus").is_dir()).expect("the fuzzers' folder")
}

fn corpus(family: &str) -> Vec<(String, Vec<u8>)> {
    let folder = fuzz().join("corpus").join(family);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    entries
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.display().to_string(), fs::read(&path).unwrap()))
        .collect()
}

fn keeps(family: &str) {
    let holds: Family = FAMILIES.into_iter().find(|(name, _)| *name == family).unwrap().1;
    let cases = corpus(family);
    assert!(!cases.is_empty(), "no corpus for {family}");
    for (name, bytes) in &cases {
        holds(&mut Draw::new(bytes)).unwrap_or_else(|broken| panic!("{name}: {broken}"));
    }
    let seed = seed();
    println!("{family}: {} cases of the corpus, then {COUNT} from SUNGLINT_SEED={seed}", cases.len());
    let mut source = Rand64::new(seed.into());
    let mut bytes = [0_u8; LENGTH];
    for _ in 0..COUNT {
        for word in bytes.chunks_exact_mut(8) {
            word.copy_from_slice(&source.rand_u64().to_le_bytes());
        }
        holds(&mut Draw::new(&bytes)).unwrap_or_else(|broken| {
            panic!(
                "{broken}\nSUNGLINT_SEED={seed}; to keep it: echo {} | xxd -r -p > fuzz/corpus/{family}/NAME",
                hex(&bytes)
            )
        });
    }
}

#[test]
fn directions() {
    keeps("directions");
}

#[test]
fn normalization() {
    keeps("normalization");
}

#[test]
fn highlight() {
    keeps("highlight");
}

#[test]
fn sampling() {
    keeps("sampling");
}

#[test]
fn radiometry() {
    keeps("radiometry");
}

#[test]
fn blackbody() {
    keeps("blackbody");
}

#[test]
fn scene() {
    keeps("scene");
}

#[test]
fn raw() {
    keeps("raw");
}

#[test]
fn every_family_has_a_fuzz_target() {
    for (family, _) in FAMILIES {
        let target = fuzz().join("fuzz_targets").join(format!("{family}.rs"));
        let code = fs::read_to_string(&target).unwrap_or_else(|error| panic!("{}: {error}", target.display()));
        assert!(code.contains(&format!("property::{family}")), "{}", target.display());
    }
}
