//! The errors of directions that a search drives up, and where: a cell of the tables of budgets.

use core::f64::consts::{FRAC_PI_2, PI};

use super::budget;
use super::format::Format;
use super::input::Pair;
use super::lights::BUDGETED;
use super::method::{Constants, Method};
use crate::light::{DistantLight, SUN};
use crate::oracle;
use crate::real::Real;
use crate::specular;

/// An error of one of the functions of [`specular`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// A method's answer against the exact value of its formula, in radians.
    Direction(Method),
    /// The difference from 1 of the length of `cap`'s answer.
    CapLength,
    /// The lanes of `reflect(l, r)` against exact arithmetic; not for f64, which is its own truth.
    Reflect,
    /// The direction of `normalize(length l)`, in radians.
    Normalize,
    /// The difference from 1 of its length.
    NormalizeLength,
}

/// Some sizes: angular radii in radians, or lengths for [`Aim::Normalize`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Name, as tables print it.
    pub name: &'static str,
    /// The least.
    pub from: f64,
    /// The greatest.
    pub to: f64,
}

/// What an error is sought under.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// One of the budgeted lights.
    Light(usize),
    /// Any light of some angular radius, or any length.
    Sizes(Span),
}

/// One error in one format at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// The error.
    pub aim: Aim,
    /// The format.
    pub format: Format,
    /// The place.
    pub place: Place,
}

/// An input of a cell: a pair as rounded into the format, and the size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Angular radius or length; only within [`Place::Sizes`] does it vary.
    pub size: f64,
    /// The two directions.
    pub pair: Pair,
}

/// Discs of any size. Within a span the errors are of one size; the third of a radian before and after which the rim is
/// told by its cosine ends at 0.775 and begins at 2.366.
pub const DISCS: [Span; 9] = [
    Span { name: "to 0.001", from: 0.0, to: 1e-3 },
    Span { name: "to 0.02", from: 1e-3, to: 0.02 },
    Span { name: "to 0.1", from: 0.02, to: 0.1 },
    Span { name: "to 0.4", from: 0.1, to: 0.4 },
    Span { name: "to 0.8", from: 0.4, to: 0.8 },
    Span { name: "to 1.2", from: 0.8, to: 1.2 },
    Span { name: "to pi/2", from: 1.2, to: FRAC_PI_2 },
    Span { name: "to 2.4", from: FRAC_PI_2, to: 2.4 },
    Span { name: "to pi", from: 2.4, to: PI },
];

/// How many of [`DISCS`] are spheres, which subtend up to half the sky.
pub const SPHERES: usize = 7;

/// Up to half the sky, and beyond.
pub const HALVES: [Span; 2] =
    [Span { name: "spheres", from: 0.0, to: FRAC_PI_2 }, Span { name: "wide discs", from: FRAC_PI_2, to: PI }];

/// The lengths that [`budget::normalize`] is for, by format.
pub const LENGTHS: [[Span; 1]; 7] = [
    [lengths(1e-150, 1e150)],
    [lengths(1e-30, 1e30)],
    [lengths(1e-30, 1e30)],
    [lengths(1e-2, 3e4)],
    [lengths(0.1, 1.9)],
    [lengths(0.01, 1.9)],
    [lengths(1.0, 3e4)],
];

const fn lengths(from: f64, to: f64) -> Span {
    Span { name: "any", from, to }
}

/// Where sizes do not matter.
const ONE: Span = Span { name: "any", from: 0.0, to: 0.0 };

impl Aim {
    /// All errors, in the order of tables.
    pub const ALL: [Self; 8] = [
        Self::Direction(Method::Epic),
        Self::Direction(Method::Factored),
        Self::Direction(Method::Disc),
        Self::Direction(Method::Cap),
        Self::CapLength,
        Self::Reflect,
        Self::Normalize,
        Self::NormalizeLength,
    ];

