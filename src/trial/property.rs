//! What has to hold for every input, once for fuzzers and tests: a function for each family of kernels, which reads a
//! case off bytes and says what is broken.
//!
//! A kernel never panics, is finite where that is promised, within its budget of the f64 truth in every format,
//! symmetric and monotonic where its formula is, and continuous across the disc's edge. `fuzz/` runs the families under
//! libFuzzer, `tests/property.rs` on the committed corpus and on fresh random cases.

pub mod blackbody;
pub mod directions;
pub mod figures;
pub mod highlight;
pub mod normalization;
pub mod radiometry;
pub mod raw;
pub mod sampling;
pub mod scene;

use core::fmt;

use super::draw::Draw;
use super::format::Format;

/// The first numbers of a case, for a report; unused places are zero. The case itself is its bytes.
pub type Inputs = [f64; 10];

/// What did not hold, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Broken {
    /// What should have held.
    pub property: &'static str,
    /// In which format.
    pub format: Format,
    /// The size that was found.
    pub found: f64,
    /// The size that is allowed.
    pub allowed: f64,
    /// The case, as rounded into the format.
    pub inputs: Inputs,
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { property, format, found, allowed, inputs } = self;
        write!(f, "{property} in {}: {found:e}, allowed is {allowed:e}, at {inputs:?}", format.name())
    }
}

impl core::error::Error for Broken {}

/// Reads a case and says what it breaks.
pub type Family = fn(&mut Draw<'_>) -> Result<(), Broken>;

/// All families, by the names of the fuzz targets.
pub const FAMILIES: [(&str, Family); 8] = [
    ("directions", directions::hold),
    ("normalization", normalization::hold),
    ("highlight", highlight::hold),
    ("sampling", sampling::hold),
    ("radiometry", radiometry::hold),
    ("blackbody", blackbody::hold),
    ("scene", scene::hold),
    ("raw", raw::hold),
];

/// One case's format and numbers, for the claims that are made about it.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// The format.
    pub format: Format,
    /// The numbers.
    pub inputs: Inputs,
}

impl Case {
    /// Claims that `found` is at most `allowed`; NaN never is.
    ///
    /// # Errors
    /// [`Broken`] if it is not.
    pub fn at_most(&self, property: &'static str, found: f64, allowed: f64) -> Result<(), Broken> {
        if found <= allowed {
            return Ok(());
        }
        Err(Broken { property, format: self.format, found, allowed, inputs: self.inputs })
    }

    /// Claims that something is so.
    ///
    /// # Errors
    /// [`Broken`] if it is not.
    pub fn holds(&self, property: &'static str, so: bool) -> Result<(), Broken> {
        self.at_most(property, if so { 0.0 } else { 1.0 }, 0.0)
    }
}

/// Some vectors as the numbers of a case.
pub fn inputs<const N: usize>(vectors: [[f64; 3]; N]) -> Inputs {
    let mut inputs = [0.0; 10];
    for (place, lane) in inputs.iter_mut().zip(vectors.into_iter().flatten()) {
        *place = lane;
    }
    inputs
}
