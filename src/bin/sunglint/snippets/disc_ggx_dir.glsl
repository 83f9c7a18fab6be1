// disc_ggx dir: GGX averaged over the light's disc, seen as an ellipse, nearly, with Smith and Schlick. The recommended
// highlight: within 3 % of the integral over the Sun's disc at 45 degrees, 7 % at 60 (of the whole highlight's light).
// From sunglint 0.1.0, MIT OR Apache-2.0.
//
//   n, v, l  unit normal, unit directions to the camera and to the light's centre
//   w        1 less the cosine of the light's angular radius, 0 to 1: 1.0813e-5 for the Sun from Earth. In the
//            application, w = x * x / (1 + sqrt(1 - x * x)) of x, radius over distance; 1 - cos would lose its digits
//   alpha    GGX width, perceptual roughness squared, 5e-4 to 1
//   f0       reflectance at normal incidence, 0 to 1
//
// Gives the radiance towards v over the illuminance on a plane that faces the light, in 1/sr, the cosine included; zero
// while the light's centre is below the surface. In f32: highp in GLSL ES.
vec3 disc_ggx(vec3 n, vec3 v, vec3 l, float w, float alpha, vec3 f0) {
    float n_dot_l = dot(n, l);
    float n_dot_v = dot(n, v);
    if (!(n_dot_l > 0.0 && n_dot_v > 6.1e-5)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec3 middle = 0.5 * (l + v);
    float q = dot(middle, middle);
    float v_dot_h = sqrt(q);
    vec3 side = lean(n, middle / v_dot_h);
    // Squares of the sine and of the cosine between normal and half vector, and what of the first is along l - v.
    float m = dot(side, side);
    float z = 0.25 * (n_dot_l + n_dot_v) * (n_dot_l + n_dot_v) / q;
    vec3 apart = l - v;
    float apart_square = dot(apart, apart);
    float part = dot(side, apart);
    float along = apart_square > 1e-20 ? min(part * part / apart_square, m) : 0.5 * m;
    // The disc's image in the half vectors: as a circle, and as wide as it is towards the normal.
    float rough = alpha * alpha * z;
    float circle = 0.5 * w / v_dot_h;
    float spread = along + (m - along) * q + rough * v_dot_h;
    float wide = spread > 0.0 ? 0.5 * w * ((m + rough) / spread) : circle;
    float p = rough + m - wide;
    float size = sqrt(p * p + 4.0 * rough * circle);
    if (!(size > 0.0)) {
        return vec3(0.0, 0.0, 0.0);
    }
    // Both are the same; neither subtracts what cancels.
    float d = p < 0.0 ? (size - p) / (2.0 * circle * z * size) : 2.0 * alpha * alpha / (size * (size + p));
    float level = smith(n_dot_l, n_dot_v, alpha) * d * 0.31830989 / (1.0 - 0.5 * w);
    return level * schlick(f0, v_dot_h);
}

// A whole pixel: radiance towards v under a light of this illuminance on a plane that faces it, and a diffuse albedo
// from 0 to 1. With an illuminance of pi a white surface that faces the light is exactly 1.
vec3 lit_pixel(vec3 n, vec3 v, vec3 l, float w, float alpha, vec3 f0, vec3 albedo, vec3 illuminance) {
    vec3 diffuse = albedo * (0.31830989 * max(dot(n, l), 0.0));
    return illuminance * (diffuse + disc_ggx(n, v, l, w, alpha, f0));
}
