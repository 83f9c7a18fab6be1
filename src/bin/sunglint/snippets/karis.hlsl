// karis: GGX at the direction that cap finds, its peak lowered by Karis's factor (2013). The cheap one: its highlight
// is off by up to 41 % under the Sun at 45 degrees, most where alpha is far below x.
// From sunglint 0.1.0, MIT OR Apache-2.0.
//
//   n, v, l  unit normal, unit directions to the camera and to the light's centre
//   x, w     the light's constants, as cap takes them
//   alpha    GGX width, perceptual roughness squared, 5e-4 to 1
//   f0       reflectance at normal incidence, 0 to 1
//
// Gives the radiance towards v over the illuminance on a plane that faces the light, in 1/sr, the cosine included.
float3 karis_ggx(float3 n, float3 v, float3 l, float x, float w, float alpha, float3 f0) {
    float3 nearest = cap(l, reflect(-v, n), x, w);
    float n_dot_l = dot(n, nearest);
    float n_dot_v = dot(n, v);
    if (!(n_dot_l > 0.0 && n_dot_v > 6.1e-5)) {
        return float3(0.0, 0.0, 0.0);
    }
    float3 middle = 0.5 * (nearest + v);
    float q = dot(middle, middle);
    float v_dot_h = sqrt(q);
    float3 side = lean(n, middle / v_dot_h);
    float z = 0.25 * (n_dot_l + n_dot_v) * (n_dot_l + n_dot_v) / q;
    float rest = z + dot(side, side) / (alpha * alpha);
    float widened = min(alpha + 0.5 * x, 1.0) * rest;
    float d = 1.0 / (widened * widened);
    return smith(n_dot_l, n_dot_v, alpha) * d * 0.31830989 * schlick(f0, v_dot_h);
}
