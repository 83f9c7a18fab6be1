//! The costs that a chart can be drawn over: time on the machine of the run, or instructions on a microcontroller.

use sunglint::trial::chip::Core;

use crate::author::is_ours;
use crate::call::Call;
use crate::chip::{self, ChipRow};
use crate::number;

/// What a call's cost is counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Time on this machine, in calls of f32 `factored`.
    Host,
    /// Instructions on a core.
    Chip(Core),
}

/// A cost, and how a tooltip puts it.
#[derive(Clone, Debug)]
pub struct Price {
    /// Place on the axis.
    pub cost: f64,
    /// All that is known of it.
    pub said: String,
}

impl Axis {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 4] = [Self::Host, Self::Chip(Core::M0), Self::Chip(Core::M3), Self::Chip(Core::M4)];

    /// Short name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Host => "host",
            Self::Chip(core) => core.name(),
        }
    }

    /// What stands along it, for calls of some kind.
    pub fn label(self, call: &str) -> String {
        match self {
            Self::Host => format!("time of a {call}, in calls of f32 factored"),
            Self::Chip(core) => format!("instructions of a {call} on a Cortex-{}", core.name()),
        }
    }

    /// What errors are drawn against, as the end of a title.
    pub fn against(self) -> String {
        match self {
            Self::Host => "cost".to_owned(),
            Self::Chip(core) => format!("instructions on {}", core.name()),
        }
    }

    /// What `call` costs by this; nothing where nobody has counted, or measured the time.
    pub fn price(self, chip: &[ChipRow], call: &Call) -> Option<Price> {
        match self {
            Self::Host => {
                let price = || Price { cost: call.host[0], said: format!("cost {}", number::quartiles(call.host)) };
                (is_ours(call.by) || call.host[0].is_finite()).then(price)
            }
            Self::Chip(core) => chip::price(chip, core, call),
        }
    }
}

/// An axis and the counts that it takes its costs from.
#[derive(Clone, Copy, Debug)]
pub struct Costs<'a> {
    /// Which costs.
    pub axis: Axis,
    /// The counts of instructions.
    pub chip: &'a [ChipRow],
}

impl<'a> Costs<'a> {
    /// The axes on which one of `calls` has a cost.
    pub fn offered(chip: &'a [ChipRow], calls: &[Call]) -> Vec<Self> {
        let costs = Axis::ALL.map(|axis| Self { axis, chip });
        let counts = |costs: &Self| calls.iter().any(|call| costs.of(call).is_some());
        costs.into_iter().filter(counts).collect()
    }

    /// What `call` costs.
    pub fn of(&self, call: &Call) -> Option<Price> {
        self.axis.price(self.chip, call)
    }

    /// Those of `rows` that have a cost, each with it.
    pub fn priced<R: Copy>(&self, rows: &[R], call: impl Fn(R) -> Call) -> Vec<(R, Price)> {
        rows.iter().filter_map(|&row| self.of(&call(row)).map(|price| (row, price))).collect()
    }

    /// The calls without a cost, each function once with its formats, or nothing: `cap in f64, f16; disc`.
    pub fn left_out(&self, calls: &[Call]) -> String {
        let missing = |call: &&Call| self.of(call).is_none();
        let mut functions: Vec<(&str, Vec<&str>)> = Vec::new();
        for call in calls.iter().filter(missing) {
            match functions.iter_mut().find(|(function, _)| *function == call.function) {
                Some((_, formats)) => formats.push(&call.format),
                None => functions.push((&call.function, vec![&call.format])),
            }
        }
        let all = |function: &str| calls.iter().filter(|call| call.function == function).count();
        let said = |(function, formats): &(&str, Vec<&str>)| match formats.len() == all(function) {
            true => (*function).to_owned(),
            false => format!("{function} in {}", formats.join(", ")),
        };
        functions.iter().map(said).collect::<Vec<_>>().join("; ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::author::OURS;
    use crate::sample;

    fn call(function: &str, format: &str) -> Call {
        Call { function: function.to_owned(), format: format.to_owned(), by: OURS, host: [0.5, 0.4, 0.6] }
    }

    #[test]
    fn an_axis_is_offered_where_something_has_been_counted() {
        let chip = [sample::count("cap", "I2F14", "outside", [Some(1000), None, Some(200)])];
        let names =
            |calls: &[Call]| -> Vec<_> { Costs::offered(&chip, calls).iter().map(|costs| costs.axis.name()).collect() };
        assert_eq!(names(&[call("cap", "I2F14"), call("cap", "f32")]), ["host", "M0+", "M4F"]);
        assert_eq!(names(&[call("cap", "f32")]), ["host"]);
    }

    #[test]
    fn what_has_no_count_is_named_once() {
        let chip = [sample::count("cap", "I2F14", "outside", [Some(1000), None, Some(200)])];
        let calls = [call("cap", "I2F14"), call("cap", "f32"), call("disc", "f16"), call("disc", "f32")];
        let left_out = |axis| Costs { axis, chip: &chip }.left_out(&calls);
        assert_eq!(left_out(Axis::Chip(Core::M0)), "cap in f32; disc");
        assert_eq!(left_out(Axis::Host), "");
    }
}
