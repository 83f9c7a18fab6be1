//! The highlight methods.

use sunglint::trial::Shading;

use super::About;

const TAKES: &str = "unit vectors <i>n</i>, <i>v</i> and <i>l</i>; α is 0 (a mirror) or from 5e-4 to 1; any light, of which half the \
sky is the most that counts. Gives 1/sr: radiance over the illuminance of a plane that faces the light.";

/// GGX at the point that `cap` finds; the width in its peak follows.
const AT_A_POINT: &str = "<i>p</i> = cap(<i>l</i>, <i>r</i>), &nbsp; <i>h</i> halfway between <i>v</i> and <i>p</i>, &nbsp; \
<i>z</i> = <i>n</i>·<i>h</i>, &nbsp; <i>m</i> = 1 − <i>z</i><sup>2</sup>";
const OF_A_POINT: &str = "<i>D</i> = 1 / (π <i>b</i><sup>2</sup> (<i>z</i><sup>2</sup> + <i>m</i> / α<sup>2</sup>)<sup>2</sup>), \
&nbsp; times Smith’s visibility, Schlick’s reflectance and <i>n</i>·<i>p</i>";

const OVER_A_CIRCLE: &str = "<i>h</i> halfway between <i>v</i> and <i>l</i>, &nbsp; <i>z</i> = <i>n</i>·<i>h</i>, &nbsp; \
<i>m</i> = 1 − <i>z</i><sup>2</sup>, &nbsp; <i>T</i> = <i>w</i> / (2 <i>v</i>·<i>h</i>)";
const OF_A_CIRCLE: &str = "<i>D</i> = 2 α<sup>2</sup> / (π <i>Q</i> (<i>Q</i> + <i>p</i>)), &nbsp; \
<i>Q</i> = √(<i>p</i><sup>2</sup> + 4 α<sup>2</sup> <i>z</i><sup>2</sup> <i>T</i>), &nbsp; for <i>p</i> &lt; 0 the equal \
(<i>Q</i> − <i>p</i>) / (2π <i>T</i> <i>z</i><sup>2</sup> <i>Q</i>)";

/// What there is to say of `shading`.
pub fn about(shading: Shading) -> About {
    match shading {
        Shading::None => NONE,
        Shading::Karis => KARIS,
        Shading::KarisThird => KARIS_THIRD,
        Shading::ExactRp => EXACT_RP,
        Shading::DiscGgx => DISC_GGX,
        Shading::Directional => DIRECTIONAL,
        Shading::ConeGgx => CONE_GGX,
        Shading::Shifted => SHIFTED,
    }
}

const NONE: About = About {
    what: "GGX at the nearest point of the disc, without an energy factor",
    formula: &[AT_A_POINT, OF_A_POINT, "<i>b</i> = α"],
    takes: TAKES,
    good_for: "Studies, and lights that are much smaller than the highlight is wide.",
    function: "sunglint::highlight::PointGgx::none",
    limit: "it counts the whole light at every point of its disc, so a polished surface is too bright by the disc’s area over the \
highlight’s; a mirror is black.",
};

const KARIS: About = About {
    what: "the same times (α / α′)<sup>2</sup>, α′ = α + <i>x</i>/2",
    formula: &[AT_A_POINT, OF_A_POINT, "<i>b</i> = min(1, α + <i>x</i>/2)"],
    takes: TAKES,
    good_for: "Matching engines that have this factor, near normal incidence.",
    function: "sunglint::highlight::PointGgx::karis",
    limit: "the point of the disc takes no account of the ellipse that the disc is in the half vectors off normal incidence, so the \
model’s error grows there to more than the highlight itself.",
};

const KARIS_THIRD: About = About {
    what: "the same with α′ = α + <i>x</i>/3",
    formula: &[AT_A_POINT, OF_A_POINT, "<i>b</i> = min(1, α + <i>x</i>/3)"],
    takes: TAKES,
    good_for: "Matching engines that have this factor.",
    function: "sunglint::highlight::PointGgx::karis_third",
    limit: "where the disc is wide against the highlight it is brighter than <code>karis</code>, by up to 9/4, and too bright.",
};

const EXACT_RP: About = About {
    what: "the same with the energy that the shape has under small lights",
    formula: &[AT_A_POINT, OF_A_POINT, "<i>b</i> = √(α<sup>2</sup> + (π/4) α <i>x</i> + <i>x</i><sup>2</sup>/4)"],
    takes: TAKES,
    good_for: "The representative point with its energy right at normal incidence.",
    function: "sunglint::highlight::PointGgx::exact_rp",
    limit: "the energy is right at normal incidence only; off it the shape is as wrong as that of <code>karis</code>.",
};

const DISC_GGX: About = About {
    what: "GGX averaged over the disc in closed form, the disc taken for a circle",
    formula: &[OVER_A_CIRCLE, "<i>p</i> = α<sup>2</sup> <i>z</i><sup>2</sup> + <i>m</i> − <i>T</i>", OF_A_CIRCLE],
    takes: TAKES,
    good_for: "A highlight with the right energy at every incidence, for the price of a representative point.",
    function: "sunglint::highlight::DiscGgx::new",
    limit: "off normal incidence the disc is an ellipse in the half vectors, which a circle of the same area does not follow.",
};

