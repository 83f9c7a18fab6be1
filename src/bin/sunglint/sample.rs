//! Small made-up studies for the tests.

mod methods;
mod sweep;

pub use methods::{curves, methods_study};
pub use sweep::sweep;

use sunglint::trial::chip::{self, Cost};

use crate::anchors::AnchorRow;
use crate::author::{OURS, PIXEL_Q14, SOFT};
use crate::axis::{Axis, Costs};
use crate::chip::{ChipRow, Found};
use crate::result::{Bound, KernelRow, LobeRow, PixelRow, QuantityRow, Row, Study};
use crate::rivals::Rivals;

/// Times on this machine.
pub const HOST: Costs<'static> = Costs { axis: Axis::Host, chip: &[] };

/// A row of the Sun from Earth that works, without model error.
pub fn row(method: &str, format: &str, cost: f64, error: f64) -> Row {
    Row {
        light: "Sun from Earth".to_owned(),
        ratio: 0.004650467,
        theta: 0.004650484,
        method: method.to_owned(),
        format: format.to_owned(),
        by: OURS,
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
        error_p99: error * 0.8,
        error_bias: error * -0.1,
        edge_max: 0.3,
        edge_rms: 0.1,
        latency: cost * 1.5,
        bound: Bound::Searched,
        bound_max: error * 1.1,
        bound_samples: 1_000_000,
        repro: format!(
            "sunglint repro {method} {format} --light 'Sun from Earth' --l '3f800000 0 0' --r '3f800000 0 0'"
        ),
        ..Row::default()
    }
}

/// A study of `rows` alone.
pub fn study(rows: Vec<Row>) -> Study {
    let [version, command] = ["0.1.0", "sunglint --quick"].map(str::to_owned);
    Study { version, seed: 1, command, quick: true, rows, ..Study::default() }
}

/// The same with something of everything.
pub fn whole_study(rows: Vec<Row>) -> Study {
    let alphas = [0.0, 0.001, 0.0625];
    let lobes = |method| alphas.map(|alpha| lobe(method, alpha));
    Study {
        quantities: vec![quantity()],
        pixels: vec![
            pixel("karis", "f32", 5.0, 1e-6),
            pixel("karis", "f16", 90.0, f64::INFINITY),
            pixel("cone_ggx", "f32", 9.0, 1e-6),
        ],
        lobes: [lobes("karis"), lobes("cone_ggx")].concat(),
        kernels: vec![kernel("f32", 1.0), kernel("f16", f64::INFINITY)],
        chip: vec![
            count("cap", "f32", "inside", [Some(2500), Some(1300), Some(60)]),
            count("cap", "f32", "outside", [Some(4700), Some(2600), Some(130)]),
            count("disc", "I2F14", "outside", [Some(1000), None, Some(270)]),
            count("pixel karis", "f32", "any", [Some(9000), Some(5000), Some(800)]),
            count("normalize", "f32", "any", [Some(1500), Some(700), Some(40)]),
            by(SOFT, count("cap", "f32", "outside", [Some(950), Some(250), Some(250)])),
            by("libm 0.2.16", count("cap", "f32", "outside", [Some(4900), Some(2700), Some(120)])),
            by(PIXEL_Q14, count("pixel karis", "f32", "outside", [Some(760), Some(380), Some(380)])),
            peer(),
        ],
        rivals: Rivals {
            directions: [SOFT, "libm 0.2.16"].map(|by| Row { by, ..row("cap", "f32", f64::NAN, 5e-8) }).into(),
            kernels: vec![KernelRow { by: SOFT, cost: f64::NAN, error_max: 4e-8, ..kernel("f32", 1.0) }],
            pixels: vec![PixelRow { by: PIXEL_Q14, ..pixel("karis", "f32", 3.0, 1e-6) }],
        },
        anchors: anchors().into(),
        ..study(rows)
    }
}

