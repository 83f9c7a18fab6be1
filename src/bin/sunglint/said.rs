//! What a mark says when pointed at: all figures of its row, whatever the chart shows.

use crate::author::{self, is_peer};
use crate::axis::Axis;
use crate::call::Call;
use crate::chip::ChipRow;
use crate::field::Anchor;
use crate::number;
use crate::result::{Bound, KernelRow, PixelRow, Row};

/// What a bound rests on, in words.
pub fn bound(bound: Bound) -> &'static str {
    match bound {
        Bound::Exhaustive => "exhaustive",
        Bound::Searched => "searched",
        Bound::Sampled => "sampled",
    }
}

/// All figures of a direction.
pub fn of_direction(row: &Row, chip: &[ChipRow]) -> String {
    let rad = |value: f64| format!("{} rad", number::scientific(value));
    let of_radius = |value: f64| match row.theta {
        0.0 => rad(value),
        theta => format!("{} ({} % of the radius)", rad(value), number::percent(value, theta)),
    };
    let mut lines = vec![name(&row.method, &row.format, row.by, row.failure.as_deref())];
    if is_peer(row.by) {
        lines.push(format!("arithmetic error: up to {}", of_radius(row.error_max)));
        lines.push(format!("total error: at most {}", of_radius(row.total_max)));
    } else {
        lines.push(format!("arithmetic error: max {}, rms {}", of_radius(row.error_max), rad(row.error_rms)));
        lines.push(format!("  99 % within {}, bias {}", rad(row.error_p99), rad(row.error_bias)));
        lines.push(format!("model error: max {}, rms {}", of_radius(row.model_max), rad(row.model_rms)));
        lines.push(format!("total error: max {}, rms {}", of_radius(row.total_max), rad(row.total_rms)));
        let edge = [row.edge_max, row.edge_rms].map(|value| number::percent(value, 100.0));
        lines.push(format!("edge of the disc: max {} % of the radius, rms {} %", edge[0], edge[1]));
        lines.push(rests_on(&rad(row.bound_max), row.bound, row.bound_samples));
    }
    lines.extend(costs(&row.call(), Some(row.latency), chip));
    lines.join("\n")
}

/// All figures of a lit pixel.
pub fn of_pixel(row: &PixelRow, chip: &[ChipRow]) -> String {
    let [max, rms, model_max, model_rms, total_max, total_rms] =
        [row.error_max, row.error_rms, row.model_max, row.model_rms, row.total_max, row.total_rms]
            .map(number::scientific);
    let [p99, bias] = [row.error_p99, row.error_bias].map(number::scientific);
    let [s8, r8, s10, r10] = [row.steps8_max, row.steps8_rms, row.steps10_max, row.steps10_rms].map(number::scientific);
    let mut lines = vec![
        name(&row.method, &row.format, row.by, row.failure.as_deref()),
        format!("arithmetic error: max {max}, rms {rms}"),
        format!("  99 % within {p99}, bias {bias}"),
        format!("model error: max {model_max}, rms {model_rms}"),
        format!("both: max {total_max}, rms {total_rms}"),
        format!("8-bit display: max {s8} steps, rms {r8}; 10-bit: max {s10}, rms {r10}"),
        rests_on(&number::scientific(row.bound_max), row.bound, row.bound_samples),
    ];
    lines.extend(costs(&row.call(), Some(row.latency), chip));
    lines.join("\n")
}

/// All figures of a building block, which as a peer's may `fail`.
pub fn of_kernel(row: &KernelRow, failure: Option<&str>, chip: &[ChipRow]) -> String {
    let unit = &row.unit;
    let of_unit = |value: f64| format!("{} {unit}", number::scientific(value));
    let mut lines = vec![name(&row.kernel, &row.format, row.by, failure)];
    if is_peer(row.by) {
        lines.push(format!("error up to {}", of_unit(row.error_max)));
    } else {
        lines.push(format!("error: max {}, rms {}", of_unit(row.error_max), of_unit(row.error_rms)));
        let bias = row.error_bias.map(|bias| format!(", bias {}", of_unit(bias)));
        lines.push(format!("  99 % within {}{}", of_unit(row.error_p99), bias.unwrap_or_default()));
        lines.push(rests_on(&of_unit(row.bound_max), row.bound, row.bound_samples));
    }
    lines.extend(costs(&row.call(), None, chip));
    lines.join("\n")
}

/// What an anchor says.
pub fn of_anchor(anchor: &Anchor, error: &str) -> String {
    let cost = anchor.cost.map(|cost| format!("\nan empty call: {}", number::cost(cost)));
    format!("The true answer rounded into {}\nerror {error}{}", anchor.format, cost.unwrap_or_default())
}

fn name(method: &str, format: &str, by: &str, failure: Option<&str>) -> String {
    let failure = failure.map(|failure| format!(": {failure}"));
    format!("{method} in {}{}", author::said(format, by), failure.unwrap_or_default())
}

fn rests_on(worst: &str, on: Bound, samples: u64) -> String {
    format!("worst known: {worst}, {} over {} inputs", bound(on), number::count(samples))
}

/// What is known of the costs: time with its quartiles, and instructions on each core.
fn costs(call: &Call, latency: Option<f64>, chip: &[ChipRow]) -> Vec<String> {
    let waits = latency.filter(|latency| latency.is_finite() && *latency > 0.0);
    let waits = waits.map(|latency| format!("cost {} where each call waits for the last", number::cost(latency)));
    let [host, cores @ ..] = Axis::ALL.map(|axis| axis.price(chip, call).map(|price| price.said));
    [host, waits].into_iter().chain(cores).flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::author::SOFT;
    use crate::sample;

    #[test]
    fn every_figure_of_a_direction_is_said() {
        let chip = [sample::count("cap", "f32", "outside", [Some(4700), None, Some(130)])];
        let said = of_direction(&sample::row("cap", "f32", 1.0, 1e-7), &chip);
        for part in [
            "cap in f32\n",
            "max 1.0e-7 rad (0.0022 % of the radius), rms 4.0e-8 rad",
            "99 % within 8.0e-8 rad, bias -1.0e-8 rad",
            "edge of the disc: max 0.30 % of the radius, rms 0.10 %",
            "worst known: 1.1e-7 rad, searched over 1\u{202f}000\u{202f}000 inputs",
            "cost 1.00 (0.98 to 1.02)\ncost 1.50 where each call waits for the last",
            "instructions on M0+: 4\u{202f}700 outside the disc\ninstructions on M4F: 130 outside the disc",
        ] {
            assert!(said.contains(part), "{part}: {said}");
        }
    }

    #[test]
    fn a_peer_says_only_what_is_known_of_it() {
        let peer = Row { by: "libm 0.2.16", ..sample::row("cap", "f32", f64::NAN, 1e-7) };
        let said = of_direction(&peer, &[]);
        assert!(said.starts_with("cap in f32 by libm 0.2.16\narithmetic error: up to 1.0e-7 rad"), "{said}");
        assert!(!said.contains("rms") && !said.contains("cost") && !said.contains("NaN"), "{said}");
        let soft = of_direction(&Row { by: SOFT, ..peer }, &[]);
        assert!(soft.contains("rms"), "{soft}");
    }
}
