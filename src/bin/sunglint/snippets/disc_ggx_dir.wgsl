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
// while the light's centre is below the surface. In f32.
fn disc_ggx(n: vec3f, v: vec3f, l: vec3f, w: f32, alpha: f32, f0: vec3f) -> vec3f {
    let n_dot_l = dot(n, l);
    let n_dot_v = dot(n, v);
    if !(n_dot_l > 0.0 && n_dot_v > 6.1e-5) {
        return vec3f();
    }
    let middle = 0.5 * (l + v);
    let q = dot(middle, middle);
    let v_dot_h = sqrt(q);
    let side = lean(n, middle / v_dot_h);
    // Squares of the sine and of the cosine between normal and half vector, and what of the first is along l - v.
    let m = dot(side, side);
    let z = 0.25 * (n_dot_l + n_dot_v) * (n_dot_l + n_dot_v) / q;
    let apart = l - v;
    let apart_square = dot(apart, apart);
    let part = dot(side, apart);
    let along = select(0.5 * m, min(part * part / apart_square, m), apart_square > 1e-20);
    // The disc's image in the half vectors: as a circle, and as wide as it is towards the normal.
    let rough = alpha * alpha * z;
    let circle = 0.5 * w / v_dot_h;
    let spread = along + (m - along) * q + rough * v_dot_h;
    let wide = select(circle, 0.5 * w * ((m + rough) / spread), spread > 0.0);
    let p = rough + m - wide;
    let size = sqrt(p * p + 4.0 * rough * circle);
    if !(size > 0.0) {
        return vec3f();
    }
    // Both are the same; neither subtracts what cancels.
    let d = select(2.0 * alpha * alpha / (size * (size + p)), (size - p) / (2.0 * circle * z * size), p < 0.0);
    let level = smith(n_dot_l, n_dot_v, alpha) * d * 0.31830989 / (1.0 - 0.5 * w);
    return level * schlick(f0, v_dot_h);
}

// A whole pixel: radiance towards v under a light of this illuminance on a plane that faces it, and a diffuse albedo
// from 0 to 1. With an illuminance of pi a white surface that faces the light is exactly 1.
fn lit_pixel(n: vec3f, v: vec3f, l: vec3f, w: f32, alpha: f32, f0: vec3f, albedo: vec3f, illuminance: vec3f) -> vec3f {
    let diffuse = albedo * (0.31830989 * max(dot(n, l), 0.0));
    return illuminance * (diffuse + disc_ggx(n, v, l, w, alpha, f0));
}
