// cap: the direction of the Sun's disc, or of any distant sphere, that is nearest to the mirror ray. Shade with it.
// From sunglint 0.1.0, MIT OR Apache-2.0.
//
//   l  unit direction to the light's centre
//   r  unit mirror direction, reflect(-v, n), v being the unit direction to the camera; reflect(v, n) is its negative
//   x  radius over distance of the light, 0 to 1, the sine of its angular radius: 0.00465 for the Sun from Earth
//   w  versine(x), 1 less the cosine of the angular radius; compute both once a light, outside the shader
//
// In f32 within 5.7e-8 rad where root and division are correctly rounded, 9.5e-7 with the errors that Vulkan allows.

// 1 - sqrt(1 - x^2), which would lose its digits as it stands. x from 0 to 1.
fn versine(x: f32) -> f32 {
    return x * x / (1.0 + sqrt((1.0 - x) * (1.0 + x)));
}

fn cap(l: vec3f, r: vec3f, x: f32, w: f32) -> vec3f {
    let c = dot(l, r);
    let toward = c >= 0.0;
    // The difference of near directions is exact, so s, the sine of their angle times the tangent, keeps its digits.
    let e = select(r + l, r - l, toward);
    var s = e - dot(e, l) * l;
    if !toward {
        // Beside -l the tangent is so short that what the first step has left along l counts.
        s = s - dot(s, l) * l;
    }
    let square = dot(s, s);
    // r = l, or r = -l, from where all of the rim is as near; also where a direction is no number.
    if !(square > 1e-30) {
        return select(l, r, toward);
    }
    // The sine tells the rim of discs below 44 degrees, the cosine that of larger ones.
    let inside = select(c >= 1.0 - w, toward && square <= x * x, w < 0.286);
    // The small difference comes first, so that only the last sum rounds at the size of l.
    return select(l + (x * inverseSqrt(square) * s - w * l), r, inside);
}
