//! What the documentation promises of an error, and the tests of the library hold it to.

use std::f64::consts::PI;

use sunglint::trial::gloss::{self, CASES};
use sunglint::trial::{Format, Method, Shading, budget, lights};

use super::measurement::{Measurement, Origin};
use super::subject::Subject;
use crate::author::{SOFT, is_ours};
use crate::kernel::Kernel;
use crate::result::Row;

/// The most that the error of `measured` may be; none where it is known to fail, or where nothing is promised.
pub fn of(subject: Subject, measured: &Measurement) -> Option<f64> {
    let format = Format::named(measured.format)?;
    if measured.failure.is_some() {
        return None;
    }
    match (subject, measured.row) {
        (Subject::Direction(method), Origin::Direction(row)) => direction(method, format, row),
        (Subject::Soft, Origin::Direction(row)) => Some(soft(row)),
        (Subject::Highlight(shading), _) => pixel(shading, format, measured.under),
        (Subject::PixelQ14, _) => Some(gloss::PIXEL_Q14[case(measured.under)?][0]),
        (Subject::Block(Kernel::Normalize), _) if is_ours(measured.by) => Some(budget::normalize(format)[0]),
        // What is promised are lanes, of which a direction has three.
        (Subject::Block(Kernel::Reflect), _) if is_ours(measured.by) => Some(3_f64.sqrt() * budget::reflect(format)?),
        (Subject::Block(kernel), _) if is_ours(measured.by) => Some(kernel.budget(format)),
        (Subject::Block(Kernel::Normalize), _) if measured.by == SOFT => Some(budget::SOFT_NORMALIZE),
        _ => None,
    }
}

/// The Sun from Earth has budgets of its own, other lights share those of their size.
fn direction(method: Method, format: Format, row: &Row) -> Option<f64> {
    let [sun, ..] = lights::STUDY;
    if row.light == sun.name {
        budget::maximum(method, format, 0)
    } else {
        budget::of_any_light(method, format, row.theta)
    }
}

/// The bound in the documentation of `soft::cap`, at the worst input.
fn soft(row: &Row) -> f64 {
    let alone = if row.ratio <= 0.05 { 5.4e-8 } else { 1.1e-7 };
    alone + 1.15e-9 * row.ratio / (PI - row.worst_angle)
}

fn pixel(shading: Shading, format: Format, under: &str) -> Option<f64> {
    Some(gloss::MAXIMA[gloss::family(shading)][case(under)?][format as usize])
}

fn case(name: &str) -> Option<usize> {
    CASES.iter().position(|case| case.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn promised(subject: Subject) -> Vec<Option<f64>> {
        let study = sample::methods_study();
        subject.measurements(&study).iter().map(|measured| of(subject, measured)).collect()
    }

    #[test]
    fn the_sun_has_the_figures_of_the_documentation_and_failures_have_none() {
        assert_eq!(promised(Subject::Direction(Method::Cap)), [Some(2.5e-16), Some(4.8e-4)]);
        assert_eq!(promised(Subject::Direction(Method::Epic)), [None]);
    }

    #[test]
    fn pixels_and_blocks_have_theirs() {
        assert_eq!(promised(Subject::Highlight(Shading::Karis)), [Some(3.0e-4), None]);
        assert_eq!(promised(Subject::PixelQ14).len(), 1);
        assert_eq!(promised(Subject::Block(Kernel::Normalize))[0], Some(7.8e-8));
    }
}
