//! The choice of what a chart counts costs in, and what its caption says of that.

use super::cells;
use crate::axis::{Axis, Costs};
use crate::call::Call;

/// Buttons for the `offered` costs; none where there is but one.
pub fn choice(offered: &[Costs]) -> String {
    let names: Vec<_> = offered.iter().map(|costs| costs.axis.name()).collect();
    if names.len() > 1 { cells::radio("Cost", "axis", &names) } else { String::new() }
}

/// What stands across on a core, of which inputs, and which of `calls` are missing.
pub fn caption(costs: &Costs, what: &str, calls: &[Call]) -> String {
    let Axis::Chip(core) = costs.axis else { return String::new() };
    let left_out = costs.left_out(calls);
    let left_out = if left_out.is_empty() { left_out } else { format!(" Without a count, and left out: {left_out}.") };
    format!(". Across: instructions of {what} on a Cortex-{}.{left_out}", core.name())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn a_caption_names_the_core_and_what_is_missing() {
        let rows = [sample::row("cap", "f32", 1.0, 1e-7), sample::row("disc", "f32", 1.0, 1e-7)];
        let calls = rows.map(|row| row.call());
        let chip = [sample::count("cap", "f32", "outside", [Some(4700), None, None])];
        let offered = Costs::offered(&chip, &calls);
        assert!(choice(&offered).contains("value=\"M0+\"") && !choice(&offered).contains("M3"));
        assert_eq!(caption(&offered[0], "a call", &calls), "");
        let said = ". Across: instructions of a call on a Cortex-M0+. Without a count, and left out: disc.";
        assert_eq!(caption(&offered[1], "a call", &calls), said);
    }
}
