//! The README's table of errors is the table of budgets.

use sunglint::trial::{Format, Method, budget};

const METHODS: [Method; 4] = [Method::Cap, Method::Factored, Method::Disc, Method::Epic];

/// The cells of the row of `format`.
fn row(format: Format) -> Vec<String> {
    let start = format!("| {} |", format.name());
    let line = include_str!("../README.md").lines().find(|line| line.starts_with(&start));
    line.unwrap_or_else(|| panic!("no row for {}", format.name()))
        .split('|')
        .map(|cell| cell.trim().to_owned())
        .collect()
}

#[test]
fn errors_are_the_budgets_that_are_asserted() {
    for format in Format::ALL {
        let cells = row(format);
        for (index, method) in METHODS.into_iter().enumerate() {
            let cell = &cells[2 + 2 * index];
            let shown =
                cell.split(',').next().and_then(|figure| figure.parse::<f64>().ok().filter(|figure| !figure.is_nan()));
            assert_eq!(shown, budget::maximum(method, format, 0), "{} in {}", method.name(), format.name());
        }
    }
}
