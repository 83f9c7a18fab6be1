//! A root that does not return.

use sunglint::fixed::types::I16F16;
use sunglint::trial::chip::{self, Core, peers};
use sunglint::{Real, Scalar};

use super::row::{CURE, FAILS, PresetRow, TRUTH, figure, worst};
use super::{Effort, Preset};

/// What is reported, and how it is run.
pub const PRESET: Preset = Preset {
    name: "cordic-root",
    source: "crate cordic 0.1.5, found by this crate's tests/peers (2026), whose figures stand here: it is not \
             called, since it would not return",
    question: "What is the square root of a 16.16 number by a CORDIC?",
    chart: None,
    measure,
    verdict,
};

const BY: &str = "cordic 0.1.5";
const ERROR: &str = "off by at most, steps of 2^-16";
const UP_TO: &str = "inputs up to this are answered";
const COUNT: &str = "instructions on a Cortex-M0+";

const OURS: &str = "root of Scaled, I16F16";

/// What the peer's own row says.
fn theirs() -> Option<peers::Peer> {
    peers::rows().find(|peer| peer.by == BY && peer.function == "root")
}

/// Where it ceases to return, which its note begins with: `below 16384: ...`.
fn end(peer: &peers::Peer) -> Option<f64> {
    peer.note.strip_prefix("below ")?.split(':').next()?.parse().ok()
}

/// Numbers over the whole range, evenly in the logarithm.
fn inputs(count: usize) -> impl Iterator<Item = I16F16> {
    let bits = move |index: usize| (31.0 * index as f64 / count as f64).exp2() as i32;
    (0..=count).map(move |index| I16F16::from_bits(bits(index)))
}

fn root(value: I16F16) -> I16F16 {
    I16F16::lane(I16F16::of_lane(value).root())
}

fn instructions(by: &str) -> f64 {
    let row = chip::rows().find(|row| (row.function, row.format, row.by) == ("root", "I16F16", by));
    row.and_then(|row| row.on(Core::M0)).map_or(f64::NAN, |cost| cost.median.into())
}

fn measure(effort: Effort) -> Vec<PresetRow> {
    let tried = || inputs(effort.count(10_000, 200_000));
    let off = |value: I16F16| (root(value).to_f64() - value.to_f64().sqrt()).abs() * 65536.0;
    let greatest = worst(tried().map(I16F16::to_f64));
    let error = theirs().map_or(f64::NAN, |peer| peer.error);
    vec![
        PresetRow::new(TRUTH, "I16F16", "greatest number", I16F16::MAX.to_f64()),
        PresetRow::new(FAILS, BY, ERROR, error).at_most(1.0),
        PresetRow::new(FAILS, BY, UP_TO, theirs().as_ref().and_then(end).unwrap_or(f64::NAN)).at_least(32767.0),
        PresetRow::new(TRUTH, BY, COUNT, instructions(BY)),
        PresetRow::new(CURE, OURS, ERROR, worst(tried().map(off))).at_most(1.0),
        PresetRow::new(CURE, OURS, UP_TO, greatest).at_least(32767.0),
        PresetRow::new(CURE, OURS, COUNT, instructions("sunglint")),
    ]
}

fn verdict(rows: &[PresetRow]) -> String {
    format!(
        "{BY} answers below {} and never returns from there on; it is {} steps off, in {} instructions. The root here \
         returns everywhere, within {} steps, in {}.",
        figure(rows, BY, UP_TO),
        figure(rows, BY, ERROR),
        figure(rows, BY, COUNT),
        figure(rows, OURS, ERROR),
        figure(rows, OURS, COUNT)
    )
}

#[cfg(test)]
mod tests {
    use super::super::row::value;
    use super::*;

    #[test]
    fn the_peers_row_is_read() {
        let rows = measure(Effort::Quick);
        assert_eq!([value(&rows, BY, UP_TO), value(&rows, BY, COUNT)], [16384.0, instructions(BY)]);
        assert!((value(&rows, BY, ERROR) - 81.0).abs() < 0.1);
    }
}
