//! How large the errors of the building blocks may be.

use sunglint::trial::radiometry::Formula;
use sunglint::trial::{Format, blackbody, diffuse, sampling, shadow};

use super::{DIRECTIONS, Kernel};

impl Kernel {
    /// What the tests of the library assert of its errors.
    pub fn budget(self, format: Format) -> f64 {
        let maxima = match self {
            Self::Normalize | Self::Reflect => return 4.0 * format.step(),
            Self::Basis => sampling::BASIS,
            Self::SinCos => sampling::TURN,
            Self::ConeDirection => sampling::DIRECTION[0],
            Self::RelativeIlluminance => diffuse::RELATIVE[0],
            Self::Lambert => diffuse::LAMBERT,
            Self::SoftShadow => return shadow::budget(format, 0, DIRECTIONS),
            Self::Irradiance => return Formula::Irradiance.maximum(format),
            Self::Flux => return Formula::Flux.maximum(format),
            Self::SphereLight => return Formula::SmallSphere.maximum(format),
            Self::RelativeToPeak => blackbody::RELATIVE[0],
            Self::Tint => blackbody::TINT,
        };
        maxima[format as usize]
    }
}
