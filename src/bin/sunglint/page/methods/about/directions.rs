//! The direction methods.

use sunglint::trial::Method;

use super::About;

const TAKES: &str = "<i>l</i> and <i>r</i>, of length 1 but for their rounding, and a <code>DistantSphere</code> for \
<i>x</i> from 0 to 1 (in fixed point lengths up to 1.16). Gives a direction.";

/// What there is to say of `method`.
pub fn about(method: Method) -> About {
    match method {
        Method::Epic => EPIC,
        Method::Factored => FACTORED,
        Method::Disc => DISC,
        Method::Cap => CAP,
    }
}

const EPIC: About = About {
    what: "the representative point as published, with its lengths",
    formula: &[
        "<i>L</i> = <i>d</i> <i>l</i>, &nbsp; <i>C</i> = (<i>L</i>·<i>r</i>) <i>r</i> − <i>L</i>",
        "<i>P</i> = <i>L</i> + <i>C</i> min(1, <i>R</i> / |<i>C</i>|), &nbsp; answer: <i>P</i> / |<i>P</i>|",
    ],
    takes: "<i>l</i> and <i>r</i> of length 1, and an <code>UnfactoredSphere</code>: the distance <i>d</i> and the radius <i>R</i> in \
one unit, of the Sun in kilometres.",
    good_for: "Studies: it shows what keeping the distance costs. Where it works its answer is that of <code>factored</code>.",
    function: "sunglint::epic",
    limit: "the squared distance must fit the format: the Sun’s in kilometres is beyond f16 (NaN) and beyond fixed point (a finite \
answer without meaning).",
};

const FACTORED: About = About {
    what: "the same point with the distance divided out",
    formula: &[
        "<i>D</i> = (<i>l</i>·<i>r</i>) <i>r</i> − <i>l</i>",
        "<i>P</i> = <i>l</i> + <i>D</i> min(1, <i>x</i> / |<i>D</i>|), &nbsp; answer: <i>P</i> / |<i>P</i>|",
    ],
    takes: TAKES,
    good_for: "Shaders that have the representative point already: one constant in place of two lengths, and no overflow. It is \
exact inside the disc and close beside it.",
    function: "sunglint::factored",
    limit: "it turns by about θ cos(angle) in place of θ, so it falls short away from the light, and behind the light it turns away \
from the mirror ray; no format cures that.",
};

const DISC: About = About {
    what: "the nearest direction of the disc, told by its cosine",
    formula: &[
        "<i>r</i> where <i>l</i>·<i>r</i> ≥ cos θ, else:",
        "<i>t</i> = <i>r</i> − (<i>l</i>·<i>r</i>) <i>l</i>, &nbsp; cos θ <i>l</i> + sin θ <i>t</i> / |<i>t</i>|, at unit length",
    ],
    takes: TAKES,
    good_for: "Studies. In exact arithmetic it is the same direction as <code>cap</code>, and under large lights away from their opposite \
it comes close to that.",
    function: "sunglint::disc",
    limit: "the cosine of a small disc is a few steps of the format below 1 (for the Sun 181 in f32, none in f16), so the \
edge blurs; and a few steps from the light’s opposite the rounding of the tangent decides the side of the rim, in f64 too.",
};

const CAP: About = About {
    what: "the nearest direction of the disc, told by its sine, without cancellation: the default",
    formula: &[
        "<i>e</i> = <i>r</i> − <i>l</i> where <i>l</i>·<i>r</i> ≥ 0, else <i>r</i> + <i>l</i>, &nbsp; \
<i>s</i> = <i>e</i> − (<i>e</i>·<i>l</i>) <i>l</i>",
        "<i>r</i> where <i>l</i>·<i>r</i> ≥ 0 and <i>s</i>·<i>s</i> ≤ <i>x</i><sup>2</sup>, \
else <i>l</i> + (<i>x</i> / |<i>s</i>|) <i>s</i> − <i>w</i> <i>l</i>",
    ],
    takes: "<i>l</i> and <i>r</i>, of length 1 but for their rounding, and a <code>DistantSphere</code> of any size, from a point to \
the full sphere. Gives a direction as long as the inputs.",
    good_for: "Everything: the most exact direction in every format, no root inside the disc and one outside. Discs from 44 to \
136 degrees of angular radius are told by the cosine, which is the better measure there.",
    function: "sunglint::cap",
    limit: "within a step of the format of the light’s opposite all of the rim is as near, and the answer is any of its directions, in \
f16 up to 0.023 <i>x</i> beyond it.",
};

/// `soft::cap`.
pub const SOFT: About = About {
    what: "<code>cap</code> of f32 vectors, computed in integers",
    formula: &["each lane to I2F30, &nbsp; <code>cap</code> there, &nbsp; each lane back to f32, rounded once"],
    takes: "<i>l</i> and <i>r</i> in f32, of length 1 but for their rounding, and a <code>raw::SphereQ30</code>.",
    good_for: "Chips without an FPU whose vectors are f32 all the same: it links no float library and takes a fraction of the \
instructions.",
    function: "sunglint::soft::cap",
    limit: "lanes below 2<sup>−7</sup> are rounded to multiples of 2<sup>−30</sup>, and beside the light’s opposite the error grows as \
1.15e-9 <i>x</i> over the gap in radians.",
};
