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
fn karis_ggx(n: vec3f, v: vec3f, l: vec3f, x: f32, w: f32, alpha: f32, f0: vec3f) -> vec3f {
    let nearest = cap(l, reflect(-v, n), x, w);
    let n_dot_l = dot(n, nearest);
    let n_dot_v = dot(n, v);
    if !(n_dot_l > 0.0 && n_dot_v > 6.1e-5) {
        return vec3f();
    }
    let middle = 0.5 * (nearest + v);
    let q = dot(middle, middle);
    let v_dot_h = sqrt(q);
    let side = lean(n, middle / v_dot_h);
    let z = 0.25 * (n_dot_l + n_dot_v) * (n_dot_l + n_dot_v) / q;
    let rest = z + dot(side, side) / (alpha * alpha);
    let widened = min(alpha + 0.5 * x, 1.0) * rest;
    let d = 1.0 / (widened * widened);
    return smith(n_dot_l, n_dot_v, alpha) * d * 0.31830989 * schlick(f0, v_dot_h);
}
