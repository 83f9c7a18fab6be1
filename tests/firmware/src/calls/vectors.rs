//! Vectors and roots.

use sunglint::trial::mantissa;
use sunglint::{Float, Real, Scalar, specular};

pub fn normalize<T: Real>(v: &[T; 3]) -> [T; 3] {
    specular::normalize(*v)
}

pub fn reflect<T: Real>([n, v]: &[[T; 3]; 2]) -> [T; 3] {
    specular::reflect(*n, *v)
}

pub fn dot<T: Real>([a, b]: &[[T; 3]; 2]) -> T::Wide {
    T::dot(*a, *b)
}

pub fn root<S: Scalar>(square: &S) -> S {
    square.root()
}

pub fn reciprocal_root<T: Float>(square: &T) -> T {
    T::over_root(T::ONE, *square)
}

pub fn mantissa_reciprocal_root(m: &u32) -> u32 {
    mantissa::reciprocal_root(*m)
}
