//! Code beside that which a format always runs: instructions of it have been counted, so that it stands in charts of
//! microcontrollers.

pub mod kernels;

use indicatif::ProgressBar;
use serde::Serialize;
use sunglint::raw::SphereQ30;
use sunglint::trial::chip::peers;
use sunglint::trial::{Format, Light, Method, Visitor, formula, judge_code, lights};
use sunglint::{DistantSphere, Real, soft};

use crate::author::{FORMULA, SOFT};
use crate::directions;
use crate::options::Options;
use crate::result::{KernelRow, PixelRow, Row, Study};
use crate::workers;

/// The light under which the peers were measured.
const SUN: &str = lights::STUDY[0].name;

/// `cap` by other code.
const CAPS: [(&str, Format); 3] = [(SOFT, Format::F32), (FORMULA, Format::I2F14), (FORMULA, Format::I2F30)];

/// Rows like those of the study, of rivals.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Rivals {
    /// One row per light and code, and of each peer under the Sun from Earth. They have no time.
    pub directions: Vec<Row>,
    /// One row per case and code.
    pub pixels: Vec<PixelRow>,
    /// One row per building block, format and code. They have no time.
    pub kernels: Vec<KernelRow>,
}

impl Study {
    /// All directions, the rivals last.
    pub fn all_directions(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().chain(&self.rivals.directions)
    }

    /// The same, to be set.
    pub fn all_directions_mut(&mut self) -> impl Iterator<Item = &mut Row> {
        self.rows.iter_mut().chain(&mut self.rivals.directions)
    }

    /// All lit pixels, the rivals last.
    pub fn all_pixels(&self) -> impl Iterator<Item = &PixelRow> {
        self.pixels.iter().chain(&self.rivals.pixels)
    }

    /// All building blocks, the rivals last.
    pub fn all_kernels(&self) -> impl Iterator<Item = &KernelRow> {
        self.kernels.iter().chain(&self.rivals.kernels)
    }
}

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    directions::wanted(options).count() * caps(options).len()
}

/// Those of [`CAPS`] that were asked for.
fn caps(options: &Options) -> Vec<(&'static str, Format)> {
    let wanted = |format| options.wants_method(Method::Cap.name()) && options.wants_format(format);
    CAPS.into_iter().filter(|(_, format)| wanted(*format)).collect()
}

/// The errors of `cap` by other code, and of the peers, whose formulas are those of `rows`.
pub fn directions(rows: &[Row], options: &Options, progress: &ProgressBar) -> Vec<Row> {
    let contenders: Vec<_> = directions::wanted(options)
        .flat_map(|light| caps(options).into_iter().map(move |(by, format)| Judge { light, by, format, options }))
        .collect();
    let own = workers::map(&contenders, progress, |contender| {
        progress.set_message(format!("{}, cap by {}", contender.light.name, contender.by));
        contender.row()
    });
    own.into_iter().chain(of_peers(rows)).collect()
}

#[derive(Clone, Copy)]
struct Judge<'a> {
    light: Light,
    by: &'static str,
    format: Format,
    options: &'a Options,
}

impl Judge<'_> {
    fn row(self) -> Row {
        if self.by == FORMULA {
            return self.format.visit(self);
        }
        let sphere = SphereQ30::new(&self.light.light);
        self.judged(|l, r| soft::cap(l, r, &sphere))
    }

    /// As the methods are judged, on the same pairs.
    fn judged<T: Real>(&self, code: impl Fn([T; 3], [T; 3]) -> [T; 3]) -> Row {
        let pairs = directions::pairs(&self.light, self.options);
        let judgement = judge_code(Method::Cap, code, &self.light.light, pairs, self.format.step());
        Row { by: self.by, ..directions::row(self.light, Method::Cap, self.format, &judgement) }
    }
}

impl Visitor for Judge<'_> {
    type Output = Row;

    fn visit<T: Real>(self) -> Row {
        let sphere = DistantSphere::<T>::of(&self.light.light);
        self.judged(|l, r| formula::cap(l, r, &sphere))
    }
}

/// The peers' directions, with the worst arithmetic errors that the crate `tests/peers` has found. Their total errors
/// are at most these and the model's together.
fn of_peers(rows: &[Row]) -> Vec<Row> {
    let row = |peer: peers::Peer| {
        let same = |row: &&Row| row.light == SUN && row.method == peer.function && row.format == peer.format;
        rows.iter().find(same).map(|own| Row {
            by: peer.by,
            cost: f64::NAN,
            cost_low: f64::NAN,
            cost_high: f64::NAN,
            error_max: peer.error,
            error_rms: f64::NAN,
            total_max: peer.error + own.model_max,
            total_rms: f64::NAN,
            samples: 0,
            excluded: 0,
            undirected: 0,
            failure: None,
            worst_angle: f64::NAN,
            worst_l: String::new(),
            worst_r: String::new(),
            ..own.clone()
        })
    };
    peers::rows().filter_map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::author::is_peer;
    use crate::sample;

    fn under_the_sun() -> Vec<Row> {
        let options = Options::parse_from(["sunglint", "--quick", "--light", SUN]);
        let rows = [sample::row("cap", "f32", 1.0, 1e-3), sample::row("factored", "f32", 1.0, 1e-3)];
        directions(&rows.map(|row| Row { model_max: 1e-5, ..row }), &options, &ProgressBar::hidden())
    }

    fn of<'a>(rows: &'a [Row], by: &str, format: Format) -> &'a Row {
        let row = rows.iter().find(|row| row.by == by && row.format == format.name()).expect("a row");
        assert!(row.failure.is_none() && row.total_max == row.error_max && row.cost.is_nan());
        row
    }

    #[test]
    fn the_formula_is_as_exact_as_its_format_allows() {
        let rows = under_the_sun();
        for format in [Format::I2F14, Format::I2F30] {
            let steps = of(&rows, FORMULA, format).error_max / format.step();
            assert!((0.5..1.25).contains(&steps), "{format:?}: {steps}");
        }
    }

    /// The hard directions are beside the opposite of the light, where the bound grows.
    #[test]
    fn integers_keep_the_bound_of_their_documentation() {
        let rows = under_the_sun();
        let soft = of(&rows, SOFT, Format::F32);
        let gap = core::f64::consts::PI - soft.worst_angle;
        let bound = 5.4e-8 + 1.15e-9 * soft.ratio / gap;
        assert!((bound / 4.0..bound).contains(&soft.error_max), "{:e}, bound {bound:e}", soft.error_max);
    }

    #[test]
    fn peers_have_the_model_s_error_too() {
        let rows = under_the_sun();
        let peers: Vec<_> = rows.iter().filter(|row| is_peer(row.by)).collect();
        assert_eq!(peers.len(), 4, "two functions by two peers");
        assert!(peers.iter().all(|row| row.total_max == row.error_max + 1e-5 && row.cost.is_nan()));
        assert!(peers.iter().all(|row| row.error_max != 1e-3), "an error of the study's own");
    }
}
