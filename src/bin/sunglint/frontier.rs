//! The Pareto frontier of error against cost: the rows that no other row beats on both.

use sunglint::trial::chip::Core;

use crate::axis::Axis;
use crate::error_kind::ErrorKind;
use crate::pixel_error::PixelError;
use crate::result::{Row, Study};

/// What it takes to stand on a frontier.
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    /// Time of a call, or instructions.
    pub cost: f64,
    /// How wrong the answer is.
    pub error: f64,
    /// Whether it answers at all.
    pub works: bool,
}

impl Standing {
    /// Whether it works and its error and cost are numbers.
    fn is_candidate(&self) -> bool {
        self.works && self.cost.is_finite() && self.error.is_finite()
    }

    /// Whether it is at most as costly and at most as wrong as `other`, and one of the two strictly.
    fn beats(&self, other: &Self) -> bool {
        let at_most = self.cost <= other.cost && self.error <= other.error;
        self.is_candidate() && at_most && (self.cost < other.cost || self.error < other.error)
    }
}

/// Marks the rows of `study`, rivals too, that are on their light's or their case's frontier.
pub fn mark(study: &mut Study) {
    let [arithmetic, total] = directions(study, |row| row.cost);
    for (row, (arithmetic, total)) in study.all_directions_mut().zip(arithmetic.into_iter().zip(total)) {
        row.frontier = arithmetic;
        row.total_frontier = total;
    }
    Core::ALL.into_iter().for_each(|core| mark_on(core, study));
    let rows: Vec<_> = study.all_pixels().collect();
    let pixels = members(&rows, |row| row.case.clone(), |row| PixelError::default().standing(row, row.cost));
    for (row, on_frontier) in study.pixels.iter_mut().chain(&mut study.rivals.pixels).zip(pixels) {
        row.frontier = on_frontier;
    }
}

/// The same by the instructions on `core`, which the rows get as well.
fn mark_on(core: Core, study: &mut Study) {
    let chip = &study.chip;
    let instructions = |row: &Row| Axis::Chip(core).price(chip, &row.call()).map_or(f64::NAN, |price| price.cost);
    let frontiers = directions(study, instructions);
    let counts: Vec<_> = study.all_directions().map(instructions).collect();
    for (place, row) in study.all_directions_mut().enumerate() {
        let (count, members) = row.on_chip_mut(core);
        *count = counts[place].is_finite().then_some(counts[place] as u32);
        members.into_iter().zip(&frontiers).for_each(|(member, frontier)| *member = frontier[place]);
    }
}

/// Who is on the frontiers of both errors of the directions, at some cost.
fn directions(study: &Study, cost: impl Fn(&Row) -> f64) -> [Vec<bool>; 2] {
    let rows: Vec<_> = study.all_directions().collect();
    ErrorKind::ALL.map(|kind| members(&rows, |row| row.light.clone(), |row| kind.standing(row, cost(row))))
}

/// For each of `rows`, whether no other of its group beats it.
pub fn members<R>(rows: &[R], group: impl Fn(&R) -> String, standing: impl Fn(&R) -> Standing) -> Vec<bool> {
    let standings: Vec<_> = rows.iter().map(|row| (group(row), standing(row))).collect();
    let on_frontier = |(group, own): &(String, Standing)| {
        let mut rivals = standings.iter().filter(|(other, _)| other == group);
        own.is_candidate() && !rivals.any(|(_, rival)| rival.beats(own))
    };
    standings.iter().map(on_frontier).collect()
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
    fn a_core_has_a_frontier_of_its_own() {
        // On this machine f32 is both cheaper and more exact, on this core dearer.
        let rows = vec![sample::row("cap", "f32", 1.0, 1e-7), sample::row("cap", "I2F14", 2.0, 1e-4)];
        let mut study = sample::study(rows);
        study.chip = vec![
            sample::count("cap", "f32", "outside", [Some(4700), None, None]),
            sample::count("cap", "I2F14", "outside", [Some(1000), None, Some(270)]),
        ];
        mark(&mut study);
        let shown = |shown: fn(&Row) -> (Option<u32>, bool)| [&study.rows[0], &study.rows[1]].map(shown);
        assert_eq!(shown(|row| (None, row.frontier)), [(None, true), (None, false)]);
        assert_eq!(shown(|row| (row.m0_instructions, row.m0_frontier)), [(Some(4700), true), (Some(1000), true)]);
        assert_eq!(shown(|row| (row.m3_instructions, row.m3_frontier)), [(None, false); 2]);
        assert_eq!(shown(|row| (row.m4_instructions, row.m4_total_frontier)), [(None, false), (Some(270), true)]);
    }

    #[test]
    fn rivals_beat_whatever_is_dearer_and_more_wrong() {
        let mut study = sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]);
        mark(&mut study);
        let [own, soft, peer] = [&study.rows[0], &study.rivals.directions[0], &study.rivals.directions[1]];
        assert!(own.frontier && !soft.frontier, "on this machine they have no time");
        assert_eq!([own, soft, peer].map(|row| row.m0_frontier), [false, true, false]);
        assert_eq!([own, soft, peer].map(|row| row.m4_frontier), [false, false, true]);
        assert_eq!(soft.m0_instructions, Some(950));
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
