//! What building blocks are for, and what the error of each is relative to.

use super::Kernel;

/// Building blocks of one purpose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Directions and angles.
    Directions,
    /// How much light arrives and is sent on.
    Light,
    /// Which colour it has.
    Colour,
}

impl Group {
    /// Name, as headings print it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Directions => "Directions",
            Self::Light => "Light",
            Self::Colour => "Colour",
        }
    }
}

impl Kernel {
    /// What it is for.
    pub fn group(self) -> Group {
        match self {
            Self::Normalize | Self::Reflect | Self::Basis | Self::SinCos | Self::ConeDirection => Group::Directions,
            Self::RelativeIlluminance
            | Self::Lambert
            | Self::SoftShadow
            | Self::Irradiance
            | Self::Flux
            | Self::SphereLight => Group::Light,
            Self::RelativeToPeak | Self::Tint => Group::Colour,
        }
    }

    /// What it does and what its error means, in a sentence each.
    pub fn about(self) -> &'static str {
        match self {
            Self::Normalize => {
                "A vector of length 0.5 to 1.15 to unit length. The error is the angle to the vector as the format holds it."
            }
            Self::Reflect => {
                "The mirror direction 2 (n·v) n − v. The error is the angle to that of the vectors as the format holds them."
            }
            Self::Basis => {
                "Two directions across l. The error is how far the three are from right angles, in radians, or the two from \
                 length 1, whichever is greater."
            }
            Self::SinCos => {
                "Sine and cosine of a part of a turn. The error is the greater of the two’s, on the scale on which the radius of \
                 the circle is 1."
            }
            Self::ConeDirection => {
                "A direction of the Sun’s disc from two numbers. The error is the angle to the true direction; the Sun’s radius is \
                 4.65e-3 rad."
            }
            Self::RelativeIlluminance => {
                "What a plane gets of the Sun as it sets, over what a plane gets that faces it. The error is \
                 relative to the true share, down to the last sliver; in f16 shares below 6.1e-5 count as that \
                 much. Of it 2.5e-7 is a polynomial’s, in every format."
            }
            Self::Lambert => {
                "Radiance of a matt surface. The error is in units of the last place of the answer: of the float, in \
                 fixed point of the light level (U16F16, U32F32) or of 31 bits where those are coarser. So formats cannot be \
 compared by it, and there is no frontier."
            }
            Self::SoftShadow => {
                "What a point sees of the Sun behind a sphere, by 16 directions. The error is that of the share \
                 that is seen, of which 1 is the whole disc; up to 0.25 of it is due to there being only 16, whose cost this is."
            }
            Self::Irradiance => "Irradiance by a point, I cos / r². The error is relative to the true irradiance.",
            Self::Flux => {
                "Power from one patch to another, L A cos A′ cos′ / r². The error is relative to the true power."
            }
            Self::SphereLight => {
                "Radiance of the small sphere that stands for a point light of colour 1, (distance / radius)², with its \
                 checks. The error is relative to the true radiance."
            }
            Self::RelativeToPeak => {
                "Planck’s law by wavelength over its peak, from 0.5 to 10 times the peak’s wavelength. The error is relative to \
                 the true ratio."
            }
            Self::Tint => {
                "Colour of 800 to 40 000 K at three wavelengths. The error is that of a level, on the scale on which the brightest \
                 of the three is 1."
            }
        }
    }
}
