// cap_half: cap in f16, which is what mediump is on many phones. Where mediump is f32 it is right as well.
// From sunglint 0.1.0, MIT OR Apache-2.0.
//
//   l  unit direction to the light's centre
//   r  unit mirror direction, reflect(-v, n), v being the unit direction to the camera; reflect(v, n) is its negative
//   x  radius over distance of the light, 1e-4 to 1, the sine of its angular radius: 0.00465 for the Sun from Earth
//   w  1 less the cosine of the angular radius, x * x / (1 + sqrt(1 - x * x)), computed in f32 outside the shader
//
// The Sun's x^2 is 2.2e-5, below f16's normal numbers (from 6.1e-5), which may be flushed to 0. So differences are taken
// times 64, and divided by their largest lane before they are squared. That w is flushed as well does no harm.
// Within 4.8e-4 rad, the step of f16, under the Sun; 6.1e-4 with the errors that Vulkan allows.
mediump vec3 cap_half(mediump vec3 l, mediump vec3 r, mediump float x, mediump float w) {
    mediump float c = dot(l, r);
    bool toward = c >= 0.0;
    // The difference of near directions is exact, so s, the sine of their angle times the tangent, keeps its digits.
    mediump vec3 e = 64.0 * (toward ? r - l : r + l);
    mediump vec3 s = e - dot(e, l) * l;
    if (!toward) {
        // Beside -l the tangent is so short that what the first step has left along l counts.
        s = s - dot(s, l) * l;
    }
    mediump float largest = max(abs(s.x), max(abs(s.y), abs(s.z)));
    // r = l, or r = -l, from where all of the rim is as near.
    if (!(largest > 0.0)) {
        return toward ? r : l;
    }
    mediump vec3 t = s / largest;
    mediump float size = sqrt(dot(t, t));
    // The sine tells the rim of discs below 44 degrees, the cosine that of larger ones.
    bool inside = w < 0.286 ? (toward && largest * size <= 64.0 * x) : (c >= 1.0 - w);
    // The small difference comes first, so that only the last sum rounds at the size of l.
    return inside ? r : l + (x / size * t - w * l);
}
