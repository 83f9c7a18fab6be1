//! Small made-up studies for the tests.

use crate::result::{QuantityRow, Row, Study};

/// A row of the Sun from Earth that works, without model error.
pub fn row(method: &str, format: &str, cost: f64, error: f64) -> Row {
    Row {
        light: "Sun from Earth".to_owned(),
        ratio: 0.004650467,
        theta: 0.004650484,
        method: method.to_owned(),
        format: format.to_owned(),
        cost,
        cost_low: cost * 0.98,
        cost_high: cost * 1.02,
        error_max: error,
        error_rms: error * 0.4,
        model_max: 0.0,
        model_rms: 0.0,
        total_max: error,
        total_rms: error * 0.4,
        input_max: 0.0,
        input_rms: 0.0,
        samples: 1000,
        excluded: 0,
        undirected: 0,
        failure: None,
        worst_angle: 0.01,
        worst_l: "0x3f800000 00000000 00000000".to_owned(),
        worst_r: "0x3f800000 3c000000 00000000".to_owned(),
        frontier: false,
        total_frontier: false,
    }
}

/// A study of `rows` alone.
pub fn study(rows: Vec<Row>) -> Study {
    Study { version: "0.1.0".to_owned(), seed: 1, light: None, quick: true, rows, quantities: Vec::new() }
}

/// A quantity that works.
pub fn quantity() -> QuantityRow {
    QuantityRow {
        quantity: "size_factor".to_owned(),
        format: "f32".to_owned(),
        unit: "ULP".to_owned(),
        error_max: 0.5,
        worst_input: 0.004,
        samples: 1000,
        refused: 3,
    }
}
