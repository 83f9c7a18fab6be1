//! What calls are counted on: fixed inputs, the same on every core and for every peer.

use oorandom::Rand64;

use crate::light::SUN;
use crate::oracle::angle_between;
use crate::trial::input::{self, Pair, on_sphere, turned, unit};

/// How many of each.
pub const INPUTS: usize = 256;

/// GGX widths of the surfaces, one after the other: from wet to matt.
pub const WIDTHS: [f64; 4] = [0.02, 0.1, 0.3, 0.8];

/// Where the mirror ray is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    /// Within the Sun's disc.
    Inside,
    /// From its rim to the opposite of its centre.
    Outside,
}

impl Case {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Inside, Self::Outside];

    /// Name, as the table has it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Inside => "inside",
            Self::Outside => "outside",
        }
    }

    /// Clear of the rim by more than rounding to f16 moves a direction.
    fn holds(self, pair: &Pair) -> bool {
        let turn = angle_between(pair.l, pair.r) / SUN.angular_radius();
        match self {
            Self::Inside => turn <= 0.8,
            Self::Outside => turn >= 1.25,
        }
    }
}

/// A lit pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Normal.
    pub n: [f64; 3],
    /// To the viewer.
    pub v: [f64; 3],
    /// To the light's centre, above the surface.
    pub l: [f64; 3],
}

/// [`INPUTS`] pairs of directions for the Sun.
pub fn pairs(case: Case) -> impl Iterator<Item = Pair> {
    endless(case).take(INPUTS)
}

/// [`INPUTS`] pixels under the Sun, which is above the surface, seen from up to 75 degrees from the normal.
pub fn pixels(case: Case) -> impl Iterator<Item = Pixel> {
    const MOST: f64 = 150.0 * core::f64::consts::PI / 180.0;
    let mut source = Rand64::new(2);
    let pixel = move |Pair { l, r }| {
        let v = turned(r, on_sphere(&mut source), MOST * source.rand_float());
        Pixel { n: unit([0, 1, 2].map(|i| r[i] + v[i])), v, l }
    };
    let lit = |pixel: &Pixel| (0..3).map(|i| pixel.n[i] * pixel.l[i]).sum::<f64>() > 0.05;
    endless(case).map(pixel).filter(lit).take(INPUTS)
}

/// [`INPUTS`] times three numbers in `[0, 1)`.
pub fn numbers() -> impl Iterator<Item = [f64; 3]> {
    let mut source = Rand64::new(3);
    (0..INPUTS).map(move |_| [(); 3].map(|()| source.rand_float()))
}

fn endless(case: Case) -> impl Iterator<Item = Pair> {
    input::random(1, usize::MAX, SUN.angular_radius()).filter(move |pair| case.holds(pair))
}
