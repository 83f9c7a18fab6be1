//! Building blocks as a list: functions that are part of a lit pixel, or of the light that it is lit by.
//!
//! To add one: a variant of [`Kernel`], its name, group, unit, inputs and what its error means, its errors and its
//! calls. Table, chart and clock then have it.

mod budget;
mod calls;
mod group;
pub mod vectors;

use sunglint::oracle::planck::Law;
use sunglint::trial::radiometry::Formula;
use sunglint::trial::shadow::Occluder;
use sunglint::trial::{Found, blackbody, diffuse, sampling, shadow};
use sunglint::{Real, SUN};

/// A function to be measured; at the Sun from Earth, where it takes a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// A vector of any length to unit length.
    Normalize,
    /// The mirror direction.
    Reflect,
    /// Two directions across a given one.
    Basis,
    /// Sine and cosine of a part of a turn.
    SinCos,
    /// A direction of the disc.
    ConeDirection,
    /// How much of a disc that sets a plane gets.
    RelativeIlluminance,
    /// A matt surface.
    Lambert,
    /// What of the disc is seen, by [`DIRECTIONS`] directions.
    SoftShadow,
    /// Irradiance by a point.
    Irradiance,
    /// Power from patch to patch.
    Flux,
    /// Colour by a small sphere.
    SphereLight,
    /// Planck's law over its peak.
    RelativeToPeak,
    /// The colour of a temperature.
    Tint,
}

/// The last place of an answer, which is a unit for each format.
pub const ULP: &str = "ULP";

/// Directions to the light for each soft shadow.
const DIRECTIONS: u32 = 16;

impl Kernel {
    /// All of them, in the order of tables.
    pub const ALL: [Self; 13] = [
        Self::Normalize,
        Self::Reflect,
        Self::Basis,
        Self::SinCos,
        Self::ConeDirection,
        Self::RelativeIlluminance,
        Self::Lambert,
        Self::SoftShadow,
        Self::Irradiance,
        Self::Flux,
        Self::SphereLight,
        Self::RelativeToPeak,
        Self::Tint,
    ];

    /// Name, as tables and charts print it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Normalize => "normalize",
            Self::Reflect => "reflect",
            Self::Basis => "basis",
            Self::SinCos => "sin_cos",
            Self::ConeDirection => "Cone::direction",
            Self::RelativeIlluminance => "relative_illuminance",
            Self::Lambert => "lambert",
            Self::SoftShadow => "soft_shadow",
            Self::Irradiance => "irradiance",
            Self::Flux => "flux",
            Self::SphereLight => "SphereLight",
            Self::RelativeToPeak => "relative_to_peak",
            Self::Tint => "tint",
        }
    }

    /// What its errors are in.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Normalize | Self::Reflect | Self::Basis | Self::ConeDirection => "rad",
            Self::SinCos | Self::SoftShadow | Self::Tint => "absolute",
            Self::Lambert => ULP,
            Self::RelativeIlluminance | Self::Irradiance | Self::Flux | Self::SphereLight | Self::RelativeToPeak => {
                "relative"
            }
        }
    }

    /// What a worst case is made of: a name for each place of [`Found::worst`], none for those that play no part.
    fn inputs(self) -> &'static [&'static str] {
        match self {
            Self::Normalize => &["v.x", "v.y", "v.z"],
            Self::Reflect => &["n.x", "n.y", "n.z", "v.x", "v.y", "v.z"],
            Self::Basis => &["l.x", "l.y", "l.z"],
            Self::SinCos => &["turn"],
            Self::ConeDirection => &["l.x", "l.y", "l.z", "z", "turn"],
            Self::RelativeIlluminance => &["n.l"],
            Self::Lambert => &["albedo", "illuminance", "n.l"],
            Self::SoftShadow => &["", "", "edge", "radius", "", "first"],
            Self::Irradiance => &["intensity", "distance", "", "", "cos"],
            Self::Flux => &["radiance", "sender", "receiver", "distance", "cos", "receiver's cos"],
            Self::SphereLight => &["x", "y", "z", "radius"],
            Self::RelativeToPeak => &["ratio"],
            Self::Tint => &["kK", "red µm", "green µm", "blue µm"],
        }
    }

    /// Its errors against f64 at `count` random inputs, as rounded into the format.
    pub fn errors<T: Real>(self, seed: u64, count: usize) -> Measured {
        match self {
            Self::Normalize => self.measured(&vectors::normalize_errors::<T>(seed, count)),
            Self::Reflect => self.measured(&vectors::reflect_errors::<T>(seed, count)),
            Self::Basis => self.measured(&sampling::basis_error::<T>(seed, count)),
            Self::SinCos => {
                let turns = sampling::points::<T>(seed).map(|[_, turn]| turn);
                self.measured(&sampling::turn_error(turns.take(count)))
            }
            Self::ConeDirection => self.measured(&sampling::direction_error::<T>(&SUN, seed, count)),
            Self::RelativeIlluminance => self.measured(&diffuse::relative_illuminance_error::<T>(&SUN, seed, count)),
            Self::Lambert => self.measured(&diffuse::lambert_error::<T>(seed, count)),
            Self::SoftShadow => {
                // The true share takes as long as a hundred other kernels.
                let scenes = count / 100;
                self.measured(&shadow::error::<T>(&SUN, Occluder::Sphere, DIRECTIONS, seed, scenes))
            }
            Self::Irradiance => self.measured(&Formula::Irradiance.error::<T>(seed, count)),
            Self::Flux => self.measured(&Formula::Flux.error::<T>(seed, count)),
            Self::SphereLight => self.measured(&Formula::SmallSphere.error::<T>(seed, count)),
            Self::RelativeToPeak => self.measured(&blackbody::relative_error::<T>(Law::Wavelength, seed, count)),
            Self::Tint => self.measured(&blackbody::tint_error::<T>(seed, count)),
        }
    }

    /// What was found, with the names of the inputs.
    pub fn measured<const INPUTS: usize>(self, found: &Found<INPUTS>) -> Measured {
        let named = self.inputs().iter().zip(&found.worst).filter(|(name, _)| !name.is_empty());
        let worst: Vec<_> = named.map(|(name, value)| format!("{name} {value}")).collect();
        Measured {
            max: found.max,
            rms: found.rms(),
            samples: found.samples,
            worst: worst.join(", "),
            p99: found.p99(),
            bias: found.bias(),
        }
    }
}

