//! The table of building blocks.

use super::{align_right, table};
use crate::key::{Key, in_order};
use crate::number;
use crate::result::{KernelRow, Study};

/// Worst error and cost of each function in each format.
pub fn all(study: &Study) -> String {
    let rows = &study.kernels;
    let key = Key::new(rows.iter().map(|row| [&row.kernel, &row.format]));
    let mut header = vec!["function", ""];
    header.extend(key.formats.iter().map(String::as_str));
    let mut table = table(&header);
    for kernel in in_order(rows.iter().map(|row| &row.kernel)) {
        let of = |format: &String| rows.iter().find(|row| row.kernel == kernel && row.format == *format);
        let line = |shown: &dyn Fn(&KernelRow) -> String| -> Vec<String> {
            key.formats.iter().map(|format| of(format).map_or_else(String::new, shown)).collect()
        };
        let unit = rows.iter().find(|row| row.kernel == kernel).map_or("", |row| &row.unit);
        let names = [kernel.clone(), format!("max, {unit}")];
        table.add_row(names.into_iter().chain(line(&|row| number::scientific(row.error_max))));
        table.add_row([String::new(), "cost".to_owned()].into_iter().chain(line(&|row| number::cost(row.cost))));
    }
    align_right(&mut table, 2..header.len());
    format!("Building blocks\n{}\n", table.trim_fmt())
}
