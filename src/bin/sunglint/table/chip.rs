//! The table of instructions on microcontrollers.

use sunglint::trial::chip::Core;

use super::{add_group, align_right, table};
use crate::author::{self, is_peer};
use crate::axis::{Axis, Costs};
use crate::chart::{direction_key, under_light};
use crate::key::in_order;
use crate::number;
use crate::result::{Row, Study};

/// Instructions of each direction method in each format on each core; marked are those on the frontier of the total
/// error under the first light.
pub fn all(study: &Study) -> String {
    let key = direction_key(study);
    let first = study.rows.first().map_or("", |row| &row.light);
    let rows = under_light(study.all_directions().filter(|row| !is_peer(row.by)), first);
    let calls: Vec<_> = rows.iter().map(|row| row.call()).collect();
    let mut header = vec!["method", "core"];
    header.extend(key.formats.iter().map(String::as_str));
    let mut table = table(&header);
    let codes: Vec<_> = rows.iter().map(|row| code(row)).collect();
    let codes = in_order(codes.iter());
    for costs in Costs::offered(&study.chip, &calls) {
        let Axis::Chip(core) = costs.axis else { continue };
        let lines = codes.iter().map(|code| line(&rows, code, core, &key.formats));
        add_group(&mut table, lines.filter(|line| line[2..].iter().any(|cell| !cell.is_empty())));
    }
    if table.is_empty() {
        return String::new();
    }
    align_right(&mut table, 2..header.len());
    format!(
        "Instructions of a call on a Cortex-M, median outside the disc; *: on the frontier of the total error\n{}\n",
        table.trim_fmt()
    )
}

/// What a line is named by: the method, and whose code that is.
fn code(row: &Row) -> String {
    author::label(&row.method, row.by)
}

fn line(rows: &[&Row], name: &str, core: Core, formats: &[String]) -> Vec<String> {
    let of = |format: &String| rows.iter().find(|row| code(row) == name && row.format == *format);
    let cells = formats.iter().map(|format| of(format).map_or_else(String::new, |row| cell(row, core)));
    [name.to_owned(), core.name().to_owned()].into_iter().chain(cells).collect()
}

fn cell(row: &Row, core: Core) -> String {
    let (instructions, [_, on_frontier]) = row.on_chip(core);
    let mark = if on_frontier { "*" } else { "" };
    instructions.map_or_else(String::new, |count| format!("{mark}{}", number::count(count.into())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{frontier, sample};
    use sunglint::trial::{Format, Method};

    #[test]
    fn all_methods_and_formats_make_a_short_table() {
        let of_all = || Method::ALL.into_iter().flat_map(|method| Format::ALL.map(|format| (method, format)));
        let rows = of_all().map(|(method, format)| sample::row(method.name(), format.name(), 1.0, 1e-7));
        let mut study = sample::study(rows.collect());
        let count = |(method, format): (Method, Format)| {
            sample::count(method.name(), format.name(), "outside", [Some(24_000), Some(13_000), Some(5600)])
        };
        study.chip = of_all().map(count).collect();
        frontier::mark(&mut study);
        let text = all(&study);
        assert!(text.lines().count() <= 20, "{text}");
        assert_eq!(text.matches("*24\u{202f}000").count(), 28, "all are equal");
        assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    }

    #[test]
    fn other_code_has_lines_of_its_own_and_peers_none() {
        let mut study = sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        frontier::mark(&mut study);
        let text = all(&study);
        assert!(text.contains("cap soft") && text.contains("*950") && !text.contains("libm"), "{text}");
    }

    #[test]
    fn no_counts_make_no_table() {
        assert!(all(&sample::study(vec![sample::row("cap", "f32", 1.0, 1e-7)])).is_empty());
    }
}