/// What came of judging a kernel, however many inputs it has.
pub struct Measured {
    /// The worst error.
    pub max: f64,
    /// Root mean square of the error.
    pub rms: f64,
    /// Inputs that were tried.
    pub samples: u64,
    /// Input of the worst error: names and exact values.
    pub worst: String,
    /// What 99 in 100 errors do not exceed.
    pub p99: f64,
    /// Mean of the errors with their signs, where they have one.
    pub bias: Option<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use sunglint::trial::{Format, Visitor};

    struct Errors(Kernel);

    impl Visitor for Errors {
        type Output = Measured;

        fn visit<T: Real>(self) -> Measured {
            self.0.errors::<T>(1, 4000)
        }
    }

    #[test]
    fn errors_are_those_that_the_library_promises() {
        for kernel in Kernel::ALL {
            for format in Format::ALL {
                let (found, budget) = (format.visit(Errors(kernel)), kernel.budget(format));
                let name = format!("{} in {}: {} of {budget}", kernel.name(), format.name(), found.max);
                assert!(found.max <= budget && found.max > budget / 10.0, "{name}");
                assert!(found.rms < found.max && found.samples >= 40, "{name}");
                assert!(found.p99 <= found.max && found.p99 > 0.2 * found.rms, "{name}, 99th {}", found.p99);
                let has_sign = !matches!(
                    kernel,
                    Kernel::Normalize
                        | Kernel::Reflect
                        | Kernel::Basis
                        | Kernel::SinCos
                        | Kernel::ConeDirection
                        | Kernel::Tint
                );
                assert_eq!(found.bias.is_some(), has_sign, "{name}");
                assert!(found.bias.is_none_or(|bias| bias.abs() <= found.rms), "{name}, bias {:?}", found.bias);
            }
        }
    }

    #[test]
    fn a_worst_case_has_a_name_for_each_number() {
        let worst = Kernel::Irradiance.errors::<f32>(1, 100).worst;
        let names: Vec<_> = worst.split(", ").filter_map(|part| part.split(' ').next()).collect();
        assert_eq!(names, ["intensity", "distance", "cos"]);
    }

    #[test]
    fn groups_follow_each_other() {
        let groups = Kernel::ALL.map(|kernel| kernel.group() as usize);
        assert!(groups.is_sorted());
    }
}
