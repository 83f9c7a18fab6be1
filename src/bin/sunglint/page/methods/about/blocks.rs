//! The building blocks.

use super::About;
use crate::kernel::Kernel;

/// What there is to say of `kernel`.
pub fn about(kernel: Kernel) -> About {
    match kernel {
        Kernel::Normalize => NORMALIZE,
        Kernel::Reflect => REFLECT,
        Kernel::Basis => BASIS,
        Kernel::SinCos => SIN_COS,
        Kernel::ConeDirection => CONE_DIRECTION,
        Kernel::RelativeIlluminance => RELATIVE_ILLUMINANCE,
        Kernel::Lambert => LAMBERT,
        Kernel::SoftShadow => SOFT_SHADOW,
        Kernel::Irradiance => IRRADIANCE,
        Kernel::Flux => FLUX,
        Kernel::SphereLight => SPHERE_LIGHT,
        Kernel::RelativeToPeak => RELATIVE_TO_PEAK,
        Kernel::Tint => TINT,
    }
}

const NORMALIZE: About = About {
    what: "a vector at unit length",
    formula: &["<i>v</i> / √(<i>v</i>·<i>v</i>)"],
    takes: "a vector of any length that the format holds; the study tries lengths from 0.5 to 1.15. Zero, NaN and infinite vectors \
give zero.",
    good_for: "Interpolated normals and directions. In I2F14 and I2F30 it is by hand, without a division.",
    function: "sunglint::normalize",
    limit: "",
};

const REFLECT: About = About {
    what: "the mirror direction",
    formula: &["<i>r</i> = 2 (<i>n</i>·<i>v</i>) <i>n</i> − <i>v</i>"],
    takes: "<i>n</i> and <i>v</i> of length 1; <i>v</i> leads from the surface to the viewer.",
    good_for: "The mirror ray of every direction method.",
    function: "sunglint::reflect",
    limit: "shading languages’ <code>reflect</code> takes the direction <em>to</em> the surface and gives the negative of this for the \
same <i>v</i>.",
};

const BASIS: About = About {
    what: "two directions at right angles to a given one",
    formula: &[
        "<i>h</i> = 1 / (1 + |<i>l</i><sub>z</sub>|), &nbsp; <i>s</i> = sign of <i>l</i><sub>z</sub>",
        "<i>t</i> = (1 − <i>h</i> <i>l</i><sub>x</sub><sup>2</sup>, −<i>h</i> <i>l</i><sub>x</sub> <i>l</i><sub>y</sub>, \
−<i>s</i> <i>l</i><sub>x</sub>), &nbsp; <i>b</i> = (−<i>s</i> <i>h</i> <i>l</i><sub>x</sub> <i>l</i><sub>y</sub>, \
<i>s</i> (1 − <i>h</i> <i>l</i><sub>y</sub><sup>2</sup>), −<i>l</i><sub>y</sub>)",
    ],
    takes: "<i>l</i> of length 1. The error is the greatest of the three angles’ difference from right ones, in radians, and of the \
two lengths’ from 1.",
    good_for: "Turning samples of a disc about its centre’s direction, without a branch at the poles.",
    function: "sunglint::sampling::basis",
    limit: "<i>b</i> changes its sign where <i>l</i><sub>z</sub> does.",
};

const SIN_COS: About = About {
    what: "sine and cosine of a part of a full turn",
    formula: &[
        "sin(2π <i>t</i>) and cos(2π <i>t</i>), folded into the first eighth, which is exact, then Taylor’s series",
    ],
    takes: "<i>t</i> in turns, from 0 to 1; what is beyond is taken for the end. The error is absolute.",
    good_for: "The azimuth of samples: π, which I2F14 and I2F30 cannot hold, is not needed.",
    function: "sunglint::sampling::sin_cos",
    limit: "",
};

const CONE_DIRECTION: About = About {
    what: "a direction of the light’s disc, evenly spread over it",
    formula: &[
        "versine of the angle from <i>l</i>: <i>z</i> <i>w</i>, &nbsp; sine: √(<i>z</i> (<i>x</i><sup>2</sup> + \
<i>w</i><sup>2</sup> (1 − <i>z</i>)))",
    ],
    takes: "two numbers from 0 to 1, <i>z</i> and the turn, and a <code>Cone</code>: <i>l</i> with any light.",
    good_for: "Soft shadows and path tracing. Every sample passes the disc’s own hit test.",
    function: "sunglint::sampling::Cone::direction",
    limit: "in f16 the Sun is some steps of the format wide, so its samples crowd on few directions.",
};

