//! The true levels of lit pixels.

use indicatif::ProgressBar;
use sunglint::Real;
use sunglint::oracle::quadrature::Quadrature;
use sunglint::trial::gloss::{self, Case};
use sunglint::trial::{Format, Visitor};

use super::{arithmetic, wanted};
use crate::options::Options;
use crate::workers;

/// The true levels of the pixels whose arithmetic is judged: the BRDF integrated over the disc, in every case, at the
/// inputs as each format rounds them.
#[derive(Default)]
pub struct Truths(Vec<Truth>);

struct Truth {
    case: &'static str,
    format: Format,
    levels: Vec<f64>,
}

impl Truths {
    /// All of them, on all cores.
    pub fn of(options: &Options, progress: &ProgressBar) -> Self {
        let cases = wanted(options);
        let all: Vec<_> = cases.iter().flat_map(|&case| Format::ALL.map(|format| (case, format))).collect();
        let truth = |&(case, format): &(Case, Format)| {
            progress.set_message(format!("{}, integrals over the disc in {}", case.name, format.name()));
            // The models' are those of f64.
            let wanted = format == Format::F64 || options.wants_format(format);
            let levels = if wanted { format.visit(Integrals { case, options }) } else { vec![] };
            Truth { case: case.name, format, levels }
        };
        Self(workers::map(&all, progress, truth))
    }

    /// Those of the pixels of [`arithmetic`], over the level of white.
    pub fn levels(&self, case: &Case, format: Format) -> &[f64] {
        let truth = self.0.iter().find(|truth| truth.case == case.name && truth.format == format);
        truth.map_or(&[], |truth| &truth.levels)
    }
}

struct Integrals<'a> {
    case: Case,
    options: &'a Options,
}

impl Integrals<'_> {
    fn by<T: Real, const N: usize>(&self) -> Vec<f64> {
        let rule = Quadrature::<N>::new();
        arithmetic(&self.case, self.options).map(|pixel| gloss::integral::<T, N>(&self.case, &pixel, &rule)).collect()
    }
}

impl Visitor for Integrals<'_> {
    type Output = Vec<f64>;

    fn visit<T: Real>(self) -> Vec<f64> {
        if self.options.quick { self.by::<T, 8>() } else { self.by::<T, 12>() }
    }
}