    /// Name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Direction(method) => method.name(),
            Self::CapLength => "cap length",
            Self::Reflect => "reflect",
            Self::Normalize => "normalize",
            Self::NormalizeLength => "normalize length",
        }
    }

    /// The error in the format `T` at inputs that it holds; infinite where the answer is no direction, none where there
    /// is no one truth.
    pub fn error<T: Real>(self, format: Format, light: &Lit<T>, at: &Candidate) -> Option<f64> {
        let (l, r) = (at.pair.l.map(T::from_f64), at.pair.r.map(T::from_f64));
        match self {
            Self::Direction(method) => {
                let defined = method.is_defined(at.pair.l, at.pair.r, &light.light, format.step());
                let truth = || method.truth(at.pair.l, at.pair.r, &light.light);
                defined.then(|| apart(method.direction(l, r, &light.constants), truth()))
            }
            Self::CapLength => Some(length_error(specular::cap(l, r, &light.constants.sphere))),
            Self::Reflect => (format != Format::F64).then(|| reflect_error(l, r)),
            Self::Normalize => {
                let v = at.pair.l.map(|lane| T::from_f64(lane * at.size));
                Some(apart(specular::normalize(v), v.map(T::to_f64)))
            }
            Self::NormalizeLength => {
                Some(length_error(specular::normalize(at.pair.l.map(|lane| T::from_f64(lane * at.size)))))
            }
        }
    }

    /// Where the error is budgeted.
    pub(super) fn places(self, format: Format) -> impl Iterator<Item = Place> {
        let (lights, sizes): (usize, &[Span]) = match self {
            // A light without a distance has distance 1, which makes it the arithmetic of `factored`.
            Self::Direction(Method::Epic) => (1, &[]),
            Self::Direction(Method::Factored) => (BUDGETED.len(), &DISCS[..SPHERES]),
            Self::Direction(_) => (BUDGETED.len(), &DISCS),
            Self::CapLength => (0, &HALVES),
            Self::Reflect => (0, &[ONE]),
            Self::Normalize | Self::NormalizeLength => (0, &LENGTHS[format as usize]),
        };
        (0..lights).map(Place::Light).chain(sizes.iter().copied().map(Place::Sizes))
    }
}

/// A light and its constants in a format.
#[derive(Clone, Copy, Debug)]
pub struct Lit<T: Real> {
    /// The light.
    pub light: DistantLight,
    /// Its constants.
    pub constants: Constants<T>,
}

impl<T: Real> Lit<T> {
    /// `light` in the format `T`.
    pub fn of(light: DistantLight) -> Self {
        Self { light, constants: Constants::of(&light) }
    }
}

impl Place {
    /// Name in tables.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Light(index) => BUDGETED[*index].name,
            Self::Sizes(span) => span.name,
        }
    }

    /// The light of a `size` there.
    pub fn light(&self, size: f64) -> DistantLight {
        let light = match *self {
            Self::Light(index) => return BUDGETED[index].light,
            Self::Sizes(_) if size < FRAC_PI_2 => DistantLight::from_ratio(libm::sin(size)),
            Self::Sizes(_) => DistantLight::from_angular_radius(size),
        };
        light.unwrap_or(SUN)
    }

    /// The sizes there.
    pub fn sizes(&self) -> [f64; 2] {
        match *self {
            Self::Light(index) => [BUDGETED[index].light.angular_radius(); 2],
            Self::Sizes(Span { from, to, .. }) => [from, to],
        }
    }
}

impl Cell {
    /// All cells that have a budget, in the order of tables.
    pub fn all() -> impl Iterator<Item = Self> {
        let cells = Aim::ALL.into_iter().flat_map(|aim| {
            let cells = move |format| aim.places(format).map(move |place| Self { aim, format, place });
            Format::ALL.into_iter().flat_map(cells)
        });
        cells.filter(|cell| cell.budget().is_some())
    }

    /// What the error may be.
    pub fn budget(&self) -> Option<f64> {
        let format = self.format;
        match (self.aim, self.place) {
            (Aim::Direction(method), Place::Light(light)) => budget::maximum(method, format, light),
            (Aim::Direction(method), Place::Sizes(span)) => budget::of_any_light(method, format, span.to),
            (Aim::CapLength, _) => Some(budget::cap_length(format, self.place.sizes()[1])),
            (Aim::Reflect, _) => budget::reflect(format),
            (Aim::Normalize, _) => Some(budget::normalize(format)[0]),
            (Aim::NormalizeLength, _) => Some(budget::normalize(format)[1]),
        }
    }
}

fn apart<T: Real>(answer: [T; 3], truth: [f64; 3]) -> f64 {
    let answer = answer.map(T::to_f64);
    // The zero vector has no direction, and atan2 would find no angle in it.
    let directed = answer.into_iter().all(f64::is_finite) && answer != [0.0; 3];
    if directed { oracle::angle_between(answer, truth) } else { f64::INFINITY }
}

fn length_error<T: Real>(answer: [T; 3]) -> f64 {
    let [x, y, z] = answer.map(T::to_f64);
    let error = libm::fabs(libm::sqrt(x * x + y * y + z * z) - 1.0);
    if error.is_nan() { f64::INFINITY } else { error }
}

fn reflect_error<T: Real>(n: [T; 3], v: [T; 3]) -> f64 {
    let answer = specular::reflect(n, v).map(T::to_f64);
    let (n, v) = (n.map(T::to_f64), v.map(T::to_f64));
    let twice = 2.0 * (n[0] * v[0] + n[1] * v[1] + n[2] * v[2]);
    let errors = [0, 1, 2].map(|i| libm::fabs(answer[i] - (twice * n[i] - v[i])));
    errors.into_iter().fold(0.0, |most, error| if error <= most { most } else { error })
}