const RELATIVE_ILLUMINANCE: About = About {
    what: "how much of a disc that sets a plane gets",
    formula: &[
        "<i>n</i>·<i>l</i> above the horizon, 0 below it; where the plane cuts the disc, with the centre <i>h</i> <i>x</i> below it:",
        "<i>x</i><sup>3</sup> sin<sup>3</sup>(<i>b</i>) (1 − <i>h</i>) times the mean of a smooth function, a polynomial; over π \
<i>x</i><sup>2</sup>",
    ],
    takes: "<i>n</i>·<i>l</i> with the disc’s centre, from −1 to 1, and a <code>DistantSphere</code> of any size. Gives a share of \
what a plane gets that faces the light.",
    good_for: "Diffuse light at sunset, down to the last sliver of the disc.",
    function: "sunglint::relative_illuminance",
    limit: "of the error 2.5e-7 is the polynomial’s, in every format; and near the horizon <i>n</i>·<i>l</i> itself is as good as the \
rounded vectors are.",
};

const LAMBERT: About = About {
    what: "radiance of a matt surface",
    formula: &["(ρ / π) <i>E</i> max(<i>n</i>·<i>l</i>, 0)"],
    takes: "the albedo ρ from 0 to 1, the illuminance <i>E</i> of a plane that faces the light, in units of your choice, and \
<i>n</i>·<i>l</i> with the light’s centre. Gives a light level; what is too great is the greatest.",
    good_for: "The diffuse part of a pixel, away from the horizon.",
    function: "sunglint::lambert",
    limit: "",
};

const SOFT_SHADOW: About = About {
    what: "what a surface sees of the disc",
    formula: &[
        "visible = mean of <i>V</i>, &nbsp; cosine = mean of <i>V</i> (<i>n</i>·<i>a</i>), over directions <i>a</i> of the disc",
    ],
    takes: "a <code>Cone</code>, the normal, how many directions, and a function of yours that says whether a direction is free. Gives \
shares from 0 to 1.",
    good_for: "Soft diffuse shadows in any scene: the sums are of integers, so the count does not cost precision.",
    function: "sunglint::shadow::soft_shadow",
    limit: "with <i>N</i> directions a share is off by up to 2 <i>N</i><sup>−3/4</sup>, in every format.",
};

const IRRADIANCE: About = About {
    what: "irradiance by a point light",
    formula: &["<i>I</i> cos / <i>r</i><sup>2</sup>"],
    takes: "intensity <i>I</i> in W/sr, the cosine at the surface, distance <i>r</i> in metres. Gives W/m².",
    good_for: "Lamps that are small against their distance.",
    function: "sunglint::radiometry::irradiance",
    limit: "",
};

const FLUX: About = About {
    what: "power from one small patch to another",
    formula: &["<i>L</i> (<i>A</i> cos) (<i>A′</i> cos′ / <i>r</i><sup>2</sup>)"],
    takes: "radiance <i>L</i> in W/(m² sr), two patches, each an area in m² and a cosine, and their distance in metres. Gives watts.",
    good_for: "Light from patch to patch; the two may change places.",
    function: "sunglint::radiometry::flux",
    limit: "both patches must be small against their distance.",
};

const SPHERE_LIGHT: About = About {
    what: "a small sphere in place of a point or directional light",
    formula: &["radiance = colour (<i>d</i> / <i>R</i>)<sup>2</sup>"],
    takes: "a position, a target, a radius and a colour, which is what a white surface at the target shows. Refuses with a typed error \
what is out of range.",
    good_for: "Giving lights without a size one, at the same brightness.",
    function: "sunglint::radiometry::SphereLight::of_point",
    limit: "the radiance of a sphere as large as the Sun seems is 46 239 times its colour, beyond I16F16 and close to the end of f16; the \
colour itself fits every format.",
};

const RELATIVE_TO_PEAK: About = About {
    what: "Planck’s law over its peak",
    formula: &[
        "<i>y</i><sup>−5</sup> (exp(<i>a</i>) − 1) / (exp(<i>a</i> / <i>y</i>) − 1), &nbsp; <i>a</i> = 4.965114",
    ],
    takes: "<i>y</i>, the wavelength over that of the peak; the study tries 0.5 to 10. Gives 0 to 1, the same curve for all \
temperatures.",
    good_for: "Spectra in formats that cannot hold SI units: the Sun’s radiance peaks at 2.6e13.",
    function: "sunglint::blackbody::relative_to_peak",
    limit: "in f16 answers for ratios below 0.224 and above 25.5 are subnormal.",
};

const TINT: About = About {
    what: "the colour of a temperature at three wavelengths",
    formula: &["radiance at each wavelength over the greatest of the three, by their quotients alone"],
    takes: "a temperature in kilokelvins and three wavelengths in micrometres, up to a factor of 8 apart; the study tries 0.8 to \
40 kK. Gives levels from 0 to 1; the error is absolute.",
    good_for: "Tinting a light by its temperature, embers included, in every format.",
    function: "sunglint::blackbody::tint",
    limit: "",
};
