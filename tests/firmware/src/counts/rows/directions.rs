//! The direction methods.

use sunglint::fixed::types::{I2F14, I2F30};
use sunglint::trial::chip::{Case, INPUTS, pairs};
use sunglint::trial::{Constants, Method};
use sunglint::{Real, SUN};

use crate::calls::directions::{self, Ray};
use crate::counter::Counter;
use crate::inputs::{all, rounded};
use crate::row::Row;

pub fn count<T: Real>(counter: &Counter) {
    for case in Case::ALL {
        let rays = rays::<T>(case);
        for method in Method::ALL {
            let call = match method {
                Method::Epic => directions::epic::<T>,
                Method::Factored => directions::factored,
                Method::Disc => directions::disc,
                Method::Cap => directions::cap,
            };
            row::<T>(method, "sunglint", case).count(counter, call, &rays);
        }
    }
}

/// What the formats with code of their own have that of all formats do.
pub fn by_formula(counter: &Counter) {
    for case in Case::ALL {
        row::<I2F14>(Method::Cap, "formula", case).count(counter, directions::cap_by_formula, &rays::<I2F14>(case));
        row::<I2F30>(Method::Cap, "formula", case).count(counter, directions::cap_by_formula, &rays::<I2F30>(case));
    }
}

fn row<T: Real>(method: Method, by: &'static str, case: Case) -> Row {
    Row { function: method.name(), format: T::NAME, by, case: case.name() }
}

fn rays<T: Real>(case: Case) -> [Ray<T>; INPUTS] {
    let Constants { sphere, unfactored } = Constants::of(&SUN);
    all(pairs(case).map(|pair| Ray { l: rounded(pair.l), r: rounded(pair.r), sphere, unfactored }))
}
