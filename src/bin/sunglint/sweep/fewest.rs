//! The shortest word that is enough.

use super::{Goal, SweepRow};

/// Words of one kind, and a method in each of them, the shortest first.
#[derive(Clone, Debug)]
pub struct Family<'a> {
    /// Its words' rows.
    pub rows: Vec<&'a SweepRow>,
}

impl<'a> Family<'a> {
    /// All families of each method of `rows`, in their order.
    pub fn all(rows: impl IntoIterator<Item = &'a SweepRow>) -> Vec<Self> {
        let mut families: Vec<Self> = Vec::new();
        for row in rows {
            match families.iter_mut().find(|family| family.first().is_kin(row)) {
                Some(family) => family.rows.push(row),
                None => families.push(Self { rows: vec![row] }),
            }
        }
        families
    }

    /// The shortest word's row.
    pub fn first(&self) -> &'a SweepRow {
        self.rows[0]
    }

    /// The row whose error is least.
    pub fn nearest(&self, goal: Goal) -> &'a SweepRow {
        let better =
            |best: &'a SweepRow, row: &'a SweepRow| if goal.error(row) < goal.error(best) { row } else { best };
        self.rows.iter().copied().fold(self.first(), better)
    }

    /// What its words are, in words.
    pub fn name(&self) -> String {
        let SweepRow { family, exponent, .. } = self.first();
        match exponent {
            Some(exponent) => format!("{family}, {exponent} exponent bits"),
            None => "fixed point".to_owned(),
        }
    }
}

impl SweepRow {
    /// Whether both are of one method and family.
    fn is_kin(&self, other: &Self) -> bool {
        let names = |row: &Self| [row.subject, row.family].map(str::to_owned);
        (names(self), &self.light, &self.method) == (names(other), &other.light, &other.method)
            && (self.alpha, self.exponent) == (other.alpha, other.exponent)
    }
}

/// The shortest word of `family` that is within `tolerance`, as are all longer ones.
pub fn fewest<'a>(family: &Family<'a>, goal: Goal, tolerance: f64) -> Option<&'a SweepRow> {
    family.rows.iter().rev().copied().take_while(|row| goal.error(row) <= tolerance).last()
}

/// The least bits that may be enough, given that those of `found` are: what is shorter than all words that were tried
/// is not known, nor what lies between `found` and the next shorter one.
fn at_least(family: &Family, found: &SweepRow) -> Option<u32> {
    let shorter = family.rows.iter().rev().find(|row| row.bits < found.bits);
    shorter.map(|row| row.bits + 1)
}

/// The fewest bits that are enough, as far as the words that were tried tell.
pub fn said(family: &Family, found: &SweepRow) -> String {
    let bits = found.bits;
    match at_least(family, found) {
        None => format!("≤ {bits}"),
        Some(least) if least < bits => format!("{least}–{bits}"),
        Some(_) => bits.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(bits: u32, edge: f64) -> SweepRow {
        SweepRow { family: "fixed", bits, edge_max: Some(edge), ..SweepRow::default() }
    }

    #[test]
    fn a_word_is_enough_if_all_longer_ones_are() {
        let rows = [row(8, 0.5), row(10, 3.0), row(12, 0.9), row(14, 0.1)];
        let families = Family::all(&rows);
        let bits = |tolerance| fewest(&families[0], Goal::Edge, tolerance).map(|row| row.bits);
        assert_eq!([bits(4.0), bits(1.0), bits(0.2), bits(0.05)], [Some(8), Some(12), Some(14), None]);
        assert_eq!(families[0].nearest(Goal::Edge).bits, 14);
    }

    #[test]
    fn what_fails_is_never_enough() {
        let failed = SweepRow { failure: Some("disc lost".to_owned()), ..row(14, 0.1) };
        assert_eq!(Goal::Edge.error(&failed), f64::INFINITY);
        assert_eq!(Goal::Edge.error(&row(14, f64::NAN)), f64::INFINITY);
        assert_eq!(fewest(&Family::all(&[failed])[0], Goal::Edge, 1.0).map(|row| row.bits), None);
    }

    #[test]
    fn what_lies_between_the_words_that_were_tried_is_left_open() {
        let rows = [row(8, 5.0), row(10, 3.0), row(12, 0.9), row(13, 0.1)];
        let family = &Family::all(&rows)[0];
        let bits = |tolerance| fewest(family, Goal::Edge, tolerance).map(|found| said(family, found));
        assert_eq!(
            [6.0, 4.0, 1.0, 0.2].map(|tolerance| bits(tolerance).unwrap_or_default()),
            ["≤ 8", "9–10", "11–12", "13"]
        );
    }

    #[test]
    fn families_are_apart() {
        let flushing = SweepRow { family: "flushing float", exponent: Some(5), ..row(8, 1.0) };
        let other = SweepRow { method: "cap".to_owned(), ..row(8, 1.0) };
        let rows = [row(8, 1.0), flushing, other, row(10, 1.0)];
        let families = Family::all(&rows);
        assert_eq!(families.iter().map(|family| family.rows.len()).collect::<Vec<_>>(), [2, 1, 1]);
        assert_eq!([families[0].name(), families[1].name()], ["fixed point", "flushing float, 5 exponent bits"]);
    }
}
