//! The section of the page about building blocks.

use sunglint::trial::chip::peers;

use super::{cells, costs, figures, kernel_table};
use crate::author::{self, is_ours, is_peer};
use crate::axis::Costs;
use crate::chart;
use crate::kernel::Kernel;
use crate::kernel_panel;
use crate::key::{Key, in_order};
use crate::mean::Mean;
use crate::required;
use crate::result::{KernelRow, Study};

const INTRODUCTION: &str = "<p>What a lit pixel and its light are made of, each part by itself, at the Sun from Earth: its \
error against f64 at the inputs as they were rounded into the format, and its cost. What an error is relative to stands under \
each chart. Over instructions there are more marks: <em>soft</em> is f32 computed in integers (<code>sunglint::soft</code>), and \
grey are peers, whose worst errors are those that the crate <code>tests/peers</code> has found.</p>";

/// What would otherwise be misread.
const ABOUT: &str = "<details><summary>Units, limits and small print</summary><p>In f64 the errors are the truth’s own rounding as \
much. Costs of 1/16 and less count as 1/16: the clock cannot tell them from nothing.</p><p>Where a format cannot hold a quantity, \
all formats compute its normalised form. f16 ends at 65 504 and is subnormal below \
6.1e-5, and in SI units the Sun’s radiance peaks at 2.6e13: so Planck’s law is over its peak, a colour over the brightest of its \
levels, temperatures are in kilokelvins and wavelengths in micrometres. Of radiance 1 the Sun gives 6.8e-5: so what a plane gets is \
over what a plane gets that faces it, and a shadow is a share of the disc. Fixed point ends at 2 (I2F14, I2F30) or 32 768 \
(I16F16), and holds directions only: brightness is computed with 31 bits and an exponent, hence errors alike in all three, \
and kept as a light level, U16F16 or U32F32, which rounds once more.</p></details>";

/// The peers that answer wrongly or never, each with what has been noted of it.
fn failing_peers() -> String {
    let failing = peers::rows().filter_map(|peer| {
        let failure = author::failure_of_peer(peer.function, peer.format, peer.by)?;
        let note = if peer.note == failure { String::new() } else { format!(" ({})", peer.note) };
        Some(format!("<strong>{}</strong> {} in {}{note}", peer.by, peer.function, peer.format))
    });
    format!("Peers that fail, crossed out where they are drawn: {}.", failing.collect::<Vec<_>>().join("; "))
}

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
    format!(
        "{INTRODUCTION}<p>{} {}</p>{choice}{groups}{ABOUT}<h3>All measurements</h3>\n{}",
        required::SAID,
        failing_peers(),
        kernel_table::all(study)
    )
}

/// The charts of a group, those of one mean and one cost in a figure.
fn group(study: &Study, group: &str, key: &Key, offered: &[Costs]) -> String {
    let rows: Vec<_> = study.all_kernels().filter(|row| row.group == group).collect();
    let names = in_order(rows.iter().map(|row| &row.kernel));
    let figure = |&(costs, mean): &(Costs, Mean)| {
        let panels: String = names.iter().map(|name| panel(&rows, name, mean, key, costs)).collect();
        let choices = cells::data(&[("mean", mean.name()), ("axis", costs.axis.name())]);
        format!("<figure class=\"several\"{choices}>{}{panels}</figure>\n", caption(&rows, costs))
    };
    let all: Vec<_> = offered.iter().flat_map(|costs| Mean::ALL.map(|mean| (*costs, mean))).collect();
    format!("<h3>{}</h3>\n{}", cells::escape(group), figures::shown(&all, figure))
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
    format!("<div>{}<p>{}</p></div>", figures::linked(&svg), cells::escape(about))
}
