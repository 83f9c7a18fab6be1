//! What the pages of the methods show.

use super::{row, whole_study};
use crate::curves::CurveRow;
use crate::pictures::{Kind, Picture};
use crate::presets::PresetRow;
use crate::result::{Row, Study};

/// A study of two direction methods and two highlights with all that their pages show.
pub fn methods_study() -> Study {
    let failed = Row { failure: Some("NaN".to_owned()), ..row("epic", "f16", 0.5, f64::NAN) };
    let rows = vec![failed, row("cap", "f64", 1.0, 1e-16), row("cap", "f16", 30.0, 1e-3)];
    let form = |form: &str| PresetRow {
        preset: "tiny-sun",
        role: "cure",
        form: form.to_owned(),
        measure: "lost".to_owned(),
        ..PresetRow::default()
    };
    Study {
        curves: [curves("cap", "angle"), curves("cap", "ratio"), curves("epic", "angle")].concat(),
        presets: vec![form("cap, f16"), form("disc_ggx, f32")],
        pictures: [Kind::Lit, Kind::Error, Kind::Truth].map(picture).into(),
        ..whole_study(rows)
    }
}

/// Errors of a direction method in f64 and in f16, format by format.
pub fn curves(method: &str, along: &'static str) -> Vec<CurveRow> {
    let places = 0..=24;
    let row = |format: &str, error: f64, place: i32| CurveRow {
        subject: "direction",
        method: method.to_owned(),
        format: format.to_owned(),
        alpha: None,
        ratio: 0.004650467,
        along,
        at: 10f64.powf(f64::from(place) / 4.0 - 6.0),
        error_max: error,
        error_rms: error * 0.25,
        model_max: 0.1,
        samples: 100,
    };
    let of = |(format, error): (&'static str, f64)| places.clone().map(move |place| row(format, error, place));
    [("f64", 1e-16), ("f16", 1e-3)].into_iter().flat_map(of).collect()
}

/// A picture of `cap`, or of the truth; its bytes are no PNG.
fn picture(kind: Kind) -> Picture {
    let [method, format] = if kind == Kind::Truth { ["truth", "f64"] } else { ["cap", "f16"] };
    Picture {
        name: format!("{method}-{format}"),
        subject: "direction",
        method: method.to_owned(),
        format: format.to_owned(),
        kind,
        caption: "a sphere".to_owned(),
        size: [2, 2],
        png: vec![1, 2, 3],
    }
}
