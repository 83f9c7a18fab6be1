//! f32 as one writes it by hand, without an answer for zero vectors, NaN or large discs; the root is a library's.

use micromath::F32;
use sunglint::SUN;

type Vector = [f32; 3];

/// To the light and along the mirror ray.
pub type Ray = [Vector; 2];

const SIN: f32 = SUN.sin() as f32;
const SIN_SQUARE: f32 = (SUN.sin() * SUN.sin()) as f32;
const VERSINE: f32 = SUN.versine() as f32;

/// Whose roots.
pub trait Roots {
    /// The square root.
    fn root(square: f32) -> f32;

    /// One over it.
    fn reciprocal_root(square: f32) -> f32;
}

/// libm's, right to the last place.
pub struct Libm;

/// micromath's, which look at the exponent.
pub struct Micromath;

impl Roots for Libm {
    #[inline]
    fn root(square: f32) -> f32 {
        libm::sqrtf(square)
    }

    #[inline]
    fn reciprocal_root(square: f32) -> f32 {
        1.0 / libm::sqrtf(square)
    }
}

impl Roots for Micromath {
    #[inline]
    fn root(square: f32) -> f32 {
        F32(square).sqrt().0
    }

    #[inline]
    fn reciprocal_root(square: f32) -> f32 {
        F32(square).invsqrt().0
    }
}

/// The square root.
pub fn root<R: Roots>(square: &f32) -> f32 {
    R::root(*square)
}

/// One over the square root.
pub fn reciprocal_root<R: Roots>(square: &f32) -> f32 {
    R::reciprocal_root(*square)
}

/// The dot product.
pub fn dot([a, b]: &[Vector; 2]) -> f32 {
    product(*a, *b)
}

/// A vector at unit length.
pub fn normalize<R: Roots>(v: &Vector) -> Vector {
    unit::<R>(*v)
}

/// The representative point with the distance divided out: the formula of the seed, under the Sun.
pub fn factored<R: Roots>([l, r]: &Ray) -> Vector {
    let along = product(*l, *r);
    let d = zip(*r, *l, |r, l| along * r - l);
    let square = product(d, d);
    let share = if square <= SIN_SQUARE { 1.0 } else { SIN * R::reciprocal_root(square) };
    unit::<R>(zip(*l, d, |l, d| l + d * share))
}

/// The nearest direction of the Sun's disc, without cancellation.
pub fn cap<R: Roots>([l, r]: &Ray) -> Vector {
    let toward = product(*l, *r) >= 0.0;
    let e = zip(*r, *l, |r, l| if toward { r - l } else { r + l });
    let along = product(e, *l);
    let s = zip(e, *l, |e, l| e - along * l);
    let square = product(s, s);
    if toward && square <= SIN_SQUARE {
        return *r;
    }
    let share = SIN * R::reciprocal_root(square);
    zip(*l, s, |l, s| l + (s * share - l * VERSINE))
}

#[inline]
fn unit<R: Roots>(v: Vector) -> Vector {
    let k = R::reciprocal_root(product(v, v));
    [v[0] * k, v[1] * k, v[2] * k]
}

#[inline]
fn product(a: Vector, b: Vector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
fn zip(a: Vector, b: Vector, f: impl Fn(f32, f32) -> f32) -> Vector {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}
