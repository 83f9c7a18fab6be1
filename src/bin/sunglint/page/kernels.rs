//! The section of the page about building blocks.

use super::cells::{self, cell, count, scientific, sortable, text};
use super::costs;
use crate::author::{is_ours, is_peer};
use crate::axis::Costs;
use crate::chart;
use crate::kernel::Kernel;
use crate::kernel_panel;
use crate::key::{Key, in_order};
use crate::mean::Mean;
use crate::number;
use crate::result::{KernelRow, Study};

const INTRODUCTION: &str = "<p>What a lit pixel and its light are made of, each part by itself, at the Sun from Earth: its \
error against f64 at the inputs as they were rounded into the format, and its cost. What an error is relative to stands under \
each chart. Over instructions there are more marks: <em>soft</em> is f32 computed in integers (<code>sunglint::soft</code>), and \
grey are peers, whose worst errors are those that the crate <code>tests/peers</code> has found. In f64 the errors are the truth’s own rounding as much. Costs of 1/16 and less count as 1/16: the clock cannot tell them from nothing.</p>\
<p>Where a format cannot hold a quantity, all formats compute its normalised form. f16 ends at 65 504 and is subnormal below \
6.1e-5, and in SI units the Sun’s radiance peaks at 2.6e13: so Planck’s law is over its peak, a colour over the brightest of its \
levels, temperatures are in kilokelvins and wavelengths in micrometres. Of radiance 1 the Sun gives 6.8e-5: so what a plane gets is \
over what a plane gets that faces it, and a shadow is a share of the disc. Fixed point ends at 2 (I2F14, I2F30) or 32 768 \
(I16F16), and holds directions only: brightness is computed with 31 bits and an exponent, hence errors alike in all three, \
and kept as a light level, U16F16 or U32F32, which rounds once more.</p>";

const COLUMNS: [&str; 10] =
    ["group", "function", "format", "unit", "cost", "cost quartiles", "error max", "error rms", "tried", "worst input"];

/// Width and height of a panel, of which several stand side by side.
const PANEL: (f64, f64) = (430.0, 340.0);

/// A small chart for each function, by groups, and a table of all.
pub fn all(study: &Study) -> String {
    let rows = &study.kernels;
    // One shape for all, as each function has a panel of its own.
    let key = Key { methods: Vec::new(), ..Key::new(rows.iter().map(|row| [&row.kernel, &row.format])) };
    let calls: Vec<_> = rows.iter().map(KernelRow::call).collect();
    let offered = Costs::offered(&study.chip, &calls);
    let choice = cells::radio("Error", "mean", &Mean::ALL.map(Mean::name)) + &costs::choice(&offered);
    let choice = cells::form(&choice);
    let names = in_order(rows.iter().map(|row| &row.group));
    let groups: String = names.iter().map(|name| group(study, name, &key, &offered)).collect();
    let lines: String = rows.iter().map(line).collect();
    format!("{INTRODUCTION}\n{choice}{groups}<h3>All measurements</h3>\n{}", sortable("blocks", &COLUMNS, &lines))
}

/// The charts of a group, those of one mean and one cost in a figure.
fn group(study: &Study, group: &str, key: &Key, offered: &[Costs]) -> String {
    let rows: Vec<_> = study.all_kernels().filter(|row| row.group == group).collect();
    let names = in_order(rows.iter().map(|row| &row.kernel));
    let figure = |mean: Mean, costs: Costs| {
        let panels: String = names.iter().map(|name| panel(&rows, name, mean, key, costs)).collect();
        let choices = cells::data(&[("mean", mean.name()), ("axis", costs.axis.name())]);
        format!("<figure class=\"several\"{choices}>{}{panels}</figure>\n", caption(&rows, costs))
    };
    let figures = offered.iter().flat_map(|costs| Mean::ALL.map(|mean| figure(mean, *costs)));
    format!("<h3>{}</h3>\n{}", cells::escape(group), figures.collect::<String>())
}

/// What of a group has no count on a core; nothing for times.
fn caption(rows: &[&KernelRow], costs: Costs) -> String {
    let calls: Vec<_> = rows.iter().filter(|row| is_ours(row.by)).map(|row| row.call()).collect();
    match costs.left_out(&calls) {
        left_out if left_out.is_empty() => left_out,
        left_out => format!(
            "<figcaption>Without a count on {}, and left out: {}.</figcaption>",
            costs.axis.name(),
            cells::escape(&left_out)
        ),
    }
}

/// The chart of a function; none where no format has a cost.
fn panel(rows: &[&KernelRow], name: &str, mean: Mean, key: &Key, costs: Costs) -> String {
    // Of peers the worst error alone is known.
    let known = |row: &&KernelRow| !is_peer(row.by) || mean == Mean::Max;
    let rows: Vec<_> = rows.iter().copied().filter(|row| row.kernel == name).filter(known).collect();
    if costs.priced(&rows, KernelRow::call).is_empty() {
        return String::new();
    }
    let about = Kernel::ALL.into_iter().find(|kernel| kernel.name() == name).map_or("", Kernel::about);
    let name = format!("{name}: {} error against {}", mean.name(), costs.axis.against());
    let svg = chart::small_panel(&kernel_panel::field(&rows, mean, costs), key, PANEL, &name);
    format!("<div>{svg}<p>{}</p></div>", cells::escape(about))
}

fn line(row: &KernelRow) -> String {
    let cells = [
        text(&row.group),
        text(&row.kernel),
        text(&row.format),
        text(&row.unit),
        cell(row.cost, &number::cost(row.cost)),
        cell(row.cost_low, &format!("{} to {}", number::cost(row.cost_low), number::cost(row.cost_high))),
        scientific(row.error_max),
        scientific(row.error_rms),
        count(row.samples),
        text(&row.worst_input),
    ];
    format!("<tr>{}</tr>\n", cells.concat())
}
