//! What images are asked, and what they have to answer.

use sunglint::raw::SUN_Q30;
use sunglint::trial::chip::{Case, pixels};
use sunglint::trial::{Format, Visitor};
use sunglint::{DistantSphere, Real, SUN, cap, reflect, soft};

pub type Vector = [f64; 3];

/// Where the images' own Sun is.
pub const SUN_AT: Vector = [0.6, 0.0, 0.8];

/// Normal, to the viewer and to the light.
pub type Seen = [Vector; 3];

/// 512 of them: the mirror ray inside the Sun's disc and outside, and the Sun astride the horizon.
pub fn seen() -> impl Iterator<Item = Seen> {
    Case::ALL.into_iter().flat_map(pixels).enumerate().map(|(index, pixel)| {
        let [n, v] = [pixel.n, pixel.v].map(|w| mirrored(w, pixel.l));
        if index % 8 > 0 {
            return [n, v, SUN_AT];
        }
        let n = unit(sum(n, SUN_AT, -dot(n, SUN_AT)));
        [n, unit(sum(v, n, 1.0)), SUN_AT]
    })
}

/// All in a format, as they lie in memory.
pub fn bytes(format: Format) -> Vec<u8> {
    seen().flatten().flatten().flat_map(|lane| in_memory(format, lane)).collect()
}

/// Who answers.
#[derive(Clone, Copy, PartialEq)]
pub enum By {
    /// Gives the light back.
    Nobody,
    /// `reflect` and `cap` in the format.
    Formula,
    /// Those of `soft`.
    Soft,
}

impl By {
    /// All answers, as they lie in memory.
    pub fn answers(self, format: Format) -> Vec<u8> {
        let lanes = format.visit(Answers { by: self });
        lanes.into_iter().flatten().flat_map(|lane| in_memory(format, lane)).collect()
    }
}

struct Answers {
    by: By,
}

impl Visitor for Answers {
    type Output = Vec<Vector>;

    fn visit<T: Real>(self) -> Self::Output {
        let sphere = DistantSphere::<T>::of(&SUN);
        let answer = |seen: Seen| {
            let [n, v, l] = seen.map(|v| v.map(T::from_f64));
            match self.by {
                By::Nobody => l.map(T::to_f64),
                By::Formula => cap(l, reflect(n, v), &sphere).map(T::to_f64),
                By::Soft => {
                    let [n, v, l] = [n, v, l].map(|v| v.map(|lane| lane.to_f64() as f32));
                    soft::cap(l, soft::reflect(n, v), &SUN_Q30).map(f64::from)
                }
            }
        };
        seen().map(answer).collect()
    }
}

/// A number that the format holds or is rounded to.
fn in_memory(format: Format, value: f64) -> impl Iterator<Item = u8> {
    struct Rounded(f64);
    impl Visitor for Rounded {
        type Output = f64;
        fn visit<T: Real>(self) -> f64 {
            T::from_f64(self.0).to_f64()
        }
    }
    format.bits(format.visit(Rounded(value))).to_le_bytes().into_iter().take(format.width() / 8)
}

/// In the mirror that has `l` where the Sun is.
fn mirrored(w: Vector, l: Vector) -> Vector {
    let across = unit(sum(l, SUN_AT, -1.0));
    sum(w, across, -2.0 * dot(w, across))
}

fn sum(a: Vector, b: Vector, times: f64) -> Vector {
    [0, 1, 2].map(|i| a[i] + times * b[i])
}

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    v.map(|lane| lane / length)
}
