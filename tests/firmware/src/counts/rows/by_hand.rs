//! What has a function of its own beside the formulas.

use sunglint::fixed::types::I2F14;
use sunglint::material::Surface;
use sunglint::raw::{PixelQ14, SUN_Q14, SUN_Q30};
use sunglint::real::{Scalar, Scaled};
use sunglint::trial::chip::{Case, INPUTS, WIDTHS, pairs, pixels};

use super::vectors::{couples, long, square};
use crate::calls::by_hand::{self, Seen, SoftRay};
use crate::counter::Counter;
use crate::inputs::{all, of_numbers, rounded};
use crate::row::Row;

/// Who is said to have made f32 in integers.
const SOFT: &str = "sunglint soft";

pub fn count(counter: &Counter) {
    for case in Case::ALL {
        soft("cap", case.name()).count(counter, by_hand::soft_cap, &rays(case));
        let row = Row { function: "pixel disc_ggx", format: "I2F14", by: "PixelQ14", case: case.name() };
        row.count(counter, by_hand::pixel_q14, &seen(case));
    }
    soft("reflect", "any").count(counter, by_hand::soft_reflect, &couples::<f32>());
    soft("normalize", "any").count(counter, by_hand::soft_normalize, &long::<f32>());
    let squares = of_numbers(|numbers| square(numbers) as f32);
    soft("root", "any").count(counter, by_hand::soft_root, &squares);
    soft("reciprocal root", "any").count(counter, by_hand::soft_reciprocal_root, &squares);
    let row = Row { function: "reciprocal root", format: "U16F16", by: "sunglint", case: "any" };
    row.count(counter, by_hand::reciprocal_root_q16, &of_numbers(|numbers| (square(numbers) * 65536.0) as u32));
}

fn soft(function: &'static str, case: &'static str) -> Row {
    Row { function, format: "f32", by: SOFT, case }
}

fn rays(case: Case) -> [SoftRay; INPUTS] {
    all(pairs(case).map(|pair| SoftRay { l: rounded(pair.l), r: rounded(pair.r), sphere: SUN_Q30 }))
}

/// On the surfaces that the formulas' pixels are of.
fn seen(case: Case) -> [Seen; INPUTS] {
    let [half, dielectric] = [0.5, 0.04].map(Scaled::nearest);
    let surfaces =
        WIDTHS.map(|alpha| Surface::<I2F14>::new([half; 3], Scaled::nearest(alpha), [dielectric; 3]).unwrap());
    all(pixels(case).enumerate().map(|(index, pixel)| {
        let [n, v, l] = [pixel.n, pixel.v, pixel.l].map(|v| rounded::<I2F14>(v).map(I2F14::to_bits));
        // Pi in Q16.
        let pixel = PixelQ14::new(l, &SUN_Q14, &surfaces[index % WIDTHS.len()], [205_887; 3]).unwrap();
        Seen { n, v, pixel }
    }))
}
