//! What an expression of a shader may be worth.

/// A value; numbers are held in f64, whatever they were rounded to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A scalar.
    Number(f64),
    /// A vector of three.
    Vector([f64; 3]),
    /// True or false.
    Truth(bool),
    /// A local variable by its index, or one lane of it.
    Place(usize, Option<usize>),
}

impl Value {
    /// The lanes of a vector.
    pub fn vector(self) -> [f64; 3] {
        match self {
            Self::Vector(lanes) => lanes,
            Self::Number(number) => [number; 3],
            other => panic!("{other:?} is no vector"),
        }
    }

    /// A scalar.
    pub fn number(self) -> f64 {
        match self {
            Self::Number(number) => number,
            other => panic!("{other:?} is no number"),
        }
    }

    /// A truth.
    pub fn truth(self) -> bool {
        match self {
            Self::Truth(truth) => truth,
            other => panic!("{other:?} is no truth"),
        }
    }

    /// `f` of the number or of each lane.
    pub fn map(self, f: impl FnMut(f64) -> f64) -> Self {
        let mut f = f;
        match self {
            Self::Number(number) => Self::Number(f(number)),
            Self::Vector(lanes) => Self::Vector(lanes.map(f)),
            other => panic!("no arithmetic on {other:?}"),
        }
    }

    /// `f` of two numbers, of the lanes of two vectors, or of a number and each lane.
    pub fn zip(self, other: Self, mut f: impl FnMut(f64, f64) -> f64) -> Self {
        if let (Self::Number(a), Self::Number(b)) = (self, other) {
            return Self::Number(f(a, b));
        }
        let (a, b) = (self.vector(), other.vector());
        Self::Vector([0, 1, 2].map(|lane| f(a[lane], b[lane])))
    }
}