const DIRECTIONAL: About = About {
    what: "the same with the disc taken nearly for the ellipse that it is",
    formula: &[
        OVER_A_CIRCLE,
        "<i>p</i> = α<sup>2</sup> <i>z</i><sup>2</sup> + <i>m</i> − <i>T</i><sub>p</sub>, &nbsp; <i>T</i><sub>p</sub> = (<i>w</i>/2) \
(<i>m</i> + α<sup>2</sup> <i>z</i><sup>2</sup>) / (<i>m</i><sub>d</sub> + <i>m</i><sub>o</sub> (<i>v</i>·<i>h</i>)<sup>2</sup> + \
α<sup>2</sup> <i>z</i><sup>2</sup> (<i>v</i>·<i>h</i>))",
        OF_A_CIRCLE,
        "<i>m</i><sub>d</sub> is the part of <i>m</i> in the plane of <i>l</i> and <i>v</i>, <i>m</i><sub>o</sub> the rest",
    ],
    takes: TAKES,
    good_for: "Real time: a model error of some per cent for little more than the circle costs.",
    function: "sunglint::highlight::DiscGgx::directional",
    limit: "towards grazing incidence the ellipse is long and what is missing shows: at 80 degrees over a third of the Sun’s highlight.",
};

const CONE_GGX: About = About {
    what: "GGX integrated over the exact cone of half vectors: the default",
    formula: &[
        "<i>l′</i> is of the disc where <i>l</i>·<i>l′</i> ≥ 1 − <i>w</i>: with <i>l′</i> = 2 (<i>v</i>·<i>h</i>) <i>h</i> − <i>v</i> an \
elliptic cone of half vectors",
        "<i>k</i> = 1 − α<sup>2</sup>, &nbsp; <i>g</i> = 2 (<i>v</i>·<i>h</i>)<sup>2</sup> − <i>w</i>, &nbsp; \
<i>A</i><sub>d</sub> = <i>w</i> / (2 − <i>w</i>), &nbsp; <i>A</i><sub>o</sub> = <i>w</i> / <i>g</i>",
        "<i>y</i> = (α<sup>2</sup> + <i>k</i> φ) / (1 − <i>k</i> (<i>m</i> − φ)), &nbsp; φ = <i>m</i><sub>d</sub> <i>y</i> / \
(<i>y</i> + <i>A</i><sub>d</sub>) + <i>m</i><sub>o</sub> <i>y</i> / (<i>y</i> + <i>A</i><sub>o</sub>)",
        "<i>D</i> = 4 α<sup>2</sup> (<i>v</i>·<i>h</i>) / (π (2 − <i>w</i>) √(1 − <i>k</i> (<i>m</i> − φ)) √(((2 − <i>w</i>) <i>y</i> + \
<i>w</i>) (<i>g</i> <i>y</i> + <i>w</i>)) <i>S</i>)",
        "<i>S</i> = α<sup>2</sup> + <i>k</i> <i>y</i><sup>2</sup> (<i>m</i><sub>d</sub> (1 + <i>A</i><sub>d</sub>) / (<i>y</i> + \
<i>A</i><sub>d</sub>)<sup>2</sup> + <i>m</i><sub>o</sub> (1 + <i>A</i><sub>o</sub>) / (<i>y</i> + <i>A</i><sub>o</sub>)<sup>2</sup>)",
    ],
    takes: TAKES,
    good_for: "The reference in real arithmetic: right at every incidence and roughness, the mirror included. The root <i>y</i> of \
the cubic takes three steps, more at grazing incidence.",
    function: "sunglint::highlight::ConeGgx",
    limit: "shadowing, reflectance and the cosine are taken at the disc’s centre, which shows under large \
lamps.",
};

const SHIFTED: About = About {
    what: "the same with the rest of the model taken beside the mirror ray, for lamps of any size",
    formula: &[
        "<i>D</i> as that of <code>cone_ggx</code>",
        "<i>V</i>, <i>F</i> and the cosine at a direction between <i>l</i> and cap(<i>l</i>, <i>r</i>), the nearer to the latter the \
smaller α<sup>2</sup> is beside <i>w</i>",
    ],
    takes: TAKES,
    good_for: "Large lamps on polished surfaces. At the Sun <code>cone_ggx</code> is as good and cheaper.",
    function: "sunglint::highlight::ShiftedConeGgx",
    limit: "black where <i>n</i>·<i>l</i> + <i>n</i>·<i>v</i> is not above zero, which under lights of almost half the sky is an edge.",
};

/// `raw::PixelQ14`.
pub const PIXEL_Q14: About = About {
    what: "a whole lit pixel in Q14 with code of its own, for chips whose products have 32 bits",
    formula: &[
        "the highlight of <code>disc_ggx</code>, everything times |<i>l</i> + <i>v</i>|<sup>2</sup>: with <i>A</i> = <i>n</i>·<i>l</i> + \
<i>n</i>·<i>v</i>,",
        "<i>P</i> = α<sup>2</sup> <i>A</i><sup>2</sup> + |<i>n</i> × (<i>l</i> + <i>v</i>)|<sup>2</sup> − <i>w</i> |<i>l</i> + <i>v</i>|, \
&nbsp; <i>H</i><sup>2</sup> = <i>P</i><sup>2</sup> + 4 α<sup>2</sup> <i>A</i><sup>2</sup> <i>w</i> |<i>l</i> + <i>v</i>|",
        "<i>D</i> = 2 α<sup>2</sup> |<i>l</i> + <i>v</i>|<sup>4</sup> / (π <i>H</i> (<i>H</i> + <i>P</i>))",
    ],
    takes: "<i>n</i> and <i>v</i> as Q14 integers (16384 is 1), lengths up to 1.16; light, surface and illuminance are constants. \
Gives radiance in unsigned Q16, which saturates.",
    good_for: "One light on one material on a small core, as exact as the generic pixel for a fraction of its instructions.",
    function: "sunglint::raw::PixelQ14",
    limit: "where the surface cuts the light’s disc, the diffuse part falls back on the generic code, for thousands of instructions.",
};
