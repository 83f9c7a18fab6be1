//! What the study has found of a method under one light in one format, from whatever table it stands in.

use super::subject::Subject;
use crate::author::{self, PIXEL_Q14, SOFT, is_ours, is_peer};
use crate::call::Call;
use crate::result::{Bound, KernelRow, PixelRow, Row, Study};

/// A row of the study, as the pages of the methods show it.
#[derive(Clone, Debug)]
pub struct Measurement<'a> {
    /// Name of the light, or of the case; empty for building blocks.
    pub under: &'a str,
    /// Name of the number format.
    pub format: &'a str,
    /// Whose code it is.
    pub by: &'static str,
    /// What is called, and its time.
    pub call: Call,
    /// Time of a call that waits for the one before; zero where it was not measured.
    pub latency: f64,
    /// What the errors are in.
    pub unit: &'a str,
    /// Worst arithmetic error.
    pub max: f64,
    /// 99th percentile of the error.
    pub p99: f64,
    /// Mean of the signed error, where it has a sign.
    pub bias: Option<f64>,
    /// What `bound_max` rests on.
    pub bound: Bound,
    /// The worst error known.
    pub bound_max: f64,
    /// How many inputs that took.
    pub bound_samples: u64,
    /// The worst input: names, each with raw bits or an exact value.
    pub worst: Vec<(&'static str, &'a str)>,
    /// The command that computes it again.
    pub repro: &'a str,
    /// How it fails, if it does.
    pub failure: Option<&'a str>,
    /// The row itself, for what only some have.
    pub row: Origin<'a>,
}

/// The row that a measurement is of.
#[derive(Clone, Copy, Debug)]
pub enum Origin<'a> {
    /// A direction.
    Direction(&'a Row),
    /// A lit pixel.
    Pixel(&'a PixelRow),
    /// A building block.
    Block,
}

impl Subject {
    /// All that `study` has found of it; peers are left out, as little more than their worst error is known.
    pub fn measurements(self, study: &Study) -> Vec<Measurement<'_>> {
        let directions = |code: fn(&str) -> bool, name: &'static str| {
            let rows = study.all_directions().filter(move |row| row.method == name && code(row.by));
            rows.map(of_direction).collect()
        };
        let pixels = |code: fn(&str) -> bool| study.all_pixels().filter(move |row| code(row.by));
        match self {
            Self::Direction(method) => directions(|by| by != SOFT && !is_peer(by), method.name()),
            Self::Soft => directions(|by| by == SOFT, "cap"),
            Self::Highlight(shading) => {
                pixels(is_ours).filter(|row| row.method == shading.name()).map(of_pixel).collect()
            }
            Self::PixelQ14 => pixels(|by| by == PIXEL_Q14).map(of_pixel).collect(),
            Self::Block(kernel) => {
                let rows = study.all_kernels().filter(|row| row.kernel == kernel.name() && !is_peer(row.by));
                rows.map(of_block).collect()
            }
        }
    }
}

impl Measurement<'_> {
    /// The format, and whose code it is where that is not what the format always runs.
    pub fn said(&self) -> String {
        author::said(self.format, self.by)
    }
}

fn of_direction(row: &Row) -> Measurement<'_> {
    Measurement {
        under: &row.light,
        format: &row.format,
        by: row.by,
        call: row.call(),
        latency: row.latency,
        unit: "rad",
        max: row.error_max,
        p99: row.error_p99,
        bias: Some(row.error_bias),
        bound: row.bound,
        bound_max: row.bound_max,
        bound_samples: row.bound_samples,
        worst: vec![("l", &row.worst_l), ("r", &row.worst_r)],
        repro: &row.repro,
        failure: row.failure.as_deref(),
        row: Origin::Direction(row),
    }
}

fn of_pixel(row: &PixelRow) -> Measurement<'_> {
    Measurement {
        under: &row.case,
        format: &row.format,
        by: row.by,
        call: row.call(),
        latency: row.latency,
        unit: "relative",
        max: row.error_max,
        p99: row.error_p99,
        bias: Some(row.error_bias),
        bound: row.bound,
        bound_max: row.bound_max,
        bound_samples: row.bound_samples,
        worst: vec![("n", &row.worst_n), ("v", &row.worst_v), ("l", &row.worst_l)],
        repro: &row.repro,
        failure: row.failure.as_deref(),
        row: Origin::Pixel(row),
    }
}

fn of_block(row: &KernelRow) -> Measurement<'_> {
    Measurement {
        under: "",
        format: &row.format,
        by: row.by,
        call: row.call(),
        latency: 0.0,
        unit: &row.unit,
        max: row.error_max,
        p99: row.error_p99,
        bias: row.error_bias,
        bound: row.bound,
        bound_max: row.bound_max,
        bound_samples: row.bound_samples,
        worst: vec![("", &row.worst_input)],
        repro: &row.repro,
        failure: (!row.error_max.is_finite()).then_some("NaN"),
        row: Origin::Block,
    }
}
