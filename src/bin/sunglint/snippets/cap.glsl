// cap: the direction of the Sun's disc, or of any distant sphere, that is nearest to the mirror ray. Shade with it.
// From sunglint 0.1.0, MIT OR Apache-2.0.
//
//   l  unit direction to the light's centre
//   r  unit mirror direction, reflect(-v, n), v being the unit direction to the camera; reflect(v, n) is its negative
//   x  radius over distance of the light, 0 to 1, the sine of its angular radius: 0.00465 for the Sun from Earth
//   w  versine(x), 1 less the cosine of the angular radius; compute both once a light, outside the shader
//
// In f32 within 5.7e-8 rad of the exact direction under the Sun, with an inverse root as far off as Vulkan allows too.

// 1 - sqrt(1 - x^2), which would lose its digits as it stands. x from 0 to 1.
float versine(float x) {
    return x * x / (1.0 + sqrt((1.0 - x) * (1.0 + x)));
}

vec3 cap(vec3 l, vec3 r, float x, float w) {
    float c = dot(l, r);
    bool toward = c >= 0.0;
    // The difference of near directions is exact, so s, the sine of their angle times the tangent, keeps its digits.
    vec3 e = toward ? r - l : r + l;
    vec3 s = e - dot(e, l) * l;
    if (!toward) {
        // Beside -l the tangent is so short that what the first step has left along l counts.
        s = s - dot(s, l) * l;
    }
    float square = dot(s, s);
    // r = l, or r = -l, from where all of the rim is as near; also where a direction is no number.
    if (!(square > 1e-30)) {
        return toward ? r : l;
    }
    // The sine tells the rim of discs below 44 degrees, the cosine that of larger ones.
    bool inside = w < 0.286 ? (toward && square <= x * x) : (c >= 1.0 - w);
    // The small difference comes first, so that only the last sum rounds at the size of l.
    return inside ? r : l + (x * inversesqrt(square) * s - w * l);
}
