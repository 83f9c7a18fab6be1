//! The figures that tell a failure from its cure, as words.

use crate::number;
use crate::pictures::figures::{Figures, per_cent};

/// How wide the disc is drawn, and the worst error.
pub fn width(figures: &Figures) -> String {
    let width = match figures.lit {
        lit if lit > 0.6 => "wider than the picture".to_owned(),
        _ => format!("{:.2} times as wide as the Sun", figures.width),
    };
    format!("{width}, errors up to {} % of its radius", number::percent(figures.worst, 100.0))
}

/// What has no direction; where all have one, how wide the disc is.
pub fn no_direction(figures: &Figures) -> String {
    match figures.nan {
        0.0 => width(figures),
        share => format!("{} % of the pixels are NaN", per_cent(share)),
    }
}

/// What is no number, and what is far off.
pub fn lost(figures: &Figures) -> String {
    let share = |share: f64, what: &str| (share > 0.0).then(|| format!("{} % {what}", per_cent(share)));
    let shares = [
        share(figures.nan, "NaN"),
        share(figures.infinite, "infinite"),
        share(figures.doubled, "off by a factor of two"),
        share(figures.visible - figures.doubled, "off by a tenth"),
    ];
    let shares: Vec<_> = shares.into_iter().flatten().collect();
    match shares.is_empty() {
        true => format!("no pixel is off by a tenth, worst error {} %", per_cent(figures.worst)),
        false => shares.join(", ").replacen(" % ", " % of the pixels ", 1),
    }
}

/// How many levels there are.
pub fn shades(figures: &Figures) -> String {
    format!("{} levels of grey", figures.shades)
}
