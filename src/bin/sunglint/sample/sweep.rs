//! Made-up words, each with an error.

use crate::sweep::SweepRow;

/// A sweep: `cap` in fixed point and in two kinds of floats, 8 % off in 8 bits and half of that with each bit more, and
/// a lit pixel.
pub fn sweep() -> Vec<SweepRow> {
    let word = |family, exponent, bits: u32| SweepRow {
        subject: "direction",
        light: "Sun from Earth".to_owned(),
        ratio: 0.004650467,
        method: "cap".to_owned(),
        family,
        exponent,
        bits,
        width: bits + exponent.unwrap_or(2),
        word: format!("Q{bits} in {} bits", bits + 2),
        format: (bits == 14).then_some("I2F14"),
        edge_max: Some(8.0 * 0.5_f64.powi(bits as i32 - 8)),
        samples: 1000,
        ..SweepRow::default()
    };
    let words = |family, exponent| [8, 10, 12, 14].map(|bits| word(family, exponent, bits));
    let pixels = words("fixed", None).map(|row| SweepRow {
        subject: "pixel",
        light: "Sun".to_owned(),
        alpha: Some(0.001),
        error_rms: row.edge_max.unwrap_or(0.0) / 100.0,
        total_rms: row.edge_max.unwrap_or(0.0).hypot(0.5) / 100.0,
        model_rms: 0.005,
        edge_max: None,
        ..row
    });
    [words("fixed", None), words("float", Some(5)), words("flushing float", Some(8)), pixels].concat()
}
