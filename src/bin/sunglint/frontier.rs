//! The Pareto frontier of error against cost: the rows that no other row beats on both.

use crate::error_kind::ErrorKind;
use crate::result::{Row, Study};

/// Marks the rows of `study` that are on their light's frontier, for both kinds of error.
pub fn mark(study: &mut Study) {
    let arithmetic = members(&study.rows, ErrorKind::Arithmetic);
    let total = members(&study.rows, ErrorKind::Total);
    for (row, (arithmetic, total)) in study.rows.iter_mut().zip(arithmetic.into_iter().zip(total)) {
        row.frontier = arithmetic;
        row.total_frontier = total;
    }
}

/// For each row, whether it is on the frontier.
fn members(rows: &[Row], kind: ErrorKind) -> Vec<bool> {
    let on_frontier = |row: &Row| {
        let mut rivals = rows.iter().filter(|rival| rival.light == row.light);
        is_candidate(row, kind) && !rivals.any(|rival| beats(rival, row, kind))
    };
    rows.iter().map(on_frontier).collect()
}

/// Whether `row` works and its error and cost are numbers.
fn is_candidate(row: &Row, kind: ErrorKind) -> bool {
    row.failure.is_none() && row.cost.is_finite() && kind.worst(row).is_finite()
}

/// Whether `rival` is at most as costly and at most as wrong as `row`, and one of the two strictly.
fn beats(rival: &Row, row: &Row, kind: ErrorKind) -> bool {
    let (wrong, limit) = (kind.worst(rival), kind.worst(row));
    is_candidate(rival, kind) && (rival.cost <= row.cost && wrong <= limit) && (rival.cost < row.cost || wrong < limit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn marked(rows: Vec<Row>) -> Vec<bool> {
        let mut study = sample::study(rows);
        mark(&mut study);
        study.rows.iter().map(|row| row.frontier).collect()
    }

    #[test]
    fn a_cheaper_and_a_more_exact_row_are_both_on_it() {
        let rows = vec![sample::row("cap", "f16", 0.5, 1e-3), sample::row("cap", "f32", 1.0, 1e-7)];
        assert_eq!(marked(rows), [true, true]);
    }

    #[test]
    fn a_beaten_row_is_not_on_it() {
        let rows = vec![
            sample::row("cap", "f32", 1.0, 1e-7),
            sample::row("epic", "f32", 1.0, 2e-7),
            sample::row("disc", "f32", 1.5, 1e-7),
        ];
        assert_eq!(marked(rows), [true, false, false]);
    }

    #[test]
    fn equal_rows_do_not_beat_each_other() {
        let row = sample::row("cap", "f32", 1.0, 0.0);
        assert_eq!(marked(vec![row.clone(), row]), [true, true]);
    }

    #[test]
    fn failures_and_missing_numbers_neither_stand_on_it_nor_beat() {
        let mut failed = sample::row("disc", "f16", 0.1, 1e-9);
        failed.failure = Some("disc lost".to_owned());
        let rows = vec![failed, sample::row("epic", "f16", 0.1, f64::NAN), sample::row("cap", "f16", 0.5, 1e-3)];
        assert_eq!(marked(rows), [false, false, true]);
    }

    #[test]
    fn lights_are_kept_apart() {
        let mut mars = sample::row("cap", "f32", 0.5, 1e-9);
        mars.light = "Sun from Mars".to_owned();
        let rows = vec![sample::row("cap", "f32", 1.0, 1e-7), mars];
        assert_eq!(marked(rows), [true, true]);
    }

    #[test]
    fn the_total_error_has_a_frontier_of_its_own() {
        let mut factored = sample::row("factored", "f32", 1.0, 1e-8);
        factored.total_max = 1e-4;
        let mut study = sample::study(vec![factored, sample::row("cap", "f32", 1.0, 1e-7)]);
        mark(&mut study);
        assert!(study.rows[0].frontier && !study.rows[0].total_frontier);
        assert!(!study.rows[1].frontier && study.rows[1].total_frontier);
    }
}
