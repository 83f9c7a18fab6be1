//! What the pixels of a picture come to.

use std::collections::BTreeSet;

use super::sphere::{Cell, Sphere};
use crate::number;

/// Figures of a whole picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// Worst error of all numbers.
    pub worst: f64,
    /// Root mean square of that.
    pub rms: f64,
    /// Share of the pixels that are NaN.
    pub nan: f64,
    /// Share of the pixels that are infinite.
    pub infinite: f64,
    /// Share of the pixels that are finite, but at most half or at least twice as bright as they are.
    pub doubled: f64,
    /// Share of the pixels that are finite, but a tenth brighter or darker than they are, or more.
    pub visible: f64,
    /// How wide the lit area is, over how wide it is in truth: the root of the areas' ratio, of what is at least half
    /// as bright as white.
    pub width: f64,
    /// Share of the pixels that are at least half as bright as white.
    pub lit: f64,
    /// Different levels of brightness.
    pub shades: usize,
}

impl Figures {
    /// Those of `sphere`.
    pub fn of(sphere: &Sphere) -> Self {
        let cells: Vec<_> = sphere.cells().collect();
        let share =
            |test: &dyn Fn(&Cell) -> bool| cells.iter().filter(|cell| test(cell)).count() as f64 / cells.len() as f64;
        let finite = |cell: &Cell| cell.level.is_finite();
        let errors = || cells.iter().filter(|cell| cell.error.is_finite()).map(|cell| f64::from(cell.error));
        let off = |cell: &Cell, factor: f32| cell.level >= factor * cell.truth || cell.level * factor <= cell.truth;
        let shades: BTreeSet<_> = cells.iter().map(|cell| cell.level.to_bits()).collect();
        Self {
            worst: errors().reduce(f64::max).unwrap_or(f64::NAN),
            rms: (errors().map(|error| error * error).sum::<f64>() / errors().count() as f64).sqrt(),
            nan: share(&|cell| cell.level.is_nan()),
            infinite: share(&|cell| cell.level.is_infinite()),
            doubled: share(&|cell| finite(cell) && cell.truth > 0.0 && off(cell, 2.0)),
            visible: share(&|cell| finite(cell) && cell.truth > 0.0 && off(cell, 1.1)),
            width: (share(&|cell| cell.level >= 0.5) / share(&|cell| cell.truth >= 0.5)).sqrt(),
            lit: share(&|cell| cell.level >= 0.5),
            shades: shades.len(),
        }
    }

    /// The same as words.
    pub fn sentence(&self, unit: &str) -> String {
        let share = |share: f64, what: &str| match share {
            0.0 => String::new(),
            share => format!(", {} % of the pixels {what}", per_cent(share)),
        };
        let lost = share(self.nan, "NaN") + &share(self.infinite, "infinite");
        if self.nan == 1.0 {
            return "all of it NaN".to_owned();
        }
        let [worst, rms] = [self.worst, self.rms].map(number::scientific);
        format!("worst error {worst} {unit}, root mean square {rms}{lost}")
    }

    /// The worst error and the root mean square, in `unit`, for beneath a picture.
    pub fn lines(&self, unit: &str) -> [String; 2] {
        if self.nan == 1.0 {
            return ["all NaN".to_owned(), String::new()];
        }
        let lost =
            |share: f64, what: &str| if share > 0.0 { format!("{} % {what}", per_cent(share)) } else { String::new() };
        let rms = format!("rms {}{unit}", number::scientific(self.rms));
        let no_number = if self.nan > 0.0 { lost(self.nan, "NaN") } else { lost(self.infinite, "inf") };
        let second = if no_number.is_empty() { rms } else { no_number };
        [format!("max {}{unit}", number::scientific(self.worst)), second]
    }
}

/// A share in per cent.
pub fn per_cent(share: f64) -> String {
    number::percent(share, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::patch::Patch;

    /// A ball that is 0.4 bright, and `level` in its upper half.
    fn half(level: f64) -> Figures {
        let patch = Patch::about_the_highlight(1.0);
        let code = |[n, ..]: [[f64; 3]; 3]| if n[1] > 0.0 { level } else { 0.4 };
        Figures::of(&Sphere::lit::<f64>((&patch, 20, 0.1), code, |_, _| 0.4))
    }

    #[test]
    fn shares_are_of_all_pixels() {
        assert_eq!([half(f64::NAN).nan, half(f64::INFINITY).infinite, half(0.9).doubled, half(0.45).visible], [0.5; 4]);
        assert_eq!([half(0.4).worst, half(0.4).rms, half(0.7).doubled, half(0.41).visible], [0.0; 4]);
        assert_eq!([half(0.9).shades, half(0.4).shades], [2, 1]);
    }

    #[test]
    fn errors_are_of_numbers_alone() {
        let lost = half(f64::NAN);
        assert_eq!([lost.worst, lost.rms], [0.0; 2]);
        assert!((half(0.6).worst - 0.5).abs() < 1e-6 && (half(0.6).rms - 0.5 / 2f64.sqrt()).abs() < 1e-6);
        assert_eq!(lost.lines(" %"), ["max 0 %", "50 % NaN"]);
    }
}