/// Anchors of the light, and of the case, of the other rows.
pub fn anchors() -> [AnchorRow; 3] {
    let anchor = |subject, light: &str, format: &str, empty: f64, rounded_max: f64| AnchorRow {
        subject,
        light: light.to_owned(),
        format: format.to_owned(),
        empty,
        rounded_max,
        rounded_rms: rounded_max * 0.4,
    };
    [
        anchor("direction", "Sun from Earth", "f32", 0.25, 3e-8),
        anchor("direction", "Sun from Earth", "I2F14", 0.25, 3e-5),
        anchor("pixel", "Sun, alpha 0.001", "f32", 0.5, 5e-6),
    ]
}

/// A pixel of the polished case.
pub fn pixel(method: &str, format: &str, cost: f64, error: f64) -> PixelRow {
    PixelRow {
        case: "Sun, alpha 0.001".to_owned(),
        ratio: 0.004650467,
        alpha: 0.001,
        method: method.to_owned(),
        format: format.to_owned(),
        by: OURS,
        cost,
        cost_low: cost * 0.98,
        cost_high: cost * 1.02,
        error_max: error,
        error_rms: error * 0.4,
        model_max: 0.1,
        model_rms: 0.04,
        total_max: error.hypot(0.1),
        total_rms: (error * 0.4).hypot(0.04),
        input_max: 0.01,
        input_rms: 0.004,
        samples: 1000,
        model_samples: 100,
        failure: (!error.is_finite()).then(|| "NaN".to_owned()),
        worst_n: "3f800000 00000000 00000000".to_owned(),
        worst_v: "3f800000 3c000000 00000000".to_owned(),
        worst_l: "3f800000 00000000 3c000000".to_owned(),
        error_p99: error * 0.8,
        error_bias: error * -0.1,
        steps8_max: 2.0,
        steps8_rms: 0.4,
        steps10_max: 8.0,
        steps10_rms: 1.6,
        latency: cost * 1.1,
        bound: Bound::Sampled,
        bound_max: error,
        bound_samples: 1000,
        repro: format!("sunglint repro '{method}' {format} --light 'Sun, alpha 0.001' --n '0' --v '0' --l '0'"),
        ..PixelRow::default()
    }
}

/// A highlight of the Sun at 45 degrees.
pub fn lobe(method: &str, alpha: f64) -> LobeRow {
    LobeRow {
        light: "Sun".to_owned(),
        ratio: 0.004650467,
        alpha,
        incidence: 45,
        method: method.to_owned(),
        truth: 0.04,
        energy: 1.01,
        peak: 0.98,
        relative_l1: 0.02 / (1.0 + alpha),
        nodes: 8,
    }
}

/// A building block.
pub fn kernel(format: &str, error: f64) -> KernelRow {
    KernelRow {
        group: "Directions".to_owned(),
        kernel: "normalize".to_owned(),
        unit: "rad".to_owned(),
        format: format.to_owned(),
        by: OURS,
        cost: 0.4,
        cost_low: 0.39,
        cost_high: 0.41,
        error_max: error,
        error_rms: error * 0.4,
        samples: 1000,
        worst_input: "v.x 0.25, v.y 0.5, v.z 0.125".to_owned(),
        error_p99: error * 0.8,
        error_bias: None,
        bound: Bound::Exhaustive,
        bound_max: error,
        bound_samples: 4_294_967_296,
        repro: format!("sunglint worst --method 'normalize' --format {format} --seed 1"),
    }
}

/// Counts of this crate's own, of which the study has found an error.
pub fn count(function: &'static str, format: &'static str, case: &'static str, medians: [Option<u32>; 3]) -> ChipRow {
    let cost = |median: u32| Cost { median, worst: median + 50, stack: 100, text: 900, rodata: 192 };
    ChipRow {
        count: chip::Row {
            function,
            format,
            by: OURS,
            case,
            inputs: 256,
            costs: medians.map(|median| median.map(cost)),
            note: "",
        },
        found: Some(Found { error: 1e-7, unit: "rad".to_owned(), failure: None, note: String::new() }),
    }
}

/// The same by somebody else.
fn by(by: &'static str, row: ChipRow) -> ChipRow {
    ChipRow { count: chip::Row { by, ..row.count }, ..row }
}

/// A peer that cannot be counted.
pub fn peer() -> ChipRow {
    let row = count("root", "U16F16", "any", [None; 3]);
    ChipRow { count: chip::Row { by: "cordic 0.1.5", note: "never returns", ..row.count }, found: None }
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
